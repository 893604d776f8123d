#include "limber/planning/certificate.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include <fmt/format.h>

#include "exact_arm.hpp"
#include "exact_valves.hpp"
#include "frame_checks.hpp"
#include "limber/common/error.hpp"
#include "limber/common/units.hpp"
#include "swept_clearance.hpp"

namespace limber {

namespace {

constexpr double kMostTurnRad = std::numbers::pi;  // of one gap; beyond there is no such arc
constexpr double kRoundingM = 1e-5;  // of one step of the forward model in float32, with room
constexpr double kReportedClearanceM = 1.2e-3;  // a planner's own figure may be a little cautious

ExactArm::Shape shape_of(const Backbone& backbone) {
  ExactArm::Shape shape;
  for (Eigen::Index i = 0; i < backbone.rows(); ++i) {
    shape.push_back({double(backbone(i, 0)), double(backbone(i, 1)), double(backbone(i, 2))});
  }
  return shape;
}

std::vector<double> numbers(const Pressures& kpa) {
  return {kpa.begin(), kpa.end()};
}

/// Whether collision has a meaning: finite poses, and no gap that turns by more than half a turn.
bool is_drawable(const ExactArm::Shape& shape) {
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const bool finite = std::isfinite(shape[i].x_m) && std::isfinite(shape[i].y_m) &&
                        std::isfinite(shape[i].theta_rad);
    if (!finite ||
        (i > 0 && std::abs(shape[i].theta_rad - shape[i - 1].theta_rad) > kMostTurnRad)) {
      return false;
    }
  }
  return true;
}

/// How far two shapes are apart, and the plate that is farthest off its place.
struct Deviation {
  double apart_m = 0.0;
  double turned_rad = 0.0;
  int plate = 0;
};

/// A coordinate that is no number counts as any distance: comparisons with it are false.
Deviation deviation(const ExactArm::Shape& own, const ExactArm::Shape& stored) {
  Deviation largest;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    const double apart = std::hypot(own[i].x_m - stored[i].x_m, own[i].y_m - stored[i].y_m);
    const double turned = std::abs(own[i].theta_rad - stored[i].theta_rad);
    if (!(apart <= largest.apart_m)) {
      largest.apart_m = apart;
      largest.plate = static_cast<int>(i);
    }
    if (!(turned <= largest.turned_rad)) {
      largest.turned_rad = turned;
    }
  }
  return largest;
}

/// One certification: what the checks share.
class Certification {
 public:
  Certification(const Plan& plan, const ArmDescription& arm, const CompensationModel* network,
                const ValveParameters& valves, const Environment& environment)
      : plan_(plan), arm_(arm), valves_(valves), environment_(environment), model_(arm, network) {}

  Certificate run() {
    result_.frames = plan_.frame_count();
    check_frames(plan_, arm_, result_);
    if (plan_.certified && !plan_.certified->seal_is_intact) {
      fail("seal", -1, "the file was changed since the plan was certified");
    }
    if (has_failed("sizes")) {
      return result_;  // nothing to simulate
    }
    check_start();
    simulate_valves();
    check_settling();
    simulate();
    check_deviation();
    if (check_shapes()) {
      check_collision();
      check_goal();
    }
    return result_;
  }

 private:
  void fail(const char* check, int frame, std::string message) {
    result_.failures.push_back({check, frame, std::move(message)});
  }

  bool has_failed(const std::string& check) const {
    for (const CertificateFailure& failure : result_.failures) {
      if (failure.check == check) {
        return true;
      }
    }
    return false;
  }

  void check_start() {
    std::vector<double> pressures(arm_.segments.size(), 0.0);
    ExactArm::Shape shape = model_.no_load(pressures);
    if (environment_.start) {
      const ArmStart& start = *environment_.start;
      pressures.assign(start.pressures_kpa.begin(), start.pressures_kpa.end());
      shape = shape_of(start.backbone);
    }
    if (numbers(plan_.frames.front().setpoint_kpa) != pressures) {
      fail("start", 0, "the first set points are not the environment's start");
    }
    simulated_ = {std::move(shape)};
  }

  void simulate_valves() {
    ExactValves::Configurations setpoints_kpa;
    for (const PlanFrame& frame : plan_.frames) {
      setpoints_kpa.push_back(numbers(frame.setpoint_kpa));
    }
    pressures_kpa_ = ExactValves(arm_, valves_).pressures_along(setpoints_kpa);
    for (std::size_t k = 0; k < pressures_kpa_.size(); ++k) {
      for (std::size_t i = 0; i < pressures_kpa_[k].size(); ++i) {
        const double stored = double(plan_.frames[k].pressure_kpa[static_cast<Eigen::Index>(i)]);
        const double apart = std::abs(pressures_kpa_[k][i] - stored);
        const bool agreed =
            result_.largest_pressure_deviation_kpa <= Certificate::kPressureDeviationKpa;
        if (!(apart <= result_.largest_pressure_deviation_kpa)) {
          result_.largest_pressure_deviation_kpa = apart;
        }
        if (agreed && !(apart <= Certificate::kPressureDeviationKpa)) {
          fail("valves", static_cast<int>(k),
               fmt::format("segment {} is said to be at {:.6g} {unit}; its valves bring it to "
                           "{:.6g} {unit}",
                           i, stored, pressures_kpa_[k][i], fmt::arg("unit", arm_.command.unit)));
        }
      }
    }
  }

  /// The goal is judged once the pressures have arrived.
  void check_settling() {
    for (std::size_t i = 0; i < valves_.segments.size(); ++i) {
      const double setpoint =
          double(plan_.frames.back().setpoint_kpa[static_cast<Eigen::Index>(i)]);
      const double apart = std::abs(pressures_kpa_.back()[i] - setpoint);
      const double allowed =
          std::max(valves_.segments[i].dead_band_kpa,
                   Certificate::kSettledShare * arm_.segments[i].pressure_limit_kpa);
      if (!(apart <= allowed + Certificate::kPressureDeviationKpa)) {
        fail("hold", plan_.frame_count() - 1,
             fmt::format("segment {} is still {:.3g} {unit} from its set point; {:.3g} {unit} are "
                         "allowed at the end of the hold",
                         i, apart, allowed, fmt::arg("unit", arm_.command.unit)));
        return;
      }
    }
  }

  void simulate() {
    for (std::size_t k = 1; k < plan_.frames.size(); ++k) {
      simulated_.push_back(
          model_.next(pressures_kpa_[k - 1], pressures_kpa_[k], simulated_.back()));
    }
  }

  void check_deviation() {
    ExactArm::Shape before = simulated_.front();
    for (std::size_t k = 0; k < simulated_.size(); ++k) {
      const ExactArm::Shape stored = shape_of(plan_.frames[k].backbone);
      const Deviation of_path = deviation(simulated_[k], stored);
      const bool agreed =
          result_.largest_deviation_m <= Certificate::kDeviationM &&
          result_.largest_heading_deviation_rad <= Certificate::kHeadingDeviationRad;
      if (!(of_path.apart_m <= result_.largest_deviation_m)) {
        result_.largest_deviation_m = of_path.apart_m;
        result_.deviation_frame = static_cast<int>(k);
      }
      if (!(of_path.turned_rad <= result_.largest_heading_deviation_rad)) {
        result_.largest_heading_deviation_rad = of_path.turned_rad;
      }
      if (k > 0) {
        const Deviation of_step =
            deviation(model_.next(pressures_kpa_[k - 1], pressures_kpa_[k], before), stored);
        if (!(of_step.apart_m <= result_.largest_step_deviation_m)) {
          result_.largest_step_deviation_m = of_step.apart_m;
        }
      }
      if (agreed && !(of_path.apart_m <= Certificate::kDeviationM &&
                      of_path.turned_rad <= Certificate::kHeadingDeviationRad)) {
        fail_model(static_cast<int>(k), of_path);
      }
      before = stored;
    }
  }

  void fail_model(int frame, const Deviation& found) {
    const bool is_rounding = result_.largest_step_deviation_m <= kRoundingM;
    fail("model", frame,
         fmt::format("plate {} is {:.4g} mm and {:.4g} rad from where the model puts it; allowed: "
                     "{} mm and {} rad{}",
                     found.plate + 1, found.apart_m * 1e3, found.turned_rad,
                     Certificate::kDeviationM * 1e3, Certificate::kHeadingDeviationRad,
                     is_rounding ? "; every single step agrees, so the model amplifies rounding "
                                   "along this plan, and does not say where the arm goes"
                                 : ""));
  }

  bool check_shapes() {
    for (std::size_t k = 0; k < simulated_.size(); ++k) {
      if (!is_drawable(simulated_[k])) {
        fail("model", static_cast<int>(k), "the model predicts a shape that no arm has");
        return false;
      }
    }
    return true;
  }

  void check_collision() {
    const SweptClearance::Result swept =
        SweptClearance(arm_, environment_.obstacles, Certificate::kClearanceToleranceM)
            .over(simulated_);
    result_.clearance_m = swept.value_m;
    result_.clearance_frame = swept.frame;
    result_.clearance_gap = swept.gap;
    result_.clearance_obstacle = swept.obstacle;
    const double least = std::max(plan_.margin_m, Certificate::kLeastClearanceM);
    if (!(swept.value_m >= least)) {
      fail("collision", swept.frame,
           fmt::format(
               "the arm, between plates {} and {}, comes within {:.3f} mm of obstacle {} "
               "({}); {:.3f} mm are asked for",
               swept.gap + 1, swept.gap + 2, swept.value_m * 1e3, swept.obstacle + 1,
               obstacle_kind(environment_.obstacles[static_cast<std::size_t>(swept.obstacle)]),
               least * 1e3));
    }
    const bool both_infinite = std::isinf(plan_.clearance_m) && std::isinf(swept.value_m);
    if (!both_infinite && !(std::abs(plan_.clearance_m - swept.value_m) <= kReportedClearanceM)) {
      fail("claims", -1,
           fmt::format("clearance_m = {:.6g}; found {:.6g}", plan_.clearance_m, swept.value_m));
    }
  }

  void check_goal() {
    const PoseGoal& goal = environment_.goal;
    const Pose& tip = simulated_.back().back();
    result_.goal_distance_m = std::hypot(tip.x_m - goal.x_m, tip.y_m - goal.y_m);
    const int last = plan_.frame_count() - 1;
    if (!(result_.goal_distance_m <= goal.position_tolerance_m)) {
      fail("goal", last,
           fmt::format("the tip ends {:.3f} cm from the goal; tolerance {:.3f} cm",
                       result_.goal_distance_m * kCmPerM, goal.position_tolerance_m * kCmPerM));
    }
    if (goal.theta_rad) {
      // As a rotation, so that a full turn makes no difference.
      result_.goal_orientation_rad =
          std::abs(std::arg(std::polar(1.0, tip.theta_rad - *goal.theta_rad)));
      if (!(result_.goal_orientation_rad <= goal.orientation_tolerance_rad)) {
        fail("goal", last,
             fmt::format("the tip ends {:.4f} rad from the goal's heading; tolerance {:.4f} rad",
                         result_.goal_orientation_rad, goal.orientation_tolerance_rad));
      }
    }
    require_claim("goal_distance_m", plan_.goal_distance_m, result_.goal_distance_m,
                  Certificate::kDeviationM);
    require_claim("goal_orientation_rad", plan_.goal_orientation_rad, result_.goal_orientation_rad,
                  Certificate::kHeadingDeviationRad);
  }

  void require_claim(const char* name, double claimed, double found, double tolerance) {
    if (!(std::abs(claimed - found) <= tolerance)) {
      fail("claims", -1, fmt::format("{} = {:.6g}; found {:.6g}", name, claimed, found));
    }
  }

  const Plan& plan_;
  const ArmDescription& arm_;
  const ValveParameters& valves_;
  const Environment& environment_;
  ExactArm model_;
  ExactValves::Configurations pressures_kpa_;
  std::vector<ExactArm::Shape> simulated_;
  Certificate result_;
};

}  // namespace

Certificate certify(const Plan& plan, const ArmDescription& arm, const CompensationModel* network,
                    const ValveParameters& valves, const Environment& environment) {
  const auto require = [&](const char* what, const std::string& made_for,
                           const std::string& given) {
    if (made_for != given) {
      throw InputError(fmt::format("the plan was made for another {} ({}; this one is {})", what,
                                   made_for, given));
    }
  };
  if (const std::string why = why_another_arm(plan.arm(), arm, "the plan"); !why.empty()) {
    throw InputError(fmt::format(
        "the plan was made for another arm ('{}', hash {}; this one is '{}', hash {}): {}",
        plan.arm_name, plan.arm_hash, arm.name, arm.hash(), why));
  }
  const auto valves_named = [](const std::string& hash) {
    return hash.empty() ? std::string("none") : "hash " + hash;
  };
  require("valve model", valves_named(plan.valves_hash), valves_named(valves.hash()));
  const std::string environment_now = environment_hash(environment);
  if (plan.environment_hash != environment_now) {
    throw InputError(fmt::format(
        "the plan was made for another environment ('{}', hash {}; this one is '{}', hash {})",
        plan.environment_name, plan.environment_hash, environment.name, environment_now));
  }
  require("kind of model", plan.model, network != nullptr ? "network" : "no_load");
  if (network != nullptr) {
    require_model_of(*network, arm, "the plan's model");
  }
  return Certification(plan, arm, network, valves, environment).run();
}

}  // namespace limber
