#include "src/lab/improve/plan_run_file.hpp"

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

  static PlanRun solved(int environment, bool was_vented = true) {
    PlanRun run{environment, "solved"};
    run.executed = run.arrived = run.recorded = true;
    run.distance_m = 0.0125;
    run.duration_s = 2.5;
    run.was_vented = was_vented;
    return run;
  }

  static PlanRun unsolved(int environment) { return {environment, "limit"}; }

  /// With an episode for each venting, one frame longer than the one before.
  PlanRuns runs(std::vector<PlanRun> runs) const {
    PlanRuns result;
    for (PlanRun& run : runs) {
      result.arm_time_s += run.duration_s;
      if (run.was_vented) {
        result.episodes.push_back(still(4 + static_cast<int>(result.episodes.size())));
      }
      result.runs.push_back(std::move(run));
    }
    return result;
  }

  void write(const PlanRuns& part) {
    write_plan_runs(settings_, on_, output_, part_name(kBatch, part.runs.front().environment), part,
                    7);
  }
  std::optional<PlanRuns> read(int first) { return read_part(output_, kBatch, first); }
  std::filesystem::path file_of(int first) const {
    return output_.path() / (part_name(kBatch, first) + ".json");
  }

  static constexpr const char* kBatch = "round_1/plans";
  TemporaryFolder folder_;
  ImproveSettings settings_;
  ImproveArm on_;
  OutputFolder output_{folder_.path() / "x", "improve", OutputFolder::Start::fresh};
};

TEST_F(PlanRunFile, PartSurvivesTheRoundTrip) {
  write(runs({solved(3), unsolved(4), solved(5, false)}));
  const PlanRuns found = read(3).value();
  ASSERT_EQ(found.runs.size(), 3U);
  EXPECT_EQ(found.runs[0].status, "solved");
  EXPECT_TRUE(found.runs[0].executed);
  EXPECT_TRUE(found.runs[0].arrived);
  EXPECT_EQ(found.runs[0].distance_m, 0.0125);
  EXPECT_EQ(found.runs[0].duration_s, 2.5);
  EXPECT_FALSE(found.runs[1].recorded);
  EXPECT_FALSE(found.runs[1].distance_m);
  EXPECT_EQ(found.arm_time_s, 5.0);
  EXPECT_EQ(found.ventings(), 1);
  ASSERT_EQ(found.episodes.size(), 1U);
  EXPECT_EQ(found.episodes[0].frame_count(), 4);
  EXPECT_FALSE(read(4));
}

TEST_F(PlanRunFile, EnvironmentWithoutAPlanHasNoRecording) {
  write(runs({unsolved(5)}));
  EXPECT_TRUE(read(5).value().episodes.empty());
}

// Killed after the recording was written and before what says that it is whole.
TEST_F(PlanRunFile, RecordingAloneIsNoFinishedPart) {
  write(runs({solved(3)}));
  std::filesystem::remove(file_of(3));
  EXPECT_FALSE(read(3));
}

TEST_F(PlanRunFile, JoinedRunsReplaceTheirParts) {
  write(runs({solved(0), unsolved(1)}));
  write(runs({solved(2)}));
  const PlanRuns joined = runs({solved(0), unsolved(1), solved(2)});
  write_plan_runs(settings_, on_, output_, kBatch, joined, 7);
  remove_parts(output_, kBatch, joined);
  EXPECT_FALSE(std::filesystem::exists(output_.path() / "round_1/plans.parts"));
  const PlanRuns found = read_plan_runs(output_, kBatch);
  EXPECT_EQ(found.runs.size(), 3U);
  EXPECT_EQ(found.episodes.size(), 2U);
  EXPECT_EQ(found.arm_time_s, 5.0);
}

TEST_F(PlanRunFile, DamagedPartIsNamed) {
  write(runs({solved(3)}));
  write_file_atomically(file_of(3), R"({"schema": "limber/plan-runs/2", "runs": []})");
  EXPECT_THAT([&] { (void)read(3); },
              ::testing::ThrowsMessage<InputError>(
                  AllOf(HasSubstr(file_of(3).string()), HasSubstr("expected 3"))));
}

TEST_F(PlanRunFile, EpisodesThatAreMissingAreNamed) {
  write(runs({solved(3), solved(4)}));
  write_episodes(settings_, on_, output_, part_name(kBatch, 3) + ".h5", {still(4)}, 7);
  EXPECT_THAT([&] { (void)read(3); },
              ::testing::ThrowsMessage<InputError>(HasSubstr("1 episodes")));
}

}  // namespace
}  // namespace limber
