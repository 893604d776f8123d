// limber's own environments, environments/01…08: what of their rules can be tested without a
// trained model.
#include <filesystem>
#include <set>

#include <gmock/gmock.h>

#include "limber/arm/arm_description.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/plan_builder.hpp"
#include "limber/run/executor.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/world/collision.hpp"
#include "limber/world/environment.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;

constexpr double kPositionToleranceM = 0.02;
constexpr double kOrientationToleranceRad = 0.3;

const fs::path kFolder = fs::path(LIMBER_SOURCE_DIR) / "environments";

std::vector<fs::path> environment_files() {
  std::set<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".yaml") {
      files.insert(entry.path());
    }
  }
  return {files.begin(), files.end()};
}

std::vector<Pressures> read_witness(const fs::path& path) {
  std::vector<Pressures> waypoints;
  for (const YamlReader& row : YamlReader::from_file(path).at("waypoints_kpa").elements()) {
    const std::vector<double> numbers = row.numbers("a pressure in kPa");
    waypoints.push_back(
        Eigen::Map<const Eigen::VectorXd>(numbers.data(), Eigen::Index(numbers.size()))
            .cast<float>());
  }
  return waypoints;
}

class OwnEnvironment : public testing::TestWithParam<fs::path> {
 protected:
  const ArmDescription arm_ = load_arm(fs::path(LIMBER_SOURCE_DIR) / "arms/three_segment.yaml");
  const Environment environment_ = load_environment(GetParam(), arm_);
};

TEST_P(OwnEnvironment, StartsStraightAndFreeWithTheUsualTolerances) {
  const CollisionChecker checker(arm_, environment_.obstacles);
  const ArmStart start = start_state(environment_, arm_);
  EXPECT_TRUE(start.pressures_kpa.isZero());
  EXPECT_TRUE(checker.is_free(start.backbone));
  EXPECT_EQ(environment_.goal.position_tolerance_m, kPositionToleranceM);
  if (environment_.goal.theta_rad) {
    EXPECT_EQ(environment_.goal.orientation_tolerance_rad, kOrientationToleranceRad);
  }
}

// The goal can be reached: a motion kept beside the environment does it on the arm, seen at every
// simulator step.
TEST_P(OwnEnvironment, IsSolvedOnTheVirtualArmByItsWitness) {
  const ForwardModel model(arm_);
  const CollisionChecker checker(arm_, environment_.obstacles);
  MotionSimulator simulator(arm_, model, checker);
  const PlanningProblem problem{arm_, model, environment_};
  const std::vector<Pressures> waypoints =
      read_witness(kFolder / "witnesses" / GetParam().filename());
  const Plan plan = build_plan(problem, simulator, waypoints, "witness", 0);
  VirtualArm driver(arm_);
  const ExecutionResult run = execute(arm_, environment_, plan, driver);
  EXPECT_EQ(run.status, ExecutionStatus::done);
  EXPECT_FALSE(run.collided);
  EXPECT_TRUE(run.goal_reached) << run.goal_error.position_m << " m, "
                                << run.goal_error.orientation_rad << " rad off";
}

std::string stem(const testing::TestParamInfo<fs::path>& info) {
  return "E" + info.param.stem().string();
}

INSTANTIATE_TEST_SUITE_P(All, OwnEnvironment, testing::ValuesIn(environment_files()), stem);

TEST(OwnEnvironments, AreEightAndShowEveryKindOfObstacle) {
  std::set<std::string> kinds;
  const std::vector<fs::path> files = environment_files();
  for (const fs::path& file : files) {
    for (const Obstacle& obstacle : load_environment(file).obstacles) {
      kinds.insert(obstacle_kind(obstacle));
    }
  }
  EXPECT_EQ(files.size(), 8U);
  EXPECT_EQ(kinds, (std::set<std::string>{"circle", "rectangle", "polygon"}));
}

}  // namespace
}  // namespace limber
