// The fit that never falls, on bench data as they come: curves that level off or fall a little near
// the limit, noise, single and repeated readings.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/QR>

#include "limber/arm/characterisation.hpp"
#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

constexpr double kLimit = 100.0;  // [kPa]
// Of the squared residual, and of full strain at each reading: 7 digits, and the slope held above
// what they may tip.
constexpr double kRoundingOfResidual = 1e-6;
constexpr double kRoundingOfStrain = 2e-6;

/// The least squares over all quartics that never fall, by a way of its own: a cubic is ≥ 0 on
/// [0, 1] exactly where it is u (α0 + α1 u)² + (1 − u) (β0 + β1 u)² (Lukács), so the slope is
/// written like that and α, β are found by Levenberg's method from many random starts.
class SquaresReference {
 public:
  explicit SquaresReference(const std::vector<BenchPoint>& points)
      : powers_(points.size(), 4), strain_(points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double u = points[i].pressure_kpa / kLimit;
      powers_.row(Eigen::Index(i)) << u, u * u, u * u * u, u * u * u * u;
      strain_[Eigen::Index(i)] = -points[i].strain;
    }
  }

  double min_squares(std::uint64_t seed) const {
    constexpr int kStarts = 12;
    RandomStream random(seed, 1);
    double best = std::numeric_limits<double>::infinity();
    for (int start = 0; start < kStarts; ++start) {
      Eigen::Vector4d roots;
      for (double& root : roots) {
        root = random.uniform(-1.0, 1.0);
      }
      best = std::min(best, descend(roots));
    }
    return best;
  }

 private:
  /// a1 … a4 of e(u) whose slope the roots α0, α1, β0, β1 make, or its derivative along `step`.
  static Eigen::Vector4d product(const Eigen::Vector4d& p, const Eigen::Vector4d& q) {
    // Slopes by power: u (p0 + p1 u)(q0 + q1 u) + (1 − u)(p2 + p3 u)(q2 + q3 u).
    const double a0 = p[0] * q[0];
    const double a1 = p[0] * q[1] + p[1] * q[0];
    const double a2 = p[1] * q[1];
    const double b0 = p[2] * q[2];
    const double b1 = p[2] * q[3] + p[3] * q[2];
    const double b2 = p[3] * q[3];
    return {b0, (a0 + b1 - b0) / 2.0, (a1 + b2 - b1) / 3.0, (a2 - b2) / 4.0};
  }

  double squares(const Eigen::Vector4d& roots) const {
    return (powers_ * product(roots, roots) - strain_).squaredNorm();
  }

  double descend(Eigen::Vector4d roots) const {
    constexpr int kSteps = 500;
    double damping = 1e-3;
    double value = squares(roots);
    for (int step = 0; step < kSteps && damping < 1e12; ++step) {
      Eigen::Matrix4d derivative;
      for (int k = 0; k < 4; ++k) {
        derivative.col(k) = 2.0 * product(roots, Eigen::Vector4d::Unit(k));
      }
      const Eigen::MatrixX4d jacobian = powers_ * derivative;
      const Eigen::VectorXd residual = powers_ * product(roots, roots) - strain_;
      Eigen::Matrix4d normal = jacobian.transpose() * jacobian;
      normal.diagonal().array() += damping * normal.diagonal().maxCoeff();
      const Eigen::Vector4d next =
          roots - normal.colPivHouseholderQr().solve(jacobian.transpose() * residual);
      const double after = squares(next);
      damping *= after < value ? 0.2 : 5.0;
      if (after < value) {
        roots = next;
        value = after;
      }
    }
    return value;
  }

  Eigen::MatrixX4d powers_;
  Eigen::VectorXd strain_;
};

/// Strain that levels off, or falls a little, before the limit; one or two readings a pressure.
std::vector<BenchPoint> random_bench(std::uint64_t seed) {
  RandomStream random(seed, 0);
  const double full = random.uniform(0.08, 0.22);
  const double levels_off_at = random.uniform(0.85, 1.05);  // of the limit
  const double bend = random.uniform(0.8, 2.5);
  const double noise = random.uniform() < 0.2 ? 0.0 : random.uniform(0.0, 0.002);
  const double step = random.uniform() < 0.5 ? 10.0 : 5.0;
  std::vector<BenchPoint> points;
  for (double p = step; p <= kLimit; p += step) {
    const double u = p / kLimit / levels_off_at;
    const double clean = full * std::sin(0.5 * M_PI * std::pow(std::min(u, 1.2), bend));
    const int readings = random.uniform() < 0.3 ? 2 : 1;
    for (int k = 0; k < readings; ++k) {
      points.push_back({p, -clean + noise * random.normal()});
    }
  }
  return points;
}

double sum_of_squares(const StrainPolynomial& c, const std::vector<BenchPoint>& points) {
  double sum = 0.0;
  for (const BenchPoint& point : points) {
    sum += std::pow(strain_at(c, point.pressure_kpa) + point.strain, 2);
  }
  return sum;
}

void expect_best_that_never_falls(const std::vector<BenchPoint>& points, std::uint64_t seed) {
  const StrainFit fit = fit_strain_polynomial(points, kLimit);
  EXPECT_GE(min_strain_slope(fit.polynomial, kLimit).slope_per_kpa, 0.0) << "bench " << seed;
  const double reference = SquaresReference(points).min_squares(seed);
  const double rounding = kRoundingOfStrain * fit.full_strain;
  EXPECT_LE(
      std::sqrt(sum_of_squares(fit.polynomial, points)),
      std::sqrt(reference) * (1.0 + kRoundingOfResidual) + rounding * std::sqrt(points.size()))
      << "bench " << seed;
}

TEST(MonotoneFit, EndsOnEveryBenchAndIsAsGoodAsASearch) {
  constexpr int kBenches = 400;
  int held = 0;
  for (std::uint64_t seed = 0; seed < kBenches; ++seed) {
    const std::vector<BenchPoint> points = random_bench(seed);
    held += int(fit_strain_polynomial(points, kLimit).refitted);
    expect_best_that_never_falls(points, seed);
  }
  EXPECT_GT(held, kBenches / 4) << "benches that ask for a held slope";
}

// Lifting the slope by what rounding tipped moved no digit of the result, and so never ended.
TEST(MonotoneFit, EndsWhereRoundingTipsTheSlopeByLessThanADigit) {
  expect_best_that_never_falls({{5, -0.00880978},
                                {10, -0.018503},
                                {20, -0.0401003},
                                {20, -0.0402825},
                                {30, -0.0629589},
                                {40, -0.0846032},
                                {40, -0.0844282},
                                {50, -0.103638},
                                {60, -0.119283},
                                {70, -0.130739},
                                {80, -0.137701},
                                {90, -0.140579},
                                {100, -0.14002},
                                {100, -0.140053}},
                               0);
}

}  // namespace
}  // namespace limber
