#include "swept_clearance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "limber/common/interrupt.hpp"

namespace limber {

namespace {

using Complex = std::complex<double>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double sinc(double x) {
  return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x;
}

double distance_to_edge(Complex p, Complex a, Complex b) {
  const Complex along = (p - a) / (b - a);  // the edge is the unit interval of the real axis
  return std::abs(p - (a + std::clamp(along.real(), 0.0, 1.0) * (b - a)));
}

double distance_of(const Circle& circle, Complex p) {
  return std::abs(p - Complex(circle.x_m, circle.y_m)) - circle.radius_m;
}

double distance_of(const Rectangle& rectangle, Complex p) {
  const Complex own =
      (p - Complex(rectangle.x_m, rectangle.y_m)) * std::polar(1.0, -rectangle.angle_rad);
  const double x = std::abs(own.real()) - rectangle.width_m / 2.0;
  const double y = std::abs(own.imag()) - rectangle.height_m / 2.0;
  return std::hypot(std::max(x, 0.0), std::max(y, 0.0)) + std::min(std::max(x, y), 0.0);
}

/// Of a point from an axis-aligned box, negative inside. No point of what the box covers is nearer,
/// nor farther inside.
double distance_to(const CoveringBox& box, Complex p) {
  const double x = std::max(box.low.real() - p.real(), p.real() - box.high.real());
  const double y = std::max(box.low.imag() - p.imag(), p.imag() - box.high.imag());
  return std::hypot(std::max(x, 0.0), std::max(y, 0.0)) + std::min(std::max(x, y), 0.0);
}

void cover(CoveringBox& box, Complex p) {
  box.low = {std::min(box.low.real(), p.real()), std::min(box.low.imag(), p.imag())};
  box.high = {std::max(box.high.real(), p.real()), std::max(box.high.imag(), p.imag())};
}

/// One edge's part in the winding number about p.
int winding_of(Complex a, Complex b, Complex p) {
  const double side = (std::conj(b - a) * (p - a)).imag();  // > 0: p is left of the edge
  if (a.imag() <= p.imag() && b.imag() > p.imag() && side > 0.0) {
    return 1;
  }
  return a.imag() > p.imag() && b.imag() <= p.imag() && side < 0.0 ? -1 : 0;
}

}  // namespace

/// A gap between two frames. Time runs from 0 to 1, place from 0 at the lower plate to 1.
class SweptClearance::MovingArc {
 public:
  MovingArc(const Pose& start_from, const Pose& end_from, const Pose& start_to, const Pose& end_to)
      : start_(start_from.x_m, start_from.y_m),
        start_way_(Complex(start_to.x_m, start_to.y_m) - start_),
        chord_(Complex(end_from.x_m, end_from.y_m) - start_),
        chord_way_(Complex(end_to.x_m, end_to.y_m) - (start_ + start_way_) - chord_),
        turn_(end_from.theta_rad - start_from.theta_rad),
        turn_way_(end_to.theta_rad - start_to.theta_rad - turn_) {
    // With φ the turn, a point is s + c·w(u, φ), w = ∫₀ᵘ e^{iφ(σ−½)} dσ / D, D = sinc(φ/2) ≥ 2/π.
    // |w| ≤ 1 up to half a turn, |∂w/∂u| = 1/D, and |∂w/∂φ| ≤ (¼ + |D'|)/D ≤ (¼ + 2/π²)·π/2.
    constexpr double kPlacePerTurn = 0.72;
    const double longest = std::max(std::abs(chord_), std::abs(chord_ + chord_way_));
    const double most_turn = std::max(std::abs(turn_), std::abs(turn_ + turn_way_));
    const double end_speed = std::abs(start_way_ + chord_way_);
    speed_m_ = std::min(std::abs(start_way_), end_speed) + std::abs(chord_way_) +
               kPlacePerTurn * longest * std::abs(turn_way_);
    length_m_ = longest / sinc(most_turn / 2.0);
  }

  Complex at(double time, double place) const {
    const double turn = turn_ + time * turn_way_;
    const Complex w = place * sinc(turn * place / 2.0) / sinc(turn / 2.0) *
                      std::polar(1.0, turn * (place - 1.0) / 2.0);
    return start_ + time * start_way_ + (chord_ + time * chord_way_) * w;
  }

  double speed_m() const { return speed_m_; }    ///< bound on a point's way over all time
  double length_m() const { return length_m_; }  ///< bound on the arc's length at any time

 private:
  Complex start_, start_way_, chord_, chord_way_;
  double turn_, turn_way_;
  double speed_m_ = 0.0;
  double length_m_ = 0.0;
};

namespace {

/// A rectangle of time and place, by its middle and half its sizes.
struct Cell {
  double time, place, half_time, half_place;
};

std::array<Cell, 2> halves(const Cell& cell, bool by_time) {
  Cell low = cell;
  Cell high = cell;
  if (by_time) {
    low.half_time = high.half_time = cell.half_time / 2.0;
    low.time -= low.half_time;
    high.time += high.half_time;
  } else {
    low.half_place = high.half_place = cell.half_place / 2.0;
    low.place -= low.half_place;
    high.place += high.half_place;
  }
  return {low, high};
}

}  // namespace

PolygonOutline::PolygonOutline(const Polygon& polygon) {
  for (const Eigen::Vector2d& p : polygon.points_m) {
    corners_.emplace_back(p.x(), p.y());
  }
  corners_.push_back(corners_.front());
  for (std::size_t first = 0; first + 1 < corners_.size(); first += kEdgesPerBox) {
    CoveringBox box;
    for (std::size_t i = first; i <= std::min(first + kEdgesPerBox, corners_.size() - 1); ++i) {
      cover(box, corners_[i]);
    }
    boxes_.push_back(box);
  }
}

double PolygonOutline::distance_m(Complex p) const {
  double nearest = kInfinity;
  int winding = 0;
  for (std::size_t k = 0; k < boxes_.size(); ++k) {
    const CoveringBox& box = boxes_[k];
    const bool is_near = distance_to(box, p) < nearest;
    // Edges count where the ray from p along x meets them.
    const bool is_met =
        box.low.imag() <= p.imag() && p.imag() <= box.high.imag() && p.real() <= box.high.real();
    if (!is_near && !is_met) {
      continue;
    }
    const std::size_t end = std::min((k + 1) * kEdgesPerBox, corners_.size() - 1);
    for (std::size_t i = k * kEdgesPerBox; i < end; ++i) {
      nearest = std::min(nearest, distance_to_edge(p, corners_[i], corners_[i + 1]));
      winding += winding_of(corners_[i], corners_[i + 1], p);
    }
  }
  return winding != 0 ? -nearest : nearest;
}

double SweptClearance::CoveredObstacle::distance_m(Complex p) const {
  if (const auto* circle = std::get_if<Circle>(&shape)) {
    return distance_of(*circle, p);
  }
  if (const auto* rectangle = std::get_if<Rectangle>(&shape)) {
    return distance_of(*rectangle, p);
  }
  return std::get<PolygonOutline>(shape).distance_m(p);
}

SweptClearance::SweptClearance(const ArmDescription& arm, const std::vector<Obstacle>& obstacles,
                               double tolerance_m)
    : tolerance_m_(tolerance_m) {
  for (const Segment& segment : arm.segments) {
    for (int g = 0; g < segment.gaps; ++g) {
      radius_m_.push_back(segment.width_m / 2.0 + arm.actuator_radius_m);
    }
  }
  for (const Obstacle& obstacle : obstacles) {
    obstacles_.push_back(covered(obstacle));
  }
}

SweptClearance::CoveredObstacle SweptClearance::covered(const Obstacle& obstacle) {
  CoveringBox box;
  if (const auto* circle = std::get_if<Circle>(&obstacle)) {
    const Complex centre(circle->x_m, circle->y_m);
    const Complex corner(circle->radius_m, circle->radius_m);
    cover(box, centre - corner);
    cover(box, centre + corner);
    return {box, *circle};
  }
  if (const auto* rectangle = std::get_if<Rectangle>(&obstacle)) {
    const Complex turn = std::polar(1.0, rectangle->angle_rad);
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        cover(box, Complex(rectangle->x_m, rectangle->y_m) +
                       turn * Complex(x * rectangle->width_m, y * rectangle->height_m));
      }
    }
    return {box, *rectangle};
  }
  const Polygon& polygon = std::get<Polygon>(obstacle);
  for (const Eigen::Vector2d& p : polygon.points_m) {
    cover(box, {p.x(), p.y()});
  }
  return {box, PolygonOutline(polygon)};
}

SweptClearance::Result SweptClearance::over(const std::vector<ExactArm::Shape>& shapes) const {
  Result best{kInfinity};
  // A signal from before has been heeded by the caller, who asks for this all the same.
  const bool was_interrupted = interrupt_requested();
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    if (!was_interrupted) {
      throw_if_interrupted();
    }
    const ExactArm::Shape& from = shapes[k == 0 ? 0 : k - 1];
    const ExactArm::Shape& to = shapes[k];
    for (std::size_t gap = 0; gap + 1 < to.size(); ++gap) {
      const MovingArc arc(from[gap], from[gap + 1], to[gap], to[gap + 1]);
      for (std::size_t o = 0; o < obstacles_.size(); ++o) {
        const double value = lowest(arc, o, best.value_m + radius_m_[gap]) - radius_m_[gap];
        if (value < best.value_m) {
          best = {value, static_cast<int>(k), static_cast<int>(gap), static_cast<int>(o)};
        }
      }
    }
  }
  best.value_m -= tolerance_m_;
  return best;
}

double SweptClearance::lowest(const MovingArc& arc, std::size_t obstacle, double best) const {
  const CoveredObstacle& covered = obstacles_[obstacle];
  std::vector<Cell> open{{0.5, 0.5, 0.5, 0.5}};
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    const double time_way = cell.half_time * arc.speed_m();
    const double place_way = cell.half_place * arc.length_m();
    const double slack = time_way + place_way - tolerance_m_;
    const Complex p = arc.at(cell.time, cell.place);
    if (distance_to(covered.box, p) >= best + slack) {
      continue;
    }
    const double distance = covered.distance_m(p);
    best = std::min(best, distance);
    if (distance < best + slack) {
      const auto parts = halves(cell, time_way > place_way);
      open.insert(open.end(), parts.begin(), parts.end());
    }
  }
  return best;
}

}  // namespace limber
