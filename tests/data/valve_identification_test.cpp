#include "limber/data/valve_identification.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/data/valve_simulation.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kLimitKpa = 100.0;
// What 20 minutes tell of valves whose model is exact.
constexpr double kTimeShare = 0.01;  // of a time constant
constexpr double kRateShare = 0.01;  // of a rate limit
constexpr double kDeadTimeS = 0.0005;
constexpr double kNoisyTimeShare = 0.03;
constexpr double kNoisyDeadTimeS = 0.002;
constexpr double kNoiseKpa = 0.5;

/// Set points of an arm: jumps and ramps, holds of all lengths, zero among the targets.
FrameMatrix random_setpoints(int frames, int segments, RandomStream& random,
                             double largest = 95.0) {
  FrameMatrix setpoints = FrameMatrix::Zero(frames, segments);
  for (int i = 0; i < segments; ++i) {
    float value = 0.0F;
    int t = 1;
    while (t < frames) {
      const auto target = float(random.uniform() < 0.1 ? 0.0 : random.uniform(-largest, largest));
      const float step = random.uniform() < 0.5 ? 1e6F : float(largest / 20.0);
      const int until = std::min(frames, t + 5 + int(random.index(50)));
      for (; t < until; ++t) {
        value += std::clamp(target - value, -step, step);
        setpoints(t, i) = value;
      }
    }
  }
  return setpoints;
}

/// What an arm with these valves would have recorded.
Recording recording_of(const ValveParameters& valves, int episodes, int frames,
                       double noise_kpa = 0.0, std::uint64_t seed = 1, double largest = 95.0) {
  const auto segments = int(valves.segments.size());
  Recording recording = make_recording(sample_arm(segments), "test.h5", seed);
  if (!valves.has_sides) {
    recording.command = {"motor angle", "rad"};
  }
  RandomStream random(seed, 0);
  for (int e = 0; e < episodes; ++e) {
    Episode episode;
    episode.time_s = Eigen::VectorXd::LinSpaced(frames, 0.0, (frames - 1) / recording.rate_hz);
    episode.setpoint_kpa = random_setpoints(frames, segments, random, largest);
    episode.pressure_kpa = FrameMatrix::Zero(frames, segments);
    episode.pressure_kpa = simulate_valves(valves, recording.rate_hz, episode);
    for (Eigen::Index k = 0; k < episode.pressure_kpa.size(); ++k) {
      episode.pressure_kpa.data()[k] += float(noise_kpa * random.normal());
    }
    episode.backbone = FrameMatrix::Zero(frames, 3 * recording.point_count);
    episode.motion_index.assign(std::size_t(frames), 0);
    recording.episodes.push_back(episode);
  }
  return recording;
}

void expect_near(const SegmentValves& found, const SegmentValves& truth, double time_share,
                 double dead_time_s) {
  for (const auto& [f, t] :
       {std::pair{found.inflating, truth.inflating}, std::pair{found.venting, truth.venting}}) {
    EXPECT_NEAR(f.time_constant_s, t.time_constant_s, time_share * t.time_constant_s);
    if (std::isfinite(t.rate_limit_kpa_per_s)) {
      EXPECT_NEAR(f.rate_limit_kpa_per_s, t.rate_limit_kpa_per_s,
                  kRateShare * t.rate_limit_kpa_per_s);
    } else {
      EXPECT_EQ(f.rate_limit_kpa_per_s, kNone);
    }
  }
  EXPECT_NEAR(found.dead_time_s, truth.dead_time_s, dead_time_s);
}

struct Case {
  const char* name;
  SegmentValves valves;
};

class ValveIdentification : public ::testing::TestWithParam<Case> {};

TEST_P(ValveIdentification, RecoversWhatMadeTheRecording) {
  const SegmentValves& truth = GetParam().valves;
  const Recording recording = recording_of({true, {truth, truth}}, 6, 1500);
  const IdentifiedValves found = identify_valves(recording);
  ASSERT_EQ(found.findings.reason, "");
  ASSERT_EQ(found.parameters.segments.size(), 2U);
  EXPECT_EQ(found.parameters.segments[0], found.parameters.segments[1]) << "one for both";
  expect_near(found.parameters.segments[0], truth, kTimeShare, kDeadTimeS);
  EXPECT_NEAR(found.parameters.segments[0].dead_band_kpa, truth.dead_band_kpa, 0.02);
  EXPECT_LT(found.findings.held_back.mean_kpa, 1e-3 * kLimitKpa);
  EXPECT_GT(found.findings.held_back.frames, 500);
  EXPECT_THAT(found.findings.warnings, IsEmpty());
}

TEST_P(ValveIdentification, IsNotBiasedBySensorNoise) {
  const SegmentValves& truth = GetParam().valves;
  const Recording recording = recording_of({true, {truth, truth}}, 10, 2400, kNoiseKpa);
  const IdentifiedValves found = identify_valves(recording);
  ASSERT_EQ(found.findings.reason, "");
  expect_near(found.parameters.segments[0], truth, kNoisyTimeShare, kNoisyDeadTimeS);
  // |normal| has a mean of √(2/π) deviations; the model adds next to nothing to the noise.
  EXPECT_NEAR(found.findings.held_back.mean_kpa, kNoiseKpa * std::sqrt(2.0 / M_PI),
              0.1 * kNoiseKpa);
}

INSTANTIATE_TEST_SUITE_P(Valves, ValveIdentification,
                         ::testing::Values(Case{"usual", {{0.1, 100.0}, {0.12, 100.0}, 0.01, 0.2}},
                                           Case{"slow", {{0.3, kNone}, {0.5, kNone}, 0.01, 0.2}},
                                           Case{"late", {{0.1, 100.0}, {0.12, 100.0}, 0.14, 0.2}},
                                           Case{"limited", {{0.1, 60.0}, {0.12, 140.0}, 0.01, 0.2}},
                                           Case{"very_late",
                                                {{0.2, kNone}, {0.05, 150.0}, 0.63, 0.0}}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(ValveIdentificationOf, SegmentsThatDifferGetTheirOwnValves) {
  const SegmentValves first{{0.1, 100.0}, {0.12, 100.0}, 0.02, 0.0};
  const SegmentValves second{{0.4, kNone}, {0.2, kNone}, 0.1, 0.0};
  const IdentifiedValves found = identify_valves(recording_of({true, {first, second}}, 6, 1500));
  ASSERT_EQ(found.parameters.segments.size(), 2U);
  expect_near(found.parameters.segments[0], first, kTimeShare, kDeadTimeS);
  expect_near(found.parameters.segments[1], second, kTimeShare, kDeadTimeS);
}

TEST(ValveIdentificationOf, CommandsWithoutSidesRiseAndFall) {
  const SegmentValves truth{{0.2, kNone}, {0.4, kNone}, 0.03, 0.0};
  const Recording recording = recording_of({false, {truth}}, 6, 1500, 0.0, 1, 1.4);
  const IdentifiedValves found = identify_valves(recording);
  ASSERT_EQ(found.findings.reason, "");
  EXPECT_FALSE(found.parameters.has_sides);
  expect_near(found.parameters.segments[0], truth, kTimeShare, kDeadTimeS);
}

TEST(ValveIdentificationOf, OneEpisodeIsSplit) {
  const SegmentValves truth{{0.1, 100.0}, {0.12, 100.0}, 0.01, 0.2};
  const Recording recording = recording_of({true, {truth}}, 1, 4000);
  const ValveSplit split = split_for_valves(recording.episodes);
  ASSERT_EQ(split.held_back.size(), 1U);
  EXPECT_EQ(split.fitted[0].count, 3200);
  EXPECT_EQ(split.held_back[0].first, 3200);
  EXPECT_EQ(split.held_back[0].count, 800);
  const IdentifiedValves found = identify_valves(recording);
  expect_near(found.parameters.segments[0], truth, kTimeShare, kDeadTimeS);
}

TEST(ValveIdentificationOf, LogsWithoutSetPointsSayNothing) {
  const SegmentValves truth{{0.1, 100.0}, {0.12, 100.0}, 0.01, 0.2};
  Recording recording = recording_of({true, {truth}}, 6, 1500);
  const ValveParameters alone = identify_valves(recording).parameters;
  for (std::size_t e = 0; e < 4; ++e) {
    Episode measured = recording.episodes[e];
    measured.setpoint_kpa = measured.pressure_kpa;
    recording.episodes.push_back(std::move(measured));
  }
  EXPECT_EQ(identify_valves(recording).parameters, alone);
}

TEST(ValveIdentificationOf, AnEpisodeThatBeginsWithALongRestIsSplitByItsChanges) {
  const SegmentValves truth{{0.1, 100.0}, {0.12, 100.0}, 0.01, 0.2};
  Recording recording = recording_of({true, {truth}}, 1, 4000);
  Episode& episode = recording.episodes.front();
  constexpr int kRest = 20000;  // frames
  const auto behind_rest = [](const FrameMatrix& values) {
    FrameMatrix both(kRest + values.rows(), values.cols());
    both << FrameMatrix::Zero(kRest, values.cols()), values;
    return both;
  };
  episode.setpoint_kpa = behind_rest(episode.setpoint_kpa);
  episode.pressure_kpa = behind_rest(episode.pressure_kpa);
  episode.backbone = behind_rest(episode.backbone);
  const auto frames = episode.pressure_kpa.rows();
  episode.time_s = Eigen::VectorXd::LinSpaced(frames, 0.0, double(frames - 1) / recording.rate_hz);
  episode.motion_index.assign(std::size_t(frames), 0);
  EXPECT_GT(split_for_valves(recording.episodes).fitted[0].count, kRest + 3000);
  expect_near(identify_valves(recording).parameters.segments[0], truth, kTimeShare, kDeadTimeS);
}

TEST(ValveIdentificationOf, TheSameRecordingGivesTheSameValves) {
  const SegmentValves truth{{0.1, 100.0}, {0.12, 100.0}, 0.01, 0.2};
  const Recording recording = recording_of({true, {truth}}, 6, 800, kNoiseKpa);
  EXPECT_EQ(identify_valves(recording).parameters, identify_valves(recording).parameters);
}

TEST(ValveIdentificationOf, ASpikeDoesNotDecide) {
  const SegmentValves truth{{0.1, 100.0}, {0.12, 100.0}, 0.01, 0.2};
  Recording recording = recording_of({true, {truth}}, 10, 1500);
  RandomStream random(3, 0);
  for (Episode& episode : recording.episodes) {
    for (int k = 0; k < 15; ++k) {
      const int t = 1 + int(random.index(1499));
      episode.pressure_kpa(t, 0) = 100.0F;
    }
  }
  expect_near(identify_valves(recording).parameters.segments[0], truth, kNoisyTimeShare,
              kNoisyDeadTimeS);
}

TEST(ValveIdentificationOf, SetpointsThatCopyThePressuresTellNothing) {
  Recording recording = recording_of({true, {{{0.1, 100.0}, {0.12, 100.0}, 0.01, 0.2}}}, 6, 300);
  for (Episode& episode : recording.episodes) {
    episode.setpoint_kpa = episode.pressure_kpa;
  }
  const IdentifiedValves found = identify_valves(recording);
  EXPECT_TRUE(found.parameters.is_ideal());
  EXPECT_THAT(found.findings.reason, HasSubstr("the set points equal the measured numbers"));
}

TEST(ValveIdentificationOf, SetpointsThatHardlyChangeTellNothing) {
  Recording recording = recording_of({true, {{{0.1, 100.0}, {0.12, 100.0}, 0.01, 0.2}}}, 6, 300);
  for (Episode& episode : recording.episodes) {
    episode.setpoint_kpa.setConstant(40.0F);
  }
  EXPECT_EQ(identify_valves(recording).findings.reason, "the set points never change");
  for (Episode& episode : recording.episodes) {
    episode.setpoint_kpa.bottomRows(100).setConstant(20.0F);
  }
  EXPECT_EQ(identify_valves(recording).findings.reason,
            "set points change in 6 frames at most; expected 20 or more");
}

TEST(ValveIdentificationOf, ASegmentThatRestsTakesTheValvesOfTheOthers) {
  const SegmentValves truth{{0.1, 100.0}, {0.12, 100.0}, 0.01, 0.2};
  Recording recording = recording_of({true, {truth, truth}}, 6, 1500);
  for (Episode& episode : recording.episodes) {
    episode.setpoint_kpa.col(1).setZero();
    episode.pressure_kpa.col(1).setZero();
  }
  const IdentifiedValves found = identify_valves(recording, {kLimitKpa, kLimitKpa});
  ASSERT_EQ(found.parameters.segments.size(), 2U);
  expect_near(found.parameters.segments[1], truth, kTimeShare, kDeadTimeS);
  EXPECT_THAT(found.findings.warnings, Contains(HasSubstr("set points of 1 of 2 segments hardly")));
}

TEST(ValveIdentificationOf, SetpointsLoggedLateAreNoticed) {
  const SegmentValves truth{{0.1, 200.0}, {0.12, 200.0}, 0.01, 0.2};
  Recording recording = recording_of({true, {truth}}, 6, 1500);
  constexpr int kLate = 6;
  for (Episode& episode : recording.episodes) {
    const FrameMatrix given = episode.setpoint_kpa;
    for (int t = 0; t < episode.frame_count(); ++t) {
      episode.setpoint_kpa.row(t) = given.row(std::max(t - kLate, 0));
    }
  }
  const IdentifiedValves found = identify_valves(recording);
  EXPECT_THAT(found.findings.warnings, Contains(HasSubstr("look for a supply pressure")));
  EXPECT_THAT(found.findings.warnings,
              Contains(HasSubstr("pressures move before their set points")));
}

TEST(ValveIdentificationOf, ASupplyThatIsTooLowIsNoticed) {
  const SegmentValves truth{{0.1, 100.0}, {0.12, 100.0}, 0.01, 0.2};
  Recording recording = recording_of({true, {truth}}, 6, 1500);
  for (Episode& episode : recording.episodes) {
    episode.pressure_kpa = episode.pressure_kpa.cwiseMin(50.0F).cwiseMax(-50.0F);
  }
  EXPECT_THAT(identify_valves(recording).findings.warnings,
              Contains(HasSubstr("a supply pressure that is too low")));
}

TEST(ValveErrors, CountFramesAfterAChangeAlone) {
  const SegmentValves truth{{0.1, 100.0}, {0.12, 100.0}, 0.0, 0.0};
  Recording recording = recording_of({true, {truth}}, 1, 200);
  Episode& episode = recording.episodes[0];
  episode.setpoint_kpa.setZero();
  episode.setpoint_kpa.bottomRows(100).setConstant(50.0F);
  episode.pressure_kpa.setZero();
  episode.pressure_kpa(105, 0) = 30.0F;
  const ValveErrors errors = valve_errors({true, {}}, recording, {{0, 0, 200}});
  EXPECT_EQ(errors.frames, 11);  // the change and 0.5 s after it
  EXPECT_EQ(errors.max_kpa, 50.0);
  EXPECT_NEAR(errors.mean_kpa, (10 * 50.0 + 20.0) / 11.0, 1e-9);
}

TEST(SimulateValves, GoesOnFromTheMiddleOfAnEpisode) {
  const SegmentValves truth{{0.1, 100.0}, {0.12, 100.0}, 0.37, 0.2};
  const Recording recording = recording_of({true, {truth}}, 1, 300);
  const Episode& episode = recording.episodes[0];
  constexpr double kFloatKpa = 1e-3;  // pressures are stored as float and begun from there
  const FrameMatrix part = simulate_valves({true, {truth}}, 20.0, episode, 150, 100);
  EXPECT_LT((part - episode.pressure_kpa.middleRows(150, 100)).cwiseAbs().maxCoeff(), kFloatKpa);
  EXPECT_THROW((void)simulate_valves({true, {truth, truth}}, 20.0, episode), InputError);
}

}  // namespace
}  // namespace limber
