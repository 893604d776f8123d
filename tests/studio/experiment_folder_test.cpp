#include "src/studio/experiment_folder.hpp"

#include <gmock/gmock.h>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/common/error.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const fs::path kData = fs::path(LIMBER_SOURCE_DIR) / "tests/data/closed_loop";
constexpr const char* kRow =
    R"("environment": "arm_019", "model": "network", "planner": "default", "controller": "open",
       "disturbance": "", "trials": 2, "reached": 1, "collided": 0)";

/// A project with an experiment of one row and two trials, the second without a plan.
class Experiment : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(root_);
    const ArmDescription arm = load_arm(data_folder() / "arms/three_segment.yaml");
    write("out/table/experiment.json",
          fmt::format(R"({{"arm": {{"name": "{}", "hash": "{}"}}}})", arm.name, arm.hash()));
    write("out/table/table.json", fmt::format("[{{{}}}]", kRow));
    write("out/table/trials/arm_019_network_default_001.json", trial("1", "\"x\"", "solved"));
    write("out/table/trials/arm_019_network_default_002.json", trial("2", "null", "limit"));
    write("out/table/trials/arm_019_network_default_tip_load_001.json",
          R"({"belongs_to": {"environment": "arm_019", "model": "network", "planner": "default",
              "disturbance": "tip_load"}})");
    write("secret.json", R"({"belongs_to": {"environment": "SECRET"}})", root_);
    fs::create_directories(root_ / "project/out/table/plans");
    fs::copy_file(kData / "arm_019.plan.json", plan_);
    fs::create_directories(root_ / "project/environments");
    fs::copy_file(kData / "arm_019.yaml", root_ / "project/environments/arm_019.yaml");
    fs::copy_file(kData / "ten_hours.safetensors", root_ / "project/model.safetensors");
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& text, fs::path folder = {}) const {
    write_file_atomically((folder.empty() ? root_ / "project" : folder) / name, text);
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
  fs::path plan_ = root_ / "project/out/table/plans/arm_019_network_default_001.json";
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
  EXPECT_EQ(runs[0].at("id"), "arm_019_network_default_001");
  EXPECT_EQ(runs[0].at("distance_to_goal_cm"), 0.25);
  EXPECT_EQ(runs[1].at("status"), "limit");
  EXPECT_THAT([&] { (void)folder.runs(1); }, ThrowsMessage<InputError>(HasSubstr("has 1")));
}

TEST_F(Experiment, ARunNamesTheFilesThatItWasMadeFor) {
  const ProjectFolder project(root_ / "project");
  const ExperimentFolder::Run run =
      ExperimentFolder(project, "out/table").run("arm_019_network_default_001");
  EXPECT_EQ(run.scene.arm, "limber:three_segment");
  EXPECT_EQ(run.scene.model, "model.safetensors");
  EXPECT_EQ(run.environment, "environments/arm_019.yaml");
  EXPECT_EQ(run.plan.seed, 5019U);
}

TEST_F(Experiment, WhatIsMissingOrChangedIsSaid) {
  const ProjectFolder project(root_ / "project");
  const ExperimentFolder folder(project, "out/table");
  const auto open = [&] { (void)folder.run("arm_019_network_default_001"); };
  EXPECT_THAT([&] { (void)folder.run("arm_019_network_default_002"); },
              ThrowsMessage<InputError>(HasSubstr("no plan was found")));
  fs::remove(root_ / "project/model.safetensors");
  EXPECT_THAT(open, ThrowsMessage<InputError>(HasSubstr("the network that this plan")));
  fs::remove(root_ / "project/environments/arm_019.yaml");
  EXPECT_THAT(open, ThrowsMessage<InputError>(HasSubstr("the environment that this plan")));
  std::string text = read_file(plan_);
  text.replace(text.find("\"seed\": 5019"), 12, "\"seed\": 5018");
  write_file_atomically(plan_, text);
  EXPECT_THAT(open, ThrowsMessage<InputError>(HasSubstr("was changed since")));
}

TEST_F(Experiment, NoNameLeadsOut) {
  const ProjectFolder project(root_ / "project");
  for (const char* name : {"..", "../..", "", "out", "/etc", "out/table/../../.."}) {
    EXPECT_THAT([&] { ExperimentFolder(project, name); },
                ThrowsMessage<InputError>(HasSubstr("no file of the project folder")))
        << name;
  }
  const ExperimentFolder folder(project, "out/table");
  for (const char* id : {"../../../../secret", "/etc/passwd", "", "missing"}) {
    EXPECT_THAT([&] { (void)folder.run(id); },
                ThrowsMessage<InputError>(HasSubstr("no file of the project folder")))
        << id;
  }
}

}  // namespace
}  // namespace limber
