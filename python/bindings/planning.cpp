#include <algorithm>
#include <atomic>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "caller_thread.hpp"
#include "limber/common/error.hpp"
#include "limber/network/gap_bounds.hpp"
#include "limber/planning/planner_factory.hpp"
#include "pictures.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

/// A planner takes one caller at a time; Python's threads do not know that.
class OnePlanner {
 public:
  explicit OnePlanner(std::unique_ptr<Planner> planner) : planner_(std::move(planner)) {}

  const char* name() const { return planner_->name(); }

  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
                  const py::object& callback) {
    if (problem.model.has_network()) {
      require_bounded(problem.model.compensation(), "the model");
    }
    if (busy_.exchange(true)) {
      throw InputError("this planner is planning already; make one for each thread");
    }
    const std::unique_ptr<std::atomic<bool>, void (*)(std::atomic<bool>*)> free_again(
        &busy_, [](std::atomic<bool>* busy) { busy->store(false); });
    CallerThread caller;
    return caller.run([&] {
      return planner_->plan(problem, limits, seed, [&](const PlannerProgress& now) {
        return !caller.should_stop() && (callback.is_none() || goes_on(caller, callback, now));
      });
    });
  }

 private:
  static bool goes_on(CallerThread& caller, const py::object& callback,
                      const PlannerProgress& now) {
    bool answer = true;
    const bool returned = caller.call([&] {
      const py::object said = callback(now);
      answer = said.is_none() || said.cast<bool>();
    });
    return returned && answer;
  }

  std::unique_ptr<Planner> planner_;
  std::atomic<bool> busy_{false};
};

void bind_limits(py::module_& module) {
  Record<PlannerLimits>(module, "PlannerLimits",
                        "When to stop; whichever comes first. At least one of time_s, iterations "
                        "and queries is set.")
      .field("time_s", &PlannerLimits::time_s, "[s]")
      .field("iterations", &PlannerLimits::iterations, "Samples.")
      .field("queries", &PlannerLimits::queries, "Of the forward model.")
      .field("memory_mb", &PlannerLimits::memory_mb, "Of the tree [MB].")
      .field("cost_threshold_kpa", &PlannerLimits::cost_threshold_kpa,
             "Stops at a plan this cheap [kPa].")
      .keywords()
      .done();
  py::enum_<PlanStatus>(module, "PlanStatus", "What came of planning.")
      .value("solved", PlanStatus::solved, "a certified plan exists")
      .value("limit", PlanStatus::limit, "a limit came first")
      .value("invalid_start", PlanStatus::invalid_start, "the arm starts in an obstacle")
      .value("goal_unreachable", PlanStatus::goal_unreachable, "beyond the arm's length")
      .value("goal_in_collision", PlanStatus::goal_in_collision, "no tip in the goal is free")
      .value("not_certified", PlanStatus::not_certified, "plans were found, and all refused");
  py::enum_<PlanLimit>(module, "PlanLimit", "The limit that ended a search.")
      .value("time", PlanLimit::time)
      .value("iterations", PlanLimit::iterations)
      .value("queries", PlanLimit::queries)
      .value("memory", PlanLimit::memory);
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
            PlanningProblem problem{arm, model, environment, margin_m, goal_margin};
            problem.stay_within = stay_within;
            problem.margin_yields_to_start = margin_yields_to_start;
            for (const auto& [lower, upper] : limits_kpa) {
              problem.limits.emplace_back(lower, upper);
            }
            problem.tube = tube;
            return problem;
          }),
          py::arg("arm"), py::arg("model"), py::arg("environment"), py::arg("margin_m") = 0.0,
          py::arg("goal_margin") = PoseError{}, py::arg("stay_within") = py::none(),
          py::arg("margin_yields_to_start") = false,
          py::arg("limits_kpa") = std::vector<std::pair<double, double>>{},
          py::arg("tube") = py::none(), py::keep_alive<1, 2>(), py::keep_alive<1, 3>(),
          py::keep_alive<1, 4>(), py::keep_alive<1, 7>(),
          "margin_m: clearance kept from obstacles [m]; goal_margin: how far inside the goal's "
          "tolerances plans end; limits_kpa: lower and upper of each segment, within the arm's; "
          "empty: the arm's; tube: kept free beside the margin.")
      .def_readonly("margin_m", &PlanningProblem::margin_m, "[m]")
      .def_readonly("goal_margin", &PlanningProblem::goal_margin, "Room for the model's error.")
      .def_readonly("tube", &PlanningProblem::tube, "PlanTube, or None.")
      .def("__repr__", [](const PlanningProblem& problem) {
        return fmt::format("PlanningProblem(arm='{}', environment='{}', margin_m={})",
                           problem.arm.name, problem.environment.name, problem.margin_m);
      });
}

void bind_problem_with_room(py::module_& module) {
  module.def("problem_with_room", &problem_with_room, py::arg("arm"), py::arg("model"),
             py::arg("environment"), py::arg("room"), py::keep_alive<0, 1>(),
             py::keep_alive<0, 2>(), py::keep_alive<0, 3>(),
             "The problem whose plans keep that room: the model's tube, or one clearance "
             "everywhere.");
}

/// A motion of somebody else's planner, in (w, n) set points.
PlanResult along(const PlanningProblem& problem, const FloatArray& waypoints_kpa,
                 const std::string& planner, std::uint64_t seed) {
  const auto n = py::ssize_t{problem.arm.segment_count()};
  require_shape(waypoints_kpa, {batch_size(waypoints_kpa, "waypoints_kpa"), n}, "waypoints_kpa");
  require_finite(waypoints_kpa, "waypoints_kpa");
  if (problem.model.has_network()) {
    require_bounded(problem.model.compensation(), "the model");
  }
  std::vector<Pressures> waypoints;
  for (py::ssize_t w = 0; w < waypoints_kpa.shape(0); ++w) {
    waypoints.emplace_back(Eigen::Map<const Pressures>(waypoints_kpa.data(w, 0), n));
  }
  const py::gil_scoped_release others_may_run;
  return plan_along(problem, waypoints, planner, seed);
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
      .read_only("time_s", &PlannerProgress::time_s, "[s]")
      .read_only("iterations", &PlannerProgress::iterations, "Samples.")
      .read_only("nodes", &PlannerProgress::nodes, "Of the tree.")
      .read_only("queries", &PlannerProgress::queries, "Of the forward model.")
      .read_only("best_cost_kpa", &PlannerProgress::best_cost_kpa, "None before the first plan.")
      .done();
  Record<FirstSolution>(module, "FirstSolution", "The first plan that was certified.")
      .read_only("time_s", &FirstSolution::time_s, "[s]")
      .read_only("cost_kpa", &FirstSolution::cost_kpa, "[kPa]")
      .read_only("queries", &FirstSolution::queries, "Until it was found.")
      .read_only("candidate_s", &FirstSolution::candidate_s, "When it was found [s].")
      .read_only("certificate_s", &FirstSolution::certificate_s,
                 "What building and certifying it then took [s].")
      .done();
  Record<PlannerStatistics>(module, "PlannerStatistics", "What a search took.")
      .read_only("time_s", &PlannerStatistics::time_s, "[s]")
      .read_only("iterations", &PlannerStatistics::iterations, "Samples.")
      .read_only("queries", &PlannerStatistics::queries, "Of the forward model.")
      .read_only("nodes", &PlannerStatistics::nodes, "Of the tree.")
      .done();
}

void bind_plan_result(py::module_& module) {
  bind_progress(module);
  Record<PlanResult>(module, "PlanResult", "What came of planning.")
      .read_only("status", &PlanResult::status, "PlanStatus.")
      .read_only("reason", &PlanResult::reason, "What ended the search, a sentence.")
      .read_only("plan", &PlanResult::plan, "The plan, if and only if solved.")
      .read_only("limit", &PlanResult::limit, "The limit that ended the search, or None.")
      .read_only("warnings", &PlanResult::warnings, "What to know of the plan, sentences.")
      .read_only("statistics", &PlanResult::statistics, "What it took.")
      .done()
      .def_readonly("best_partial", &PlanResult::best_partial,
                    "Where there is no plan, the motion that came nearest; never a solution.")
      .def_readonly("certificate", &PlanResult::certificate, "Of the plan.")
      .def_readonly("first_solution", &PlanResult::first_solution, "FirstSolution, or None.")
      .def_readonly("max_clearance_m", &PlanResult::max_clearance_m,
                    "What a plan keeps that was found with less clearance [m], or None.")
      .def_readonly("events", &PlanResult::events, "Each plan that was notably cheaper.")
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
          py::call_guard<py::gil_scoped_release>());
}

}  // namespace

void bind_planning(py::module_& module) {
  bind_limits(module);
  bind_problem(module);
  bind_problem_with_room(module);
  bind_plan_result(module);
  py::class_<OnePlanner>(module, "Planner", "A planner in pressure space: one caller at a time.")
      .def_property_readonly("name", &OnePlanner::name, "As make_planner knows it.")
      .def("plan", &OnePlanner::plan, py::arg("problem"), py::arg("limits"), py::arg("seed"),
           py::arg("callback") = py::none(),
           "Searches; the plan is certified. `callback(progress)` comes about ten times per "
           "second; False stops the search. Ctrl-C ends it with KeyboardInterrupt. With limits of "
           "iterations or queries alone the seed decides everything.")
      .def("__repr__",
           [](const OnePlanner& planner) { return fmt::format("Planner('{}')", planner.name()); });
  module.def("planner_names", &planner_names, "Names that make_planner knows, the default first.");
  module.def(
      "make_planner",
      [](const std::string& name, int jobs) {
        return std::make_unique<OnePlanner>(make_planner(name, jobs));
      },
      py::arg("name") = "default", py::arg("jobs") = 0, py::call_guard<py::gil_scoped_release>(),
      "By name; settings may follow it: \"default,improved_plans=0\". jobs: threads, 0: one per "
      "core; they never change a result.");
  module.def("plan_along", &along, py::arg("problem"), py::arg("waypoints_kpa"), py::arg("planner"),
             py::arg("seed") = 0,
             "The motion that a planner of your own proposes, from the start straight to each of "
             "the waypoints (w, n) [kPa]: simulated, held and certified. Not certified: "
             "best_partial is the motion, reason what is wrong with it.");
}

}  // namespace limber::python
