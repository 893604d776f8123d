// Whole logs whose columns are not the arm's: what import refuses, and what it says then.
#include <gmock/gmock.h>

#include "limber/common/random_stream.hpp"
#include "logs/csv_import.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double kFrame_s = 0.05;

class ColumnCheck : public CsvImport {
 protected:
  ColumnCheck() { rows_ = 4000; }

  std::string mapping_of(const std::string& columns) const {
    return replaced(mapping(), "[pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]", columns);
  }

  ImportOptions with_two_clocks(const std::string& columns, double offset_s) const {
    write_file_atomically(folder_.path() / "run.csv",
                          LogTruth::table("time_s" + header().substr(header().find(",x0")), rows_,
                                          rate_hz_, [&](double t) { return pose_cells(t); }));
    write_file_atomically(
        folder_.path() / "p.csv",
        LogTruth::table("time_s" + truth_.pressure_names(), rows_, rate_hz_,
                        [&](double t) { return truth_.pressure_cells(t + offset_s); }));
    write_file_atomically(folder_.path() / "map.yaml", mapping_of(columns));
    ImportOptions options;
    options.mapping = read_import_mapping(folder_.path() / "map.yaml", truth_.arm());
    options.command_logs = {folder_.path() / "p.csv"};
    return options;
  }

  std::string refusal(const ImportOptions& options) const {
    try {
      import_csv({folder_.path() / "run.csv"}, options, truth_.arm());
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing was refused";
  }
};

TEST_F(ColumnCheck, SaysWhichOrderWouldFit) {
  expect_refusal(log(), mapping_of("[pressure_3_kpa, pressure_1_kpa, pressure_2_kpa]"),
                 {"not in the segments' order",
                  "What would fit: 'columns: [pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]'"});
}

TEST_F(ColumnCheck, SaysWhichOrderAndSignsWouldFit) {
  expect_refusal(log(), mapping_of("[-pressure_2_kpa, pressure_1_kpa, pressure_3_kpa]"),
                 {"not in the segments' order, and some have the other sign",
                  "'columns: [pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]'"});
}

TEST_F(ColumnCheck, NamesTheOneSegmentThatIsTurned) {
  expect_refusal(log(), mapping_of("[pressure_1_kpa, -pressure_2_kpa, pressure_3_kpa]"),
                 {"a segment bends to the other side",
                  "'columns: [pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]'",
                  "segment 1 1.00 (as given -1.00)"});
}

TEST_F(ColumnCheck, ReportsTheCorrelationOfEverySegment) {
  const ImportResult result = import(log(), mapping());
  ASSERT_EQ(result.report.columns.size(), 3U);
  for (const SegmentCheck& segment : result.report.columns) {
    EXPECT_GT(segment.correlation, 0.95);
    EXPECT_EQ(segment.undecidable, "");
  }
}

TEST_F(ColumnCheck, FindsAPermutationBehindAnotherClock) {
  const std::string message =
      refusal(with_two_clocks("[pressure_2_kpa, -pressure_3_kpa, pressure_1_kpa]", 7.25));
  EXPECT_THAT(message, AllOf(HasSubstr("not in the segments' order"), HasSubstr("7.2"),
                             HasSubstr("[pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]")));
}

TEST_F(ColumnCheck, FindsMirroredSignsBehindAnotherClock) {
  const std::string message =
      refusal(with_two_clocks("[-pressure_1_kpa, -pressure_2_kpa, -pressure_3_kpa]", -3.5));
  EXPECT_THAT(message, AllOf(HasSubstr("bends to the other side"),
                             HasSubstr("[pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]")));
}

// A log that repeats itself has many offsets; the refusal names the best.
TEST_F(ColumnCheck, NamesTheBestOffsetOfALogThatRepeatsItself) {
  ImportOptions options = with_two_clocks("[pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]", 0.0);
  const NoLoadModel model(truth_.arm());
  const auto periodic = [&](double t) {
    return Eigen::Vector3d(80.0 * std::sin(2.0 * t), 70.0 * std::sin(2.0 * t + 1.0),
                           60.0 * std::sin(2.0 * t + 2.0));
  };
  write_file_atomically(
      folder_.path() / "run.csv",
      LogTruth::table(
          "time_s" + header().substr(header().find(",x0")), rows_, rate_hz_, [&](double t) {
            BackboneD poses(truth_.arm().point_count(), 3);
            const Eigen::VectorXd q = periodic(t);
            model.backbone(Eigen::Ref<const Eigen::VectorXd>(q), Eigen::Ref<BackboneD>(poses));
            std::string cells;
            for (const int p : plates_) {
              cells += fmt::format(",{:.8f},{:.8f},{:.8f}", poses(p, 0), poses(p, 1), poses(p, 2));
            }
            return cells;
          }));
  write_file_atomically(
      folder_.path() / "p.csv",
      LogTruth::table("time_s" + truth_.pressure_names(), rows_, rate_hz_, [&](double t) {
        const Eigen::Vector3d q = periodic(t);
        return fmt::format(",{:.6f},{:.6f},{:.6f}", q[0], q[1], q[2]);
      }));
  EXPECT_THAT(refusal(options), AllOf(HasSubstr("can't be told from the motion for certain"),
                                      HasSubstr("The best candidate is --time-offset-s")));
}

TEST_F(ColumnCheck, FindsTheOffsetOfSlowNoisyMotion) {
  constexpr double kNoise_m = 5e-4;
  constexpr double kSlower = 0.15;
  rows_ = 9000;
  ImportOptions options = with_two_clocks("[pressure_1_kpa, pressure_2_kpa, pressure_3_kpa]", 0.0);
  RandomStream random(3, 0);
  headings_ = false;
  const NoLoadModel model(truth_.arm());
  write_file_atomically(
      folder_.path() / "run.csv",
      LogTruth::table(
          "time_s" + header().substr(header().find(",x0")), rows_, rate_hz_, [&](double t) {
            const BackboneD b = truth_.backbone(kSlower * t);
            std::string cells;
            for (const int p : plates_) {
              cells += fmt::format(",{:.8f},{:.8f}", b(p, 0) + kNoise_m * random.normal(),
                                   b(p, 1) + kNoise_m * random.normal());
            }
            return cells;
          }));
  write_file_atomically(
      folder_.path() / "p.csv",
      LogTruth::table("time_s" + truth_.pressure_names(), rows_, rate_hz_,
                      [&](double t) { return truth_.pressure_cells(kSlower * (t + 4.0)); }));
  write_file_atomically(folder_.path() / "map.yaml", mapping());
  options.mapping = read_import_mapping(folder_.path() / "map.yaml", truth_.arm());
  const ImportResult result = import_csv({folder_.path() / "run.csv"}, options, truth_.arm());
  EXPECT_NEAR(result.report.runs.front().clock->offset_s, 4.0, 2.0 * kFrame_s);
}

// One mirrored trial among good ones is named; the mapping is not blamed.
TEST_F(ColumnCheck, NamesTheOneLogThatIsOtherThanTheRest) {
  pressure_scale_ = -1.0;
  write_file_atomically(folder_.path() / "bad.csv", log());
  pressure_scale_ = 1.0;
  write_file_atomically(folder_.path() / "good.csv", log());
  write_file_atomically(folder_.path() / "map.yaml", mapping());
  ImportOptions options;
  options.mapping = read_import_mapping(folder_.path() / "map.yaml", truth_.arm());
  const auto path = [&](const char* name) { return folder_.path() / name; };
  EXPECT_THAT(
      [&] {
        import_csv({path("good.csv"), path("good.csv"), path("good.csv"), path("bad.csv")}, options,
                   truth_.arm());
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("bad.csv (the other logs fit the mapping)"),
                                      HasSubstr("bends to the other side"))));
}

}  // namespace
}  // namespace limber
