#include "limber/run/lap_posture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limber/common/interrupt.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/world/inverse_kinematics.hpp"

namespace limber {

namespace {

constexpr int kPointsPerLap = 48;
constexpr int kShapesPerPoint = 24;
constexpr int kShapeStarts = 96;        // of inverse kinematics, per point
constexpr double kKeptOfLimits = 0.85;  // friction and load take the rest
constexpr double kTipTolerance_m = 0.002;
constexpr double kDistinct = 0.04;       // of the largest command
constexpr double kPostureWeight = 0.02;  // of distance from the middle, beside a step's square

/// One shape at one point of the lap, and the cheapest way there.
struct Shape {
  Eigen::VectorXd kpa;
  double cost = 0.0;
  int before = -1;
};
using Shapes = std::vector<Shape>;

class LapSearch {
 public:
  explicit LapSearch(const std::vector<PressureLimits>& limits)
      : half_kpa_(Eigen::Index(limits.size())), middle_kpa_(half_kpa_.size()) {
    for (Eigen::Index i = 0; i < half_kpa_.size(); ++i) {
      const PressureLimits& of = limits[i];
      half_kpa_[i] = of.half_width_kpa();
      middle_kpa_[i] = 0.5 * (of.lower_kpa + of.upper_kpa);
    }
  }

  /// Costs of all shapes of a point, from those of the point before.
  void follow(const Shapes& from, Shapes& to) const {
    for (Shape& shape : to) {
      shape.cost = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < from.size(); ++k) {
        const double cost = from[k].cost + step_cost(from[k].kpa, shape.kpa);
        if (cost < shape.cost) {
          shape.cost = cost;
          shape.before = int(k);
        }
      }
      shape.cost += posture_cost(shape.kpa);
    }
  }
  double posture_cost(const Eigen::VectorXd& kpa) const {
    return kPostureWeight * (kpa - middle_kpa_).cwiseQuotient(half_kpa_).squaredNorm();
  }

 private:
  double step_cost(const Eigen::VectorXd& from, const Eigen::VectorXd& to) const {
    return double(kPointsPerLap) * (to - from).cwiseQuotient(half_kpa_).squaredNorm();
  }

  Eigen::VectorXd half_kpa_;
  Eigen::VectorXd middle_kpa_;
};

std::vector<Shapes> shapes_along(const NoLoadModel& model, const TipPath& path,
                                 const std::vector<PressureLimits>& limits, std::uint64_t seed) {
  InverseKinematicsSettings settings;
  settings.starts = kShapeStarts;
  settings.max_solutions = kShapesPerPoint;
  settings.distinct_pressure = kDistinct;
  for (const PressureLimits& of : limits) {
    settings.limits.push_back({kKeptOfLimits * of.lower_kpa, kKeptOfLimits * of.upper_kpa});
  }
  std::vector<Shapes> result;
  for (int point = 0; point <= kPointsPerLap; ++point) {
    throw_if_interrupted();
    PoseGoal goal;
    const Eigen::Vector2d tip = path.at(path.lap_s() * point / kPointsPerLap);
    goal.x_m = tip.x();
    goal.y_m = tip.y();
    goal.position_tolerance_m = kTipTolerance_m;
    RandomStream random(seed, std::uint64_t(point));
    const InverseKinematicsResult found = solve_inverse_kinematics(model, goal, settings, random);
    Shapes shapes;
    for (const Eigen::VectorXd& kpa : found.pressures_kpa) {
      shapes.push_back({kpa});
    }
    if (shapes.empty()) {
      shapes.push_back({found.best_pressures_kpa});  // as near as the arm comes
    }
    result.push_back(std::move(shapes));
  }
  return result;
}

/// The cheapest way through the shapes, one of each point; from `first` of point 0 alone if ≥ 0.
std::vector<Eigen::VectorXd> cheapest_way(const LapSearch& search, std::vector<Shapes>& shapes,
                                          int first) {
  for (std::size_t k = 0; k < shapes[0].size(); ++k) {
    const bool may_start = first < 0 || int(k) == first;
    shapes[0][k].cost =
        may_start ? search.posture_cost(shapes[0][k].kpa) : std::numeric_limits<double>::infinity();
  }
  for (std::size_t point = 1; point < shapes.size(); ++point) {
    search.follow(shapes[point - 1], shapes[point]);
  }
  const auto last = std::ranges::min_element(shapes.back(), {}, &Shape::cost);
  std::vector<Eigen::VectorXd> way(shapes.size());
  int at = int(last - shapes.back().begin());
  for (std::size_t point = shapes.size(); point-- > 0;) {
    way[point] = shapes[point][at].kpa;
    at = shapes[point][at].before;
  }
  return way;
}

}  // namespace

LapPosture::LapPosture(const NoLoadModel& model, const TipPath& path,
                       const std::vector<PressureLimits>& limits, std::uint64_t seed)
    : lap_s_(path.lap_s()), closes_(path.closes()) {
  for (int s = 0; s < model.segment_count(); ++s) {
    is_known_ = is_known_ || model.curvature_limit_per_m(s) > 0.0;
  }
  if (!is_known_) {
    points_kpa_.assign(2, Eigen::VectorXd::Zero(model.channel_count()));
    return;
  }
  std::vector<Shapes> shapes = shapes_along(model, path, limits, seed);
  const LapSearch search(limits);
  if (!path.closes()) {
    points_kpa_ = cheapest_way(search, shapes, -1);
    return;
  }
  double min_cost = std::numeric_limits<double>::infinity();
  const Shapes starts = shapes.front();
  for (std::size_t k = 0; k < starts.size(); ++k) {
    shapes.back() = {starts[k]};
    std::vector<Eigen::VectorXd> way = cheapest_way(search, shapes, int(k));
    if (shapes.back().front().cost < min_cost) {
      min_cost = shapes.back().front().cost;
      points_kpa_ = std::move(way);
    }
  }
}

Eigen::VectorXd LapPosture::at(double seconds) const {
  if (seconds <= 0.0) {
    return points_kpa_.front();
  }
  const double in_lap_s = closes_ ? std::fmod(seconds, lap_s_) : std::min(seconds, lap_s_);
  const double share = in_lap_s / lap_s_ * double(points_kpa_.size() - 1);
  const auto before = std::min(std::size_t(share), points_kpa_.size() - 2);
  const double rest = share - double(before);
  return (1.0 - rest) * points_kpa_[before] + rest * points_kpa_[before + 1];
}

}  // namespace limber
