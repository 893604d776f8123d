#include "src/world/broad_phase.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

constexpr int kGaps = 70;  // of three looks
constexpr double kRadiusM = 0.02;
constexpr double kPinM = 1e-3;
constexpr double kInsideM = 1e-6;  // float32 rounds coordinates of a metre to a tenth of that

/// Plates scattered so that gaps turn by up to half a turn either way.
Backbone random_backbone(RandomStream& random) {
  Backbone b(kGaps + 1, 3);
  Pose at;
  for (int i = 0; i <= kGaps; ++i) {
    b.row(i) << float(at.x_m), float(at.y_m), float(at.theta_rad);
    const double way = random.uniform(0.0, 0.1);
    const double course = random.uniform(-std::numbers::pi, std::numbers::pi);
    at.x_m += way * std::cos(course);
    at.y_m += way * std::sin(course);
    at.theta_rad += random.uniform(-std::numbers::pi, std::numbers::pi);
  }
  return b;
}

/// The point at a part u of the arc's length, from both plates' places and the turn between them:
/// ∫ e^{iφσ} over σ to u, turned and scaled so that u = 1 is the upper plate.
Eigen::Vector2d arc_point(const Eigen::RowVector3d& lower, const Eigen::RowVector3d& upper,
                          double u) {
  const double turn = upper[2] - lower[2];
  const auto integral = [turn](double to) {
    constexpr int kSteps = 64;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (int k = 0; k < kSteps; ++k) {
      const double angle = turn * to * (k + 0.5) / kSteps;
      sum += Eigen::Vector2d(std::cos(angle), std::sin(angle)) * to / kSteps;
    }
    return sum;
  };
  const Eigen::Vector2d part = integral(u);
  const Eigen::Vector2d whole = integral(1.0);
  const Eigen::Vector2d chord = (upper - lower).head<2>().transpose();
  // Complex division and multiplication: part / whole · chord.
  const double scale = 1.0 / whole.squaredNorm();
  const Eigen::Vector2d ratio(part.dot(whole) * scale,
                              (part.y() * whole.x() - part.x() * whole.y()) * scale);
  return lower.head<2>().transpose() +
         Eigen::Vector2d(ratio.x() * chord.x() - ratio.y() * chord.y(),
                         ratio.x() * chord.y() + ratio.y() * chord.x());
}

bool has(const BroadPhase& broad, const Backbone& from, const Backbone& to, int gap) {
  const int first = gap / BroadPhase::kGaps * BroadPhase::kGaps;
  return (broad.may_touch(from, to, first) >> (gap - first) & 1U) != 0;
}

// A pin that just touches a gap's outside, at any place of its arc and any time of its motion, on
// the side where boxes are tightest.
TEST(BroadPhase, NeverLeavesOutAGapThatTouches) {
  RandomStream random(11, 1);
  const std::vector<double> radius(kGaps, kRadiusM);
  for (int trial = 0; trial < 2000; ++trial) {
    const Backbone from = random_backbone(random);
    Backbone to = from;
    for (int i = 0; i <= kGaps; ++i) {
      to.row(i) += Eigen::RowVector3f(float(random.uniform(-0.05, 0.05)),
                                      float(random.uniform(-0.05, 0.05)), 0.0F);
    }
    const int gap = static_cast<int>(random.index(kGaps));
    const double time = 0.25 * random.index(5);
    const double place = 0.25 * random.index(5);
    const auto plate = [&](int i) -> Eigen::RowVector3d {
      return (1.0 - time) * from.row(i).cast<double>() + time * to.row(i).cast<double>();
    };
    const Eigen::Vector2d point = arc_point(plate(gap), plate(gap + 1), place);
    const double angle = 0.5 * std::numbers::pi * random.index(4);
    const Eigen::Vector2d pin =
        point + (kRadiusM + kPinM - kInsideM) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const BroadPhase broad({make_obstacle_shape(Circle{pin.x(), pin.y(), kPinM}, 0)}, radius);
    EXPECT_TRUE(has(broad, from, to, gap)) << "trial " << trial << ", gap " << gap;
  }
}

TEST(BroadPhase, LeavesOutGapsFarAway) {
  const std::vector<double> radius(kGaps, kRadiusM);
  Backbone straight = Backbone::Zero(kGaps + 1, 3);
  for (int i = 0; i <= kGaps; ++i) {
    straight(i, 0) = 0.05F * float(i);
  }
  for (const int touched : {0, 31, 32, 63, 64, 69}) {
    const double x = 0.05 * (touched + 0.5);
    const BroadPhase broad({make_obstacle_shape(Circle{x, 0.0, kPinM}, 0)}, radius);
    for (int gap = 0; gap < kGaps; ++gap) {
      EXPECT_EQ(has(broad, straight, straight, gap), gap == touched) << gap;
    }
  }
}

// Three columns of a wider matrix are a backbone too.
TEST(BroadPhase, LooksAtTheColumnsThatItIsGiven) {
  Eigen::Matrix<float, Eigen::Dynamic, 4, Eigen::RowMajor> wide(3, 4);
  wide << NAN, 0.0F, 0.0F, 0.0F, NAN, 0.1F, 0.0F, 0.0F, NAN, 0.2F, 0.0F, 0.0F;
  const BroadPhase broad({make_obstacle_shape(Circle{0.15, 0.0, kPinM}, 0)}, {0.02, 0.02});
  const auto backbone = wide.rightCols<3>();
  EXPECT_EQ(broad.may_touch(backbone, backbone, 0), 2U);
}

}  // namespace
}  // namespace limber
