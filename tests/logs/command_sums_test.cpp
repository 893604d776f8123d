// Logs of an arm whose commands are not one for each segment: six motors, three segments.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "limber/arm/arm_commands.hpp"
#include "limber/data/recording_export.hpp"
#include "logs/csv_import.hpp"

namespace limber {
namespace {

constexpr double kSixDigits = 1e-4;  // [kPa]: frames are single precision, logs have six digits
constexpr double kPreload = 20.0;    // [kPa], of both tendons of a pair

/// Pairs of motors that pull at one segment each, the second at a smaller share.
class CommandSums : public CsvImport {
 protected:
  CommandSums() {
    ArmDescription arm = sample_arm(3);
    arm.commands = {{"motor_0", {1, 0, 0}},    {"motor_1", {-1, 0, 0}},   {"motor_2", {0, 0.9, 0}},
                    {"motor_3", {0, -0.9, 0}}, {"motor_4", {0, 0, -2.0}}, {"motor_5", {0, 0, 2.0}}};
    truth_ = LogTruth(arm);
  }

  /// What the motors are told at a time, with the preload that moves nothing.
  Eigen::VectorXd motors(double time_s) const {
    return (commands_for(truth_.arm(), truth_.pressures(time_s)).array() + kPreload).matrix();
  }

  static std::string header_of(const std::string& prefix, const std::string& poses) {
    std::string text = "time_s";
    for (int k = 0; k < 6; ++k) {
      text += fmt::format(",{}motor_{}", prefix, k);
    }
    return text + poses;
  }

  std::string motor_log(const std::string& prefix = "") const {
    const std::string poses = header().substr(header().find(",x0"));
    return LogTruth::table(header_of(prefix, poses), rows_, rate_hz_, [&](double t) {
      std::string text;
      for (const double value : motors(t)) {
        text += fmt::format(",{:.6f}", value);
      }
      return text + pose_cells(t);
    });
  }

  std::string motor_mapping(const std::string& columns) const {
    return replaced(mapping(), "pressure_1_kpa, pressure_2_kpa, pressure_3_kpa", columns);
  }

  static constexpr const char* kInOrder = "motor_0, motor_1, motor_2, motor_3, motor_4, motor_5";

  double farthest(const Episode& episode) const {
    double apart = 0.0;
    for (Eigen::Index t = 0; t < episode.time_s.size(); ++t) {
      const Eigen::VectorXd found = episode.pressure_kpa.row(t).cast<double>();
      apart =
          std::max(apart, (found - truth_.pressures(episode.time_s[t])).lpNorm<Eigen::Infinity>());
    }
    return apart;
  }
};

TEST_F(CommandSums, MakeTheSegmentsCommandsOfARecording) {
  const ImportResult result = import(motor_log(), motor_mapping(kInOrder));
  ASSERT_EQ(result.recording.segment_count, 3);
  EXPECT_LT(farthest(result.recording.episodes.front()), 4.0 * kSixDigits);
  const ImportNote* found = note(result, "summed to those of segments");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->first,
            "segment 0 = motor_0 - motor_1, segment 1 = 0.9 motor_2 - 0.9 motor_3, "
            "segment 2 = -2 motor_4 + 2 motor_5");
}

TEST_F(CommandSums, ColumnsAreFoundByTheCommandsNames) {
  const std::string without = without_line(without_line(mapping(), "pressures:"), "  columns:");
  EXPECT_LT(farthest(import(motor_log(), without).recording.episodes.front()), 4.0 * kSixDigits);
  const Recording told = import(motor_log("setpoint_"), without).recording;
  EXPECT_TRUE(told.setpoints_only());
}

TEST_F(CommandSums, ALogOfSegmentsCommandsIsTakenAsItIs) {
  const std::string named = replaced(mapping(), "  columns:", "  of: segments\n  columns:");
  const ImportResult result = import(log(), named);
  EXPECT_LT(farthest(result.recording.episodes.front()), kSixDigits);
  EXPECT_EQ(note(result, "summed"), nullptr);
  const std::string without = without_line(without_line(mapping(), "pressures:"), "  columns:");
  EXPECT_LT(farthest(import(log(), without).recording.episodes.front()), kSixDigits);
}

TEST_F(CommandSums, ExportedRecordingsComeBackToTheBit) {
  const Recording first = import(motor_log(), motor_mapping(kInOrder)).recording;
  export_csv(first, folder_.path() / "out");
  ImportOptions options;
  options.mapping = read_import_mapping(folder_.path() / "out" / "mapping.yaml", truth_.arm());
  const Recording again =
      import_csv({folder_.path() / "out" / "episode_000.csv"}, options, truth_.arm()).recording;
  EXPECT_EQ(again.episodes.front().pressure_kpa, first.episodes.front().pressure_kpa);
}

TEST_F(CommandSums, AnEmptyCellOfSetPointsHoldsThatCommandAlone) {
  std::string told = motor_log("setpoint_");
  told = hidden(told, 1, 100, 200);  // motor 0 says nothing new; motor 1 goes on
  const std::string without = without_line(without_line(mapping(), "pressures:"), "  columns:");
  const Episode episode = import(told, without).recording.episodes.front();
  for (Eigen::Index t = 0; t < episode.time_s.size(); ++t) {
    const double time_s = episode.time_s[t];
    if (time_s > 1.0 + 1e-9 && time_s < 2.0 - 1e-9) {
      const double expected = motors(0.99)[0] - motors(time_s)[1];
      EXPECT_NEAR(double(episode.pressure_kpa(t, 0)), expected, 4.0 * kSixDigits) << time_s;
      EXPECT_NEAR(double(episode.pressure_kpa(t, 1)), truth_.pressures(time_s)[1], 4.0 * kSixDigits)
          << time_s;
    }
  }
}

TEST_F(CommandSums, SetPointsBeyondALimitAreNamedByTheirSum) {
  std::string told = header_of("", "");
  for (int k = 0; k < 6; ++k) {
    told += fmt::format(",setpoint_motor_{}", k);
  }
  told += header().substr(header().find(",x0")) + "\n";
  for (int k = 0; k < rows_; ++k) {
    const double t = k / rate_hz_;
    told += fmt::format("{:.6f}", t);
    for (const double scale : {1.0, 1e3}) {
      for (const double value : motors(t)) {
        told += fmt::format(",{:.6f}", scale * value);
      }
    }
    told += pose_cells(t) + "\n";
  }
  expect_refusal(told, without_line(without_line(mapping(), "pressures:"), "  columns:"),
                 {"'set point of motor_0 - motor_1' (segment 0) reaches", "the limit of arm"});
}

TEST_F(CommandSums, WrongOnesAreRefusedWithTheSumsThatFit) {
  expect_refusal(motor_log(), motor_mapping("motor_2, motor_3, motor_0, motor_1, motor_4, motor_5"),
                 {"not in the segments' order", "Change the mapping, or 'commands' in the arm file",
                  "'segment 0: 0.9 motor_2 - 0.9 motor_3, segment 1: motor_0 - motor_1, segment 2: "
                  "-2 motor_4 + 2 motor_5'"});
  expect_refusal(motor_log(), motor_mapping("motor_1, motor_0, motor_2, motor_3, motor_4, motor_5"),
                 {"a segment bends to the other side", "segment 0: -(motor_0 - motor_1)"});
}

TEST_F(CommandSums, MappingsForThemAreChecked) {
  expect_refusal(motor_log(), motor_mapping("motor_0, motor_1"),
                 {"2 columns found; expected 6, one for each command of arm 'sample3'"});
  expect_refusal(motor_log(),
                 replaced(motor_mapping(kInOrder), "  columns:", "  of: motors\n  columns:"),
                 {"pressures.of: 'motors' found; expected segments or commands"});
  expect_refusal(motor_log(), replaced(motor_mapping(kInOrder), "  columns:", "  right:"),
                 {"pressures.right: the arm's file has 'commands', which are signed"});
  truth_ = LogTruth(sample_arm(3));
  expect_refusal(log(), replaced(mapping(), "  columns:", "  of: commands\n  columns:"),
                 {"expected segments: the arm's file has no 'commands'"});
}

}  // namespace
}  // namespace limber
