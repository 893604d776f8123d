#include "src/experiment/improve/plan_run_file.hpp"

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "support/sample_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class PlanRunFile : public ::testing::Test {
 protected:
  PlanRunFile() {
    settings_.arm = sample_arm(3);
    on_.source = "virtual arm";
    on_.about = "a test";
  }

  Episode still(int frames) const {
    Episode episode;
    episode.time_s = Eigen::VectorXd::LinSpaced(frames, 0.0, frames - 1.0);
    episode.pressure_kpa = FrameMatrix::Zero(frames, 3);
    episode.setpoint_kpa = FrameMatrix::Zero(frames, 3);
    episode.backbone = FrameMatrix::Zero(frames, 48);
    episode.motion_index.assign(static_cast<std::size_t>(frames), 0);
    return episode;
  }

  PlanRunPart solved(int environment) const {
    PlanRunPart part;
    part.run = {environment, "solved", true, false, true, 0.0125, 2.5};
    part.episode = still(4);
    return part;
  }

  void write(const PlanRunPart& part) {
    write_part(settings_, on_, output_, part_name("round_1/plans", part.run.environment), part, 7);
  }
  std::optional<PlanRunPart> read(int environment) {
    return read_part(output_.path(), part_name("round_1/plans", environment), environment);
  }

  TemporaryFolder folder_;
  ImproveSettings settings_;
  ImproveArm on_;
  OutputFolder output_{folder_.path() / "x", "improve", OutputFolder::Start::fresh};
};

TEST_F(PlanRunFile, PartSurvivesTheRoundTrip) {
  write(solved(3));
  const PlanRunPart found = read(3).value();
  EXPECT_EQ(found.run.status, "solved");
  EXPECT_TRUE(found.run.executed);
  EXPECT_TRUE(found.run.arrived);
  EXPECT_EQ(found.run.distance_m, 0.0125);
  EXPECT_EQ(found.run.duration_s, 2.5);
  EXPECT_EQ(found.episode->frame_count(), 4);
  EXPECT_FALSE(read(4));
}

TEST_F(PlanRunFile, EnvironmentWithoutAPlanHasNoRecording) {
  PlanRunPart part;
  part.run = {5, "limit", false, false, false, std::nullopt, 0.0};
  write(part);
  const PlanRunPart found = read(5).value();
  EXPECT_FALSE(found.episode);
  EXPECT_FALSE(found.run.distance_m);
}

// Killed after the recording was written and before what says that it is whole.
TEST_F(PlanRunFile, RecordingAloneIsNoFinishedPart) {
  write(solved(3));
  std::filesystem::remove(output_.path() / (part_name("round_1/plans", 3) + ".json"));
  EXPECT_FALSE(read(3));
}

TEST_F(PlanRunFile, JoinedRunsReplaceTheirParts) {
  PlanRuns runs;
  for (const int k : {0, 1}) {
    const PlanRunPart part = solved(k);
    write(part);
    runs.runs.push_back(part.run);
    runs.episodes.push_back(*part.episode);
  }
  write_joined(settings_, on_, output_, "round_1/plans", runs, 7);
  remove_parts(output_, "round_1/plans", runs);
  EXPECT_FALSE(std::filesystem::exists(output_.path() / "round_1/plans.parts"));
  const PlanRuns found = read_plan_runs(output_, "round_1/plans");
  ASSERT_EQ(found.runs.size(), 2U);
  EXPECT_EQ(found.episodes.size(), 2U);
  EXPECT_EQ(found.arm_time_s, 5.0);
}

TEST_F(PlanRunFile, DamagedPartIsNamed) {
  write(solved(3));
  const std::filesystem::path file = output_.path() / (part_name("round_1/plans", 3) + ".json");
  write_file_atomically(file, R"({"schema": "limber/plan-runs/1", "recorded": true, "runs": []})");
  EXPECT_THAT([&] { (void)read(3); },
              ::testing::ThrowsMessage<InputError>(
                  AllOf(HasSubstr(file.string()), HasSubstr("expected one run"))));
}

}  // namespace
}  // namespace limber
