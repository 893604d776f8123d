#include "limber/logs/log_import.hpp"

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "logs/csv_import.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr double kWritten = 2e-6;  // [m], [rad]: logs have six digits, frames are single precision
constexpr double kTangent_rad = 2e-3;  // headings from chords written with six digits

TEST_F(CsvImport, GivesThePosesOfTheLogAtTheArmsRate) {
  const ImportResult result = import(log(), mapping());
  ASSERT_THAT(result.recording.episodes, SizeIs(1));
  const Episode& episode = result.recording.episodes[0];
  EXPECT_EQ(episode.log, result.report.runs[0].name);
  EXPECT_EQ(result.recording.rate_hz, 20.0);
  EXPECT_EQ(episode.frame_count(), 120);  // 5.99 s
  EXPECT_NEAR(episode.time_s[7], 0.35, 1e-12);
  EXPECT_EQ(episode.untracked_count(), 0);
  const auto [position, heading] = errors(episode);
  EXPECT_LT(position, kWritten);
  EXPECT_LT(heading, kWritten);
  EXPECT_NEAR(episode.pressure_kpa(7, 1), truth_.pressures(0.35)[1], 1e-4);
  EXPECT_NO_THROW(validate(result.recording, "imported"));
  EXPECT_EQ(result.recording.arm_hash, truth_.arm().hash());
}

// Files of before count segments from 1; one with a column 0 counts from 0, so that none shifts.
TEST_F(CsvImport, DefaultColumnsCountFrom0UnlessThereIsNoColumn0) {
  const std::size_t at = mapping().find("pressures:");
  const std::string without_commands =
      mapping().substr(0, at) + mapping().substr(mapping().find("backbone:"));
  const auto counted_from_0 = [&](std::string text) {
    for (int i = 0; i < truth_.arm().segment_count(); ++i) {
      text =
          replaced(text, fmt::format("pressure_{}_kpa", i + 1), fmt::format("pressure_{}_kpa", i));
    }
    return text;
  };
  const Recording expected = import(log(), mapping()).recording;
  for (const std::string& text : {log(), counted_from_0(log())}) {
    const Recording found = import(text, without_commands).recording;
    ASSERT_EQ(found.episodes.size(), expected.episodes.size());
    EXPECT_EQ(found.episodes[0].pressure_kpa, expected.episodes[0].pressure_kpa);
  }
}

TEST_F(CsvImport, TurnsUnitsAndSigns) {
  length_scale_ = 1e3;
  pressure_scale_ = -1.0 / 6.894757;
  std::string map =
      replaced(mapping(), "  columns: [pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]",
               "  unit: psi\n  columns: [-pressure_1_kpa, -pressure_2_kpa, -pressure_3_kpa]");
  map = replaced(map, "backbone:\n", "backbone:\n  unit: mm\n");
  map = replaced(map, "{column: time_s}", "{column: time_s, unit: ms}");
  std::string text = header() + "\n";
  for (int k = 0; k < rows_; ++k) {
    const double t = k / rate_hz_;
    text += fmt::format("{:.3f}{}{}\n", 1e3 * t, truth_.pressure_cells(t, pressure_scale_),
                        pose_cells(t));
  }
  const Episode episode = import(text, map).recording.episodes.front();
  EXPECT_EQ(episode.frame_count(), 120);
  EXPECT_LT(errors(episode).first, kWritten);
  EXPECT_NEAR(episode.pressure_kpa(40, 0), truth_.pressures(2.0)[0], 1e-3);
}

TEST_F(CsvImport, FindsTheBaseOfAnArmThatLiesAnywhere) {
  turn_rad_ = 2.5;
  shift_m_ = {-1.25, 3.5};
  const ImportResult result = import(log(), mapping());
  const auto [position, heading] = errors(result.recording.episodes.front());
  EXPECT_LT(position, 5 * kWritten);
  EXPECT_LT(heading, kWritten);
  const RunReport& run = result.report.runs.front();
  EXPECT_NEAR(run.base.x_m, -1.25, kWritten);
  EXPECT_NEAR(run.base.y_m, 3.5, kWritten);
  EXPECT_NEAR(run.base.theta_rad, 2.5, kWritten);
}

TEST_F(CsvImport, ABaseBesideWhereItWasSaidToBeIsSaidAndStandsStill) {
  shift_m_ = {0.108, 0.0};
  const ImportResult result =
      import(log(), mapping() + "alignment: {x_m: 0.1, y_m: 0.0, heading_rad: 0.0}\n");
  EXPECT_EQ(note(result, "the base moves"), nullptr);
  const ImportNote* beside = note(result, "the base lies more than 5 mm from where");
  ASSERT_NE(beside, nullptr);
  EXPECT_EQ(beside->first, "8.0 mm");
  EXPECT_LT(result.report.runs.front().base_scatter_m, 1e-6);
}

// What a line that is skipped holds is nobody's business, a quote that is never closed too.
TEST_F(CsvImport, LinesThatAreSkippedAreLines) {
  const std::string note = "\"Trial 3, rerun\na second line of it\n";
  const Episode episode =
      import(note + log(), mapping() + "skip_lines: 2\n").recording.episodes.front();
  EXPECT_LT(errors(episode).first, kWritten);
}

TEST_F(CsvImport, TakesHeadingsFromTheTangentWhereOnlyPositionsWereLogged) {
  headings_ = false;
  turn_rad_ = -0.7;
  shift_m_ = {0.3, -0.1};
  const ImportResult result = import(log(), mapping());
  const auto [position, heading] = errors(result.recording.episodes.front());
  EXPECT_LT(heading, kTangent_rad);
  EXPECT_LT(position, kTangent_rad * truth_.arm().length_m());
  EXPECT_NE(note(result, "positions only"), nullptr);
}

TEST_F(CsvImport, PutsPlatesWithoutAPointOnTheCurveBetweenTheirNeighbours) {
  plates_ = {0, 2, 5, 8, 10, 13, 15};
  const auto [position, heading] = errors(import(log(), mapping()).recording.episodes.front());
  EXPECT_LT(position, 2 * kWritten) << "an arc is met exactly";
  EXPECT_LT(heading, 2 * kWritten);
}

TEST_F(CsvImport, NeedsOnlyTheSegmentsEndsOfAnArcArm) {
  plates_ = {0, 5, 10, 15};
  headings_ = false;
  std::string map = mapping() + "alignment: none\n";
  const auto [position, heading] = errors(import(log(), map).recording.episodes.front());
  EXPECT_LT(position, 2 * kWritten);
  EXPECT_LT(heading, 2 * kWritten);
}

TEST_F(CsvImport, AddsABaseThatStandsWhereTheMappingSays) {
  plates_.erase(plates_.begin());
  shift_m_ = {1.0, 2.0};
  turn_rad_ = 0.4;
  const std::string fixed = mapping() + "alignment: {x_m: 1.0, y_m: 2.0, heading_rad: 0.4}\n";
  const Episode episode = import(log(), fixed).recording.episodes.front();
  EXPECT_LT(errors(episode).first, 2 * kWritten);
  EXPECT_EQ(episode.backbone.leftCols(3).cwiseAbs().maxCoeff(), 0.0F);
  expect_refusal(log(), mapping(), {"no point is plate 0, the base", "alignment: {x_m, y_m"});
}

TEST_F(CsvImport, TakesHeadingOffsetsFromATimeInWhichTheArmLayStraight) {
  // Straight for two seconds; every plate's heading is off by another constant.
  std::string text = header() + "\n";
  for (int k = 0; k < rows_; ++k) {
    const double t = k / rate_hz_;
    const double then = std::max(0.0, t - 2.0);
    const BackboneD b = t < 2.0 ? [&] {
      BackboneD rest(truth_.arm().point_count(), 3);
      NoLoadModel(truth_.arm()).backbone(Eigen::VectorXd::Zero(3).eval(), rest);
      return rest;
    }() : truth_.backbone(then);
    text += fmt::format("{:.6f}", t);
    for (const double p : t < 2.0 ? Eigen::VectorXd::Zero(3).eval() : truth_.pressures(then)) {
      text += fmt::format(",{:.6f}", p);
    }
    for (const int p : plates_) {
      text += fmt::format(",{:.8f},{:.8f},{:.8f}", -b(p, 1), b(p, 0),  // a quarter turn
                          std::remainder(b(p, 2) + 0.1 * p - 1.0, 2.0 * M_PI));
    }
    text += "\n";
  }
  const ImportResult result = import(text, mapping() + "alignment: {straight_s: [0, 1.9]}\n");
  const Episode& episode = result.recording.episodes.front();
  EXPECT_NEAR(result.report.runs.front().base.theta_rad, 0.5 * M_PI, 1e-6);
  const Eigen::Index last = episode.time_s.size() - 1;
  const BackboneD b = truth_.backbone(episode.time_s[last] - 2.0);
  EXPECT_NEAR(episode.backbone(last, 3 * 15), b(15, 0), 1e-5);
  EXPECT_NEAR(episode.backbone(last, 3 * 15 + 1), b(15, 1), 1e-5);
  EXPECT_NEAR(episode.backbone(last, 3 * 15 + 2), b(15, 2), 1e-5);
}

TEST_F(CsvImport, BridgesShortOcclusionsAndMarksTheirFrames) {
  // x of plate 9, rows 200 … 211: 0.12 s around 2.05 s and 2.10 s.
  const ImportResult result = import(hidden(log(), 4 + 3 * 9, 200, 212), mapping());
  ASSERT_THAT(result.recording.episodes, SizeIs(1));
  const Episode& episode = result.recording.episodes.front();
  EXPECT_EQ(episode.untracked_count(), 3);
  for (const int frame : {40, 41, 42}) {
    EXPECT_EQ(episode.tracked[std::size_t(frame)], 0);
  }
  EXPECT_LT(errors(episode).first, 5e-3) << "a straight line over 0.13 s";
  EXPECT_NE(note(result, "put between its neighbours in time"), nullptr);
  EXPECT_LT(result.report.runs.front().points[9].tracked_share, 0.99);
}

// Some trackers write zeros for a hidden point; the base may well lie at the origin.
TEST_F(CsvImport, TakesZerosOfAPointThatIsElsewhereForHidden) {
  std::string text = log();
  const std::string seen = pose_cells(2.0);
  std::size_t ninth = 0;
  for (int comma = 0; comma < 3 * 9; ++comma) {
    ninth = seen.find(',', ninth + 1);
  }
  const std::size_t tenth = seen.find(',', seen.find(',', seen.find(',', ninth + 1) + 1) + 1);
  text = replaced(text, seen, seen.substr(0, ninth) + ",0,0.0,0" + seen.substr(tenth));
  const ImportResult result = import(text, mapping());
  EXPECT_EQ(result.recording.episodes.front().untracked_count(), 1);
  EXPECT_LT(errors(result.recording.episodes.front()).first, 1e-3);
  const ImportNote* found = note(result, "points of zeros alone");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->count, 1);
  EXPECT_EQ(found->first, "line 202, plate 9");
}

TEST_F(CsvImport, InventsNothingOverLongOcclusions) {
  const ImportResult result = import(hidden(log(), 4 + 3 * 9, 200, 300), mapping());
  ASSERT_THAT(result.recording.episodes, SizeIs(2));
  EXPECT_NEAR(result.recording.episodes[0].time_s.tail<1>()[0], 1.95, 1e-9);
  EXPECT_NEAR(result.recording.episodes[1].time_s[0], 3.0, 1e-9);
  EXPECT_EQ(result.recording.untracked_count(), 0);
  EXPECT_NE(note(result, "gaps too long to bridge"), nullptr);
}

TEST_F(CsvImport, TreatsLostRowsLikeOcclusions) {
  const auto lose = [](const std::string& text, int from, int to) {
    std::string result;
    std::size_t begin = 0;
    for (int row = -1; begin < text.size(); ++row) {
      const std::size_t end = text.find('\n', begin) + 1;
      result += row >= from && row < to ? "" : text.substr(begin, end - begin);
      begin = end;
    }
    return result;
  };
  const ImportResult shortly = import(lose(log(), 199, 207), mapping());
  ASSERT_THAT(shortly.recording.episodes, SizeIs(1));
  EXPECT_EQ(shortly.recording.untracked_count(), 2);  // 2.00 s and 2.05 s
  EXPECT_THAT(import(lose(log(), 199, 300), mapping()).recording.episodes, SizeIs(2));
}

TEST_F(CsvImport, SplitsAtTheRecordingColumn) {
  std::string text = "take," + header() + "\n";
  for (const char* take : {"a", "b"}) {
    for (int k = 0; k < 200; ++k) {
      const double t = k / rate_hz_;
      text += fmt::format("{},{:.6f}{}{}\n", take, t, truth_.pressure_cells(t), pose_cells(t));
    }
  }
  const ImportResult result = import(text, mapping() + "recording: take\n");
  EXPECT_THAT(result.recording.episodes, SizeIs(2));
  EXPECT_EQ(result.report.runs[1].name, "run.csv, b");
  expect_refusal(text, mapping(),
                 {"time goes back 1 times", "named in the mapping as 'recording'"});
}

TEST_F(CsvImport, ReadsOneColumnASide) {
  const std::string text = log_of_sides();
  const std::string map =
      replaced(mapping(), "columns: [pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]",
               "right: [r1, r2, r3]\n  left: [l1, l2, l3]");
  EXPECT_NEAR(import(text, map).recording.episodes.front().pressure_kpa(30, 2),
              truth_.pressures(1.5)[2], 1e-3);
  expect_refusal(replaced(text, "0.000000,0.000000,", "0.000000,80.0,70.0,"), map,
                 {"line", "segment ", "one side at a time", "10 % of the limit"});
}

TEST_F(CsvImport, ReadsHeaderlessSemicolonTablesWithDecimalCommasAndFrameNumbers) {
  std::string names;
  std::string text;
  for (const char c : header()) {
    names += c == ',' ? std::string(", ") : std::string(1, c);
  }
  for (int k = 0; k < rows_; ++k) {
    const double t = k / rate_hz_;
    std::string line = fmt::format("{}{}{}\n", k, truth_.pressure_cells(t), pose_cells(t));
    std::replace(line.begin(), line.end(), ',', ';');
    std::replace(line.begin(), line.end(), '.', ',');
    text += line;
  }
  const std::string map =
      replaced(mapping(), "{column: time_s}", "{column: time_s, unit: frame, rate_hz: 100}") +
      "separator: ';'\ndecimal_comma: true\ncolumns: [" + names + "]\n";
  EXPECT_LT(errors(import(text, map).recording.episodes.front()).first, kWritten);
}

TEST_F(CsvImport, LeavesOutSingleBrokenRowsAndSaysSo) {
  const ImportResult result =
      import(replaced(log(), "\n2.500000,", "\nERROR,") + "5.99,1.0", mapping());
  const ImportNote* found = note(result, "can't be read");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->count, 2);
  EXPECT_THAT(found->first, AllOf(HasSubstr("line 252"), HasSubstr("'ERROR' is not a number")));
}

// Two writers in one file, or a decimal comma: its numbers stand in other columns.
TEST_F(CsvImport, LeavesOutARowWithMoreNumbersThanTheHeaderHasNames) {
  const ImportResult result = import(replaced(log(), "\n2.500000,", "\n2.500000,7,"), mapping());
  const ImportNote* found = note(result, "can't be read");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->count, 1);
  EXPECT_THAT(found->first, AllOf(HasSubstr("line 252: 53 cells"), HasSubstr("expected 52")));
  const std::string remark = replaced(log(), "\n2.510000,", ",touched!\n2.510000,");
  EXPECT_EQ(note(import(remark, mapping()), "can't be read"), nullptr);
}

TEST_F(CsvImport, PassesOverQuotesInComments) {
  const ImportResult result =
      import(replaced(log(), "\n2.500000,", "\n#, \"tube of 5 m\n2.500000,"), mapping());
  EXPECT_EQ(result.report.runs.front().rows, rows_);
  EXPECT_EQ(note(result, "can't be read"), nullptr);
}

// It would be infinite in the recording, and refused there, by another file's name.
TEST_F(CsvImport, LeavesOutARowWithANumberThatNoRecordingHolds) {
  const std::string text = log();
  const std::size_t row = text.find("\n2.500000,") + 1;
  const std::size_t second = text.find(',', row) + 1;
  const std::string cell = text.substr(second, text.find(',', second) - second);
  const ImportResult result =
      import(text.substr(0, second) + "-1e39" + text.substr(second + cell.size()), mapping());
  const ImportNote* found = note(result, "can't be read");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->count, 1);
  EXPECT_THAT(found->first, AllOf(HasSubstr("line 252"), HasSubstr("-1e+39 found; expected")));
}

TEST_F(CsvImport, SortsSingleRowsAndDropsRepeatedTimes) {
  std::string text = log();
  const std::size_t a = text.find("\n3.000000,") + 1;
  const std::size_t b = text.find('\n', a) + 1;
  const std::string row = text.substr(a, b - a);
  text.erase(a, b - a);
  const std::size_t later = text.find("\n3.020000,") + 1;
  text.insert(later, row + row);
  const ImportResult result = import(text, mapping());
  EXPECT_LT(errors(result.recording.episodes.front()).first, kWritten);
  ASSERT_NE(note(result, "sorted by time"), nullptr);
  ASSERT_NE(note(result, "repeat a time"), nullptr);
}

TEST_F(CsvImport, ReadsNumbersOfMotionsFromALogOfCommandsToo) {
  const std::string poses = LogTruth::table("time_s" + header().substr(header().find(",x0")), rows_,
                                            rate_hz_, [&](double t) { return pose_cells(t); });
  write_file_atomically(folder_.path() / "run.csv", poses);
  write_file_atomically(folder_.path() / "map.yaml", mapping() + "motion: number\n");
  ImportOptions options;
  options.mapping = read_import_mapping(folder_.path() / "map.yaml", truth_.arm());
  options.command_logs = {folder_.path() / "p.csv"};
  options.time_offset_s = 0.0;
  for (const bool numbered : {true, false}) {
    write_file_atomically(
        folder_.path() / "p.csv",
        LogTruth::table("time_s" + truth_.pressure_names() + (numbered ? ",number" : ",other"),
                        rows_, rate_hz_, [&](double t) {
                          return truth_.pressure_cells(t) +
                                 fmt::format(",{}", std::floor(t / 2.0 + 1e-9));
                        }));
    const ImportResult result = import_csv({folder_.path() / "run.csv"}, options, truth_.arm());
    EXPECT_EQ(note(result, "no column 'motion'") == nullptr, numbered);
    const std::vector<int>& motions = result.recording.episodes.front().motion_index;
    if (numbered) {
      EXPECT_EQ(motions[39], 0);
      EXPECT_EQ(motions[40], 1);
      EXPECT_EQ(motions.back(), 2);
    }
  }
}

/// Arms of any number of segments, with commands on a clock of their own.
class TwoClocks : public CsvImport, public ::testing::WithParamInterface<int> {
 protected:
  TwoClocks() : CsvImport(GetParam()) {}
};

TEST_P(TwoClocks, AreBroughtTogether) {
  constexpr double kOffset_s = 1234.567;
  constexpr double kFound_s = 2e-3;  // a fifth of the grid that is searched
  rows_ = 2000;
  write_file_atomically(
      folder_.path() / "p.csv",
      LogTruth::table(
          "time_s" + truth_.pressure_names(), 1900, 95.0,
          [&](double t) { return truth_.pressure_cells(t + kOffset_s); }, 1.0 - kOffset_s));
  const std::string text = LogTruth::table("time_s" + header().substr(header().find(",x0")), rows_,
                                           rate_hz_, [&](double t) { return pose_cells(t); });
  write_file_atomically(folder_.path() / "run.csv", text);
  write_file_atomically(folder_.path() / "map.yaml", mapping());
  ImportOptions options;
  options.mapping = read_import_mapping(folder_.path() / "map.yaml", truth_.arm());
  options.command_logs = {folder_.path() / "p.csv"};
  const ImportResult found = import_csv({folder_.path() / "run.csv"}, options, truth_.arm());
  const std::optional<ClockReport>& clock = found.report.runs.front().clock;
  ASSERT_TRUE(clock.has_value());
  EXPECT_TRUE(clock->found);
  EXPECT_NEAR(clock->offset_s, kOffset_s, kFound_s);
  EXPECT_GT(clock->correlation, 0.99);
  EXPECT_LT(errors(found.recording.episodes.front()).first, 2 * kWritten);
  options.time_offset_s = kOffset_s;
  const ImportResult given = import_csv({folder_.path() / "run.csv"}, options, truth_.arm());
  const Episode& episode = given.recording.episodes.front();
  EXPECT_NEAR(episode.time_s[0], 1.0, 1e-9) << "the pressures begin a second later";
  EXPECT_NEAR(episode.pressure_kpa(20, 0), truth_.pressures(episode.time_s[20])[0], 1e-2);
}

INSTANTIATE_TEST_SUITE_P(OfArms, TwoClocks, ::testing::Values(1, 2, 3, 5, 12));

}  // namespace
}  // namespace limber
