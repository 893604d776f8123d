#pragma once

#include <atomic>
#include <filesystem>

#include <gtest/gtest.h>

#include "limber/run/collection.hpp"
#include "support/fake_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {

inline constexpr double kLag_s = 0.1;

inline CollectionSettings quick_settings() {
  CollectionSettings settings;
  settings.schedule.kind = ScheduleKind::random;
  settings.schedule.count = 4;
  settings.schedule.episodes = 5;
  settings.schedule.hold_s = 0.5;
  settings.seed = 3;
  settings.progress = Progress::Mode::quiet;
  return settings;
}

class Collection : public ::testing::Test {
 protected:
  DriverFactory factory(FakeFaults faults = {}) {
    return [this, faults](int) {
      ++drivers_;
      return std::make_unique<FakeArm>(arm_, kLag_s, faults);
    };
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "run.h5";
  std::filesystem::path parts_ = folder_.path() / "run.h5.parts";
  ArmDescription arm_ = small_arm();
  std::atomic<int> drivers_{0};
};

inline void expect_equal(const Recording& a, const Recording& b) {
  ASSERT_EQ(a.episodes.size(), b.episodes.size());
  for (std::size_t i = 0; i < a.episodes.size(); ++i) {
    EXPECT_EQ(a.episodes[i].time_s, b.episodes[i].time_s);
    EXPECT_EQ(a.episodes[i].pressure_kpa, b.episodes[i].pressure_kpa);
    EXPECT_EQ(a.episodes[i].backbone, b.episodes[i].backbone);
    EXPECT_EQ(a.episodes[i].motion_index, b.episodes[i].motion_index);
  }
}

}  // namespace limber
