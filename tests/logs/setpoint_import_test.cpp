// Logs in which nothing was measured: set points alone, in force until the next row.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gmock/gmock.h>

#include "logs/csv_import.hpp"

namespace limber {
namespace {

constexpr double kSingle = 1e-4;  // [kPa]: frames are single precision, logs have six digits

/// Set points of a log with 100 rows a second; frames lie between its rows.
class SetpointImport : public CsvImport {
 protected:
  SetpointImport() { rate_hz_ = 33.0; }

  std::string setpoints_mapping() const {
    return replaced(mapping(), "  columns:", "  setpoints:");
  }

  /// The frames' motions in a log of 40 s whose rows are the truth's at `given_s`(time).
  std::vector<int> motions_of(const std::function<double(double)>& given_s);

  /// The set point of the last row at or before a time.
  double in_force(double time_s, Eigen::Index segment) const {
    const double row = std::floor(time_s * rate_hz_ + 1e-6);
    return truth_.pressures(row / rate_hz_)[segment];
  }

  void expect_held(const Recording& recording) const {
    ASSERT_EQ(recording.episodes.size(), 1U);
    const Episode& episode = recording.episodes.front();
    EXPECT_TRUE(recording.setpoints_only());
    EXPECT_EQ(episode.pressure_kpa, episode.setpoint_kpa);
    double apart = 0.0;
    double interpolated_apart = 0.0;
    for (Eigen::Index t = 0; t < episode.time_s.size(); ++t) {
      for (Eigen::Index i = 0; i < 3; ++i) {
        const double found = double(episode.setpoint_kpa(t, i));
        apart = std::max(apart, std::abs(found - in_force(episode.time_s[t], i)));
        interpolated_apart =
            std::max(interpolated_apart, std::abs(found - truth_.pressures(episode.time_s[t])[i]));
      }
    }
    EXPECT_LT(apart, kSingle);
    EXPECT_GT(interpolated_apart, 100.0 * kSingle) << "rows too near each other to tell";
    EXPECT_NO_THROW(validate(recording, "imported"));
  }
};

TEST_F(SetpointImport, HoldsSetPointsBetweenRowsAndNeverInterpolatesThem) {
  const ImportResult result = import(log(), setpoints_mapping());
  expect_held(result.recording);
  ASSERT_NE(note(result, "nothing measured: the recording holds set points only"), nullptr);
  EXPECT_EQ(note(result, "no set points logged"), nullptr);
}

TEST_F(SetpointImport, IsInterpolatedAndCalledMeasuredWhereTheMappingSaysSo) {
  const Recording recording = import(log(), mapping()).recording;
  EXPECT_FALSE(recording.setpoints_only());
  const Episode& episode = recording.episodes.front();
  for (Eigen::Index t = 0; t < episode.time_s.size(); ++t) {
    // Halfway between two rows a straight line is off by its own curvature alone.
    EXPECT_NEAR(double(episode.pressure_kpa(t, 1)), truth_.pressures(episode.time_s[t])[1], 1.0);
  }
}

// `commands` that come alone were commanded; `pressures` are measured unless the mapping denies it.
TEST_F(SetpointImport, TakesCommandsAloneForSetPoints) {
  expect_held(import(log(), replaced(mapping(), "pressures:", "commands:")).recording);
  expect_held(
      import(log(), replaced(mapping(), "pressures:", "pressures:\n  measured: false")).recording);
  const std::string denied = replaced(mapping(), "pressures:", "commands:\n  measured: true");
  EXPECT_FALSE(import(log(), denied).recording.setpoints_only());
}

TEST_F(SetpointImport, ReadsOneColumnPerSide) {
  expect_held(
      import(log_of_sides(),
             replaced(mapping(), "columns: [pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]",
                      "right: [r1, r2, r3]\n  left: [l1, l2, l3]\n  measured: false"))
          .recording);
}

TEST_F(SetpointImport, HoldsEachSideOverEmptyCells) {
  const std::string sides =
      replaced(mapping(), "columns: [pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]",
               "right: [r1, r2, r3]\n  left: [l1, l2, l3]\n  measured: false");
  const auto held = [&](const std::string& text) {
    return import(text, sides).recording.episodes.front().setpoint_kpa;
  };
  // Rows in which the left side stands at zero: empty, they change nothing.
  int from = 200;
  while (truth_.pressures(from / rate_hz_)[0] < 1.0 ||
         truth_.pressures((from + 8) / rate_hz_)[0] < 1.0) {
    ++from;
  }
  EXPECT_EQ(held(hidden(log_of_sides(), 2, from + 1, from + 8)), held(log_of_sides()));
}

// An empty cell says nothing new, for however long; before the first set point nothing is known.
TEST_F(SetpointImport, KeepsASetPointInForceOverEmptyCells) {
  const std::string gaps = hidden(hidden(log(), 1, 200, 260), 2, 0, 40);
  const ImportResult result = import(gaps, setpoints_mapping());
  const Episode& episode = result.recording.episodes.front();
  ASSERT_EQ(result.recording.episodes.size(), 1U);
  const double before_gap = truth_.pressures(199.0 / rate_hz_)[0];
  for (Eigen::Index t = 0; t < episode.time_s.size(); ++t) {
    const double row = episode.time_s[t] * rate_hz_;
    if (row > 199.0 && row < 259.9) {
      EXPECT_NEAR(double(episode.setpoint_kpa(t, 0)), before_gap, kSingle);
    }
  }
  EXPECT_GE(episode.time_s[0], 40.0 / rate_hz_ - 1e-6);
  const ImportNote* found = note(result, "missing set points: those before them stay in force");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->count, 60);
}

// A driver that logs each set point on its own: two rows of one time hold both.
TEST_F(SetpointImport, TakesTheLastOfSetPointsThatWereGivenAtOneTime) {
  const std::string text = log();
  const std::size_t begin = text.find("\n2.000000,") + 1;
  const std::size_t poses = text.find(',', text.find(',', text.find(',', begin + 9) + 1) + 1);
  const std::string seen = text.substr(poses, text.find('\n', begin) - poses);
  const Eigen::Vector3d told = truth_.pressures(2.0);
  const std::string rows = fmt::format("2.000000,1,{:.6f},{:.6f}{}\n2.000000,{:.6f},,{}\n", told[1],
                                       told[2], seen, told[0], seen);
  const std::string apart = text.substr(0, begin) + rows + text.substr(text.find('\n', begin) + 1);
  EXPECT_EQ(import(apart, setpoints_mapping()).recording.episodes.front().setpoint_kpa,
            import(text, setpoints_mapping()).recording.episodes.front().setpoint_kpa);
}

TEST_F(SetpointImport, OfDefaultColumnsIsToldByTheirNames) {
  const std::string without_commands = mapping().substr(0, mapping().find("pressures:")) +
                                       mapping().substr(mapping().find("backbone:"));
  std::string named = log();
  for (int i = 1; i <= 3; ++i) {
    named = replaced(named, fmt::format("pressure_{}_kpa", i), fmt::format("setpoint_{}_kpa", i));
  }
  expect_held(import(named, without_commands).recording);
  EXPECT_FALSE(import(log(), without_commands).recording.setpoints_only());
}

std::vector<int> SetpointImport::motions_of(const std::function<double(double)>& given_s) {
  const std::string text = LogTruth::table(header(), 4000, 100.0, [&](double t) {
    return truth_.pressure_cells(given_s(t)) + pose_cells(given_s(t));
  });
  return import(text, setpoints_mapping()).recording.episodes.front().motion_index;
}

// Four of a second, every ten seconds: slower than the frames, set points stand for some of them.
TEST_F(SetpointImport, AMotionGoesOnWhileSetPointsDo) {
  for (const double period_s : {0.1, 0.15}) {
    const std::vector<int> motions = motions_of([&](double t) {
      const double begin_s = 10.0 * std::floor(t / 10.0);
      return begin_s + period_s * std::floor(std::min(t - begin_s, 1.0) / period_s + 1e-9);
    });
    EXPECT_EQ(motions.back(), 4) << period_s;
    EXPECT_EQ(motions[199], 1) << period_s;
    EXPECT_EQ(motions[200], 2) << period_s;
  }
}

// As often, but to another side each time.
TEST_F(SetpointImport, EachStepIsAMotionHoweverShortItIsHeld) {
  constexpr double kHeld_s = 0.2;
  const std::vector<int> motions = motions_of([&](double t) {
    const double begin_s = 10.0 * std::floor(t / 10.0);
    return begin_s + 3.0 * std::min(std::floor((t - begin_s) / kHeld_s + 1e-9), 2.0);
  });
  EXPECT_EQ(motions.back(), 11) << "three in ten seconds, and the first begins the log";
  EXPECT_EQ(motions[8], motions[4] + 1);
}

// Written where they change alone, in rows of which frames pass over some.
TEST_F(SetpointImport, HoldsThemOverEmptyCellsAlsoBesideMeasuredOnes) {
  constexpr int kEvery = 7;  // rows
  std::string text = header().substr(0, header().find(",x0")) + ",s1,s2,s3" +
                     header().substr(header().find(",x0")) + "\n";
  for (int k = 0; k < rows_; ++k) {
    const double t = k / rate_hz_;
    const Eigen::Vector3d p = truth_.pressures(t);
    const std::string cells = fmt::format(",{:.6f},{:.6f},{:.6f}", p[0], p[1], p[2]);
    text += fmt::format("{:.6f}", t) + cells + (k % kEvery == 0 ? cells : ",,,") + pose_cells(t);
    text += "\n";
  }
  const Recording recording =
      import(text, replaced(mapping(), "backbone:", "  setpoints: [s1, s2, s3]\nbackbone:"))
          .recording;
  const Episode& episode = recording.episodes.front();
  EXPECT_FALSE(recording.setpoints_only());
  for (Eigen::Index t = 0; t < episode.time_s.size(); ++t) {
    const double row = std::floor(episode.time_s[t] * rate_hz_ + 1e-6);
    const double written = kEvery * std::floor(row / kEvery);
    for (Eigen::Index i = 0; i < 3; ++i) {
      EXPECT_NEAR(double(episode.setpoint_kpa(t, i)), truth_.pressures(written / rate_hz_)[i],
                  kSingle);
    }
  }
}

// Beside what was measured, in another unit.
TEST_F(SetpointImport, RefusesSetPointsFarBeyondTheLimitsAlsoBesideMeasuredOnes) {
  std::string text = header().substr(0, header().find(",x0")) + ",s1,s2,s3" +
                     header().substr(header().find(",x0")) + "\n";
  for (int k = 0; k < rows_; ++k) {
    const double t = k / rate_hz_;
    const Eigen::Vector3d p = truth_.pressures(t);
    text += fmt::format("{:.6f},{:.6f},{:.6f},{:.6f},{:.2f},{:.2f},{:.2f}", t, p[0], p[1], p[2],
                        1e3 * p[0], 1e3 * p[1], 1e3 * p[2]) +
            pose_cells(t) + "\n";
  }
  expect_refusal(text, replaced(mapping(), "backbone:", "  setpoints: [s1, s2, s3]\nbackbone:"),
                 {"'s1' (segment 0) reaches", "the limit of arm"});
}

TEST_F(SetpointImport, RefusesMappingsThatContradictThemselves) {
  expect_refusal(log(), replaced(setpoints_mapping(), "pressures:", "pressures:\n  measured: true"),
                 {"measured", "'setpoints' alone name nothing that was measured"});
  const std::string both = replaced(mapping(), "backbone:",
                                    "  setpoints: [pressure_1_kpa, pressure_2_kpa, "
                                    "pressure_3_kpa]\n  measured: false\nbackbone:");
  expect_refusal(log(), both, {"measured", "'setpoints' beside other columns"});
  expect_refusal(log(), replaced(mapping(), "  columns:", "  right:"),
                 {"pressures", "or 'setpoints' alone, where nothing was measured"});
  expect_refusal(log(), mapping() + "commands: {columns: [a, b, c]}\n",
                 {"commands", "stands beside pressures"});
}

// What would fit is said in the words of the mapping.
TEST_F(SetpointImport, RefusesMirroredSetPointsInTheMappingsWords) {
  rows_ = 2000;
  pressure_scale_ = -1.0;
  expect_refusal(log(), setpoints_mapping(),
                 {"What would fit: 'setpoints: [-pressure_1_kpa, -pressure_2_kpa"});
}

}  // namespace
}  // namespace limber
