#include "brute_force.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace limber {

namespace {

using Eigen::Vector2d;

double squared_to_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d ab = b - a;
  const double along = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
  return (a + along * ab - p).squaredNorm();
}

double to_polygon(const std::vector<Vector2d>& corners, const Vector2d& p) {
  double nearest = std::numeric_limits<double>::infinity();  // squared
  bool inside = false;                                       // by the crossings of a ray upwards
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2d& a = corners[i];
    const Vector2d& b = corners[(i + 1) % corners.size()];
    nearest = std::min(nearest, squared_to_segment(p, a, b));
    if ((a.x() > p.x()) != (b.x() > p.x()) &&
        p.y() < a.y() + (b.y() - a.y()) * (p.x() - a.x()) / (b.x() - a.x())) {
      inside = !inside;
    }
  }
  return inside ? -std::sqrt(nearest) : std::sqrt(nearest);
}

std::vector<Vector2d> corners_of(const Obstacle& obstacle) {
  if (const auto* polygon = std::get_if<Polygon>(&obstacle)) {
    return polygon->points_m;
  }
  const auto& r = std::get<Rectangle>(obstacle);
  const Eigen::Rotation2D<double> turn(r.angle_rad);
  std::vector<Vector2d> corners;
  for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    corners.push_back(Vector2d(r.x_m, r.y_m) +
                      turn * Vector2d(0.5 * u * r.width_m, 0.5 * v * r.height_m));
  }
  return corners;
}

/// A gap at one instant: `count` + 1 points, found by going along the arc in equal steps from the
/// lower plate, and a similarity that takes the last one to the upper plate.
class ArcPoints {
 public:
  explicit ArcPoints(int count) : points_(static_cast<std::size_t>(count) + 1) {}

  const std::vector<Vector2d>& of(const Vector2d& start, const Vector2d& end, double turn) {
    const std::size_t count = points_.size() - 1;
    const double step = turn / double(count);
    points_[0].setZero();
    Vector2d way(1.0, 0.0);
    const Eigen::Rotation2D<double> rotation(step);
    for (std::size_t k = 0; k < count; ++k) {
      points_[k + 1] = points_[k] + way;
      way = rotation * way;
    }
    const Vector2d w = points_.back();
    const Vector2d c = end - start;
    const double cosine = c.dot(w) / w.squaredNorm();
    const double sine = (c.y() * w.x() - c.x() * w.y()) / w.squaredNorm();
    for (Vector2d& p : points_) {
      p = start + Vector2d(cosine * p.x() - sine * p.y(), sine * p.x() + cosine * p.y());
    }
    return points_;
  }

 private:
  std::vector<Vector2d> points_;
};

struct Gap {
  Vector2d start_from, start_to, end_from, end_to;
  double turn_from, turn_to, radius;

  double max_turn() const { return std::max(std::abs(turn_from), std::abs(turn_to)); }
  double longest_chord() const {
    return std::max((end_from - start_from).norm(), (end_to - start_to).norm());
  }
  /// Bound on any point's way: it lies |w| of the chord from one plate and |1 − w| from the other,
  /// which add up to 1/cos(turn/4) at most; and its place changes by at most 0.72 chords a radian.
  double way() const {
    return std::max((start_to - start_from).norm(), (end_to - end_from).norm()) /
               std::cos(max_turn() / 4.0) +
           0.72 * longest_chord() * std::abs(turn_to - turn_from);
  }
  double length() const {
    const double half = max_turn() / 2.0;
    return longest_chord() * (half < 1e-3 ? 1.001 : half / std::sin(half));
  }
};

struct Found {
  double value;
  Vector2d point;
};

/// The smallest of `instants` + 1 by `places` + 1 samples, or `nearest` where that is less. Blocks
/// of samples that, by their middle one, are all farther away are left out.
template <class Distance>
Found sample(const Gap& gap, int instants, int places, Found nearest, const Distance& distance) {
  constexpr int kBlock = 8;
  std::vector<ArcPoints> arcs(kBlock + 1, ArcPoints(places));
  std::vector<const std::vector<Vector2d>*> rows(kBlock + 1);
  for (int first = 0; first <= instants; first += kBlock) {
    const int last = std::min(first + kBlock, instants);
    for (int k = first; k <= last; ++k) {
      const double t = double(k) / instants;
      rows[static_cast<std::size_t>(k - first)] = &arcs[static_cast<std::size_t>(k - first)].of(
          gap.start_from + t * (gap.start_to - gap.start_from),
          gap.end_from + t * (gap.end_to - gap.end_from),
          gap.turn_from + t * (gap.turn_to - gap.turn_from));
    }
    const double reach = kBlock * (gap.way() / instants + gap.length() / places);
    const auto value_at = [&](int k, int i) {
      return distance((*rows[static_cast<std::size_t>(k)])[static_cast<std::size_t>(i)]) -
             gap.radius;
    };
    for (int left = 0; left <= places; left += kBlock) {
      const int right = std::min(left + kBlock, places);
      if (value_at((last - first) / 2, (left + right) / 2) - reach > nearest.value) {
        continue;
      }
      for (int k = 0; k <= last - first; ++k) {
        for (int i = left; i <= right; ++i) {
          const double value = value_at(k, i);
          if (value < nearest.value) {
            nearest = {value, (*rows[static_cast<std::size_t>(k)])[static_cast<std::size_t>(i)]};
          }
        }
      }
    }
  }
  return nearest;
}

std::vector<Gap> gaps_of(const ArmDescription& arm, const Backbone& from, const Backbone& to) {
  std::vector<Gap> gaps;
  for (int g = 0; g + 1 < from.rows(); ++g) {
    const auto point = [&](const Backbone& b, int i) {
      return Vector2d(double(b(i, 0)), double(b(i, 1)));
    };
    const auto turn = [&](const Backbone& b) { return double(b(g + 1, 2)) - double(b(g, 2)); };
    const Segment& segment = arm.segments[static_cast<std::size_t>(arm.segment_of_gap(g))];
    gaps.push_back({point(from, g), point(to, g), point(from, g + 1), point(to, g + 1), turn(from),
                    turn(to), 0.5 * segment.width_m + arm.actuator_radius_m});
  }
  return gaps;
}

template <class Distance>
SampledClearance sampled(const std::vector<Gap>& gaps, double spacing_m, const Distance& distance) {
  constexpr int kCoarse = 6;
  const Found none{std::numeric_limits<double>::infinity(), Vector2d::Zero()};
  std::vector<double> coarse;
  Found nearest = none;
  for (const Gap& gap : gaps) {
    const Found found = sample(gap, kCoarse, kCoarse, none, distance);
    coarse.push_back(found.value);
    nearest = found.value < nearest.value ? found : nearest;
  }
  for (std::size_t g = 0; g < gaps.size(); ++g) {
    const Gap& gap = gaps[g];
    if (coarse[g] - 0.5 * (gap.way() + gap.length()) / kCoarse > nearest.value) {
      continue;
    }
    const auto parts = [&](double way) {
      return std::max(1, static_cast<int>(std::ceil(way / spacing_m)));
    };
    nearest = sample(gap, parts(gap.way()), parts(gap.length()), nearest, distance);
  }
  return {nearest.value, spacing_m, nearest.point};
}

}  // namespace

double brute_force_distance(const Obstacle& obstacle, const Vector2d& p) {
  if (const auto* circle = std::get_if<Circle>(&obstacle)) {
    return (p - Vector2d(circle->x_m, circle->y_m)).norm() - circle->radius_m;
  }
  return to_polygon(corners_of(obstacle), p);
}

SampledClearance brute_force_clearance(const ArmDescription& arm, const Backbone& from,
                                       const Backbone& to, const Obstacle& obstacle,
                                       double spacing_m) {
  const std::vector<Gap> gaps = gaps_of(arm, from, to);
  if (const auto* circle = std::get_if<Circle>(&obstacle)) {
    const Vector2d centre(circle->x_m, circle->y_m);
    return sampled(gaps, spacing_m,
                   [&](const Vector2d& p) { return (p - centre).norm() - circle->radius_m; });
  }
  const std::vector<Vector2d> corners = corners_of(obstacle);
  return sampled(gaps, spacing_m, [&](const Vector2d& p) { return to_polygon(corners, p); });
}

}  // namespace limber
