#include "src/studio/experiment_folder.hpp"

#include <gmock/gmock.h>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr const char* kRow =
    R"("environment": "arm_019", "model": "network", "planner": "default", "controller": "open",
       "disturbance": "", "trials": 2, "reached": 1, "collided": 0)";

/// A project with an experiment of one row and two trials, the second without a plan.
class Experiment : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(root_);
    write("out/table/experiment.json", "{}");
    write("out/table/table.json", fmt::format("[{{{}}}]", kRow));
    write("out/table/trials/arm_019_network_default_001.json", trial("1", "\"x\"", "solved"));
    write("out/table/trials/arm_019_network_default_002.json", trial("2", "null", "limit"));
    write("out/table/trials/arm_019_network_default_tip_load_001.json",
          R"({"belongs_to": {"environment": "arm_019", "model": "network", "planner": "default",
              "disturbance": "tip_load"}})");
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& text) const {
    write_file_atomically(root_ / "project" / name, text);
  }
  static std::string trial(const std::string& seed, const std::string& plan,
                           const std::string& status) {
    return fmt::format(
        R"({{"status": "{}", "cost_kpa": 78.5, "execution": {{"goal_reached": true,
            "distance_to_goal_cm": 0.25}}, "belongs_to": {{"environment": "arm_019",
            "model": "network", "planner": "default", "seed": "{}", "plan": {}}}}})",
        status, seed, plan);
  }

  fs::path root_ = fs::canonical(fs::temp_directory_path()) /
                   ("limber_experiment_" + std::to_string(::getpid()));
};

TEST_F(Experiment, TheNewestTableCounts) {
  const ProjectFolder project(root_ / "project");
  ASSERT_TRUE(ExperimentFolder::newest(project));
  EXPECT_EQ(ExperimentFolder::newest(project)->name(), "out/table");
  write("later/experiment.json", "{}");
  write("later/table.json", "[]");
  fs::last_write_time(
      root_ / "project/later/table.json",
      fs::last_write_time(root_ / "project/out/table/table.json") + std::chrono::seconds(1));
  EXPECT_EQ(ExperimentFolder::newest(project)->name(), "later");
  fs::remove_all(root_ / "project");
  fs::create_directories(root_ / "project");
  EXPECT_FALSE(ExperimentFolder::newest(ProjectFolder(root_ / "project")));
}

TEST_F(Experiment, ARowHasItsOwnRuns) {
  const ProjectFolder project(root_ / "project");
  const ExperimentFolder folder(project, "out/table");
  EXPECT_EQ(folder.rows().at(0).at("environment"), "arm_019");
  EXPECT_EQ(folder.rows().at(0).at("reached"), 1);
  const nlohmann::ordered_json runs = folder.runs(0);
  ASSERT_EQ(runs.size(), 2U) << "not those with a load";
  EXPECT_EQ(runs[0].at("plan"), "out/table/plans/arm_019_network_default_001.json");
  EXPECT_EQ(runs[0].at("distance_to_goal_cm"), 0.25);
  EXPECT_EQ(runs[1].at("status"), "limit");
  EXPECT_TRUE(runs[1].at("plan").is_null());
  EXPECT_THAT([&] { (void)folder.runs(1); }, ThrowsMessage<InputError>(HasSubstr("has 1")));
}

TEST_F(Experiment, NoNameLeadsOut) {
  const ProjectFolder project(root_ / "project");
  for (const char* name : {"..", "../..", "", "out", "/etc", "out/table/../../.."}) {
    EXPECT_THAT([&] { ExperimentFolder(project, name); },
                ThrowsMessage<InputError>(HasSubstr("no file of the project folder")))
        << name;
  }
}

}  // namespace
}  // namespace limber
