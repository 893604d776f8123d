#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/planning/forest.hpp"
#include "planning/play_model.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

struct Grown {
  Grown() {
    ForestSettings settings;
    settings.nodes = 500;
    settings.jobs = 1;
    forest = *grow_forest(arm, model, forest_key(arm, "model", {}, start), start, settings);
  }

  ArmDescription arm = three_segment_arm();
  ForwardModel model{arm, play_network(arm, 0.01F)};
  ArmStart start = start_state(Environment(), arm);
  Forest forest;
};

TEST(ForestFile, SurvivesItsFile) {
  const Grown s;
  const TemporaryFolder folder;
  const Forest forest = s.forest;
  write_forest(folder.path() / "a.forest", forest);
  const Forest back = read_forest(folder.path() / "a.forest");
  EXPECT_EQ(back.key, forest.key);
  EXPECT_EQ(back.arm_description, arm_keys_to_yaml(s.arm));
  EXPECT_EQ(back.parents, forest.parents);
  EXPECT_EQ(back.setpoints_kpa, forest.setpoints_kpa);
  EXPECT_EQ(back.held_tips, forest.held_tips);
  EXPECT_EQ(back.costs_kpa, forest.costs_kpa);
  EXPECT_EQ(back.shapes, forest.shapes);
}

TEST(ForestFile, ABrokenFileIsRefusedByTensor) {
  const Grown s;
  const TemporaryFolder folder;
  const auto refusal = [&](const Forest& broken) {
    write_forest(folder.path() / "b.forest", broken);
    try {
      (void)read_forest(folder.path() / "b.forest");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const Forest good = s.forest;
  Forest broken = good;
  broken.parents[7] = 7;
  EXPECT_THAT(refusal(broken), HasSubstr("b.forest: parents[7] = 7; expected a node before it"));
  broken = good;
  broken.held_tips(1, 3) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(refusal(broken), HasSubstr("held_tips holds a number that is not finite"));
  broken = good;
  broken.held_tips(2, 3) = 3e38F;
  EXPECT_THAT(refusal(broken), HasSubstr("held_tips[3, 2] = 3e+38; expected at most 10000"));
  broken = good;
  broken.setpoints_kpa.conservativeResize(Eigen::NoChange, 5);
  EXPECT_THAT(refusal(broken), AllOf(HasSubstr("tensor setpoints_kpa "),
                                     HasSubstr(" one row for each of the forest")));
  broken = good;
  broken.shapes.conservativeResize(Eigen::NoChange, 5);
  EXPECT_THAT(refusal(broken),
              AllOf(HasSubstr("tensor shapes "), HasSubstr(" one row for each of the forest")));
  write_file_atomically(folder.path() / "b.forest", "no tensors");
  EXPECT_THROW((void)read_forest(folder.path() / "b.forest"), InputError);
}

}  // namespace
}  // namespace limber
