#include "limber/data/log_import.hpp"

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "support/log_truth.hpp"
#include "support/sample_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::ThrowsMessage;

constexpr double kWritten = 2e-6;  // [m], [rad]: logs have six digits, frames are single precision
constexpr double kTangent_rad = 2e-3;  // headings from chords written with six digits

/// A folder with a generic CSV of a three-segment arm and its mapping, both open to changes.
class CsvImport : public ::testing::Test {
 protected:
  explicit CsvImport(int segments = 3) : truth_(sample_arm(segments)) {
    rows_ = 600;
    rate_hz_ = 100.0;
    for (int p = 0; p < truth_.arm().point_count(); ++p) {
      plates_.push_back(p);
    }
  }

  std::string pose_cells(double time_s) const {
    const BackboneD b = truth_.backbone(time_s);
    const double c = std::cos(turn_rad_);
    const double s = std::sin(turn_rad_);
    std::string text;
    for (const int p : plates_) {
      text +=
          fmt::format(",{:.8f},{:.8f}", length_scale_ * (shift_m_[0] + c * b(p, 0) - s * b(p, 1)),
                      length_scale_ * (shift_m_[1] + s * b(p, 0) + c * b(p, 1)));
      if (headings_) {
        // As trackers give it: wrapped.
        text += fmt::format(",{:.8f}", std::remainder(b(p, 2) + turn_rad_, 2.0 * M_PI));
      }
    }
    return text;
  }

  std::string header() const {
    std::string text = "time_s" + truth_.pressure_names();
    for (const int p : plates_) {
      text += fmt::format(",x{0},y{0}{1}", p, headings_ ? fmt::format(",theta{}", p) : "");
    }
    return text;
  }

  std::string log() const {
    return LogTruth::table(header(), rows_, rate_hz_, [&](double t) {
      return truth_.pressure_cells(t, pressure_scale_) + pose_cells(t);
    });
  }

  std::string mapping() const {
    std::string text = "schema: limber/import/1\ntime: {column: time_s}\npressures:\n  columns: [";
    for (int i = 1; i <= truth_.arm().segment_count(); ++i) {
      text += fmt::format("{}pressure_{}_kpa", i > 1 ? ", " : "", i);
    }
    text += "]\nbackbone:\n  points:\n";
    for (const int p : plates_) {
      text += fmt::format("    - {{plate: {0}, x: x{0}, y: y{0}{1}}}\n", p,
                          headings_ ? fmt::format(", theta: theta{}", p) : "");
    }
    return text;
  }

  ImportResult import(const std::string& log_text, const std::string& mapping_text) const {
    write_file_atomically(folder_.path() / "run.csv", log_text);
    write_file_atomically(folder_.path() / "map.yaml", mapping_text);
    ImportOptions options;
    options.mapping = read_import_mapping(folder_.path() / "map.yaml", truth_.arm());
    return import_csv({folder_.path() / "run.csv"}, options, truth_.arm());
  }

  void expect_refusal(const std::string& log_text, const std::string& mapping_text,
                      const std::vector<std::string>& parts) const {
    try {
      import(log_text, mapping_text);
      ADD_FAILURE() << "nothing was refused; expected: " << parts.front();
    } catch (const InputError& error) {
      for (const std::string& part : parts) {
        EXPECT_THAT(error.what(), HasSubstr(part));
      }
    }
  }

  /// Largest difference of a frame's numbers from the truth: {position, heading}.
  std::pair<double, double> errors(const Episode& episode) const {
    double position = 0.0;
    double heading = 0.0;
    for (Eigen::Index t = 0; t < episode.time_s.size(); ++t) {
      const BackboneD b = truth_.backbone(episode.time_s[t]);
      for (Eigen::Index p = 0; p < b.rows(); ++p) {
        const auto pose = episode.backbone.row(t).segment<3>(3 * p).cast<double>();
        position = std::max(position, (pose.head<2>() - b.row(p).head<2>()).norm());
        heading = std::max(heading, std::abs(pose[2] - b(p, 2)));
      }
    }
    return {position, heading};
  }

  static std::string without_line(std::string text, const std::string& beginning) {
    const std::size_t begin = text.find("\n" + beginning) + 1;
    return text.erase(begin, text.find('\n', begin) + 1 - begin);
  }

  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
  }

  static const ImportNote* note(const ImportResult& result, const std::string& part) {
    for (const ImportNote& found : result.report.runs.front().notes) {
      if (found.what.find(part) != std::string::npos) {
        return &found;
      }
    }
    return nullptr;
  }

  TemporaryFolder folder_;
  LogTruth truth_;
  int rows_;
  double rate_hz_;
  std::vector<int> plates_;
  bool headings_ = true;
  double length_scale_ = 1.0;
  double pressure_scale_ = 1.0;
  double turn_rad_ = 0.0;
  Eigen::Vector2d shift_m_ = Eigen::Vector2d::Zero();
};

TEST_F(CsvImport, GivesThePosesOfTheLogAtTheArmsRate) {
  const ImportResult result = import(log(), mapping());
  ASSERT_THAT(result.recording.episodes, SizeIs(1));
  const Episode& episode = result.recording.episodes[0];
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

TEST_F(CsvImport, TurnsUnitsAndSigns) {
  length_scale_ = 1e3;
  pressure_scale_ = -1.0 / 6.894757;
  std::string map =
      replaced(mapping(), "  columns: [pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]",
               "  unit: psi\n  columns: [-pressure_1_kpa, -pressure_2_kpa, "
               "-pressure_3_kpa]");
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

/// The log with the cells of one plate emptied in rows [from, to).
std::string hidden(const std::string& text, std::size_t column, int from, int to) {
  std::string result;
  std::size_t begin = 0;
  for (int row = -1; begin < text.size(); ++row) {
    const std::size_t end = text.find('\n', begin);
    std::string line = text.substr(begin, end - begin);
    if (row >= from && row < to) {
      std::size_t place = 0;
      for (std::size_t c = 0; c < column; ++c) {
        place = line.find(',', place) + 1;
      }
      line.erase(place, line.find(',', place) - place);
    }
    result += line + "\n";
    begin = end + 1;
  }
  return result;
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
  EXPECT_LT(result.report.runs.front().points[9].seen, 0.99);
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
  std::string text = "time_s";
  for (int i = 1; i <= 3; ++i) {
    text += fmt::format(",r{0},l{0}", i);
  }
  text += header().substr(header().find(",x0")) + "\n";
  for (int k = 0; k < rows_; ++k) {
    const double t = k / rate_hz_;
    text += fmt::format("{:.6f}", t);
    for (const double p : truth_.pressures(t)) {
      text += fmt::format(",{:.6f},{:.6f}", std::max(p, 0.0), std::max(-p, 0.0));
    }
    text += pose_cells(t) + "\n";
  }
  const std::string map =
      replaced(mapping(), "columns: [pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]",
               "right: [r1, r2, r3]\n  left: [l1, l2, l3]");
  EXPECT_NEAR(import(text, map).recording.episodes.front().pressure_kpa(30, 2),
              truth_.pressures(1.5)[2], 1e-3);
  expect_refusal(replaced(text, "0.000000,0.000000,", "0.000000,80.0,70.0,"), map,
                 {"line", "one side at a time"});
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
  EXPECT_THAT(found->first, AllOf(HasSubstr("line 252"), HasSubstr("'ERROR' is no number")));
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

// ---- bad input, each with what to do

TEST_F(CsvImport, FindsShuffledTime) {
  std::string text = header() + "\n";
  for (int k = 0; k < rows_; ++k) {
    const double t = (k * 7 % rows_) / rate_hz_;
    text += fmt::format("{:.6f}{}{}\n", t, truth_.pressure_cells(t), pose_cells(t));
  }
  expect_refusal(text, mapping(), {"run.csv", "time goes back", "Rows that were shuffled"});
}

TEST_F(CsvImport, FindsConstantPressures) {
  pressure_scale_ = 1e-3;
  expect_refusal(log(), mapping(), {"no pressure ever changes by more than 2 %", "is it in MPa?"});
}

TEST_F(CsvImport, FindsThreeFrames) {
  rows_ = 15;
  expect_refusal(log(), mapping(), {"nothing is left", "A longer recording is needed"});
}

TEST_F(CsvImport, FindsMarkersThatWereNeverSeen) {
  expect_refusal(hidden(log(), 4 + 3 * 9, 0, rows_), mapping(),
                 {"'x9' (plate 9) is never seen", "Leave it out of the mapping"});
}

TEST_F(CsvImport, FindsDuplicatedColumns) {
  expect_refusal(replaced(log(), ",x4,", ",x3,"), mapping(),
                 {"column 'x3' is there twice, as columns 14 and 17"});
  expect_refusal(log(), replaced(mapping(), "x: x4, y: y4", "x: x3, y: y3"),
                 {"points[4]", "the same source as point 3"});
}

TEST_F(CsvImport, FindsWrongAndMixedUnits) {
  length_scale_ = 1e3;
  expect_refusal(log(), mapping(), {"15 of 15 distances", "reads lengths in m: is it in mm?"});
  length_scale_ = 1.0;
  pressure_scale_ = 1.0 / 100.0;
  expect_refusal(log(), mapping(), {"no pressure ever changes", "is it in bar?"});
  pressure_scale_ = 10.0;
  expect_refusal(log(), mapping(),
                 {"'pressure_1_kpa' (segment 0) reaches", "the limit of arm 'sample3' is 100 kPa",
                  "is it in mbar?"});
  pressure_scale_ = 1.0;
  expect_refusal(log(), replaced(mapping(), "{column: time_s}", "{column: time_s, unit: us}"),
                 {"can't be motion capture: is the time in another unit than 'us'?"});
}

TEST_F(CsvImport, FindsPointsInAnotherOrder) {
  std::string map = mapping();
  map = replaced(map, "x: x4, y: y4, theta: theta4", "x: xx, y: yy, theta: tt");
  map = replaced(map, "x: x9, y: y9, theta: theta9", "x: x4, y: y4, theta: theta4");
  map = replaced(map, "x: xx, y: yy, theta: tt", "x: x9, y: y9, theta: theta9");
  expect_refusal(log(), map, {"are the points in order, base first, and all in one unit?"});
}

TEST_F(CsvImport, FindsALogSlowerThanTheArm) {
  rate_hz_ = 10.0;
  expect_refusal(log(), mapping(), {"10 rows a second", "set frame_rate_hz of the arm file"});
}

TEST_F(CsvImport, FindsTurnedSigns) {
  pressure_scale_ = -1.0;
  expect_refusal(log(), mapping(), {"bends to the other side", "Put a '-' before"});
}

TEST_F(CsvImport, NotesASegmentThatDoesNotFollow) {
  const std::string map = replaced(mapping(), "columns: [pressure_1_kpa, pressure_2_kpa,",
                                   "columns: [pressure_1_kpa, other,");
  std::string text = replaced(log(), ",pressure_2_kpa", ",other");
  std::string result = text.substr(0, text.find('\n') + 1);
  std::size_t begin = result.size();
  for (int k = 0; begin < text.size(); ++k) {
    const std::size_t end = text.find('\n', begin) + 1;
    const std::size_t first = text.find(',', text.find(',', begin) + 1) + 1;
    const std::size_t last = text.find(',', first);
    result += text.substr(begin, first - begin) + fmt::format("{:.4f}", 50 * std::sin(0.09 * k)) +
              text.substr(last, end - last);
    begin = end;
  }
  const ImportResult imported = import(result, map);
  const ImportNote* found = note(imported, "hardly follows its command");
  ASSERT_NE(found, nullptr);
  EXPECT_THAT(found->first, HasSubstr("segment 1"));
}

TEST_F(CsvImport, NamesColumnsThatAreNotThere) {
  expect_refusal(log(), replaced(mapping(), "x: x4", "x: p4_x"),
                 {"there is no column 'p4_x'", "the file has: time_s, pressure_1_kpa"});
  expect_refusal(without_line("\n" + log(), "time_s").substr(1), mapping(),
                 {"where a header line should be", "columns: [time_s, …]"});
  std::string semicolons = log();
  std::replace(semicolons.begin(), semicolons.end(), ',', ';');
  expect_refusal(semicolons, mapping(), {"separated by semicolons"});
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

TEST_F(CsvImport, RefusesLogsThatDoNotBelongTogether) {
  rows_ = 2000;
  const std::string text = LogTruth::table("time_s" + header().substr(header().find(",x0")), rows_,
                                           rate_hz_, [&](double t) { return pose_cells(t); });
  write_file_atomically(folder_.path() / "run.csv", text);
  write_file_atomically(
      folder_.path() / "p.csv",
      LogTruth::table("time_s" + truth_.pressure_names(), 2000, 100.0, [](double t) {
        return fmt::format(",{:.6f},{:.6f},{:.6f}", 90 * std::sin(11 * t), 90 * std::sin(13 * t),
                           90 * std::sin(17 * t));
      }));
  write_file_atomically(folder_.path() / "map.yaml", mapping());
  ImportOptions options;
  options.mapping = read_import_mapping(folder_.path() / "map.yaml", truth_.arm());
  options.command_logs = {folder_.path() / "p.csv"};
  EXPECT_THAT([&] { import_csv({folder_.path() / "run.csv"}, options, truth_.arm()); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("can't be told from the motion"), HasSubstr("--time-offset-s"))));
}

}  // namespace
}  // namespace limber
