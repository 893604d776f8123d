#include <algorithm>
#include <atomic>
#include <filesystem>
#include <variant>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "caller_thread.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/network/gap_bounds.hpp"
#include "limber/planning/planner_factory.hpp"
#include "others_may_run.hpp"
#include "pictures.hpp"
#include "planar.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

bool goes_on(CallerThread& caller, const py::object& callback, const PlannerProgress& now) {
  bool answer = true;
  const bool returned = caller.call([&] { answer = asks_to_go_on(callback(now), "callback"); });
  return returned && answer;
}

/// Asks Python's callback, and stops as soon as the caller wants to.
PlannerCallback watched(CallerThread& caller, const py::object& callback) {
  return [&](const PlannerProgress& now) {
    return !caller.should_stop() && (callback.is_none() || goes_on(caller, callback, now));
  };
}

std::vector<PressureLimits> limits_of_pairs(const std::vector<std::pair<double, double>>& kpa) {
  std::vector<PressureLimits> limits;
  for (const auto& [lower, upper] : kpa) {
    limits.emplace_back(lower, upper);
  }
  return limits;
}

void require_bounded_model(const PlanningProblem& problem) {
  if (problem.model.has_network()) {
    require_bounded(problem.model.compensation(), "the model");
  }
}

/// A planner takes one caller at a time; Python's threads do not know that.
class OnePlanner {
 public:
  explicit OnePlanner(std::unique_ptr<Planner> planner) : planner_(std::move(planner)) {}

  const char* name() const { return planner_->name(); }

  /// @param limits  a copy: Python may change its own meanwhile
  PlanResult plan(const PlanningProblem& problem, PlannerLimits limits, std::uint64_t seed,
                  const py::object& callback) {
    require_bounded_model(problem);
    refuse_if(busy_.exchange(true), "this planner is planning already; make one for each thread");
    const std::unique_ptr<std::atomic<bool>, void (*)(std::atomic<bool>*)> free_again(
        &busy_, [](std::atomic<bool>* busy) { busy->store(false); });
    CallerThread caller;
    return caller.run(
        [&] { return planner_->plan(problem, limits, seed, watched(caller, callback)); });
  }

 private:
  std::unique_ptr<Planner> planner_;
  std::atomic<bool> busy_{false};
};

void bind_limits(py::module_& module) {
  Record<PlannerLimits>(
      module, "PlannerLimits",
      "When to stop; whichever comes first. At least one of time_s, iterations and "
      "queries has to be set, or `plan` raises InputError. When a limit is reached, "
      "the best plan so far is the result; without one, status is PlanStatus.limit, "
      "and PlanResult.limit says which.")
      .field("time_s", &PlannerLimits::time_s,
             "Time [s], > 0; the search ends within 50 ms of it. The plan then depends on "
             "the machine. None: no limit.")
      .field("iterations", &PlannerLimits::iterations,
             "Samples, >= 1. With this limit alone a run can be repeated. OMPL's planners "
             "count neither these nor memory, and say so. None: no limit.")
      .field("queries", &PlannerLimits::queries,
             "Queries of the forward model by the search, >= 1, looked at after each round. "
             "PlannerStatistics.queries may be more. None: no limit.")
      .field("memory_mb", &PlannerLimits::memory_mb,
             "Size of the search tree [MB], > 0. No limit by itself: another one is needed. "
             "None: no limit.")
      .field("cost_threshold_kpa", &PlannerLimits::cost_threshold_kpa,
             "The search ends with a plan that costs this or less [kPa], the sum of |dp| "
             "over segments and frames. None: it goes on to improve plans.")
      .keywords()
      .done();
  Choice<PlanStatus>(module, "PlanStatus",
                     "What came of planning, or what is wrong with the problem.")
      .value("solved", PlanStatus::solved, "a certified plan exists, PlanResult.plan")
      .value("limit", PlanStatus::limit, "a limit came first, PlanResult.limit; there is no plan")
      .value("invalid_start", PlanStatus::invalid_start,
             "the arm starts in an obstacle or beyond the limits")
      .value("goal_unreachable", PlanStatus::goal_unreachable,
             "the goal is farther from the base than the arm is long")
      .value("goal_in_collision", PlanStatus::goal_in_collision,
             "no tip in the goal's region is free of obstacles")
      .value("not_certified", PlanStatus::not_certified,
             "plans were found, and their certificates refused all");
  Choice<PlanLimit>(module, "PlanLimit", "The limit that ended a search.")
      .value("time", PlanLimit::time, "PlannerLimits.time_s")
      .value("iterations", PlanLimit::iterations, "PlannerLimits.iterations")
      .value("queries", PlanLimit::queries, "PlannerLimits.queries")
      .value("memory", PlanLimit::memory, "PlannerLimits.memory_mb");
}

void bind_problem(py::module_& module) {
  py::class_<PlanningProblem>(module, "PlanningProblem",
                              "What is to be solved; it keeps arm, model and environment alive.")
      .def(
          py::init([](const ArmDescription& arm, const MotionModel& model,
                      const Environment& environment, double margin_m, const PoseError& goal_margin,
                      const RecordedRegion* stay_within, bool margin_yields_to_start,
                      const std::vector<std::pair<double, double>>& limits_kpa,
                      const std::optional<PlanTube>& tube) {
            require_planar(arm, "limber.PlanningProblem");
            require_model_of_arm(arm, model, "limber.PlanningProblem");
            PlanningProblem problem{arm, model, environment, margin_m, goal_margin};
            if (stay_within != nullptr &&
                (stay_within->learnt().segment_count() != arm.segment_count() ||
                 stay_within->learnt().point_count() != arm.point_count())) {
              throw InputError(fmt::format(
                  "stay_within: of {} segments and {} plates; arm '{}' has {} and {}",
                  stay_within->learnt().segment_count(), stay_within->learnt().point_count(),
                  arm.name, arm.segment_count(), arm.point_count()));
            }
            problem.stay_within = stay_within;
            problem.margin_yields_to_start = margin_yields_to_start;
            problem.limits = limits_of_pairs(limits_kpa);
            problem.tube = tube;
            return problem;
          }),
          "arm"_a, "model"_a, "environment"_a, "margin_m"_a = 0.0, "goal_margin"_a = PoseError{},
          "stay_within"_a = py::none(), "margin_yields_to_start"_a = false,
          "limits_kpa"_a = std::vector<std::pair<double, double>>{}, "tube"_a = py::none(),
          py::keep_alive<1, 2>(), py::keep_alive<1, 3>(), py::keep_alive<1, 4>(),
          py::keep_alive<1, 7>(),
          "margin_m: clearance kept from obstacles [m], >= 0; goal_margin: how far inside "
          "the goal's tolerances plans end; stay_within: a RecordedRegion that plans stay "
          "in, None: anywhere; margin_yields_to_start: see ErrorRoom; limits_kpa: (lower, "
          "upper) of each segment, within the arm's, empty: the arm's; tube: kept free "
          "beside the margin. Planning raises InputError where one is out of range.")
      .def_readonly("margin_m", &PlanningProblem::margin_m,
                    "Clearance kept from every obstacle [m], >= 0.")
      .def_property_readonly(
          "goal_margin",
          [](const PlanningProblem& problem) { return fixed_copy(problem.goal_margin); },
          "PoseError: how far inside the goal's tolerances plans end, room for the model's error.")
      .def_readonly("tube", &PlanningProblem::tube,
                    "PlanTube that plans keep free of obstacles beside the margin, or None.")
      .def("__repr__", [](const PlanningProblem& problem) {
        return fmt::format("PlanningProblem(arm='{}', environment='{}', margin_m={})",
                           problem.arm.name, problem.environment.name, problem.margin_m);
      });
}

/// A motion of somebody else's planner, in (w, n) set points.
PlanResult along(const PlanningProblem& problem, const FloatArray& waypoints_kpa,
                 const std::string& planner, std::uint64_t seed) {
  const auto n = py::ssize_t{problem.arm.channel_count()};
  require_shape(waypoints_kpa, {batch_size(waypoints_kpa, "waypoints_kpa"), n}, "waypoints_kpa");
  require_finite(waypoints_kpa, "waypoints_kpa");
  require_bounded_model(problem);
  const auto waypoints = mapped<Pressures>(waypoints_kpa.shape(0), [&](py::ssize_t w) {
    return Pressures(Eigen::Map<const Pressures>(waypoints_kpa.data(w, 0), n));
  });
  return interruptibly([&] { return plan_along(problem, waypoints, planner, seed); });
}

py::array_t<float> tree_of(const PlanResult& result) {
  py::array_t<float> edges({result.tree.size(), std::size_t{2}, std::size_t{2}});
  float* to = edges.mutable_data();
  for (const TreeEdge& edge : result.tree) {
    to = std::copy_n(edge.from_m.data(), 2, to);
    to = std::copy_n(edge.to_m.data(), 2, to);
  }
  return edges;
}

void bind_progress(py::module_& module) {
  Record<PlannerProgress>(module, "PlannerProgress", "How far a search is.")
      .read_only("time_s", &PlannerProgress::time_s, "Since the search began [s].")
      .read_only("iterations", &PlannerProgress::iterations, "Samples so far.")
      .read_only("nodes", &PlannerProgress::nodes, "Nodes of the search tree.")
      .read_only("queries", &PlannerProgress::queries,
                 "Queries of the forward model by the search so far.")
      .read_only("best_cost_kpa", &PlannerProgress::best_cost_kpa,
                 "Cost of the cheapest plan so far [kPa]; None before the first.")
      .done();
  Record<FirstSolution>(module, "FirstSolution", "The first plan that was certified.")
      .read_only("time_s", &FirstSolution::time_s,
                 "When it was certified, since the search began [s].")
      .read_only("cost_kpa", &FirstSolution::cost_kpa, "Its cost, the sum of |dp| [kPa].")
      .read_only("queries", &FirstSolution::queries,
                 "Queries of the forward model until it was found.")
      .read_only("candidate_s", &FirstSolution::candidate_s,
                 "When it was found, since the search began [s].")
      .read_only("certificate_s", &FirstSolution::certificate_s,
                 "What building and certifying it then took [s].")
      .done();
  Record<PlannerStatistics>(module, "PlannerStatistics", "What a search took.")
      .read_only("time_s", &PlannerStatistics::time_s, "Time of the whole search [s].")
      .read_only("iterations", &PlannerStatistics::iterations, "Samples that were drawn.")
      .read_only("queries", &PlannerStatistics::queries,
                 "All queries of the forward model. More than PlannerLimits.queries, which is "
                 "for the search alone: also the plan's last simulation and, of an ensemble, the "
                 "other networks, which judge every plan.")
      .read_only("nodes", &PlannerStatistics::nodes, "Nodes of the search tree.")
      .done();
}

void bind_plan_result(py::module_& module) {
  bind_progress(module);
  Record<PlanResult>(module, "PlanResult",
                     "What came of planning; no plan is no error. A notebook draws it.")
      .read_only("status", &PlanResult::status,
                 "PlanStatus; a plan is there only where it is PlanStatus.solved.")
      .read_only("reason", &PlanResult::reason,
                 "What ended the search or what is wrong with the problem, a sentence.")
      .read_only("plan", &PlanResult::plan, "The certified Plan, or None unless status is solved.")
      .read_only("limit", &PlanResult::limit, "PlanLimit that ended the search, or None.")
      .read_only("warnings", &PlanResult::warnings,
                 "What to know before the plan is used, a list of sentences.")
      .read_only("statistics", &PlanResult::statistics, "PlannerStatistics: what the search took.")
      .done()
      .def_readonly("best_partial", &PlanResult::best_partial,
                    "Where there is no plan, the motion that came nearest; never a solution.")
      .def_readonly("certificate", &PlanResult::certificate, "Certificate of the plan, or None.")
      .def_readonly("first_solution", &PlanResult::first_solution,
                    "FirstSolution: when there was a plan for the first time, or None.")
      .def_readonly("max_clearance_m", &PlanResult::max_clearance_m,
                    "What a plan keeps that was found with less clearance [m], or None.")
      .def_readonly("events", &PlanResult::events,
                    "List of PlannerProgress: the first plan, each notably cheaper one, and the "
                    "end; empty without a plan.")
      .def_property_readonly("tree", &tree_of,
                             "Tips of nodes and their parents, float32 (edges, 2, 2) [m].")
      .def(
          "_repr_svg_",
          [](const PlanResult& result) -> std::optional<std::string> {
            if (!result.plan && !result.best_partial) {
              return std::nullopt;
            }
            return motion_picture(result.plan ? *result.plan : *result.best_partial);
          },
          py::call_guard<OthersMayRun>());
}

// A copy of the network, as Python may assign to its parts meanwhile.
using AnyModel = std::variant<fs::path, CompensationModel, const MotionModel*>;

PlanResult plan_with(const ArmDescription& arm, const AnyModel& model,
                     const Environment& environment, PlannerLimits limits, std::uint64_t seed,
                     const py::object& callback, PlanSettings settings) {
  require_jobs(settings.jobs);
  require_planar(arm, "limber.plan");
  CallerThread caller;
  settings.callback = watched(caller, callback);
  return caller.run([&] {
    if (const auto* file = std::get_if<fs::path>(&model)) {
      return plan(arm, *file, environment, limits, seed, settings);
    }
    if (const auto* network = std::get_if<CompensationModel>(&model)) {
      return plan(arm, *network, environment, limits, seed, settings);
    }
    return plan(arm, *std::get<const MotionModel*>(model), environment, limits, seed, settings);
  });
}

void bind_plan_function(py::module_& module) {
  module.def(
      "plan",
      [](const ArmDescription& arm, const AnyModel& model, const Environment& environment,
         const PlannerLimits& limits, std::uint64_t seed, const py::object& callback,
         const std::string& planner, int jobs, std::optional<double> margin_m,
         std::optional<double> goal_margin_m, std::optional<double> goal_margin_rad,
         std::optional<double> tube_level, bool stay_recorded,
         const std::vector<std::pair<double, double>>& limits_kpa,
         std::optional<double> rate_limit_kpa_per_s) {
        return plan_with(arm, model, environment, limits, seed, callback,
                         {{margin_m, goal_margin_m, goal_margin_rad, tube_level},
                          limits_of_pairs(limits_kpa),
                          rate_limit_kpa_per_s,
                          stay_recorded,
                          planner,
                          jobs});
      },
      "arm"_a, "model"_a.none(false), "environment"_a, "limits"_a = PlannerLimits{}, "seed"_a = 1,
      py::kw_only(), "callback"_a = py::none(), "planner"_a = "default", "jobs"_a = 0,
      "margin_m"_a = py::none(), "goal_margin_m"_a = py::none(), "goal_margin_rad"_a = py::none(),
      "tube_level"_a = py::none(), "stay_recorded"_a = false,
      "limits_kpa"_a = std::vector<std::pair<double, double>>{},
      "rate_limit_kpa_per_s"_a = py::none(),
      "What `limber plan` does, and the same plan: it keeps the tube that the model carries, or "
      "the error that it states, stands behind the valves that it was trained with, and is "
      "certified. model: the file of one, which the plan then names; a CompensationModel; or a "
      "MotionModel, with valves of its own or without a network. limits: by default 10 s. The "
      "others as Planner.plan, make_planner, error_room and PlanningProblem have them; "
      "rate_limit_kpa_per_s: in place of the arm's, at most that; "
      "stay_recorded: with set points, rates and shapes like those recorded alone. No plan is no "
      "error: PlanResult.status and reason say why, warnings what is doubtful.");
}

}  // namespace

void bind_planning(py::module_& module) {
  bind_limits(module);
  bind_problem(module);
  module.def("problem_with_room", of_planar_arms("limber.problem_with_room", &problem_with_room),
             "arm"_a, "model"_a, "environment"_a, "room"_a, py::keep_alive<0, 1>(),
             py::keep_alive<0, 2>(), py::keep_alive<0, 3>(),
             "The PlanningProblem whose plans keep that room: the model's tube, or one "
             "clearance everywhere. room: an ErrorRoom, as error_room makes it.");
  bind_plan_result(module);
  py::class_<OnePlanner>(module, "Planner", "A planner in pressure space: one caller at a time.")
      .def_property_readonly("name", &OnePlanner::name, "Its name, a text that make_planner takes.")
      .def("plan", &OnePlanner::plan, "problem"_a, "limits"_a, "seed"_a, "callback"_a = py::none(),
           "Searches; the plan is certified. `callback(progress)` comes about ten times per "
           "second; False stops the search. Ctrl-C ends it with KeyboardInterrupt. With limits of "
           "iterations or queries alone the seed decides everything.")
      .def("__repr__",
           [](const OnePlanner& planner) { return fmt::format("Planner('{}')", planner.name()); });
  bind_plan_function(module);
  module.def("planner_names", &planner_names, "Names that make_planner knows, the default first.");
  module.def(
      "make_planner",
      [](const std::string& name, int jobs) {
        require_jobs(jobs);
        return std::make_unique<OnePlanner>(make_planner(name, jobs));
      },
      "name"_a = "default", "jobs"_a = 0, py::call_guard<OthersMayRun>(),
      "By name; settings may follow it: \"default,improved_plans=0\". jobs: threads, 0: one per "
      "core; they never change a result.");
  module.def("plan_along", &along, "problem"_a, "waypoints_kpa"_a, "planner"_a, "seed"_a = 0,
             "The motion that a planner of your own proposes, from the start straight to each of "
             "the waypoints (w, n) [kPa]: simulated, held and certified. Not certified: "
             "best_partial is the motion, reason what is wrong with it.");
}

}  // namespace limber::python
