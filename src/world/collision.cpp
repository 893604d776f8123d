#include "limber/world/collision.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "broad_phase.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

using Eigen::Vector2d;

// Both stay well inside CollisionChecker::kToleranceM together.
constexpr double kArcToleranceM = 0.25e-3;    // a chord's bulge that need not be split further
constexpr double kMotionToleranceM = 0.5e-3;  // a motion that need not be split further
constexpr int kMaxPieces = 32;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The middle line of one gap: an arc of constant curvature from `start` to `end` that turns by
/// `turn_rad`, |turn| ≤ π. With a half the turn and the chord as unit of length, the point at
/// β in [−a, a] lies (½ + sin β / 2 sin a) along the chord and (cos a − cos β) / 2 sin a beside it.
struct GapArc {
  Vector2d start;
  Vector2d end;
  double turn_rad;
};

/// tan(x) or a little more, for 0 ≤ x ≤ π/4.
double tangent_bound(double x) {
  return x * (1.0 + 0.4431 * x * x);
}

/// Farthest point of the arc from its chord, (c/2)·tan(turn/4), or a little more.
double bulge_m(double chord_m, double turn_rad) {
  return 0.5 * chord_m * tangent_bound(0.25 * std::abs(turn_rad));
}

/// At most half a turn: no arc that turns by more joins two plates, and what has no shape touches
/// everything. So it is no number, and neither is what is not finite.
double limited_turn(double turn_rad) {
  constexpr double kRoundingRad = 1e-4;  // of two headings in float32, after dozens of turns
  return std::abs(turn_rad) <= std::numbers::pi + kRoundingRad
             ? std::clamp(turn_rad, -std::numbers::pi, std::numbers::pi)
             : std::numeric_limits<double>::quiet_NaN();
}

template <class Scalar>
GapArc gap_arc(const Eigen::Ref<const BackboneOf<Scalar>>& backbone, int gap) {
  return {Vector2d(backbone(gap, 0), backbone(gap, 1)),
          Vector2d(backbone(gap + 1, 0), backbone(gap + 1, 1)),
          limited_turn(double(backbone(gap + 1, 2)) - double(backbone(gap, 2)))};
}

/// One gap while its plates move straight and turn evenly.
struct GapMotion {
  GapArc from;
  GapArc to;

  GapArc at(double fraction) const {
    return {from.start + fraction * (to.start - from.start),
            from.end + fraction * (to.end - from.end),
            from.turn_rad + fraction * (to.turn_rad - from.turn_rad)};
  }

  /// No point of the arc travels farther than this: its plates' distance, its bulge turning with
  /// the chord, and its bulge growing (the point over the chord changes by less than 0.3
  /// per radian of turn; tests/world/collision_test.cpp).
  double travel_bound_m() const {
    constexpr double kPointPerTurn = 0.3;
    const Vector2d start_shift = to.start - from.start;
    const Vector2d end_shift = to.end - from.end;
    const double chord = std::sqrt(
        std::max((from.end - from.start).squaredNorm(), (to.end - to.start).squaredNorm()));
    const double turn = std::max(std::abs(from.turn_rad), std::abs(to.turn_rad));
    return std::sqrt(std::max(start_shift.squaredNorm(), end_shift.squaredNorm())) +
           bulge_m(1.0, turn) * (end_shift - start_shift).norm() +
           kPointPerTurn * chord * std::abs(to.turn_rad - from.turn_rad);
  }
};

/// Calls visit(a, b, bulge) for chords of the arc short enough that none bulges by more than
/// kArcToleranceM, until it returns false.
template <class Visit>
void visit_pieces(const GapArc& arc, double bulge, Visit&& visit) {
  const int pieces = std::clamp(int(std::ceil(std::sqrt(bulge / kArcToleranceM))), 1, kMaxPieces);
  const double half = 0.5 * arc.turn_rad;
  const Vector2d chord = arc.end - arc.start;
  const Vector2d beside(-chord.y(), chord.x());
  const double scale = 0.5 / std::sin(half);
  Vector2d previous = arc.start;
  for (int k = 1; k <= pieces; ++k) {
    const double beta = half * (2.0 * k / pieces - 1.0);
    const Vector2d next = k == pieces ? arc.end
                                      : arc.start + (0.5 + std::sin(beta) * scale) * chord +
                                            (std::cos(half) - std::cos(beta)) * scale * beside;
    if (!visit(previous, next, bulge_m((next - previous).norm(), arc.turn_rad / pieces))) {
      return;
    }
    previous = next;
  }
}

/// True if an arc thickened by `radius` touches an obstacle; never false if it does.
bool arc_touches(const std::vector<ObstacleShape>& shapes, const GapArc& arc, double radius) {
  const double bulge = bulge_m((arc.end - arc.start).norm(), arc.turn_rad);
  const double reach = radius + bulge;
  if (!std::isfinite(reach)) {
    return true;  // no shape: a model that has run off
  }
  const double far = std::sqrt(std::max(arc.start.squaredNorm(), arc.end.squaredNorm())) + reach;
  const Box box = Box::around(arc.start, arc.end);
  for (const ObstacleShape& shape : shapes) {
    if (shape.base_distance_m > far) {
      return false;  // sorted: the others are farther still
    }
    if (squared_distance(box, shape.box) > reach * reach ||
        outside_distance(shape, arc.start, arc.end) > reach) {
      continue;
    }
    bool touches = bulge <= kArcToleranceM;
    if (!touches) {
      visit_pieces(arc, bulge, [&](const Vector2d& a, const Vector2d& b, double piece_bulge) {
        touches = outside_distance(shape, a, b) <= radius + piece_bulge;
        return !touches;
      });
    }
    if (touches) {
      return true;
    }
  }
  return false;
}

/// Lowers `best` to the clearance of a thickened arc if that is less.
void lower_by_arc(const std::vector<ObstacleShape>& shapes, const GapArc& arc, double radius,
                  int gap, Clearance& best) {
  const double bulge = bulge_m((arc.end - arc.start).norm(), arc.turn_rad);
  if (!shapes.empty() && !std::isfinite(bulge)) {
    best = {-kInfinity, gap, shapes.front().index};
    return;
  }
  const Box box = Box::around(arc.start, arc.end);
  for (const ObstacleShape& shape : shapes) {
    const double reach = best.value_m + radius + bulge;
    if (reach > 0.0 && squared_distance(box, shape.box) >= reach * reach) {
      continue;
    }
    const double whole = signed_distance(shape, arc.start, arc.end) - radius - bulge;
    double value = whole;
    if (value < best.value_m && bulge > kArcToleranceM) {
      double pieces = kInfinity;
      visit_pieces(arc, bulge, [&](const Vector2d& a, const Vector2d& b, double piece_bulge) {
        pieces = std::min(pieces, signed_distance(shape, a, b) - radius - piece_bulge);
        return true;
      });
      value = std::max(whole, pieces);  // both are bounds
    }
    if (value < best.value_m) {
      best = {value, gap, shape.index};
    }
  }
}

/// True if the gap stays free between the fractions `low` and `high` of its motion.
/// @param travel  bound on how far any of its points moves over the whole motion
bool motion_is_free(const std::vector<ObstacleShape>& shapes, const GapMotion& motion,
                    double radius, double travel, double low, double high) {
  const GapArc arc = motion.at(0.5 * (low + high));
  const double reach = 0.5 * (high - low) * travel;
  if (!arc_touches(shapes, arc, radius + reach)) {
    return true;
  }
  if (!(reach > kMotionToleranceM) || arc_touches(shapes, arc, radius)) {
    return false;
  }
  const double middle = 0.5 * (low + high);
  return motion_is_free(shapes, motion, radius, travel, low, middle) &&
         motion_is_free(shapes, motion, radius, travel, middle, high);
}

/// Lowers `best` to a bound on the gap's clearance between the fractions `low` and `high`.
/// @param known  bound on it from a longer interval; so that what motion_is_free calls free is > 0
void lower_by_motion(const std::vector<ObstacleShape>& shapes, const GapMotion& motion,
                     double radius, double travel, double low, double high, int gap, double known,
                     Clearance& best) {
  const double reach = 0.5 * (high - low) * travel;
  Clearance here{best.value_m + reach, -1, -1};  // farther than this can't matter
  lower_by_arc(shapes, motion.at(0.5 * (low + high)), radius, gap, here);
  if (here.obstacle < 0) {
    return;
  }
  known = std::max(known, here.value_m - reach);
  // A gap that no arm has may travel infinitely far, in however short a time.
  if (!(reach > kMotionToleranceM && reach < kInfinity)) {
    if (known < best.value_m) {
      best = {known, gap, here.obstacle};
    }
    return;
  }
  const double middle = 0.5 * (low + high);
  lower_by_motion(shapes, motion, radius, travel, low, middle, gap, known, best);
  lower_by_motion(shapes, motion, radius, travel, middle, high, gap, known, best);
}

/// Calls is_free(gap) for the gaps that boxes cannot clear, from the tip down, which travels
/// farthest and meets obstacles first. @return whether all of them are
template <class IsFree>
bool all_are_free(const BroadPhase& broad, int gaps, const Eigen::Ref<const Backbone>& from,
                  const Eigen::Ref<const Backbone>& to, IsFree&& is_free) {
  for (int first = (gaps - 1) / BroadPhase::kGaps * BroadPhase::kGaps; first >= 0;
       first -= BroadPhase::kGaps) {
    std::uint32_t left = broad.may_touch(from, to, first);
    while (left != 0) {
      const int i = std::bit_width(left) - 1;
      if (!is_free(first + i)) {
        return false;
      }
      left &= ~(std::uint32_t{1} << i);
    }
  }
  return true;
}

}  // namespace

CollisionChecker::CollisionChecker(const ArmDescription& arm,
                                   const std::vector<Obstacle>& obstacles, double margin_m,
                                   PlateRoom room)
    : room_(std::move(room)) {
  refuse_if(!(margin_m >= 0.0 && std::isfinite(margin_m)),
            "margin_m = {}; expected a distance in metres, at least 0", margin_m);
  if (const std::string why = why_not_solid(obstacles); !why.empty()) {
    throw InputError(why);
  }
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    obstacles_.push_back(make_obstacle_shape(obstacles[i], int(i)));
  }
  std::stable_sort(obstacles_.begin(), obstacles_.end(),
                   [](const ObstacleShape& a, const ObstacleShape& b) {
                     return a.base_distance_m < b.base_distance_m;
                   });
  for (const Segment& segment : arm.segments) {
    radius_m_.insert(radius_m_.end(), std::size_t(segment.gaps),
                     0.5 * segment.width_m + arm.actuator_radius_m + margin_m);
  }
  add_room();
  broad_ = std::make_unique<const BroadPhase>(obstacles_, radius_m_);
}

void CollisionChecker::add_room() {
  const std::vector<double>& full_m = room_.full_m;
  if (full_m.empty()) {
    room_.growth = {};
    return;
  }
  refuse_if(full_m.size() != radius_m_.size() + 1, "{} numbers of room; the arm has {} plates",
            full_m.size(), radius_m_.size() + 1);
  for (const double room : full_m) {
    refuse_if(!(room >= 0.0 && std::isfinite(room)),
              "room of {} m at a plate; expected a distance in metres, at least 0", room);
  }
  refuse_if(!room_.growth.is_constant() && room_.start.rows() != Eigen::Index(full_m.size()),
            "room grows from a start of {} plates; the arm has {}", room_.start.rows(),
            full_m.size());
  for (std::size_t gap = 0; gap < radius_m_.size(); ++gap) {
    radius_m_[gap] += std::max(full_m[gap], full_m[gap + 1]);
  }
}

CollisionChecker::CollisionChecker(CollisionChecker&&) noexcept = default;
CollisionChecker& CollisionChecker::operator=(CollisionChecker&&) noexcept = default;
CollisionChecker::~CollisionChecker() = default;

template <class Scalar>
double CollisionChecker::grown_room_m(int plate,
                                      const Eigen::Ref<const BackboneOf<Scalar>>& backbone) const {
  const double moved_m = std::hypot(double(backbone(plate, 0)) - double(room_.start(plate, 0)),
                                    double(backbone(plate, 1)) - double(room_.start(plate, 1)));
  return room_.full_m[plate] * room_.growth.share_after(moved_m);
}

/// The larger room of the gap's plates. A plate that moves straight is farthest from where it
/// started at one of the motion's ends, so its room is nowhere larger than at both.
template <class Scalar>
double CollisionChecker::radius_between_m(int gap, const Eigen::Ref<const BackboneOf<Scalar>>& from,
                                          const Eigen::Ref<const BackboneOf<Scalar>>& to) const {
  const double full_m = radius_m(gap);
  if (room_.growth.is_constant()) {
    return full_m;
  }
  const double grown_m =
      std::max({grown_room_m<Scalar>(gap, from), grown_room_m<Scalar>(gap + 1, from),
                grown_room_m<Scalar>(gap, to), grown_room_m<Scalar>(gap + 1, to)});
  return full_m - std::max(room_.full_m[gap], room_.full_m[gap + 1]) + grown_m;
}

template <class Scalar>
Clearance CollisionChecker::clearance_below(const Eigen::Ref<const BackboneOf<Scalar>>& backbone,
                                            double below_m) const {
  Clearance best{below_m, -1, -1};
  for (int gap = 0; gap < gap_count(); ++gap) {
    lower_by_arc(obstacles_, gap_arc<Scalar>(backbone, gap),
                 radius_between_m<Scalar>(gap, backbone, backbone), gap, best);
  }
  return best;
}

Clearance CollisionChecker::clearance(const Eigen::Ref<const Backbone>& backbone) const {
  return clearance_below<float>(backbone, kInfinity);
}

Clearance CollisionChecker::clearance(const Eigen::Ref<const BackboneD>& backbone) const {
  return clearance_below<double>(backbone, kInfinity);
}

bool CollisionChecker::is_free(const Eigen::Ref<const Backbone>& backbone) const {
  return all_are_free(*broad_, gap_count(), backbone, backbone, [&](int gap) {
    return !arc_touches(obstacles_, gap_arc<float>(backbone, gap),
                        radius_between_m<float>(gap, backbone, backbone));
  });
}

bool CollisionChecker::is_free(const Eigen::Ref<const BackboneD>& backbone) const {
  for (int gap = 0; gap < gap_count(); ++gap) {
    if (arc_touches(obstacles_, gap_arc<double>(backbone, gap),
                    radius_between_m<double>(gap, backbone, backbone))) {
      return false;
    }
  }
  return true;
}

bool CollisionChecker::is_motion_free(const Eigen::Ref<const Backbone>& from,
                                      const Eigen::Ref<const Backbone>& to) const {
  return all_are_free(*broad_, gap_count(), from, to, [&](int gap) {
    const GapMotion motion{gap_arc<float>(from, gap), gap_arc<float>(to, gap)};
    return motion_is_free(obstacles_, motion, radius_between_m<float>(gap, from, to),
                          motion.travel_bound_m(), 0.0, 1.0);
  });
}

Clearance CollisionChecker::motion_clearance(const Eigen::Ref<const Backbone>& from,
                                             const Eigen::Ref<const Backbone>& to,
                                             double below_m) const {
  const Clearance at_start = clearance_below<float>(from, below_m);
  const Clearance at_end = clearance_below<float>(to, at_start.value_m);
  // The ends bound the search from above; both are bounds from below, hence the tolerance.
  Clearance best = at_end.obstacle >= 0 ? at_end : at_start;
  best.value_m = std::min(best.value_m + kToleranceM, below_m);
  for (int gap = 0; gap < gap_count(); ++gap) {
    const GapMotion motion{gap_arc<float>(from, gap), gap_arc<float>(to, gap)};
    lower_by_motion(obstacles_, motion, radius_between_m<float>(gap, from, to),
                    motion.travel_bound_m(), 0.0, 1.0, gap, -kInfinity, best);
  }
  return best;
}

}  // namespace limber
