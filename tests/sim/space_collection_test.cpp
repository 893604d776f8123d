// Collection on the virtual arm in space.
#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/sim/related_arms.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "space_arms.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

ScheduleSettings short_schedule(ScheduleKind kind, int count, int episodes) {
  ScheduleSettings schedule;
  schedule.kind = kind;
  schedule.count = count;
  schedule.episodes = episodes;
  schedule.hold_s = 1.0;
  schedule.hold_min_s = 0.2;
  return schedule;
}

TEST(SpaceCollection, IsTheSameFileForAnyNumberOfJobsWithOtherPhysicsInEachEpisode) {
  const ArmDescription arm = own_space_arm("upright_4x2");
  const TemporaryFolder folder;
  VirtualArmOptions options;
  options.noise_m = 0.001;
  options.noise_rad = 0.01;
  options.noise_kpa = 0.2;
  options.drop_rate = 0.2;
  options.seed = 11;
  for (const PhysicsVariation& variation :
       {PhysicsVariation(PhysicsFactor{1.5}), PhysicsVariation(WidePhysics{})}) {
    CollectionSettings settings =
        related_collection(arm, short_schedule(ScheduleKind::random, 2, 3), options, variation);
    settings.progress = Progress::Mode::quiet;
    settings.force = true;
    const DriverFactory factory = related_arm_factory(arm, options, variation);
    settings.jobs = 1;
    const Recording one = collect(arm, settings, factory, folder.path() / "one.h5").recording;
    settings.jobs = 2;
    (void)collect(arm, settings, factory, folder.path() / "two.h5");
    EXPECT_EQ(read_file(folder.path() / "one.h5"), read_file(folder.path() / "two.h5"));
    EXPECT_GT(one.untracked_count(), 0);
    EXPECT_THAT(one.episodes[0].physics, ::testing::HasSubstr("joint_friction_n_m"));
    EXPECT_THAT(one.episodes[0].physics, ::testing::Not(::testing::HasSubstr("table")));
    EXPECT_NE(one.episodes[0].physics, one.episodes[1].physics);
  }
}

TEST(SpaceCollection, RecordsPosesOfAllPlatesAndPressuresOfAllChambers) {
  const ArmDescription arm = own_space_arm("hanging_3x2");
  const TemporaryFolder folder;
  CollectionSettings settings =
      virtual_collection(arm, short_schedule(ScheduleKind::transitions, 4, 1), {});
  settings.progress = Progress::Mode::quiet;
  (void)collect(arm, settings, virtual_arm_factory(arm, {}), folder.path() / "r.h5");
  const Recording recording = read_recording(folder.path() / "r.h5");
  EXPECT_EQ(recording.dimension, Dimension::space);
  EXPECT_EQ(recording.chamber_count, 6);
  const Episode& episode = recording.episodes.front();
  EXPECT_EQ(episode.backbone.cols(), 9 * kSpacePoseSize);
  EXPECT_EQ(episode.pressure_kpa.cols(), 6);
  for (Eigen::Index t = 0; t < episode.setpoint_kpa.rows(); ++t) {
    for (Eigen::Index i = 0; i < 6; ++i) {
      EXPECT_THAT(episode.setpoint_kpa(t, i), ::testing::AnyOf(0.0F, 50.0F, 100.0F));
    }
  }
  require_recording_of(recording, arm, "r.h5");
}

}  // namespace
}  // namespace limber
