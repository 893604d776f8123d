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

/// sin(x)/x where the sine is known.
double sinc_of(double x, double sine) {
  return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : sine / x;
}

Complex point_of(const Pose& pose) {
  return {pose.x_m, pose.y_m};
}

}  // namespace

/// A gap between two frames. Time runs from 0 to 1, position from 0 at the lower plate to 1.
class SweptClearance::MovingArc {
 public:
  MovingArc(const Pose& start_from, const Pose& end_from, const Pose& start_to, const Pose& end_to)
      : start_(point_of(start_from)),
        start_shift_(point_of(start_to) - start_),
        chord_(point_of(end_from) - start_),
        chord_shift_(point_of(end_to) - point_of(start_to) - chord_),
        turn_(end_from.theta_rad - start_from.theta_rad),
        turn_shift_(end_to.theta_rad - start_to.theta_rad - turn_) {
    // With φ the turn, a point is s + c·w(u, φ), w = ∫₀ᵘ e^{iφ(σ−½)} dσ / D, D = sinc(φ/2) ≥ 2/π.
    // |w| ≤ 1 up to half a turn, |∂w/∂u| = 1/D, |∂w/∂φ| ≤ (¼ + |D'|)/D ≤ (¼ + 2/π²)·π/2, and
    // |∂²w/∂u∂φ| ≤ ½/D + |D'|/D² ≤ π/4 + 2/π²·π²/4.
    constexpr double kPointPerTurn = 0.72;
    constexpr double kTangentPerTurn = 1.29;
    const double longest = std::max(std::abs(chord_), std::abs(chord_ + chord_shift_));
    const double max_turn = std::max(std::abs(turn_), std::abs(turn_ + turn_shift_));
    const double end_speed = std::abs(start_shift_ + chord_shift_);
    speed_m_ = std::min(std::abs(start_shift_), end_speed) + std::abs(chord_shift_) +
               kPointPerTurn * longest * std::abs(turn_shift_);
    length_m_ = longest / sinc_of(max_turn / 2.0, std::sin(max_turn / 2.0));
    tangent_per_fraction_m_ = length_m_ * max_turn;
    tangent_per_time_m_ = std::numbers::pi / 2.0 * std::abs(chord_shift_) +
                          kTangentPerTurn * longest * std::abs(turn_shift_);
  }

  /// A point, and how it moves with its position.
  struct Point {
    Complex at_m;
    Complex tangent_m;
  };
  /// The arc as it is at one time.
  class Still {
   public:
    Still(Complex start, Complex chord, double turn)
        : start_(start), half_turn_(turn / 2.0), back_(std::polar(1.0, -half_turn_)) {
      scaled_chord_ = chord / sinc_of(half_turn_, -back_.imag());
    }

    /// With a = φu/2: w·D = u·sinc(a)·e^{i(a − φ/2)}, and ∂w/∂u·D = e^{i(2a − φ/2)}.
    Point at(double fraction) const {
      const double a = half_turn_ * fraction;
      const Complex turned = std::polar(1.0, a);
      const Complex along = scaled_chord_ * turned * back_;
      return {start_ + fraction * sinc_of(a, turned.imag()) * along, along * turned};
    }

   private:
    Complex start_, scaled_chord_;
    double half_turn_;
    Complex back_;
  };
  Still still(double time) const {
    return {start_ + time * start_shift_, chord_ + time * chord_shift_, turn_ + time * turn_shift_};
  }

  double speed_m() const { return speed_m_; }    ///< bound on how far a point moves over all time
  double length_m() const { return length_m_; }  ///< bound on the arc's length at any time

  /// Bound on how far a point moves in direction −`away` when its position changes by
  /// `half_fraction` and time by `half_time`, its way over time not counted.
  double approach_m(const Point& middle, Complex away, double half_time,
                    double half_fraction) const {
    const double slope =
        std::abs(middle.tangent_m.real() * away.real() + middle.tangent_m.imag() * away.imag());
    return half_fraction * (slope + tangent_per_time_m_ * half_time +
                            0.5 * tangent_per_fraction_m_ * half_fraction);
  }

 private:
  Complex start_, start_shift_, chord_, chord_shift_;
  double turn_, turn_shift_;
  double speed_m_ = 0.0;
  double length_m_ = 0.0;
  double tangent_per_fraction_m_ = 0.0;
  double tangent_per_time_m_ = 0.0;
};

/// A rectangle of time and position, by its middle and half its sizes.
struct SweptCell {
  double time, fraction, half_time, half_fraction;
};

namespace {
std::array<SweptCell, 2> halves(const SweptCell& cell, bool by_time) {
  SweptCell low = cell;
  SweptCell high = cell;
  if (by_time) {
    low.half_time = high.half_time = cell.half_time / 2.0;
    low.time -= low.half_time;
    high.time += high.half_time;
  } else {
    low.half_fraction = high.half_fraction = cell.half_fraction / 2.0;
    low.fraction -= low.half_fraction;
    high.fraction += high.half_fraction;
  }
  return {low, high};
}

/// Covers the middle line of a gap over its motion: its plates' four points, and the bulge of an
/// arc beside its chord, (c/2)·tan(φ/4), which is at most (c/2)·φ/π up to half a turn.
CoveringBox box_about(const Pose& start_from, const Pose& end_from, const Pose& start_to,
                      const Pose& end_to) {
  CoveringBox box;
  for (const Pose* pose : {&start_from, &end_from, &start_to, &end_to}) {
    box.cover(point_of(*pose));
  }
  // Between frames neither chord nor turn is larger than at both ends.
  const double max_chord =
      std::max(std::abs(end_from.x_m - start_from.x_m) + std::abs(end_from.y_m - start_from.y_m),
               std::abs(end_to.x_m - start_to.x_m) + std::abs(end_to.y_m - start_to.y_m));
  const double max_turn = std::max(std::abs(end_from.theta_rad - start_from.theta_rad),
                                   std::abs(end_to.theta_rad - start_to.theta_rad));
  const double max_bulge = max_chord / 2.0 * max_turn / std::numbers::pi;
  box.low -= Complex(max_bulge, max_bulge);
  box.high += Complex(max_bulge, max_bulge);
  return box;
}

}  // namespace

/// One search: the best value so far, and its scratch.
class SweptClearance::Search {
 public:
  Search(const SweptClearance& clearance, const std::vector<ExactArm::Shape>& shapes,
         const std::function<bool()>& give_up, const SweptRoom& room)
      : clearance_(clearance), shapes_(shapes), give_up_(give_up) {
    std::vector<double> before_m;
    for (const ExactArm::Shape& shape : shapes) {
      const std::vector<double> now_m = room_in(shape, room);
      radius_m_.push_back(radius_over(before_m.empty() ? now_m : before_m, now_m));
      max_radius_m_ = std::max(max_radius_m_,
                               *std::max_element(radius_m_.back().begin(), radius_m_.back().end()));
      before_m = now_m;
    }
  }

  Result run() {
    find_bound();
    // A little above the bound, so that the gap that attains it is found again, and can be named.
    best_.value_m += 2.0 * clearance_.tolerance_m_;
    for (std::size_t k = 0; k < shapes_.size() && begin_frame(); ++k) {
      look_at_frame(k);
    }
    best_.value_m -= clearance_.tolerance_m_;
    best_.is_finished = !give_up_.is_given_up();
    return best_;
  }

 private:
  /// Of each plate.
  std::vector<double> room_in(const ExactArm::Shape& shape, const SweptRoom& room) const {
    std::vector<double> room_m = room.plate_m;
    for (std::size_t i = 0; i < room_m.size() && room.full_after_m > 0.0; ++i) {
      const double moved = std::abs(point_of(shape[i]) - point_of(shapes_.front()[i]));
      const double grown = std::min(moved / room.full_after_m, 1.0);
      room_m[i] *= room.start_share * (1.0 - grown) + grown;
    }
    return room_m;
  }

  /// Of each gap over a motion. A plate that moves straight is farthest from anywhere at one of its
  /// ends, so it has the most room there.
  std::vector<double> radius_over(const std::vector<double>& from_m,
                                  const std::vector<double>& to_m) const {
    std::vector<double> radius_m = clearance_.radius_m_;
    for (std::size_t gap = 0; gap + 1 < to_m.size(); ++gap) {
      radius_m[gap] += std::max({from_m[gap], from_m[gap + 1], to_m[gap], to_m[gap + 1]});
    }
    return radius_m;
  }

  /// @return whether to go on
  bool begin_frame() {
    if (!was_interrupted_) {
      throw_if_interrupted();
    }
    return !give_up_.now();
  }

  /// A value that the arm attains: of a plate, which needs no arc, then of the gaps beside the
  /// plate that is nearest.
  void find_bound() {
    Result nearest{kInfinity};
    for (std::size_t k = 0; k < shapes_.size() && begin_frame(); ++k) {
      const ExactArm::Shape& shape = shapes_[k];
      CoveringBox box;
      for (const Pose& plate : shape) {
        box.cover(point_of(plate));
      }
      find_near(box, nearest.value_m);
      for (std::size_t i = 0; i < shape.size(); ++i) {
        for (const std::size_t o : near_) {
          if (give_up_.seldom()) {
            return;
          }
          lower_by_plate(k, i, o, nearest);
        }
      }
    }
    best_.value_m = nearest.value_m;
    if (nearest.obstacle < 0) {
      return;
    }
    const auto k = std::size_t(nearest.frame);
    const auto plate = std::size_t(nearest.gap);
    for (std::size_t gap = plate == 0 ? 0 : plate - 1; gap <= plate && gap < radius_m_[k].size();
         ++gap) {
      look_at_gap(k, gap, std::size_t(nearest.obstacle));
    }
    best_ = {best_.value_m};
  }

  /// @param nearest  `gap` is the plate
  void lower_by_plate(std::size_t k, std::size_t plate, std::size_t o, Result& nearest) const {
    const std::vector<double>& radius = radius_m_[k];
    const double thickest =
        std::max(radius[plate == 0 ? 0 : plate - 1], radius[std::min(plate, radius.size() - 1)]);
    const CoveredObstacle& obstacle = clearance_.obstacles_[o];
    const Complex p = point_of(shapes_[k][plate]);
    if (obstacle.box.distance_m(p) - thickest >= nearest.value_m) {
      return;
    }
    const double value = obstacle.read(p).distance_m - thickest;
    if (value < nearest.value_m) {
      nearest = {value, int(k), int(plate), int(o)};
    }
  }

  /// Lists the obstacles whose boxes may be nearer than `value_m` to what the box covers.
  void find_near(const CoveringBox& box, double value_m) {
    near_.clear();
    const double reach = std::max(0.0, value_m + max_radius_m_);
    for (std::size_t o = 0; o < clearance_.obstacles_.size(); ++o) {
      if (clearance_.obstacles_[o].box.squared_distance(box) <= reach * reach) {
        near_.push_back(o);
      }
    }
  }

  void look_at_frame(std::size_t k) {
    const ExactArm::Shape& from = shapes_[k == 0 ? 0 : k - 1];
    const ExactArm::Shape& to = shapes_[k];
    gap_boxes_.clear();
    CoveringBox all;
    for (std::size_t gap = 0; gap + 1 < to.size(); ++gap) {
      gap_boxes_.push_back(box_about(from[gap], from[gap + 1], to[gap], to[gap + 1]));
      all.cover(gap_boxes_.back());
    }
    find_near(all, best_.value_m);
    for (std::size_t gap = 0; gap < gap_boxes_.size(); ++gap) {
      for (const std::size_t o : near_) {
        const double reach = std::max(0.0, best_.value_m + radius_m_[k][gap]);
        if (clearance_.obstacles_[o].box.squared_distance(gap_boxes_[gap]) <= reach * reach) {
          look_at_gap(k, gap, o);
        }
        if (give_up_.seldom()) {
          return;
        }
      }
    }
  }

  void look_at_gap(std::size_t k, std::size_t gap, std::size_t o) {
    const ExactArm::Shape& from = shapes_[k == 0 ? 0 : k - 1];
    const ExactArm::Shape& to = shapes_[k];
    const MovingArc arc(from[gap], from[gap + 1], to[gap], to[gap + 1]);
    const double radius = radius_m_[k][gap];
    const double known = best_.value_m + radius;
    const double value = lowest(arc, clearance_.obstacles_[o], known);
    if (value < known) {  // compared before the radius is taken off again: rounding finds nothing
      best_ = {value - radius, int(k), int(gap), int(o)};
    }
  }

  /// Smallest distance of the arc's middle line from an obstacle, or `best` if that is less.
  double lowest(const MovingArc& arc, const CoveredObstacle& obstacle, double best) {
    open_.assign(1, {0.5, 0.5, 0.5, 0.5});
    double time = open_.back().time;
    MovingArc::Still still = arc.still(time);
    while (!open_.empty() && !give_up_.seldom()) {
      const SweptCell cell = open_.back();
      open_.pop_back();
      const double time_reach = cell.half_time * arc.speed_m();
      double fraction_reach = cell.half_fraction * arc.length_m();
      if (cell.time != time) {  // cells of one time mostly follow one another
        time = cell.time;
        still = arc.still(time);
      }
      const MovingArc::Point middle = still.at(cell.fraction);
      const double enough = best - clearance_.tolerance_m_;
      if (obstacle.box.distance_m(middle.at_m) >= enough + time_reach + fraction_reach) {
        continue;
      }
      const Reading reading = obstacle.read(middle.at_m);
      best = std::min(best, reading.distance_m);
      if (reading.away != Complex(0.0)) {
        fraction_reach =
            std::min(fraction_reach,
                     arc.approach_m(middle, reading.away, cell.half_time, cell.half_fraction));
      }
      if (reading.distance_m < best - clearance_.tolerance_m_ + time_reach + fraction_reach) {
        const auto parts = halves(cell, time_reach > fraction_reach);
        open_.insert(open_.end(), parts.begin(), parts.end());
      }
    }
    return best;
  }

  const SweptClearance& clearance_;
  const std::vector<ExactArm::Shape>& shapes_;
  GiveUp give_up_;
  std::vector<std::vector<double>> radius_m_;  // of each motion's gaps, with their room
  double max_radius_m_ = 0.0;
  // A signal from before has been heeded by the caller, who asks for this all the same.
  const bool was_interrupted_ = interrupt_requested();
  Result best_{kInfinity};
  std::vector<std::size_t> near_;
  std::vector<CoveringBox> gap_boxes_;
  std::vector<SweptCell> open_;
};

SweptClearance::SweptClearance(const ArmDescription& arm, const std::vector<Obstacle>& obstacles,
                               double tolerance_m)
    : tolerance_m_(tolerance_m), obstacles_(obstacles.begin(), obstacles.end()) {
  for (const Segment& segment : arm.segments) {
    radius_m_.insert(radius_m_.end(), std::size_t(segment.gaps),
                     segment.width_m / 2.0 + arm.actuator_radius_m);
  }
}

SweptClearance::Result SweptClearance::over(const std::vector<ExactArm::Shape>& shapes,
                                            const std::function<bool()>& give_up,
                                            const SweptRoom& room) const {
  return Search(*this, shapes, give_up, room).run();
}

}  // namespace limber
