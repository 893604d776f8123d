// Collection on the real virtual arm.
#include <gmock/gmock.h>

#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "support/fake_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

CollectionSettings short_collection(const ArmDescription& arm, const VirtualArmOptions& options) {
  ScheduleSettings schedule;
  schedule.kind = ScheduleKind::random;
  schedule.count = 2;
  schedule.episodes = 3;
  schedule.hold_s = 1.0;
  schedule.hold_min_s = 0.2;
  CollectionSettings settings = virtual_collection(arm, schedule, options);
  settings.progress = Progress::Mode::quiet;
  return settings;
}

TEST(VirtualCollection, IsTheSameForAnyNumberOfJobsWithNoiseAndDrops) {
  const ArmDescription arm = small_arm();
  const TemporaryFolder folder;
  VirtualArmOptions options;
  options.noise_m = 0.001;
  options.drop_rate = 0.2;
  options.latency_s = 0.05;
  options.seed = 11;
  CollectionSettings settings = short_collection(arm, options);
  const DriverFactory factory = virtual_arm_factory(arm, options);
  settings.jobs = 1;
  const Recording one = collect(arm, settings, factory, folder.path() / "one.h5").recording;
  settings.jobs = 2;
  const Recording two = collect(arm, settings, factory, folder.path() / "two.h5").recording;
  ASSERT_EQ(one.episodes.size(), two.episodes.size());
  for (std::size_t i = 0; i < one.episodes.size(); ++i) {
    EXPECT_EQ(one.episodes[i].backbone, two.episodes[i].backbone);
    EXPECT_EQ(one.episodes[i].tracked, two.episodes[i].tracked);
  }
  EXPECT_GT(one.untracked_count(), 0);
  EXPECT_NE(one.episodes[0].tracked, one.episodes[1].tracked) << "each episode has its own drops";
}

TEST(VirtualCollection, DescribesWhatDecidesTheData) {
  ArmDescription arm = small_arm();
  VirtualArmOptions options;
  const std::string plain = describe(arm, options);
  options.noise_m = 0.002;
  EXPECT_NE(describe(arm, options), plain);
  EXPECT_THAT(describe(arm, options), ::testing::HasSubstr("noise 0.002 m"));
  change_virtual_arm(arm, [&](VirtualArmParameters& p) { p.friction_coefficient = 0.3; });
  EXPECT_NE(describe(arm, {}), plain) << "the arm's hash leaves physics out";
}

}  // namespace
}  // namespace limber
