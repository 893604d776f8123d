#include "src/run/estimate/shape_filter.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

constexpr int kGaps = 15;
constexpr double kGapM = 0.047;
constexpr double kMeasuredM = 0.002;

ShapeFilter filter() {
  return {Eigen::VectorXd::Constant(kGaps, kGapM), kMeasuredM};
}

/// Every gap an arc that turns by so much.
Backbone bent(double turn_rad) {
  Backbone result(kGaps + 1, 3);
  double x = 0.0;
  double y = 0.0;
  for (int i = 0; i <= kGaps; ++i) {
    result.row(i) << float(x), float(y), float(i * turn_rad);
    const double along = (i + 0.5) * turn_rad;
    x += kGapM * std::cos(along);
    y += kGapM * std::sin(along);
  }
  return result;
}

double largest_m(const Backbone& a, const Backbone& b) {
  return double((a - b).leftCols<2>().rowwise().norm().maxCoeff());
}

/// How far a plate is beside where the one before it has it, if the gap is an arc.
double largest_off_arc_m(const Backbone& shape) {
  double largest = 0.0;
  for (int i = 0; i < kGaps; ++i) {
    const double middle = 0.5 * double(shape(i, 2) + shape(i + 1, 2));
    const double dx = double(shape(i + 1, 0) - shape(i, 0));
    const double dy = double(shape(i + 1, 1) - shape(i, 1));
    largest = std::max(largest, std::abs(-std::sin(middle) * dx + std::cos(middle) * dy));
  }
  return largest;
}

TEST(ShapeFilter, LeavesAPredictionThatWasRight) {
  ShapeFilter shape = filter();
  shape.predict();
  EXPECT_LT(largest_m(shape.corrected(bent(0.1), bent(0.1)), bent(0.1)), 1e-6);
}

// Plates beside each other jump by a millimetre, which no arm can do.
TEST(ShapeFilter, TakesNoiseForNoise) {
  constexpr double kNoiseM = 0.0005;
  RandomStream random(7, 1);
  ShapeFilter shape = filter();
  const Backbone truth = bent(0.1);
  Backbone estimate = truth;
  double measured_off_arc_m = 0.0;
  double off_arc_m = 0.0;
  double measured_error_m = 0.0;
  double error_m = 0.0;
  for (int frame = 0; frame < 40; ++frame) {
    Backbone measured = truth;
    for (int i = 1; i <= kGaps; ++i) {
      measured(i, 0) += float(kNoiseM * random.normal());
      measured(i, 1) += float(kNoiseM * random.normal());
    }
    shape.predict();
    estimate = shape.corrected(estimate, measured);
    measured_off_arc_m += largest_off_arc_m(measured);
    off_arc_m += largest_off_arc_m(estimate);
    measured_error_m += largest_m(measured, truth);
    error_m += largest_m(estimate, truth);
  }
  EXPECT_LT(off_arc_m, 0.03 * measured_off_arc_m);
  EXPECT_LT(error_m, 0.5 * measured_error_m);
}

// Friction that the model does not know: each frame bends less than was predicted.
TEST(ShapeFilter, FollowsWhatTheModelMisses) {
  ShapeFilter shape = filter();
  Backbone estimate = bent(0.0);
  for (int frame = 1; frame <= 20; ++frame) {
    const double turn = 0.005 * frame;
    shape.predict();
    Backbone predicted = estimate;  // that the arm stands still
    estimate = shape.corrected(predicted, bent(turn));
    EXPECT_LT(largest_m(estimate, bent(turn)), 0.1 * largest_m(bent(0.0), bent(turn)) + 0.003)
        << frame;
  }
  EXPECT_LT(largest_m(estimate, bent(0.1)), 0.005);
}

}  // namespace
}  // namespace limber
