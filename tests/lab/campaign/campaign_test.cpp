#include "limber/lab/campaign.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* kGrid =
    "schema: limber/campaign/1\n"
    "verb: train\n"
    "seed: 5\n"
    "flags: {data: a.h5, ensemble: 2}\n"
    "grid:\n"
    "  hidden: [[60, 60], [100, 100, 100]]\n"
    "  epochs: [10, 20, 30]\n"
    "repeat: 2\n";

constexpr const char* kRandom =
    "schema: limber/campaign/1\n"
    "verb: collect\n"
    "flags: {arm: two_segment, schedule: random}\n"
    "random:\n"
    "  count: 500\n"
    "  arm.friction_coefficient: {from: 0.1, to: 0.45}\n"
    "  hold-s: {from: 0.01, to: 10, scale: logarithmic}\n"
    "  count-of-nothing: {from: 3, to: 5, scale: integer}\n"
    "  approach: [step, straight]\n";

class CampaignFile : public ::testing::Test {
 protected:
  Campaign read(const std::string& text) {
    const auto path = folder_.path() / "c.yaml";
    write_file_atomically(path, text);
    return read_campaign(path);
  }

  TemporaryFolder folder_;
};

std::string value_of(const Flags& flags, const std::string& name) {
  const auto found = std::ranges::find(flags, name, [](const auto& flag) { return flag.first; });
  return found == flags.end() ? "" : as_text(found->second);
}

TEST_F(CampaignFile, AGridHasEveryCombinationTheLastFactorFastest) {
  const Campaign campaign = read(kGrid);
  ASSERT_EQ(unit_count(campaign), 12U);
  std::vector<std::string> designs;
  for (std::size_t i = 0; i < unit_count(campaign); i += campaign.repeat) {
    const CampaignUnit unit = campaign_unit(campaign, i);
    designs.push_back(value_of(unit.flags, "hidden") + "|" + value_of(unit.flags, "epochs"));
  }
  EXPECT_THAT(designs, ElementsAre("60 60|10", "60 60|20", "60 60|30", "100 100 100|10",
                                   "100 100 100|20", "100 100 100|30"));
}

TEST_F(CampaignFile, RepeatsDifferInTheirSeedAndShareItBetweenCombinations) {
  const Campaign campaign = read(kGrid);
  const auto seed = [&](std::size_t i) {
    return value_of(campaign_unit(campaign, i).varied, "seed");
  };
  EXPECT_NE(seed(0), seed(1));
  for (std::size_t i = 2; i < unit_count(campaign); ++i) {
    EXPECT_EQ(seed(i), seed(i % 2));
  }
}

TEST_F(CampaignFile, AUnitDependsOnTheFileAndItsNumberAlone) {
  const Campaign campaign = read(kRandom);
  const CampaignUnit late = campaign_unit(campaign, 499);
  for (std::size_t i = 0; i < 10; ++i) {
    campaign_unit(campaign, i);
  }
  EXPECT_EQ(campaign_unit(read(kRandom), 499).flags, late.flags);
  EXPECT_NE(campaign_unit(campaign, 498).flags, late.flags);
}

TEST_F(CampaignFile, ARandomDesignDrawsWithinItsRanges) {
  const Campaign campaign = read(kRandom);
  std::set<std::string> seeds;
  std::set<std::string> integers;
  std::set<std::string> approaches;
  int below_a_tenth = 0;
  for (std::size_t i = 0; i < unit_count(campaign); ++i) {
    const Flags varied = campaign_unit(campaign, i).varied;
    const double friction = std::stod(value_of(varied, "arm.friction_coefficient"));
    EXPECT_TRUE(friction >= 0.1 && friction < 0.45);
    const double hold = std::stod(value_of(varied, "hold-s"));
    EXPECT_TRUE(hold >= 0.01 && hold < 10.0);
    below_a_tenth += hold < 0.1 ? 1 : 0;
    integers.insert(value_of(varied, "count-of-nothing"));
    approaches.insert(value_of(varied, "approach"));
    seeds.insert(value_of(varied, "seed"));
  }
  EXPECT_THAT(integers, ElementsAre("3", "4", "5"));
  EXPECT_THAT(approaches, ElementsAre("step", "straight"));
  EXPECT_EQ(seeds.size(), 500U);
  // A third of a logarithmic range: 167 expected, with a standard deviation of 11.
  EXPECT_NEAR(below_a_tenth, 167, 45);
}

TEST_F(CampaignFile, CostsGrowWithTheWork) {
  const Campaign campaign = read(kGrid);
  EXPECT_DOUBLE_EQ(campaign_unit(campaign, 2).cost, 2.0 * campaign_unit(campaign, 0).cost);
  EXPECT_GT(campaign_unit(campaign, 6).cost, 1.5 * campaign_unit(campaign, 0).cost);
}

TEST_F(CampaignFile, RefusesWhatWouldDependOnAClockOrOnOtherUnits) {
  const auto refusal = [&](const std::string& text, const char* message) {
    EXPECT_THAT([&] { read("schema: limber/campaign/1\n" + text); },
                ThrowsMessage<InputError>(HasSubstr(message)))
        << text;
  };
  refusal("verb: plan\n", "'plan' found; expected one of collect, train");
  refusal("verb: train\nflags: {data: a.h5}\n", "no budget: expected the flag epochs");
  refusal("verb: experiment\n", "no budget: expected the flag max-iterations or max-queries");
  refusal("verb: experiment\nflags: {time-limit-s: 3}\n", "budgets are iterations, queries");
  const std::string closed = "verb: experiment\nflags: {max-queries: 9, ";
  refusal(closed + "replan: true}\n", "closed loop without the flag motion-queries");
  refusal(closed + "trials: 1}\ngrid: {controller: [open, replan]}\n",
          "closed loop without the flag motion-queries");
  EXPECT_NO_THROW(read("schema: limber/campaign/1\n" + closed +
                       "motion-queries: 5}\ngrid: {controller: [open, replan]}\n"));
  refusal("verb: collect\nflags: {out: x.h5}\n", "each unit has files of its own");
  refusal("verb: collect\nflags: {driver-log: x}\n", "units run on the virtual arm");
  refusal("verb: collect\nflags: {help: true}\n", "flags.help: not a flag of a unit");
  refusal("verb: collect\nflags: {count: 3}\ngrid: {count: [4, 5]}\n",
          "c.yaml:3: flags.count: varies between units too; expected one of the two");
  refusal("verb: collect\ngrid: {count: [1, 2, 1]}\n", "c.yaml:3: grid.count: '1' found twice");
  refusal("verb: train\nflags: {epochs: 3}\ngrid: {hidden: [[8, 8], [8, 8]]}\n",
          "grid.hidden: '8 8' found twice; units would be the same");
  refusal("verb: collect\nflags: {'--count': 3}\n", "the name of a flag without its dashes");
  refusal("verb: collect\ngrid: {count: [1]}\nrandom: {count: 3}\n", "expected one design");
  refusal("verb: collect\ngrid: {count: {from: 1, to: 2}}\n", "expected a list of values");
  refusal("verb: collect\nrandom: {count: 2, hold-s: {from: 2, to: 1}}\n", "to");
  refusal("verb: collect\nrandom: {count: 2, hold-s: {from: 0, to: 1, scale: logarithmic}}\n",
          "from");
  refusal("verb: collect\ncpu: sse2\n", "'sse2' found; expected baseline, avx2 or avx512");
  refusal("verb: collect\ngrid: {data: {files: nowhere/*.h5}}\n", "'nowhere/*.h5': no such files");
  refusal("verb: collect\nrepeat: 0\n", "repeat");
  refusal("verb: collect\nflags: {seed: 5}\nrepeat: 2\n", "each repetition is the same");
  refusal("verb: collect\ngrid: {seed: [1, 2]}\nrepeat: 2\n", "each repetition is the same");
  refusal("verb: train\nflags: {epochs: 3, ensemble: []}\n",
          "c.yaml:3: flags.ensemble: an empty list found");
  refusal("verb: train\nflags: {epochs: 3}\ngrid: {hidden: [[60], []]}\n", "an empty list found");
}

TEST(ArmWith, SetsParametersAlsoThoseThatAreOffAndRefusesOneThatIsNone) {
  const auto arm = std::filesystem::path(LIMBER_SOURCE_DIR) / "arms/two_segment.yaml";
  const std::string text =
      arm_with(arm, {{"friction_coefficient", {"0.375"}}, {"tip_load_kg", {"0.05"}}});
  EXPECT_THAT(text, HasSubstr("friction_coefficient: 0.375\n"));
  EXPECT_THAT(text, HasSubstr("tip_load_kg: 0.05\n"));
  const auto refusal = [&](const char* name, const char* value, const char* message) {
    EXPECT_THAT(
        [&] {
          (void)arm_with(arm, {{name, {value}}});
        },
        ThrowsMessage<InputError>(
            AllOf(HasSubstr("arm.PARAMETER of "), HasSubstr(name), HasSubstr(message))));
  };
  refusal("fricton", "1", "unknown parameter of the virtual arm");
  refusal("tip_load_kg", "-1", "-1");
  refusal("chamber_area_m2", "3e-4", "belongs to the virtual arm in space");
}

}  // namespace
}  // namespace limber
