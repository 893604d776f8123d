// Clocks in another unit than the mapping says, clocks that jump, clocks of another day.
#include <limits>

#include <gmock/gmock.h>

#include "logs/csv_import.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr double kRate_hz = 50.0;   // of the pressure log
constexpr double kEpoch_s = 1.7e9;  // its clock, where it is the system's
// An epoch in float64 has 0.2 µs; the match itself is good to some ms (clock_match.hpp).
constexpr double kMatched_s = 0.05;

/// A motion log, and pressures on a clock of their own.
class LogClock : public CsvImport {
 protected:
  LogClock() { rows_ = 2000; }  // 20 s at 100 Hz

  /// Pressures at `start_s` … of the motion log's clock, their times as `stamp` writes them.
  std::string pressures(const std::function<std::string(double)>& stamp, int rows = 1000) const {
    std::string text = "time_s" + truth_.pressure_names() + "\n";
    for (int k = 0; k < rows; ++k) {
      const double time_s = k / kRate_hz;
      text += stamp(time_s) + truth_.pressure_cells(time_s) + "\n";
    }
    return text;
  }

  static std::function<std::string(double)> in_unit(double per_second, double epoch_s = 0.0) {
    return [=](double time_s) { return fmt::format("{:.0f}", (epoch_s + time_s) * per_second); };
  }

  ImportResult import_both(const std::string& command_log, std::optional<double> offset_s,
                           const std::string& unit = "s") const {
    const std::string motion =
        LogTruth::table("time_s" + header().substr(header().find(",x0")), rows_, rate_hz_,
                        [&](double t) { return pose_cells(t); });
    write_file_atomically(folder_.path() / "run.csv", motion);
    write_file_atomically(folder_.path() / "p.csv", command_log);
    write_file_atomically(folder_.path() / "map.yaml",
                          replaced(mapping(), "pressures:\n",
                                   "pressures:\n  time: {column: time_s, unit: " + unit + "}\n"));
    ImportOptions options;
    options.mapping = read_import_mapping(folder_.path() / "map.yaml", truth_.arm());
    options.command_logs = {folder_.path() / "p.csv"};
    options.time_offset_s = offset_s;
    return import_csv({folder_.path() / "run.csv"}, options, truth_.arm());
  }

  void expect_refused(const std::string& command_log, std::optional<double> offset_s,
                      const std::vector<std::string>& parts) const {
    try {
      import_both(command_log, offset_s);
      ADD_FAILURE() << "nothing was refused; expected: " << parts.front();
    } catch (const InputError& error) {
      for (const std::string& part : parts) {
        EXPECT_THAT(error.what(), HasSubstr(part));
      }
    }
  }
};

TEST_F(LogClock, RefusesTimesInAnotherUnitWithAGuess) {
  struct Case {
    const char* unit;
    double per_second;
    const char* rate;
  };
  for (const auto& [unit, per_second, rate] :
       {Case{"ms", 1e3, "0.05"}, Case{"us", 1e6, "5e-05"}, Case{"ns", 1e9, "5e-08"}}) {
    for (const double epoch_s : {0.0, kEpoch_s}) {
      for (const std::optional<double> offset_s : {std::optional<double>(), {0.0}}) {
        expect_refused(
            pressures(in_unit(per_second, epoch_s)), offset_s,
            {fmt::format("p.csv: column 'time_s', read in s, gives {} rows per second", rate),
             "expected 19 to 20000", fmt::format("Are its times in {}?", unit),
             fmt::format("{{column: time_s, unit: {}}}", unit)});
      }
    }
  }
}

// 19.6 Hz in s, read in ms, are 19.6 kHz: no logger gives that for a second.
TEST_F(LogClock, RefusesSecondsReadAsMilliseconds) {
  const std::string log = pressures([](double t) { return fmt::format("{:.6f}", 2.55 * t); });
  for (const std::optional<double> offset_s : {std::optional<double>(), {0.0}}) {
    EXPECT_THAT(
        [&] { import_both(log, offset_s, "ms"); },
        ::testing::ThrowsMessage<InputError>(::testing::AllOf(
            HasSubstr("p.csv: column 'time_s', read in ms, gives 1.961e+04 rows per second"),
            HasSubstr("more than 2000 only in logs of 10 s or more; this is 0.05095 s long"),
            HasSubstr("Are its times in s?"))));
  }
}

TEST_F(LogClock, ReadsThoseUnitsWhereTheMappingSaysSo) {
  for (const auto& [unit, per_second] :
       {std::pair{"ms", 1e3}, std::pair{"us", 1e6}, std::pair{"ns", 1e9}}) {
    const ImportResult result = import_both(pressures(in_unit(per_second)), {}, unit);
    EXPECT_NEAR(result.report.runs[0].clock->offset_s, 0.0, kMatched_s);
  }
}

TEST_F(LogClock, TakesAnEpochInSeconds) {
  const auto stamp = [](double time_s) { return fmt::format("{:.6f}", kEpoch_s + 3.5 + time_s); };
  for (const std::optional<double> offset_s : {std::optional<double>(), {-kEpoch_s - 3.5}}) {
    const ImportResult result = import_both(pressures(stamp), offset_s);
    EXPECT_NEAR(result.report.runs[0].clock->offset_s, -kEpoch_s - 3.5, kMatched_s);
    ASSERT_THAT(result.recording.episodes, SizeIs(1));
    EXPECT_GT(result.recording.episodes[0].frame_count(), 390);
  }
}

TEST_F(LogClock, RefusesNumbersNoClockHas) {
  const auto huge = [](double time_s) { return fmt::format("{:.4e}", 1e300 * (1.0 + time_s)); };
  const auto steep = [](double time_s) { return fmt::format("{:.0f}", 1e18 + time_s * 5e16); };
  for (const std::optional<double> offset_s : {std::optional<double>(), {0.0}}) {
    expect_refused(pressures(huge), offset_s, {"rows per second", "Is it the column of times?"});
    expect_refused(pressures(steep), offset_s, {"1e-15 rows per second"});
  }
}

TEST_F(LogClock, RefusesAClockThatJumps) {
  const auto jumps = [](double time_s) {
    return fmt::format("{:.3f}", time_s < 10.0 ? time_s : kEpoch_s + time_s);
  };
  expect_refused(
      pressures(jumps), 0.0,
      {"p.csv: column 'time_s', read in s, gives 50 rows per second, so its 1000 rows are "
       "20 s long, but they reach over 1.7e+09 s",
       "9.98 s is followed by 1700000010 s"});
  // The same in a log of both.
  std::string text = log();
  text += fmt::format("1e300{}{}\n", truth_.pressure_cells(20.0), pose_cells(20.0));
  expect_refusal(text, mapping(), {"run.csv: column 'time_s'", "is followed by 1e+300 s"});
}

TEST_F(LogClock, RefusesPressuresOfASmallPartOfTheMotion) {
  expect_refused(pressures([](double t) { return fmt::format("{:.6f}", t); }, 60), 0.0,
                 {"p.csv: column", "1.18 s in all", "is 19.99 s long: expected 1.999 s to"});
}

TEST_F(LogClock, RefusesOffsetsThatLeaveNothing) {
  const std::string log = pressures([](double t) { return fmt::format("{:.6f}", t); });
  for (const double offset_s : {1e300, -1e300, 1e17, 1e4}) {
    expect_refused(log, offset_s, {"nothing is left"});
  }
  for (const double offset_s :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    expect_refused(log, offset_s, {"expected seconds, a finite number"});
  }
}

// Numbers of motions are compared, never converted: any number, or none, may stand there.
TEST_F(LogClock, TakesAnyNumbersOfMotions) {
  rows_ = 600;
  const std::string numbered = replaced(mapping(), "backbone:\n", "motion: motion\nbackbone:\n");
  const std::string text = LogTruth::table(header() + ",motion", rows_, rate_hz_, [&](double t) {
    const char* motion = t < 2.0 ? "-1e300" : t < 3.0 ? "nan" : t < 4.0 ? "" : "1e300";
    return truth_.pressure_cells(t) + pose_cells(t) + "," + motion;
  });
  const ImportResult result = import(text, numbered);
  ASSERT_THAT(result.recording.episodes, SizeIs(1));
  EXPECT_EQ(result.recording.episodes[0].motion_index.front(), 0);
  EXPECT_EQ(result.recording.episodes[0].motion_index.back(), 1);
}

}  // namespace
}  // namespace limber
