#include "limber/run/schedule.hpp"

#include <array>
#include <map>
#include <set>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::vector<float> values(const Pressures& pressures) {
  return {pressures.begin(), pressures.end()};
}

/// How often each ordered transition occurs.
std::map<std::pair<std::vector<float>, std::vector<float>>, int> transitions_of(
    const std::vector<EpisodeSchedule>& schedule) {
  std::map<std::pair<std::vector<float>, std::vector<float>>, int> counts;
  for (const EpisodeSchedule& episode : schedule) {
    Pressures from = episode.first_kpa;
    for (const Motion& motion : episode.motions) {
      ++counts[{values(from), values(motion.setpoint_kpa)}];
      from = motion.setpoint_kpa;
    }
  }
  return counts;
}

TEST(TransitionSchedule, HoldsEveryOrderedTransitionExactlyOnce) {
  for (const int segments : {1, 2, 3}) {
    for (const int episodes : {0, 1, 7}) {
      ScheduleSettings settings;
      settings.episodes = episodes;
      const auto schedule = make_schedule(small_arm(segments), settings, 5);
      const auto counts = transitions_of(schedule);
      EXPECT_EQ(counts.size(), std::size_t(std::pow(9, segments)));
      for (const auto& [transition, count] : counts) {
        EXPECT_EQ(count, 1);
      }
      EXPECT_EQ(schedule.size(), std::size_t(episodes > 0 ? episodes : (segments == 1 ? 9 : 16)));
    }
  }
}

TEST(TransitionSchedule, HoldsUntilReached) {
  const auto schedule = make_schedule(small_arm(), {}, 5);
  for (const EpisodeSchedule& episode : schedule) {
    for (const Motion& motion : episode.motions) {
      EXPECT_EQ(motion.hold_s, 3.0);
      EXPECT_TRUE(motion.until_reached);
    }
  }
}

TEST(TransitionSchedule, DependsOnTheSeedAlone) {
  const ArmDescription arm = small_arm();
  const auto flatten = [&](std::uint64_t seed) {
    std::vector<std::vector<float>> all;
    for (const EpisodeSchedule& episode : make_schedule(arm, {}, seed)) {
      for (const Motion& motion : episode.motions) {
        all.push_back(values(motion.setpoint_kpa));
      }
    }
    return all;
  };
  EXPECT_EQ(flatten(1), flatten(1));
  EXPECT_NE(flatten(1), flatten(2));
}

TEST(TransitionSchedule, CountTakesDistinctTransitionsAboveThreeSegments) {
  ScheduleSettings settings;
  settings.count = 200;
  const auto counts = transitions_of(make_schedule(small_arm(5), settings, 3));
  EXPECT_EQ(counts.size(), 200U);
}

// 3^20 corners have numbers beyond 2^31, 3^21 beyond 2^32.
TEST(TransitionSchedule, CountTakesEveryOneOfManySegmentsToAllItsStates) {
  ScheduleSettings settings;
  settings.count = 60;
  for (const int segments : {20, 21, 24}) {
    std::vector<std::set<float>> visited(static_cast<std::size_t>(segments));
    int motions = 0;
    for (const EpisodeSchedule& episode : make_schedule(small_arm(segments), settings, 3)) {
      for (const Motion& motion : episode.motions) {
        ++motions;
        for (std::size_t s = 0; s < visited.size(); ++s) {
          visited[s].insert(motion.setpoint_kpa[static_cast<Eigen::Index>(s)]);
        }
      }
    }
    EXPECT_EQ(motions, 60);
    EXPECT_THAT(visited, Each(ElementsAre(-100.0F, 0.0F, 100.0F))) << segments;
  }
}

// So that a seed keeps its meaning: a corner of up to 20 channels is one draw, its base-3 digits.
TEST(TransitionSchedule, DrawsCornersOfSevenSegmentsByTheirNumbers) {
  constexpr std::uint64_t kScheduleStream = 0x7363'6865'6475'6c65;
  ScheduleSettings settings;
  settings.count = 30;
  settings.episodes = 1;
  const auto schedule = make_schedule(small_arm(7), settings, 3);
  RandomStream random(3, kScheduleStream);
  constexpr std::array kStates_kpa = {0.0F, 100.0F, -100.0F};
  for (const Motion& motion : schedule[0].motions) {
    std::uint32_t corner = random.index(2187);
    for (const float kpa : motion.setpoint_kpa) {
      EXPECT_EQ(kpa, kStates_kpa[corner % 3]);
      corner /= 3;
    }
  }
}

TEST(TransitionSchedule, RefusesAllTransitionsAboveThreeSegmentsWithTheirTime) {
  EXPECT_THAT([] { make_schedule(small_arm(5), {}, 1); },
              ThrowsMessage<InputError>(AllOf(
                  HasSubstr("'small' has 5 segments, so 59049 ordered transitions, 49.2 h at 3 s"),
                  HasSubstr("--count"))));
  ScheduleSettings settings;
  settings.count = 10;
  EXPECT_THAT([&] { make_schedule(small_arm(1), settings, 1); },
              ThrowsMessage<InputError>(HasSubstr("has only 9 ordered transitions")));
}

TEST(TransitionSchedule, GoesToTheLimitOfEachSide) {
  ArmDescription arm = small_arm();
  arm.segments[0].pressure_limit_kpa = PressureLimits(-11.0, 13.8);
  arm.segments[1].pressure_limit_kpa = PressureLimits(0.0, 80.0);
  EXPECT_EQ(corner_configuration(arm, CornerStates{{1, 0}})[0], 13.8F);
  EXPECT_EQ(corner_configuration(arm, CornerStates{{2, 0}})[0], -11.0F);
  EXPECT_EQ(corner_configuration(arm, CornerStates{{0, 1}})[1], 80.0F);
  EXPECT_EQ(corner_configuration(arm, CornerStates{{0, 2}})[1], 40.0F)
      << "half, where there is no other side";
}

TEST(RandomSchedule, StaysWithinTheLimitsOfEachSide) {
  ArmDescription arm = small_arm();
  arm.segments[0].pressure_limit_kpa = PressureLimits(-11.0, 13.8);
  ScheduleSettings settings;
  settings.kind = ScheduleKind::random;
  settings.count = 4000;
  settings.limit_scale = 0.5;
  float low = 0.0F;
  float high = 0.0F;
  const auto schedule = make_schedule(arm, settings, 1);
  for (const Motion& motion : schedule[0].motions) {
    low = std::min(low, motion.setpoint_kpa[0]);
    high = std::max(high, motion.setpoint_kpa[0]);
  }
  EXPECT_GE(low, -5.5F);
  EXPECT_LE(high, 6.9F);
  EXPECT_LT(low, -5.4F);  // 4000 uniform draws come that near
  EXPECT_GT(high, 6.8F);
}

TEST(RandomSchedule, DrawsUniformlyWithinTheLimits) {
  ArmDescription arm = small_arm();
  arm.segments[1].pressure_limit_kpa = 40.0;
  ScheduleSettings settings;
  settings.kind = ScheduleKind::random;
  settings.count = 4000;
  const auto schedule = make_schedule(arm, settings, 1);
  ASSERT_EQ(schedule.size(), 1U);
  EXPECT_TRUE(schedule[0].first_kpa.isZero());
  Eigen::MatrixXf all(2, 4000);
  for (int i = 0; i < 4000; ++i) {
    all.col(i) = schedule[0].motions[std::size_t(i)].setpoint_kpa;
  }
  for (const int s : {0, 1}) {
    const float limit = s == 0 ? 100.0F : 40.0F;
    EXPECT_LE(all.row(s).cwiseAbs().maxCoeff(), limit);
    // Mean and mean square of a uniform variable; 5 standard errors of 4000 draws.
    EXPECT_NEAR(all.row(s).mean() / limit, 0.0, 5 * std::sqrt(1.0 / 3.0 / 4000));
    EXPECT_NEAR((all.row(s) / limit).squaredNorm() / 4000, 1.0 / 3.0,
                5 * std::sqrt(4.0 / 45.0 / 4000));
  }
}

TEST(RandomSchedule, EpisodesDifferAndDoNotDependOnTheirNumber) {
  ScheduleSettings settings;
  settings.kind = ScheduleKind::random;
  settings.count = 3;
  settings.episodes = 2;
  const auto two = make_schedule(small_arm(), settings, 9);
  settings.episodes = 4;
  const auto four = make_schedule(small_arm(), settings, 9);
  EXPECT_EQ(two[1].motions[2].setpoint_kpa, four[1].motions[2].setpoint_kpa);
  EXPECT_NE(four[0].motions[0].setpoint_kpa, four[1].motions[0].setpoint_kpa);
}

TEST(RandomSchedule, DrawsHoldsBetweenTheirBoundsAndDoesNotWait) {
  ScheduleSettings settings;
  settings.kind = ScheduleKind::random;
  settings.count = 200;
  settings.hold_s = 2.0;
  settings.hold_min_s = 0.5;
  double shortest = 1e9;
  double longest = 0.0;
  const auto schedule = make_schedule(small_arm(), settings, 1);
  for (const Motion& motion : schedule[0].motions) {
    shortest = std::min(shortest, motion.hold_s);
    longest = std::max(longest, motion.hold_s);
    EXPECT_FALSE(motion.until_reached);
  }
  EXPECT_GE(shortest, 0.5);
  EXPECT_LT(shortest, 0.6);
  EXPECT_GT(longest, 1.9);
  EXPECT_LE(longest, 2.0);
}

TEST(Schedule, NamesSettingsOutOfRange) {
  const auto refusal = [](auto change) {
    ScheduleSettings settings;
    settings.kind = ScheduleKind::random;
    settings.count = 1;
    change(settings);
    return [settings] { make_schedule(small_arm(), settings, 1); };
  };
  EXPECT_THAT(refusal([](auto& s) { s.count = 0; }),
              ThrowsMessage<InputError>(HasSubstr("--count N is missing")));
  EXPECT_THAT(refusal([](auto& s) { s.count = -3; }),
              ThrowsMessage<InputError>(HasSubstr("--count -3")));
  EXPECT_THAT(refusal([](auto& s) { s.episodes = -1; }),
              ThrowsMessage<InputError>(HasSubstr("--episodes -1")));
  for (const double hold : {0.0, -1.0, std::nan(""), 1e9}) {
    EXPECT_THAT(refusal([hold](auto& s) { s.hold_s = hold; }),
                ThrowsMessage<InputError>(HasSubstr("--hold-s")));
  }
  EXPECT_THAT(refusal([](auto& s) { s.hold_min_s = 4.0; }),
              ThrowsMessage<InputError>(HasSubstr("--hold-min-s 4: expected seconds from 0 to")));
}

}  // namespace
}  // namespace limber
