#include "swept_clearance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

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

double distance_of(const Polygon& polygon, Complex p) {
  double nearest = kInfinity;
  int winding = 0;
  const std::size_t count = polygon.points_m.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d& from = polygon.points_m[i];
    const Eigen::Vector2d& to = polygon.points_m[(i + 1) % count];
    const Complex a(from.x(), from.y());
    const Complex b(to.x(), to.y());
    nearest = std::min(nearest, distance_to_edge(p, a, b));
    const double side = (std::conj(b - a) * (p - a)).imag();  // > 0: p is left of the edge
    if (a.imag() <= p.imag() && b.imag() > p.imag() && side > 0.0) {
      ++winding;
    } else if (a.imag() > p.imag() && b.imag() <= p.imag() && side < 0.0) {
      --winding;
    }
  }
  return winding != 0 ? -nearest : nearest;
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

double exact_distance(const Obstacle& obstacle, double x_m, double y_m) {
  return std::visit([&](const auto& o) { return distance_of(o, Complex(x_m, y_m)); }, obstacle);
}

SweptClearance::SweptClearance(const ArmDescription& arm, const std::vector<Obstacle>& obstacles,
                               double tolerance_m)
    : arm_(arm), obstacles_(obstacles), tolerance_m_(tolerance_m) {
  for (const Segment& segment : arm_.segments) {
    for (int g = 0; g < segment.gaps; ++g) {
      radius_m_.push_back(segment.width_m / 2.0 + arm_.actuator_radius_m);
    }
  }
  for (const Obstacle& obstacle : obstacles_) {
    Disc disc{};
    if (const auto* circle = std::get_if<Circle>(&obstacle)) {
      disc = {circle->x_m, circle->y_m, circle->radius_m};
    } else if (const auto* rectangle = std::get_if<Rectangle>(&obstacle)) {
      disc = {rectangle->x_m, rectangle->y_m,
              std::hypot(rectangle->width_m, rectangle->height_m) / 2.0};
    } else {
      const Polygon& polygon = std::get<Polygon>(obstacle);
      disc = {polygon.points_m.front().x(), polygon.points_m.front().y(), 0.0};
      for (const Eigen::Vector2d& p : polygon.points_m) {
        disc.radius_m = std::max(disc.radius_m, std::hypot(p.x() - disc.x_m, p.y() - disc.y_m));
      }
    }
    around_.push_back(disc);
  }
}

SweptClearance::Result SweptClearance::over(const std::vector<ExactArm::Shape>& shapes) const {
  Result best{kInfinity};
  for (std::size_t k = 0; k < shapes.size(); ++k) {
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
  const Disc& disc = around_[obstacle];
  std::vector<Cell> open{{0.5, 0.5, 0.5, 0.5}};
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    const double time_way = cell.half_time * arc.speed_m();
    const double place_way = cell.half_place * arc.length_m();
    const double slack = time_way + place_way - tolerance_m_;
    const Complex p = arc.at(cell.time, cell.place);
    if (std::abs(p - Complex(disc.x_m, disc.y_m)) - disc.radius_m >= best + slack) {
      continue;
    }
    const double distance = exact_distance(obstacles_[obstacle], p.real(), p.imag());
    best = std::min(best, distance);
    if (distance < best + slack) {
      const auto parts = halves(cell, time_way > place_way);
      open.insert(open.end(), parts.begin(), parts.end());
    }
  }
  return best;
}

}  // namespace limber
