#include "src/logs/column_check.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "limber/common/random_stream.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

constexpr int kSegments = 4;
constexpr int kHold = 20;          // rows: two seconds at 10 Hz
constexpr double kFriction = 0.3;  // of a turn, stuck where it was before

/// A log of motions that are held, by an arm that follows with friction,
/// bending right for positive.
LevelTable made_up_levels(int motions, std::uint64_t seed, int segments = kSegments) {
  RandomStream random(seed, 0);
  const int rows = motions * kHold;
  LevelTable levels{Eigen::MatrixXd(rows, segments), Eigen::MatrixXd(rows, segments), {rows}};
  for (int i = 0; i < segments; ++i) {
    double command_kpa = 0.0;
    double turn_rad = 0.0;
    for (int row = 0; row < rows; ++row) {
      command_kpa = row % kHold == 0 ? random.uniform(-100.0, 100.0) : command_kpa;
      const double wanted_rad = -0.01 * command_kpa;
      turn_rad += (row % kHold == 0 ? 1.0 - kFriction : 0.0) * (wanted_rad - turn_rad);
      levels.command(row, i) = command_kpa;
      levels.turn_rad(row, i) = turn_rad + 0.005 * random.normal();
    }
  }
  return levels;
}

ColumnFit fit(const LevelTable& levels, int segments = kSegments) {
  const ArmDescription arm = sample_arm(segments);
  return fit_columns(correlate_levels(levels, arm), arm);
}

LevelTable with_columns(LevelTable levels, const std::vector<int>& order,
                        const std::vector<double>& signs) {
  const Eigen::MatrixXd given = levels.command;
  for (int i = 0; i < kSegments; ++i) {
    levels.command.col(i) =
        signs[static_cast<std::size_t>(i)] * given.col(order[static_cast<std::size_t>(i)]);
  }
  return levels;
}

TEST(ColumnFit, TakesColumnsThatBelongAsTheyAre) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const ColumnFit found = fit(made_up_levels(30, seed));
    EXPECT_TRUE(found.belongs) << "seed " << seed;
    for (int i = 0; i < kSegments; ++i) {
      const FittedColumn& segment = found.segments[static_cast<std::size_t>(i)];
      EXPECT_EQ(segment.column, i);
      EXPECT_FALSE(segment.turned);
      EXPECT_GT(segment.as_given, 0.8);
      EXPECT_EQ(segment.undecidable, Undecidable::no);
    }
  }
}

// Undoing what was done to the columns is the law: segment i's own is where it was put.
TEST(ColumnFit, SaysWhichOrderAndSignsFit) {
  const std::vector<int> order = {2, 0, 3, 1};
  const std::vector<double> signs = {1.0, -1.0, 1.0, -1.0};
  const ColumnFit found = fit(with_columns(made_up_levels(30, 5), order, signs));
  EXPECT_FALSE(found.belongs);
  for (std::size_t put = 0; put < order.size(); ++put) {
    const FittedColumn& segment = found.segments[static_cast<std::size_t>(order[put])];
    EXPECT_EQ(segment.column, static_cast<Eigen::Index>(put));
    EXPECT_EQ(segment.turned, signs[put] < 0.0);
    EXPECT_GT(segment.correlation, 0.8);
  }
}

TEST(ColumnFit, RefusesASingleMirroredSegment) {
  for (int mirrored = 0; mirrored < kSegments; ++mirrored) {
    std::vector<double> signs(kSegments, 1.0);
    signs[static_cast<std::size_t>(mirrored)] = -1.0;
    const ColumnFit found = fit(with_columns(made_up_levels(20, 6), {0, 1, 2, 3}, signs));
    EXPECT_FALSE(found.belongs);
    for (int i = 0; i < kSegments; ++i) {
      EXPECT_EQ(found.segments[static_cast<std::size_t>(i)].column, i);
      EXPECT_EQ(found.segments[static_cast<std::size_t>(i)].turned, i == mirrored);
    }
  }
}

TEST(ColumnFit, NamesSegmentsThatHardlyMovedAndKeepsTheirColumns) {
  LevelTable levels = with_columns(made_up_levels(30, 7), {0, 1, 2, 3}, {-1.0, -1.0, -1.0, -1.0});
  levels.command.col(1).setConstant(3.0);
  levels.turn_rad.col(2).setZero();
  const ColumnFit found = fit(levels);
  EXPECT_FALSE(found.belongs);
  EXPECT_TRUE(found.segments[0].turned);
  EXPECT_EQ(found.segments[1].column, 1);
  EXPECT_EQ(found.segments[1].undecidable, Undecidable::told_little);
  EXPECT_EQ(found.segments[2].column, 2);
  EXPECT_EQ(found.segments[2].undecidable, Undecidable::turned_little);
  EXPECT_TRUE(found.segments[3].turned);
}

TEST(ColumnFit, NamesSegmentsThatWereToldTheSame) {
  LevelTable levels = made_up_levels(30, 8);
  levels.command.col(3) = levels.command.col(0);
  levels.turn_rad.col(3) = levels.turn_rad.col(0);
  const ColumnFit found = fit(levels);
  EXPECT_TRUE(found.belongs);
  EXPECT_EQ(found.segments[0].undecidable, Undecidable::told_alike);
  EXPECT_EQ(found.segments[0].alike, 3);
  EXPECT_EQ(found.segments[1].undecidable, Undecidable::no);
}

TEST(ColumnFit, SaysWhereALogIsTooShort) {
  const ColumnFit found = fit(made_up_levels(2, 9));
  EXPECT_TRUE(found.belongs);
  for (const FittedColumn& segment : found.segments) {
    EXPECT_NE(segment.undecidable, Undecidable::no);
  }
}

TEST(ColumnFit, NotesAColumnThatItsSegmentDoesNotFollow) {
  LevelTable levels = made_up_levels(60, 10);
  levels.command.col(2) = made_up_levels(60, 11).command.col(2);
  const ColumnFit found = fit(levels);
  EXPECT_TRUE(found.belongs);
  EXPECT_TRUE(found.segments[2].follows_weakly);
  EXPECT_FALSE(found.segments[1].follows_weakly);
}

// Where nothing is known of the sides, no sign is wrong; an order still can be.
TEST(ColumnFit, LeavesSignsOpenWhereTheNoLoadModelIsStraight) {
  ArmDescription arm = sample_arm(kSegments);
  arm.no_load = NoLoadKind::straight;
  const LevelTable turned =
      with_columns(made_up_levels(30, 12), {0, 1, 2, 3}, {-1.0, 1.0, -1.0, -1.0});
  EXPECT_TRUE(fit_columns(correlate_levels(turned, arm), arm).belongs);
  const LevelTable permuted =
      with_columns(made_up_levels(30, 12), {1, 0, 2, 3}, {-1.0, 1.0, 1.0, 1.0});
  EXPECT_FALSE(fit_columns(correlate_levels(permuted, arm), arm).belongs);
}

// Ten runs of five seconds say together what none of them could say alone.
TEST(ColumnFit, PoolsRuns) {
  LevelTable all = made_up_levels(3, 20);
  EXPECT_NE(fit(all).segments[0].undecidable, Undecidable::no);
  for (std::uint64_t seed = 21; seed < 30; ++seed) {
    append(all, made_up_levels(3, seed));
  }
  EXPECT_EQ(all.run_ends.back(), all.row_count());
  EXPECT_EQ(fit(all).segments[0].undecidable, Undecidable::no);
  EXPECT_FALSE(fit(with_columns(all, {0, 2, 1, 3}, {1.0, 1.0, 1.0, 1.0})).belongs);
}

// A series that repeats every row ten times is worth a tenth of its rows.
TEST(LevelCorrelations, CountIndependentRows) {
  const LevelCorrelations found = correlate_levels(made_up_levels(200, 30), sample_arm(kSegments));
  for (Eigen::Index i = 0; i < kSegments; ++i) {
    EXPECT_GT(found.independent_rows(i, i), 0.7 * 200);
    EXPECT_LT(found.independent_rows(i, i), 2.5 * 200);
  }
}

}  // namespace
}  // namespace limber
