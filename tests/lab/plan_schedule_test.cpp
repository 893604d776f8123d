#include "limber/lab/plan_schedule.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/run/collection.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/world/straight_motion.hpp"
#include "planning/play_model.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class PlanSchedule : public ::testing::Test {
 protected:
  std::vector<EpisodeSchedule> schedule(int jobs = 1) const {
    PlanScheduleSettings settings = settings_;
    settings.jobs = jobs;
    const ForwardModel model(arm_);
    return plan_schedule(arm_, model, settings);
  }

  ArmDescription arm_ = three_segment_arm();
  PlanScheduleSettings settings_{.episodes = 2,
                                 .count = 3,
                                 .queries = 3000,
                                 .limit_scale = 0.8,
                                 .progress = Progress::Mode::quiet};
};

TEST_F(PlanSchedule, HasSoManyPlansWithinTheLimitsAndTakesDetours) {
  std::size_t via = 0;
  for (const EpisodeSchedule& episode : schedule()) {
    EXPECT_TRUE(episode.first_kpa.isZero());
    ASSERT_EQ(episode.motions.size(), 3U);
    for (const Motion& motion : episode.motions) {
      EXPECT_GT(motion.hold_s, 0.0);
      EXPECT_FALSE(motion.until_reached);
      via += motion.via_kpa.size();
      for (Eigen::Index s = 0; s < motion.setpoint_kpa.size(); ++s) {
        const double limit_kpa =
            arm_.segments[static_cast<std::size_t>(s)].pressure_limit_kpa.largest_kpa();
        EXPECT_LE(std::abs(motion.setpoint_kpa[s]), 0.8001 * limit_kpa);
      }
    }
  }
  EXPECT_GT(via, 0U);
}

TEST_F(PlanSchedule, IsTheSameForAnyNumberOfJobsAndAnotherForAnotherSeed) {
  const auto one = schedule(1);
  const auto two = schedule(2);
  settings_.seed = 2;
  const auto other = schedule();
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t k = 0; k < one[i].motions.size(); ++k) {
      EXPECT_EQ(one[i].motions[k].setpoint_kpa, two[i].motions[k].setpoint_kpa);
      EXPECT_EQ(one[i].motions[k].via_kpa.size(), two[i].motions[k].via_kpa.size());
      EXPECT_NE(one[i].motions[k].setpoint_kpa, other[i].motions[k].setpoint_kpa);
    }
  }
}

TEST_F(PlanSchedule, RecordsEachPlanAsOneMotionThroughItsWaypoints) {
  const EpisodeSchedule episode = schedule().front();
  VirtualArm driver(arm_);
  const Episode run = record_episode(arm_, driver, episode, {});
  EXPECT_EQ(run.motion_index.back(), 2);
  int frames = 0;
  Pressures from = episode.first_kpa;
  for (const Motion& motion : episode.motions) {
    std::vector<Pressures> way = motion.via_kpa;
    way.push_back(motion.setpoint_kpa);
    for (const Pressures& to : way) {
      frames += motion_frame_count(from, to, arm_.pressure_step_limit_kpa());
      EXPECT_EQ(run.setpoint_kpa.row(frames), to.transpose());
      from = to;
    }
    frames += arm_.frames_in(motion.hold_s) - 1;
    EXPECT_EQ(run.setpoint_kpa.row(frames), from.transpose());
  }
  EXPECT_EQ(frames + 1, run.frame_count());
}

// Goals that only full pressures reach would leave every search in vain.
TEST_F(PlanSchedule, GoalsLieWithinTheLimitsThatPlansKeep) {
  settings_.episodes = 1;
  settings_.count = 1;
  settings_.limit_scale = 0.4;
  const EpisodeSchedule episode = schedule().front();
  ASSERT_EQ(episode.motions.size(), 1U);
  const Pressures& end = episode.motions.front().setpoint_kpa;
  EXPECT_LE(end.cwiseAbs().maxCoeff(),
            0.4001 * arm_.segments.front().pressure_limit_kpa.largest_kpa());
}

TEST_F(PlanSchedule, RefusesWhatItCannotMake) {
  settings_.count = 0;
  EXPECT_THAT([&] { schedule(); }, ThrowsMessage<InputError>(HasSubstr("--count 0: expected 1")));
}

}  // namespace
}  // namespace limber
