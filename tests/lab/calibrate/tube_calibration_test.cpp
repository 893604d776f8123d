#include "limber/lab/tube_calibration.hpp"

#include <functional>

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(CalibrationSettings, ThoseOfTheProgramAreUsable) {
  EXPECT_NO_THROW(require_usable(CalibrationSettings()));
}

TEST(CalibrationSettings, ThoseThatCanGiveNothingAreRefused) {
  const struct {
    const char* message;
    std::function<void(CalibrationSettings&)> change;
  } cases[] = {
      {"--shape-runs 1", [](CalibrationSettings& s) { s.scale_runs = 1; }},
      {"--audit-runs -1", [](CalibrationSettings& s) { s.audit_runs = -1; }},
      {"--levels: expected rising shares", [](CalibrationSettings& s) { s.levels = {}; }},
      {"--levels: expected rising shares",
       [](CalibrationSettings& s) {
         s.levels = {0.9, 0.9};
       }},
      {"--levels: a share of 1: expected",
       [](CalibrationSettings& s) {
         s.levels = {0.9, 1.0};
       }},
      {"--confidence: a share of 0: expected", [](CalibrationSettings& s) { s.confidence = 0.0; }},
      {"--test-runs 79: so few can't show a level of 0.95: at least 80",
       [](CalibrationSettings& s) { s.test_runs = 79; }},
      {"--screen-runs 13: so few can't show a level of 0.95: at least 14",
       [](CalibrationSettings& s) { s.screen_runs = 13; }},
  };
  for (const auto& one : cases) {
    CalibrationSettings settings;
    one.change(settings);
    EXPECT_THAT([&] { require_usable(settings); },
                ThrowsMessage<InputError>(HasSubstr(one.message)));
  }
}

// Recordings can't give such levels either, and two of the same run are one.
TEST(RecordedCalibration, RefusesWhatCanGiveNothingBeforeReadingARecording) {
  const TemporaryFolder folder;
  RecordedCalibration settings;
  for (const char* name : {"a.h5", "b.h5"}) {
    write_file_atomically(folder.path() / name, "the same");
    settings.recordings.push_back(folder.path() / name);
    settings.plans.push_back(folder.path() / "p.json");
  }
  EXPECT_THAT([&] { (void)tube_from_recordings(settings); },
              ThrowsMessage<InputError>(HasSubstr("b.h5: the same recording as ")));
  settings.levels = {1.0};
  EXPECT_THAT([&] { (void)tube_from_recordings(settings); },
              ThrowsMessage<InputError>(HasSubstr("a share of 1: expected")));
  settings.levels = {0.5};
  settings.confidence = 0.0;
  EXPECT_THAT([&] { (void)tube_from_recordings(settings); },
              ThrowsMessage<InputError>(HasSubstr("a share of 0: expected")));
}

// The keys of a calibration's phases, as docs/tube.md and tools/tube_figures.py read them.
TEST(TubeRuns, CountOnlyWhatWasExecuted) {
  TubeRuns runs;
  for (int k = 0; k < 10; ++k) {
    TubeRun run;
    run.number = static_cast<std::uint64_t>(k);
    run.status = k < 8 ? "solved" : k < 9 ? "limit" : "no_environment";
    run.executed = k < 7;
    run.score = 0.25 * k;
    run.cost_kpa = 100.0;
    run.first_solution_s = 0.001 * k;
    run.collided = k == 6;
    run.reached = k < 5;
    runs.all.push_back(run);
  }
  EXPECT_EQ(runs.executed(), 7);
  EXPECT_EQ(runs.solved(), 8);
  EXPECT_EQ(runs.outside(1.0), 2);   // 1.25 and 1.5; a score of 1.75 was never executed
  EXPECT_EQ(runs.outside(1.25), 1);  // on the rim is inside
  const nlohmann::ordered_json json = to_json(runs, 1.0);
  EXPECT_EQ(json["environments"], 9);
  EXPECT_EQ(json["solved"], 8);
  EXPECT_EQ(json["runs"], 7);
  EXPECT_EQ(json["outside"], 2);
  EXPECT_EQ(json["collided"], 1);
  EXPECT_EQ(json["reached"], 5);
  EXPECT_NEAR(json["coverage"]["share"].get<double>(), 5.0 / 7.0, 1e-12);
  // Clopper–Pearson of 2 in 7, from tables.
  EXPECT_NEAR(json["coverage"]["low"].get<double>(), 1.0 - 0.7096, 1e-4);
  EXPECT_NEAR(json["coverage"]["high"].get<double>(), 1.0 - 0.0367, 1e-4);
  EXPECT_NEAR(json["first_solution_s_median"].get<double>(), 0.003, 1e-12);
}

}  // namespace
}  // namespace limber
