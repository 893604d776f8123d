#include <cmath>

#include <gmock/gmock.h>

#include "limber/arm/no_load_model.hpp"
#include "logs/csv_import.hpp"
#include "logs/space_import.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;

/// Logs of positions of an arm whose gaps nearer to a segment's base bend less than those behind.
class SharedBase : public CsvImport {
 protected:
  SharedBase() { headings_ = false; }

  /// @param lean_rad  by which each segment is bent more than its pressure says, throughout
  std::string uneven_log(double lean_rad, const Eigen::Vector2d& base_m, double heading_rad) const {
    const std::vector<double> rest_m = rest_positions_m(truth_.arm());
    return LogTruth::table(header(), rows_, rate_hz_, [&](double time_s) {
      std::string text = truth_.pressure_cells(time_s, 1.0);
      Eigen::Vector2d point = base_m;
      double direction = heading_rad;
      for (int p = 0; p < truth_.arm().point_count(); ++p) {
        text += fmt::format(",{:.8f},{:.8f}", point.x(), point.y());
        if (p + 1 < truth_.arm().point_count()) {
          const int segment = truth_.arm().segment_of_gap(p);
          const double turn_rad =
              lean_rad - 0.012 * truth_.pressures(time_s)[segment];  // of the whole segment
          direction += turn_rad * kPart[p % kGaps];
          const double length_m = rest_m[std::size_t(p + 1)] - rest_m[std::size_t(p)];
          point += length_m * Eigen::Vector2d(std::cos(direction), std::sin(direction));
        }
      }
      return text;
    });
  }

  ImportResult import_all(const std::vector<std::string>& texts) const {
    std::vector<std::filesystem::path> logs;
    for (const std::string& text : texts) {
      logs.push_back(folder_.path() / fmt::format("run_{}.csv", logs.size()));
      write_file_atomically(logs.back(), text);
    }
    write_file_atomically(folder_.path() / "map.yaml", mapping());
    ImportOptions options;
    options.mapping = read_import_mapping(folder_.path() / "map.yaml", truth_.arm());
    return import_csv(logs, options, truth_.arm());
  }

  static constexpr int kGaps = 5;
  static constexpr double kPart[kGaps] = {0.04, 0.12, 0.2, 0.28, 0.36};
};

TEST_F(SharedBase, IsOneForLogsThatLeanNowThisWayNowThat) {
  const Eigen::Vector2d base_m(0.4, -0.2);
  const ImportResult result = import_all(
      {uneven_log(0.5, base_m, 1.1), uneven_log(-0.6, base_m, 1.1), uneven_log(0.1, base_m, 1.1)});
  ASSERT_TRUE(result.report.base);
  EXPECT_EQ(result.report.base->logs, 3);
  EXPECT_LT(result.report.base->most_off_rad, 1e-4);
  for (const RunReport& run : result.report.runs) {
    EXPECT_NEAR(run.base.theta_rad, 1.1, 1e-4) << "an arc would be up to 0.02 rad off";
    EXPECT_EQ(run.base.theta_rad, result.report.runs.front().base.theta_rad);
    EXPECT_EQ(run.base.x_m, result.report.runs.front().base.x_m);
  }
  EXPECT_THAT(to_text(result.report), HasSubstr("alignment: {x_m: 0.40000, y_m: -0.20000"));
}

TEST_F(SharedBase, LeavesALogItsOwnWhereTheArmStoodElsewhere) {
  const Eigen::Vector2d base_m(0.4, -0.2);
  const ImportResult result =
      import_all({uneven_log(0.0, base_m, 1.1), uneven_log(0.3, base_m, 1.1),
                  uneven_log(0.0, base_m + Eigen::Vector2d(0.02, 0.0), 1.3)});
  ASSERT_TRUE(result.report.base);
  EXPECT_EQ(result.report.base->logs, 2);
  EXPECT_NEAR(result.report.runs.back().base.x_m, 0.42, 1e-6);
  EXPECT_NEAR(result.report.runs.back().base.theta_rad, 1.3, 1e-3);
  ASSERT_FALSE(result.report.runs.back().notes.empty());
  EXPECT_THAT(result.report.runs.back().notes.front().what, HasSubstr("it keeps its own"));
}

TEST_F(SharedBase, IsNoneWhereMostLogsDiffer) {
  const ImportResult result =
      import_all({uneven_log(0.0, {0.4, -0.2}, 1.1), uneven_log(0.0, {0.5, -0.2}, 1.1)});
  EXPECT_FALSE(result.report.base);
  EXPECT_NEAR(result.report.runs.back().base.x_m, 0.5, 1e-6);
}

/// Logs of positions in space that begin at rest, where friction holds the tip now here, now there.
TEST_F(SpaceImport, PointsOneWayInLogsThatRestDifferently) {
  rotations_ = false;
  rests_s_ = 2.0;
  const Eigen::Vector3d y = X_LB_.rotation * Eigen::Vector3d::UnitY();
  std::vector<std::filesystem::path> logs;
  for (const double off_m : {0.004, -0.005, 0.0005}) {
    mistake_ = [&](int row, int plate, SpacePose& pose) {
      if (plate == 4 && row < rests_s_ * rate_hz_) {
        pose.position_m += off_m * y;
      }
    };
    logs.push_back(folder_.path() / fmt::format("run_{}.csv", logs.size()));
    write_file_atomically(logs.back(), log());
  }
  write_file_atomically(
      folder_.path() / "map.yaml",
      mapping(fmt::format("alignment: {{rest_s: [0, 1.9], y_axis: [{:.9f}, {:.9f}, {:.9f}]}}\n",
                          y.x(), y.y(), y.z())));
  ImportOptions options;
  options.mapping = read_import_mapping(folder_.path() / "map.yaml", arm_);
  const ImportReport report = import_csv(logs, options, arm_).report;
  ASSERT_TRUE(report.base);
  EXPECT_EQ(report.base->logs, 3);
  EXPECT_GT(report.base->most_off_rad, 0.01);
  EXPECT_THAT(report.base->alignment, HasSubstr("rest_s: [0, 1.9]"));
  for (const RunReport& run : report.runs) {
    EXPECT_LT((run.space->x_axis - X_LB_.rotation * Eigen::Vector3d::UnitX()).norm(), 0.002);
    EXPECT_EQ(run.space->x_axis, report.runs.front().space->x_axis);
  }
}

}  // namespace
}  // namespace limber
