// Bad logs and mappings, each with what to do about it.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "limber/common/random_stream.hpp"
#include "logs/csv_import.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class LogImportFaults : public CsvImport {};

TEST_F(LogImportFaults, FindsShuffledTime) {
  std::string text = header() + "\n";
  for (int k = 0; k < rows_; ++k) {
    const double t = (k * 7 % rows_) / rate_hz_;
    text += fmt::format("{:.6f}{}{}\n", t, truth_.pressure_cells(t), pose_cells(t));
  }
  expect_refusal(text, mapping(), {"run.csv", "time goes back", "Rows that were shuffled"});
}

TEST_F(LogImportFaults, FindsConstantPressures) {
  pressure_scale_ = 1e-3;
  expect_refusal(log(), mapping(), {"no pressure ever changes by more than 2 %", "is it in MPa?"});
}

TEST_F(LogImportFaults, FindsBodiesThatPointBackwards) {
  headings_ = true;
  EXPECT_NO_THROW(import(log(), mapping()));
  EXPECT_EQ(note(import(log(), mapping()), "headings are turned"), nullptr);
  heading_off_rad_ = 0.2;
  const ImportNote found = *note(import(log(), mapping()), "headings are turned");
  EXPECT_THAT(found.first, HasSubstr("straight_s"));
  for (const double off_rad : {0.5, -M_PI / 2.0, M_PI}) {  // bodies whose x axis points elsewhere
    heading_off_rad_ = off_rad;
    expect_refusal(log(), mapping(),
                   {"run.csv: the headings are", "off the line from each point to the next",
                    "'straight_s'", "'headings: tangent'"});
  }
}

// A body whose markers look alike: half a turn in a single row, and in a part of the take.
TEST_F(LogImportFaults, SettlesHeadingsThatFlip) {
  const Episode good = import(log(), mapping()).recording.episodes.front();
  heading_mistake_rad_ = [](double time_s, int plate) {
    const bool single = plate == 9 && std::abs(time_s - 2.0) < 0.004;
    const bool lasting = plate == 15 && time_s > 3.0 && time_s < 4.0;
    return single || lasting ? M_PI : 0.0;
  };
  const ImportResult result = import(log(), mapping());
  const ImportNote* found = note(result, "headings that jump");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->count, 1 + 99);
  ASSERT_EQ(result.recording.episodes.size(), 1U);
  const Episode& episode = result.recording.episodes.front();
  EXPECT_EQ(episode.untracked_count(), 1);
  constexpr double kTurnOfARow_rad = 0.1;  // which a lasting flip leaves
  EXPECT_LT(errors(episode).second, kTurnOfARow_rad);
  EXPECT_EQ(episode.backbone.topRows(38), good.backbone.topRows(38)) << "before any mistake";
}

TEST_F(LogImportFaults, KeepsRowsThatHideABaseThatStandsStill) {
  const std::string text = log();
  const ImportResult result = import(hidden(text, 4, 200, 300), mapping());
  EXPECT_EQ(result.recording.untracked_count(), 0);
  EXPECT_EQ(result.recording.episodes.size(), 1U);
  EXPECT_LT(errors(result.recording.episodes.front()).first, 1e-5);
  EXPECT_EQ(note(result, "rows that hide the base")->count, 100);
}

TEST_F(LogImportFaults, FindsAnUntrackedBaseInOtherUnits) {
  const double ratio = import(log(), mapping()).report.runs.front().length_ratio;
  plates_.erase(plates_.begin());
  shift_m_ = {0.2, 0.1};
  turn_rad_ = 0.5 * M_PI;
  const auto placed = [&](const char* where) { return mapping() + "alignment: " + where + "\n"; };
  const char* const right = "{x_m: 0.2, y_m: 0.1, heading_rad: 1.5707963}";
  EXPECT_NEAR(import(log(), placed(right)).report.runs.front().length_ratio, ratio, 0.01)
      << "of what was measured, without the first gap";
  expect_refusal(
      log(), placed("{x_m: 200, y_m: 100, heading_rad: 1.5707963}"),
      {"'x1' (plate 1) lies", "where 'alignment' has the base", "x_m and y_m in metres"});
  expect_refusal(log(), placed("{x_m: 0.2, y_m: 0.1, heading_rad: -90}"),
                 {"degrees off the base's heading", "heading_rad in radians"});
  const ImportResult near = import(log(), placed("{x_m: 0.2, y_m: 0.08, heading_rad: 1.5707963}"));
  EXPECT_NE(note(near, "the base is not where the first point has it"), nullptr);
}

TEST_F(LogImportFaults, NumbersNoMotionsInTheNoiseOfAHold) {
  const double frame_hz = truth_.arm().frame_rate_hz;
  for (const double hz : {5.0 * frame_hz, frame_hz}) {  // at the arm's rate frames share rows
    RandomStream random(5, 0);
    const std::string text = LogTruth::table(
        header(), static_cast<int>(40.0 * hz), hz,
        [&](double t) {
          const double held_s = 10.0 * std::floor(t / 10.0) + std::min(std::fmod(t, 10.0), 1.0);
          std::string cells;
          for (int i = 0; i < truth_.arm().segment_count(); ++i) {
            const double half_kpa = truth_.arm().limits_of_channel(i).half_width_kpa();
            cells += fmt::format(",{:.6f}",
                                 truth_.pressures(held_s)[i] + 0.015 * half_kpa * random.normal());
          }
          return cells + pose_cells(held_s);
        },
        0.5 / frame_hz);
    const Episode episode = import(text, mapping()).recording.episodes.front();
    EXPECT_GE(episode.motion_index.back(), 2) << hz;
    EXPECT_LE(episode.motion_index.back(), 5) << hz << ": four motions of a second, then rest";
  }
}

TEST_F(LogImportFaults, KeepsRowsWithoutAnythingWhereRowsAreTheClock) {
  std::string text = log();
  const std::string counted = replaced(mapping(), "time: {column: time_s}", "time: {rate_hz: 100}");
  const auto columns = std::ranges::count(header(), ',');
  std::size_t begin = 0;
  for (int line = 0; line < 260; ++line) {
    const std::size_t end = text.find('\n', begin);
    if (line > 200) {
      text.replace(begin, end - begin, std::string(static_cast<std::size_t>(columns), ','));
    }
    begin = text.find('\n', begin) + 1;
  }
  const Recording recording = import(text, counted).recording;
  ASSERT_EQ(recording.episodes.size(), 2U) << "the arm was not seen in between";
  EXPECT_LT(errors(recording.episodes[1]).first, 1e-3);
}

TEST_F(LogImportFaults, FindsThreeFrames) {
  rows_ = 15;
  expect_refusal(log(), mapping(), {"nothing is left", "A longer recording is needed"});
}

TEST_F(LogImportFaults, FindsMarkersThatWereNeverSeen) {
  expect_refusal(hidden(log(), 4 + 3 * 9, 0, rows_), mapping(),
                 {"'x9' (plate 9) is never tracked", "Leave it out of the mapping"});
}

// As pandas, MATLAB, R, spreadsheets and C write that there is no number.
TEST_F(LogImportFaults, KnowsTheWordsForMissingCells) {
  const std::vector<std::string> words = {"NaN",  "nan",  "-nan", "None", "NONE", "N/A",
                                          "#N/A", "n/a",  "NA",   "<NA>", "NULL", "Null",
                                          "inf",  "-Inf", "INF",  "+inf", "-",    "-Infinity"};
  std::string text = log();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const int row = 20 * (static_cast<int>(i) + 1);
    text = hidden(text, 4 + 3 * 9, row, row + 1, words[i]);
  }
  const ImportResult result = import(text, mapping());
  EXPECT_EQ(note(result, "can't be read"), nullptr);
  EXPECT_NEAR(result.report.runs.front().points[9].tracked_share,
              1.0 - double(words.size()) / double(rows_), 1e-12);
  EXPECT_EQ(result.recording.episodes.size(), 1U);
  expect_refusal(hidden(log(), 4 + 3 * 9, 100, 110, "nowhere"), mapping(),
                 {"10 of 600 rows can't be read", "'nowhere' is not a number"});
}

TEST_F(LogImportFaults, FindsDuplicatedColumns) {
  expect_refusal(replaced(log(), ",x4,", ",x3,"), mapping(),
                 {"column 'x3' is there twice, as column 13 and column 16"});
  expect_refusal(log(), replaced(mapping(), "x: x4, y: y4", "x: x3, y: y3"),
                 {"points[4]", "the same source as point 3"});
}

TEST_F(LogImportFaults, FindsWrongAndMixedUnits) {
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
  expect_refusal(
      log(), replaced(mapping(), "{column: time_s}", "{column: time_s, unit: us}"),
      {"run.csv: column 'time_s', read in us, gives 1e+08 rows per second; expected 19 to 20000",
       "Are its times in s?"});
}

TEST_F(LogImportFaults, FindsPointsInAnotherOrder) {
  std::string map = mapping();
  map = replaced(map, "x: x4, y: y4, theta: theta4", "x: xx, y: yy, theta: tt");
  map = replaced(map, "x: x9, y: y9, theta: theta9", "x: x4, y: y4, theta: theta4");
  map = replaced(map, "x: xx, y: yy, theta: tt", "x: x9, y: y9, theta: theta9");
  expect_refusal(log(), map, {"are the points in order, base first, and all in one unit?"});
}

TEST_F(LogImportFaults, FindsALogSlowerThanTheArm) {
  rate_hz_ = 10.0;
  expect_refusal(log(), mapping(),
                 {"10 rows per second; expected 19 to", "Is it the column of times?",
                  "set frame_rate_hz of the arm file to at most 10"});
}

TEST_F(LogImportFaults, NamesTheSlowestOfAllLogsAtOnce) {
  const auto written = [&](const char* name, double rate_hz) {
    rate_hz_ = rate_hz;
    write_file_atomically(folder_.path() / name, log());
    return folder_.path() / name;
  };
  const std::vector<std::filesystem::path> logs = {written("a.csv", 30.0), written("b.csv", 12.0),
                                                   written("c.csv", 9.0), written("d.csv", 15.0)};
  write_file_atomically(folder_.path() / "map.yaml", mapping());
  ImportOptions options;
  options.mapping = read_import_mapping(folder_.path() / "map.yaml", truth_.arm());
  EXPECT_THAT([&] { import_csv(logs, options, truth_.arm()); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("3 of 4 logs are slower than arm"), HasSubstr("slowest is"),
                        HasSubstr("c.csv with 9 rows per second"), HasSubstr("at most 9.47"))));
  ArmDescription slower = truth_.arm();
  slower.frame_rate_hz = 9.47;
  EXPECT_NO_THROW(import_csv(logs, options, slower)) << "what the message says is enough";
}

TEST_F(LogImportFaults, ManyLogsGetALineEach) {
  write_file_atomically(folder_.path() / "map.yaml", mapping());
  headings_ = false;
  write_file_atomically(folder_.path() / "run.csv", log());
  std::string map = mapping();
  write_file_atomically(folder_.path() / "map.yaml", map);
  ImportOptions options;
  options.mapping = read_import_mapping(folder_.path() / "map.yaml", truth_.arm());
  const std::vector<std::filesystem::path> logs(12, folder_.path() / "run.csv");
  const std::string text = to_text(import_csv(logs, options, truth_.arm()).report);
  EXPECT_LT(std::count(text.begin(), text.end(), '\n'), 20);
  EXPECT_THAT(text, HasSubstr("12 times in 12 of 12 logs, first: run.csv"));
}

TEST_F(LogImportFaults, FindsTurnedSigns) {
  pressure_scale_ = -1.0;
  expect_refusal(log(), mapping(),
                 {"bends to the other side",
                  "What would fit: 'columns: [-pressure_1_kpa, "
                  "-pressure_2_kpa, -pressure_3_kpa]'"});
}

TEST_F(LogImportFaults, NotesASegmentThatDoesNotFollow) {
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
  const std::vector<SegmentCheck>& segments = imported.report.columns;
  ASSERT_EQ(segments.size(), 3U);
  EXPECT_FALSE(segments[0].follows_weakly);
  EXPECT_TRUE(segments[1].follows_weakly);
  EXPECT_THAT(to_text(imported.report), HasSubstr("segment 1 hardly follows its command"));
}

TEST_F(LogImportFaults, NamesColumnsThatAreNotThere) {
  expect_refusal(log(), replaced(mapping(), "x: x4", "x: p4_x"),
                 {"there is no column 'p4_x'", "the file has: time_s, pressure_1_kpa"});
  expect_refusal(without_line("\n" + log(), "time_s").substr(1), mapping(),
                 {"where a header line should be", "columns: [time_s, …]"});
  std::string semicolons = log();
  std::replace(semicolons.begin(), semicolons.end(), ',', ';');
  expect_refusal(semicolons, mapping(), {"separated by semicolons"});
}

TEST_F(LogImportFaults, RefusesWhatItWouldNotRead) {
  expect_refusal(log(), replaced(mapping(), "{column: time_s}", "{column: ''}"),
                 {"time.column", "an empty name found"});
  expect_refusal(log(), replaced(mapping(), "columns: [pressure_1_kpa", "columns: [''"),
                 {"columns[0]", "an empty name found"});
  expect_refusal(log(), replaced(mapping(), "x: x4, y: y4, theta", "body: P4, theta"),
                 {"points[4].theta: unknown key"});
  expect_refusal(log(), replaced(mapping(), "pressures:\n", "pressures:\n  right: [a, b, c]\n"),
                 {"both 'right' and 'left'"});
  expect_refusal(
      log(),
      replaced(mapping(), "pressures:\n", "pressures:\n  time: {column: valves, unit: ms}\n"),
      {"the commands' times in 'valves' (ms)", "in one log", "--pressures"});
}

TEST_F(LogImportFaults, RefusesLogsThatDoNotBelongTogether) {
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
              ThrowsMessage<InputError>(AllOf(HasSubstr("can't be told from the motion"),
                                              HasSubstr("best candidate is --time-offset-s"))));
}

}  // namespace
}  // namespace limber
