#include "limber/arm/valve_parameters.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/yaml_reader.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

IdentifiedValves sample_valves() {
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  IdentifiedValves valves;
  valves.parameters.segments = {{{0.1 / 3.0, 99.5}, {0.12, kNoLimit}, 0.0131, 0.2},
                                {{0.5, kNoLimit}, {0.0, 60.0}, 0.0, 0.0}};
  valves.findings = {"a: \"b\" # c.h5", {0.2, 0.5, 1.5, 900}, {8.0, 20.0, 60.0, 900}, "", {"x: y"}};
  return valves;
}

void expect_equal(const IdentifiedValves& back, const IdentifiedValves& valves) {
  EXPECT_EQ(back.parameters, valves.parameters);
  EXPECT_EQ(back.parameters.hash(), valves.parameters.hash());
  EXPECT_EQ(back.findings.source, valves.findings.source);
  EXPECT_EQ(back.findings.reason, valves.findings.reason);
  EXPECT_EQ(back.findings.warnings, valves.findings.warnings);
  EXPECT_EQ(back.findings.held_back.mean_kpa, valves.findings.held_back.mean_kpa);
  EXPECT_EQ(back.findings.held_back.frames, valves.findings.held_back.frames);
  EXPECT_EQ(back.findings.from_setpoints.max_kpa, valves.findings.from_setpoints.max_kpa);
}

TEST(ValveFile, ComesBackAfterARoundTrip) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "valves.yaml";
  write_valves(path, sample_valves());
  expect_equal(read_valves(path), sample_valves());
  expect_equal(read_valves(YamlReader::from_text(to_json(sample_valves()).dump(), "json")),
               sample_valves());
}

TEST(ValveFile, SaysWhyThereAreNoParameters) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "valves.yaml";
  IdentifiedValves none;
  none.parameters.has_sides = false;
  none.findings.source = "log.h5";
  none.findings.reason = "the set points never change";
  write_valves(path, none);
  expect_equal(read_valves(path), none);
  EXPECT_EQ(to_text(none), "valves: none known (the set points never change)");
}

TEST(ValveFile, HowTheyWereFoundIsNoPartOfTheHash) {
  IdentifiedValves other = sample_valves();
  other.findings = {};
  EXPECT_EQ(other.parameters.hash(), sample_valves().parameters.hash());
}

TEST(ValveFile, NamesSegmentsOnceWhereTheyAreAlike) {
  IdentifiedValves valves;
  valves.parameters.segments.assign(3, {{0.1, 99.5}, {0.12, 80.0}, 0.0131, 0.2});
  EXPECT_EQ(to_text(valves),
            "valves: inflate 0.100 s at most 99.5 kPa/s, vent 0.120 s at most 80 kPa/s, dead time "
            "0.013 s, dead band 0.2 kPa");
  valves.parameters.segments[2].dead_time_s = 0.1;
  EXPECT_THAT(to_text(valves), HasSubstr("segment 2: inflate 0.100 s"));
}

TEST(ValveFile, NamesLineAndKeyOfWhatIsWrong) {
  const auto expect_refused = [](const std::string& from, const std::string& to,
                                 const std::string& message) {
    std::string text = valves_to_yaml(sample_valves());
    const std::size_t place = text.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    EXPECT_THAT([&] { (void)read_valves(YamlReader::from_text(text, "v.yaml")); },
                ThrowsMessage<InputError>(HasSubstr(message)));
  };
  expect_refused("limber/valves/1", "limber/valves/2", "v.yaml:1: schema: 'limber/valves/2' found");
  expect_refused("dead_time_s: 0.0131", "dead_time_s: -1",
                 "v.yaml:4: segments[0].dead_time_s: -1 found; expected a time in seconds");
  expect_refused("vent_rate_limit_kpa_per_s: 60.0", "vent_rate_limit_kpa_per_s: 0",
                 "v.yaml:5: segments[1].vent_rate_limit_kpa_per_s: 0 found");
  expect_refused("dead_band_kpa", "dead_bnad_kpa",
                 "v.yaml:4: segments[0].dead_bnad_kpa: unknown key");
  expect_refused("frames: 900", "frames: -900", "identified.held_back_error.frames: -900 found");
}

}  // namespace
}  // namespace limber
