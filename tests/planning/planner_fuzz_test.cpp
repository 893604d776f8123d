// Planners on drawn problems (drawn_problem.hpp): every plan through the certificate, and through
// geometry that is written out here and shares nothing with either: set points from their
// definitions, shapes by complex numbers, clearances by sampling.
#include <complex>
#include <cstdlib>
#include <limits>
#include <span>

#include <gmock/gmock.h>

#include "limber/certificate/certificate.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "planning/drawn_problem.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using Point = std::complex<double>;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

constexpr double kRoundingKpa = 1e-3;  // float32 set points
constexpr double kShapeM = 1e-4;       // float32 shapes at the tip of a long chain
constexpr double kHeadingRad = 1e-3;   // the same
constexpr double kRoundingM = 1e-6;    // of clearances on the same float32 shapes
constexpr double kCheckerM = 1.5e-3;   // by which planners' bounds lie below true clearances
constexpr double kReserveM = 1e-4;     // that plans keep inside the goal for the certificate
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kStartSamplesPerGap = 200;
constexpr int kTimesPerFrame = 4;
constexpr std::uint64_t kEveryOneOf = 4;  // is also planned by other threads, and written

// --- shapes -------------------------------------------------------------------------------------

/// Along an arc of unit length that turns by a: ∫ e^{i a s} ds from 0 to s.
Point along_arc(double a, double s) {
  return std::abs(a) < 1e-6 ? Point(s, 0.5 * a * s * s)
                            : (std::polar(1.0, a * s) - 1.0) / Point(0.0, a);
}

/// (3), (4) or, of an arm that bends by its command, (17); chained from the base.
BackboneD no_load_shape(const ArmDescription& arm, const Pressures& kpa) {
  BackboneD shape = BackboneD::Zero(arm.point_count(), 3);
  Point at = 0.0;
  double heading = 0.0;
  int plate = 0;
  for (int i = 0; i < arm.segment_count(); ++i) {
    const Segment& s = arm.segments[static_cast<std::size_t>(i)];
    double length = s.length_m;
    double turn = s.curvature_per_unit * double(kpa[i]) * length;
    if (arm.no_load == NoLoadKind::strain_polynomial) {
      const double p = std::abs(double(kpa[i]));
      const double e = s.strain_polynomial[0] * p + s.strain_polynomial[1] * p * p;
      turn = (kpa[i] > 0.0F ? -e : e) * s.length_m / s.width_m;
      length = (1.0 - 0.5 * e) * s.length_m;
    }
    for (int g = 0; g < s.gaps; ++g) {
      at += std::polar(length / s.gaps, heading) * along_arc(turn / s.gaps, 1.0);
      heading += turn / s.gaps;
      shape.row(++plate) << at.real(), at.imag(), heading;
    }
  }
  return shape;
}

/// What the play does, and the change that goes on (play_model.hpp), in closed form.
BackboneD next_shape(const DrawnProblem& drawn, const Pressures& kpa, const BackboneD& before,
                     const BackboneD& now) {
  const BackboneD free = no_load_shape(drawn.arm, kpa);
  BackboneD next = free;
  if (drawn.play_m > 0.0) {
    next.leftCols<2>() = now.leftCols<2>()
                             .cwiseMax((free.leftCols<2>().array() - drawn.play_m).matrix())
                             .cwiseMin((free.leftCols<2>().array() + drawn.play_m).matrix());
  }
  return next + drawn.momentum * (now - before);
}

// --- distances ----------------------------------------------------------------------------------

double distance_to_edge(Point p, Point a, Point b) {
  const double share = ((p - a) * std::conj(b - a)).real() / std::norm(b - a);
  return std::abs(p - a - std::clamp(share, 0.0, 1.0) * (b - a));
}

/// Negative inside: a ray to the right crosses an odd number of edges.
double distance_to_corners(Point p, const std::vector<Point>& corners) {
  double nearest = kInfinity;
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i];
    const Point b = corners[(i + 1) % corners.size()];
    nearest = std::min(nearest, distance_to_edge(p, a, b));
    if ((a.imag() > p.imag()) != (b.imag() > p.imag())) {
      const double share = (p.imag() - a.imag()) / (b.imag() - a.imag());
      inside ^= a.real() + share * (b.real() - a.real()) > p.real();
    }
  }
  return inside ? -nearest : nearest;
}

double distance(const Obstacle& obstacle, Point p) {
  if (const auto* circle = std::get_if<Circle>(&obstacle)) {
    return std::abs(p - Point(circle->x_m, circle->y_m)) - circle->radius_m;
  }
  std::vector<Point> corners;
  if (const auto* r = std::get_if<Rectangle>(&obstacle)) {
    for (const Point unit : {Point(-1, -1), Point(1, -1), Point(1, 1), Point(-1, 1)}) {
      corners.push_back(Point(r->x_m, r->y_m) +
                        std::polar(0.5, r->angle_rad) *
                            Point(unit.real() * r->width_m, unit.imag() * r->height_m));
    }
  } else {
    for (const Eigen::Vector2d& corner : std::get<Polygon>(obstacle).points_m) {
      corners.emplace_back(corner.x(), corner.y());
    }
  }
  return distance_to_corners(p, corners);
}

/// Of points on each gap's arc; never below the true clearance.
double sampled_clearance(const DrawnProblem& drawn, const BackboneD& shape,
                         int samples_per_gap = 5) {
  double smallest = kInfinity;
  for (int gap = 0; gap + 1 < shape.rows(); ++gap) {
    const auto& segment =
        drawn.arm.segments[static_cast<std::size_t>(drawn.arm.segment_of_gap(gap))];
    const double radius = 0.5 * segment.width_m + drawn.arm.actuator_radius_m;
    const Point from(shape(gap, 0), shape(gap, 1));
    const Point chord = Point(shape(gap + 1, 0), shape(gap + 1, 1)) - from;
    const double turn = shape(gap + 1, 2) - shape(gap, 2);
    for (int k = 0; k < samples_per_gap; ++k) {
      const double s = double(k) / (samples_per_gap - 1);
      const Point p = from + chord * along_arc(turn, s) / along_arc(turn, 1.0);
      for (const Obstacle& obstacle : drawn.environment.obstacles) {
        smallest = std::min(smallest, distance(obstacle, p) - radius);
      }
    }
  }
  return smallest;
}

double sampled_clearance(const DrawnProblem& drawn, std::span<const PlanFrame> frames) {
  double smallest = kInfinity;
  for (std::size_t k = 1; k < frames.size(); ++k) {
    const BackboneD from = frames[k - 1].backbone.cast<double>();
    const BackboneD to = frames[k].backbone.cast<double>();
    for (int t = 0; t < kTimesPerFrame; ++t) {
      smallest = std::min(
          smallest, sampled_clearance(drawn, from + double(t) / kTimesPerFrame * (to - from)));
    }
  }
  return std::min(smallest, sampled_clearance(drawn, frames.back().backbone.cast<double>()));
}

// --- what is wrong with a result ----------------------------------------------------------------

using Waypoints = std::vector<Pressures>;
using Faults = std::vector<std::string>;

void check_setpoints(const DrawnProblem& drawn, const Plan& plan, Faults& faults) {
  const double step = drawn.arm.pressure_rate_limit_kpa_per_s / drawn.arm.frame_rate_hz;
  double cost = 0.0;
  for (std::size_t k = 0; k < plan.frames.size(); ++k) {
    for (int i = 0; i < drawn.arm.segment_count(); ++i) {
      const double kpa = plan.frames[k].setpoint_kpa[i];
      const PressureLimits& limit = drawn.limits.empty()
                                        ? drawn.arm.segments[std::size_t(i)].pressure_limit_kpa
                                        : drawn.limits[std::size_t(i)];
      if (!(kpa >= limit.lower_kpa - kRoundingKpa && kpa <= limit.upper_kpa + kRoundingKpa)) {
        faults.push_back(fmt::format("frame {}: segment {} at {}", k, i, kpa));
      }
      const double change =
          k == 0 ? 0.0 : std::abs(kpa - double(plan.frames[k - 1].setpoint_kpa[i]));
      cost += change;
      if (!(change <= step + kRoundingKpa)) {
        faults.push_back(fmt::format("frame {}: segment {} goes {} of {}", k, i, change, step));
      }
      const bool is_held = k + std::size_t(plan.hold_frame_count) >= plan.frames.size();
      if (is_held && change != 0.0) {
        faults.push_back(fmt::format("frame {}: the hold moves by {}", k, change));
      }
    }
  }
  if (std::abs(cost - plan.cost_kpa) > 1e-6 * (1.0 + cost)) {
    faults.push_back(fmt::format("cost {}, recomputed {}", plan.cost_kpa, cost));
  }
}

/// Frame by frame, each from the plan's own pressures; rounding must not grow along the plan.
void check_shapes(const DrawnProblem& drawn, const Plan& plan, Faults& faults) {
  BackboneD before = plan.frames[0].backbone.cast<double>();
  BackboneD now = before;
  for (std::size_t k = 1; k < plan.frames.size(); ++k) {
    const BackboneD next = next_shape(drawn, plan.frames[k].pressure_kpa, before, now);
    before = now;
    now = plan.frames[k].backbone.cast<double>();
    const double off_m = (next - now).leftCols<2>().cwiseAbs().maxCoeff();
    const double off_rad = (next - now).col(2).cwiseAbs().maxCoeff();
    if (!(off_m <= kShapeM && off_rad <= kHeadingRad)) {
      faults.push_back(fmt::format("frame {}: shape off by {} m, {} rad", k, off_m, off_rad));
    }
    if (plan.valves_hash.empty() && plan.frames[k].pressure_kpa != plan.frames[k].setpoint_kpa) {
      faults.push_back(fmt::format("frame {}: pressures are not the set points", k));
    }
  }
}

/// Of a motion that is no plan, its hold may collide: nobody looks at it.
void check_clearance(const DrawnProblem& drawn, const Plan& plan, bool is_plan, Faults& faults) {
  const std::size_t count = plan.frames.size() - (is_plan ? 0 : std::size_t(plan.hold_frame_count));
  const double sampled = sampled_clearance(drawn, std::span(plan.frames).first(count));
  if (!(sampled >= drawn.margin_m)) {
    faults.push_back(fmt::format("clearance {}, margin {}", sampled, drawn.margin_m));
  }
  if (is_plan && !(plan.clearance_m <= sampled + kRoundingM)) {
    faults.push_back(fmt::format("clearance {} claimed, {} sampled", plan.clearance_m, sampled));
  }
}

void check_goal(const DrawnProblem& drawn, const Plan& plan, Faults& faults) {
  const PoseGoal& goal = drawn.environment.goal;
  const BackboneD last = plan.frames.back().backbone.cast<double>();
  const Eigen::Index tip = last.rows() - 1;
  const double off_m = std::hypot(last(tip, 0) - goal.x_m, last(tip, 1) - goal.y_m);
  if (!(off_m <= goal.position_tolerance_m - drawn.goal_margin_m + kRoundingM)) {
    faults.push_back(fmt::format("ends {} m from the goal", off_m));
  }
  if (goal.theta_rad) {
    const double off_rad = std::abs(std::arg(std::polar(1.0, last(tip, 2) - *goal.theta_rad)));
    if (!(off_rad <= goal.orientation_tolerance_rad + kRoundingM)) {
      faults.push_back(fmt::format("ends {} rad from the goal", off_rad));
    }
  }
}

void check_plan(const DrawnProblem& drawn, const Plan& plan, Faults& faults) {
  check_setpoints(drawn, plan, faults);
  check_shapes(drawn, plan, faults);
  check_clearance(drawn, plan, true, faults);
  check_goal(drawn, plan, faults);
  const CompensationModel* network =
      drawn.forward.has_network() ? &drawn.forward.compensation() : nullptr;
  const ValveParameters valves = plan.valves_hash.empty() ? ValveParameters{} : drawn.valves;
  for (const CertificateFailure& failure :
       certify(plan, drawn.arm, network, valves, drawn.environment).failures) {
    faults.push_back(fmt::format("certificate: {}: {}", failure.check, failure.message));
  }
}

/// Of the start, less the margin; below 0, too, where it is beyond the limits to plan within.
double start_clearance(const DrawnProblem& drawn) {
  const ArmStart start = start_state(drawn.environment, drawn.arm);
  for (std::size_t i = 0; i < drawn.limits.size(); ++i) {
    const double kpa = start.pressures_kpa[Eigen::Index(i)];
    if (kpa < drawn.limits[i].lower_kpa || kpa > drawn.limits[i].upper_kpa) {
      return -1.0;
    }
  }
  return sampled_clearance(drawn, start.backbone.cast<double>(), kStartSamplesPerGap) -
         drawn.margin_m;
}

/// A refusal has to be true, and what is true has to be refused.
void check_refusal(const DrawnProblem& drawn, PlanStatus status, Faults& faults) {
  const double at_start = start_clearance(drawn);
  if (status == PlanStatus::invalid_start ? at_start > kCheckerM : at_start < 0.0) {
    faults.push_back(fmt::format("{}; the start's clearance is {}", to_string(status), at_start));
  }
  const PoseGoal& goal = drawn.environment.goal;
  const double tolerance_m = goal.position_tolerance_m - drawn.goal_margin_m;
  const double beyond_m = std::hypot(goal.x_m, goal.y_m) - tolerance_m - drawn.arm.length_m();
  const bool is_unreachable = status == PlanStatus::goal_unreachable;
  if (status != PlanStatus::invalid_start &&
      (is_unreachable ? beyond_m < -kReserveM : beyond_m > 0.0)) {
    faults.push_back(fmt::format("{}; the goal is {} m too far", to_string(status), beyond_m));
  }
  if (status == PlanStatus::goal_in_collision) {
    double nearest = kInfinity;
    for (const Obstacle& obstacle : drawn.environment.obstacles) {
      nearest = std::min(nearest, distance(obstacle, {goal.x_m, goal.y_m}));
    }
    const double radius = 0.5 * drawn.arm.segments.back().width_m + drawn.arm.actuator_radius_m;
    if (nearest + tolerance_m > radius + drawn.margin_m + kCheckerM) {
      faults.push_back(fmt::format("goal_in_collision; {} m from an obstacle", nearest));
    }
  }
}

Faults faults_of(const DrawnProblem& drawn, const PlanResult& result) {
  Faults faults;
  check_refusal(drawn, result.status, faults);
  if (result.plan.has_value() != (result.status == PlanStatus::solved)) {
    faults.push_back(
        fmt::format("{} and a plan: {}", to_string(result.status), result.plan.has_value()));
  }
  if (result.status == PlanStatus::not_certified) {
    faults.push_back("not certified: " + result.reason);
  }
  if (result.plan) {
    check_plan(drawn, *result.plan, faults);
  } else if (result.best_partial) {
    check_setpoints(drawn, *result.best_partial, faults);
    check_shapes(drawn, *result.best_partial, faults);
    check_clearance(drawn, *result.best_partial, false, faults);
  }
  return faults;
}

void expect_same_for_other_threads(const DrawnProblem& drawn, const PlanResult& result) {
  const PlanResult again = drawn.plan(drawn.jobs == 1 ? 3 : 1);
  EXPECT_EQ(again.status, result.status) << drawn.reproduction();
  EXPECT_EQ(again.statistics.queries, result.statistics.queries) << drawn.reproduction();
  EXPECT_EQ(again.plan ? again.plan->waypoints_kpa : Waypoints{},
            result.plan ? result.plan->waypoints_kpa : Waypoints{})
      << drawn.reproduction();
}

/// What a plan's file says is the plan: read and written again, it is the same file.
void expect_file_comes_back(const Plan& plan) {
  const TemporaryFolder folder;
  write_plan(folder.path() / "first.json", plan);
  write_plan(folder.path() / "second.json", read_plan(folder.path() / "first.json"));
  EXPECT_EQ(read_file(folder.path() / "second.json"), read_file(folder.path() / "first.json"));
}

std::uint64_t asked(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

TEST(PlannerFuzz, PlansAndRefusalsOfDrawnProblemsAreTrue) {
  const std::uint64_t first = asked("LIMBER_FUZZ_FIRST", 1);
  const std::uint64_t draws = asked("LIMBER_FUZZ_DRAWS", 40);
  std::uint64_t solved = 0;
  for (std::uint64_t number = first; number < first + draws; ++number) {
    const DrawnProblem drawn(number);
    const PlanResult result = drawn.plan(drawn.jobs);
    solved += result.plan ? 1 : 0;
    EXPECT_THAT(faults_of(drawn, result), IsEmpty()) << drawn.reproduction();
    if (number % kEveryOneOf == 0) {
      expect_same_for_other_threads(drawn, result);
    }
    if (number % kEveryOneOf == 0 && result.plan) {
      expect_file_comes_back(*result.plan);
    }
  }
  RecordProperty("solved", std::to_string(solved));  // in --gtest_output
  if (draws >= 40) {
    EXPECT_GE(solved, draws / 4) << "too few plans to say anything of them";
  }
}

TEST(PlannerFuzz, ArmsInSpaceAreRefusedByName) {
  for (std::uint64_t number = 1; number <= 5; ++number) {
    RandomStream random(number, 0);
    const ArmDescription arm = drawn::space_arm(number, random);
    const ForwardModel model(arm);
    Environment environment;
    environment.goal.x_m = 0.5 * arm.length_m();
    const PlanningProblem problem{arm, MotionModel(model), environment};
    PlannerLimits limits;
    limits.iterations = 10;
    const auto is_refused = ThrowsMessage<InputError>(HasSubstr("in space yet, and '" + arm.name));
    for (const char* planner : {"default", "paper"}) {
      EXPECT_THAT([&] { (void)make_planner(planner)->plan(problem, limits, 1); }, is_refused);
    }
    EXPECT_THAT([&] { (void)plan_along(problem, {drawn::pressures(arm, random)}, "mine"); },
                is_refused);
  }
}

}  // namespace
}  // namespace limber
