#include "limber/certificate/certificate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "covered_obstacle.hpp"
#include "exact_arm.hpp"
#include "frame_checks.hpp"
#include "give_up.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/units.hpp"
#include "swept_clearance.hpp"

namespace limber {

namespace {

constexpr double kRoundingM = 1e-5;  // of one step of the forward model in float32, with room
constexpr double kReportedClearanceM = 1.2e-3;  // a planner's own figure may be a little cautious

}  // namespace

/// What every plan for one problem is checked against.
struct Certifier::Problem {
  const ArmDescription& arm;
  const CompensationModel* network;
  const ValveParameters& valves;
  const Environment& environment;
  std::string arm_hash, valves_hash, environment_hash;
  std::string refusal;  // why this can't be judged; empty: it can
  ExactArm model;
  SweptClearance clearance;
};

/// One certification: what the checks share.
class Certifier::Certification {
 public:
  Certification(const Plan& plan, const Problem& problem, const std::function<bool()>& give_up)
      : plan_(plan),
        problem_(problem),
        arm_(problem.arm),
        valves_(problem.valves),
        environment_(problem.environment),
        ask_(give_up),
        give_up_(give_up) {}

  Certificate run() {
    check();
    if (give_up_.is_given_up()) {
      result_.unfinished = true;
      fail("unfinished", -1, "the certificate was not finished in the time left");
    }
    return result_;
  }

 private:
  void check() {
    result_.frames = plan_.frame_count();
    check_frames(plan_, arm_, result_);
    if (plan_.certified && !plan_.certified->seal_is_intact) {
      fail("seal", -1, "the file was changed since the plan was certified");
    }
    if (has_failed("sizes")) {
      return;  // nothing to simulate
    }
    check_tube(plan_, problem_.network, arm_, result_);
    if (has_failed("tube")) {
      return;  // its width means nothing
    }
    check_start();
    simulate_valves();
    check_settling();
    if (simulate() && check_shapes() && check_collision()) {
      check_goal();
    }
  }

  void fail(const char* check, int frame, std::string message) {
    result_.failures.push_back({check, frame, std::move(message)});
  }

  bool has_failed(const std::string& check) const {
    return std::ranges::any_of(result_.failures, [&](const CertificateFailure& failure) {
      return failure.check == check;
    });
  }

  void check_start() {
    start_ = exact_start(environment_, arm_, problem_.model);
    if (numbers(plan_.frames.front().setpoint_kpa) != start_.setpoint_kpa) {
      fail("start", 0, "the first set points are not the environment's start");
    }
    simulated_ = {start_.shape};
  }

  double rounding_kpa(std::size_t segment) const {
    return Certificate::kPressureDeviationShare *
           arm_.segments[segment].pressure_limit_kpa.largest_kpa();
  }

  void simulate_valves() {
    ExactValves::Configurations setpoints_kpa;
    for (const PlanFrame& frame : plan_.frames) {
      setpoints_kpa.push_back(numbers(frame.setpoint_kpa));
    }
    pressures_kpa_ = ExactValves(arm_, valves_)
                         .pressures_along(setpoints_kpa, start_.pressure_kpa, start_.before_kpa);
    for (std::size_t k = 0; k < pressures_kpa_.size(); ++k) {
      for (std::size_t i = 0; i < pressures_kpa_[k].size(); ++i) {
        const double stored = double(plan_.frames[k].pressure_kpa[Eigen::Index(i)]);
        const double apart = std::abs(pressures_kpa_[k][i] - stored);
        raise_to(result_.max_pressure_deviation_kpa, apart);
        if (!(apart <= rounding_kpa(i)) && !has_failed("valves")) {
          fail("valves", int(k),
               fmt::format("{} is said to be at {:.6g} {unit}; "
                           "its valves bring it to {:.6g} {unit}",
                           segment_name(i), stored, pressures_kpa_[k][i],
                           fmt::arg("unit", arm_.command.unit)));
        }
      }
    }
  }

  /// The goal is judged once the pressures have arrived.
  void check_settling() {
    for (std::size_t i = 0; i < valves_.segments.size(); ++i) {
      const double setpoint = double(plan_.frames.back().setpoint_kpa[Eigen::Index(i)]);
      const double apart = std::abs(pressures_kpa_.back()[i] - setpoint);
      const double allowed =
          std::max(valves_.segments[i].dead_band_kpa,
                   Certificate::kSettledShare * arm_.segments[i].pressure_limit_kpa.largest_kpa());
      if (!(apart <= allowed + rounding_kpa(i))) {
        fail("hold", plan_.frame_count() - 1,
             fmt::format("{} is still {:.3g} {unit} from its set point; {:.3g} {unit} are "
                         "allowed at the end of the hold",
                         segment_name(i), apart, allowed, fmt::arg("unit", arm_.command.unit)));
        return;
      }
    }
  }

  /// Open loop from the start and, beside that, each step from the stored backbone before it.
  /// @return false if it gave up
  bool simulate() {
    ExactNetwork::Workspace workspace;
    simulated_.reserve(plan_.frames.size());
    ExactArm::Shape stored = shape_of(plan_.frames.front().backbone);
    ExactArm::Shape stored_before = start_.before;
    compare(0, stored);
    for (std::size_t k = 1; k < plan_.frames.size(); ++k) {
      if (give_up_.now()) {
        return false;
      }
      const ExactArm::Shape& before = k == 1 ? start_.before : simulated_[k - 2];
      std::array<ExactArm::Shape, 2> next = problem_.model.next_two(
          pressures_kpa_[k - 1], pressures_kpa_[k],
          {{{&before, &simulated_.back()}, {&stored_before, &stored}}}, workspace);
      stored_before = std::move(stored);
      stored = shape_of(plan_.frames[k].backbone);
      simulated_.push_back(std::move(next[0]));
      raise_to(result_.max_step_deviation_m, deviation(next[1], stored).apart_m);
      compare(k, stored);
    }
    return true;
  }

  void compare(std::size_t k, const ExactArm::Shape& stored) {
    const Deviation of_path = deviation(simulated_[k], stored);
    const bool agreed = result_.max_deviation_m <= Certificate::kDeviationM &&
                        result_.max_heading_deviation_rad <= Certificate::kHeadingDeviationRad;
    raise_to(result_.max_deviation_m, of_path.apart_m);
    raise_to(result_.max_heading_deviation_rad, of_path.turned_rad);
    if (agreed && !(of_path.apart_m <= Certificate::kDeviationM &&
                    of_path.turned_rad <= Certificate::kHeadingDeviationRad)) {
      fail_model(int(k), of_path);
    }
  }

  void fail_model(int frame, const Deviation& found) {
    const bool is_rounding = result_.max_step_deviation_m <= kRoundingM;
    fail(
        "model", frame,
        fmt::format(
            "{} is {:.4g} mm and {:.4g} rad from where the "
            "model puts it; allowed: {} mm and {} rad{}",
            plate_name(found.plate), found.apart_m * 1e3, found.turned_rad,
            Certificate::kDeviationM * 1e3, Certificate::kHeadingDeviationRad,
            is_rounding
                ? "; every single step agrees, so the model amplifies rounding along this plan and "
                  "can't say where the arm goes"
                : ""));
  }

  bool check_shapes() {
    for (std::size_t k = 0; k < simulated_.size(); ++k) {
      if (!is_drawable(simulated_[k])) {
        fail("model", int(k), "the model predicts a shape that no arm has");
        return false;
      }
    }
    return true;
  }

  /// @return false if it gave up
  bool check_collision() {
    if (give_up_.now()) {
      return false;
    }
    SweptRoom room;
    if (plan_.tube) {
      room = {plan_.tube->plate_radius_m, plan_.tube->growth.start_share,
              plan_.tube->growth.full_after_m};
    }
    const SweptClearance::Result swept = problem_.clearance.over(simulated_, ask_, room);
    if (!swept.is_finished) {
      give_up_.give_up();
      return false;
    }
    result_.clearance_m = swept.value_m;
    result_.clearance_frame = swept.frame;
    result_.clearance_gap = swept.gap;
    result_.clearance_obstacle = swept.obstacle;
    const double min_m = std::max(plan_.margin_m, Certificate::kMinClearanceM);
    if (!(swept.value_m >= min_m)) {
      fail("collision", swept.frame,
           fmt::format("the arm{}, {}, comes within {:.3f} mm of {}; {:.3f} mm are asked for",
                       plan_.tube ? " with its tube" : "", gap_name(arm_, swept.gap),
                       swept.value_m * 1e3, obstacle_name(environment_, swept.obstacle),
                       min_m * 1e3));
    }
    const bool both_infinite = std::isinf(plan_.clearance_m) && std::isinf(swept.value_m);
    if (!both_infinite && !(std::abs(plan_.clearance_m - swept.value_m) <= kReportedClearanceM)) {
      fail("claims", -1,
           fmt::format("clearance_m = {:.6g}; found {:.6g}", plan_.clearance_m, swept.value_m));
    }
    return true;
  }

  void check_goal() {
    const PoseGoal& goal = environment_.goal;
    const Pose& tip = simulated_.back().back();
    result_.goal_distance_m = std::hypot(tip.x_m - goal.x_m, tip.y_m - goal.y_m);
    const int last = plan_.frame_count() - 1;
    const bool keeps_tube = plan_.tube && plan_.tube->goal_inside;
    const double room_m = keeps_tube ? plan_.tube->end_radius_m : 0.0;
    const double room_rad = keeps_tube ? plan_.tube->end_heading_rad : 0.0;
    const auto tube_note = [&](double room, const char* unit) {
      return keeps_tube ? fmt::format(", of which {:.4g} {} are its tube's", room, unit) : "";
    };
    if (!(result_.goal_distance_m <= goal.position_tolerance_m - room_m)) {
      fail("goal", last,
           fmt::format("the tip ends {:.3f} cm from the goal; tolerance {:.3f} cm{}",
                       result_.goal_distance_m * kCmPerM, goal.position_tolerance_m * kCmPerM,
                       tube_note(room_m * kCmPerM, "cm")));
    }
    if (goal.theta_rad) {
      // As a rotation, so that a full turn makes no difference.
      result_.goal_orientation_rad =
          std::abs(std::arg(std::polar(1.0, tip.theta_rad - *goal.theta_rad)));
      if (!(result_.goal_orientation_rad <= goal.orientation_tolerance_rad - room_rad)) {
        fail("goal", last,
             fmt::format("the tip ends {:.4f} rad from the goal's heading; tolerance {:.4f} rad{}",
                         result_.goal_orientation_rad, goal.orientation_tolerance_rad,
                         tube_note(room_rad, "rad")));
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
  const Problem& problem_;
  const ArmDescription& arm_;
  const ValveParameters& valves_;
  const Environment& environment_;
  const std::function<bool()>& ask_;
  GiveUp give_up_;
  ExactStart start_;
  ExactValves::Configurations pressures_kpa_;
  std::vector<ExactArm::Shape> simulated_;
  Certificate result_;
};

namespace {

std::string why_not_usable(const CompensationModel* network, const ArmDescription& arm,
                           const ValveParameters& valves, const Environment& environment) {
  if (std::string why = why_not_solid(environment.obstacles); !why.empty()) {
    return why;
  }
  if (const std::string why = why_unusable(valves, arm); !why.empty()) {
    return "valves: " + why;
  }
  try {
    require_planar(arm, "a certificate");
    require_start_of(arm, environment);
    if (network != nullptr) {
      require_model_of(*network, arm, "the plan's model");
      require_no_valves_before(*network, valves, "the plan's model");
      validate(*network, "the plan's model");
    }
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

void require_same(const char* what, const std::string& made_for, const std::string& given) {
  refuse_if(made_for != given, "the plan was made for another {} ({}; this one is {})", what,
            made_for, given);
}

std::string valves_named(const std::string& hash) {
  return hash.empty() ? std::string("none") : "hash " + hash;
}

}  // namespace

Certifier::Certifier(const ArmDescription& arm, const CompensationModel* network,
                     const ValveParameters& valves, const Environment& environment) {
  const std::string refusal = why_not_usable(network, arm, valves, environment);
  static const std::vector<Obstacle> kNone;  // what is no obstacle has no distance either
  const std::vector<Obstacle>& solid = refusal.empty() ? environment.obstacles : kNone;
  problem_.reset(new Problem{arm,
                             network,
                             valves,
                             environment,
                             arm.hash(),
                             valves.hash(),
                             limber::environment_hash(environment),
                             refusal,
                             {arm, network},
                             {arm, solid, Certificate::kClearanceToleranceM}});
}

Certifier::Certifier(Certifier&&) noexcept = default;
Certifier& Certifier::operator=(Certifier&&) noexcept = default;
Certifier::~Certifier() = default;

const std::string& Certifier::environment_hash() const {
  return problem_->environment_hash;
}

void Certifier::require_plan_of_problem(const Plan& plan) const {
  const Problem& problem = *problem_;
  if (plan.arm_hash != problem.arm_hash) {
    if (const std::string why = why_another_arm(plan.arm(), problem.arm, "the plan");
        !why.empty()) {
      throw InputError(fmt::format(
          "the plan was made for another arm ('{}', hash {}; this one is '{}', hash {}): {}",
          plan.arm_name, plan.arm_hash, problem.arm.name, problem.arm_hash, why));
    }
  }
  require_same("valve model", valves_named(plan.valves_hash), valves_named(problem.valves_hash));
  refuse_if(plan.environment_hash != problem.environment_hash,
            "the plan was made for another environment ('{}', hash {}; this one is '{}', hash {})",
            plan.environment_name, plan.environment_hash, problem.environment.name,
            problem.environment_hash);
  require_same("kind of model", plan.model, problem.network != nullptr ? "network" : "no_load");
  if (!problem.refusal.empty()) {
    throw InputError(problem.refusal);
  }
}

Certificate Certifier::certify(const Plan& plan, const std::function<bool()>& give_up) const {
  require_plan_of_problem(plan);
  return Certification(plan, *problem_, give_up).run();
}

Certificate certify(const Plan& plan, const ArmDescription& arm, const CompensationModel* network,
                    const ValveParameters& valves, const Environment& environment) {
  const ArmDescription slowed = at_rate_of(plan.arm(), arm, "the plan");
  return Certifier(slowed, network, valves, environment).certify(plan);
}

}  // namespace limber
