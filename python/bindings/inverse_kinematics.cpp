#include "limber/world/inverse_kinematics.hpp"

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/common/random_stream.hpp"
#include "others_may_run.hpp"
#include "planar.hpp"
#include "record.hpp"

namespace limber::python {

void bind_inverse_kinematics(py::module_& module) {
  using Settings = InverseKinematicsSettings;
  using Result = InverseKinematicsResult;
  Record<Settings>(module, "InverseKinematicsSettings", "How long solutions are looked for.")
      .field("starts", &Settings::starts, "Random configurations to start from, >= 1.")
      .field("max_solutions", &Settings::max_solutions,
             "The search stops at so many solutions, >= 1.")
      .field("iterations", &Settings::iterations,
             "Largest number of Newton steps from each start, >= 1.")
      .field("convergence_m", &Settings::convergence_m,
             "A start is done when the tip is this near to the goal [m], > 0.")
      .field("distinct_pressure_kpa", &Settings::distinct_pressure_kpa,
             "Solutions differ by more than this in some segment [kPa], >= 0.")
      .keywords()
      .done();
  Record<Result>(module, "InverseKinematicsResult",
                 "What was found; that there is no solution is no error, and raises nothing.")
      .property(
          "pressures_kpa",
          [](const Result& result) {
            const auto k = static_cast<py::ssize_t>(result.pressures_kpa.size());
            const py::ssize_t n = result.best_pressures_kpa.size();
            py::array_t<double> rows({k, n});
            for (py::ssize_t i = 0; i < k; ++i) {
              Eigen::Map<Eigen::VectorXd>(rows.mutable_data() + i * n, n) =
                  result.pressures_kpa[static_cast<std::size_t>(i)];
            }
            return rows;
          },
          "Solutions, float64 (k, n) [kPa], in the order found.")
      .property(
          "best_pressures_kpa",
          [](const Result& result) { return vector_array(result.best_pressures_kpa); },
          "The nearest configuration of all starts, float64 (n,) [kPa].")
      .read_only("best_error", &Result::best_error,
                 "PoseError of best_pressures_kpa: how far they miss the goal's centre.")
      .read_only("starts_used", &Result::starts_used, "Number of starts that were tried.")
      .read_only("reason", &Result::reason, "Why there is no solution; empty where there is one.")
      .property("reachable", &Result::reachable, "Whether there is at least one solution.")
      .done();
  module.def(
      "solve_inverse_kinematics",
      [](const NoLoadModel& model, const PoseGoal& goal, const Settings& settings,
         RandomStream& random) {
        require_planar_model(model.dimension(), "limber.solve_inverse_kinematics");
        return solve_inverse_kinematics(model, goal, settings, random);
      },
      py::arg("model"), py::arg("goal"), py::arg("settings"), py::arg("random"),
      py::call_guard<OthersMayRun>(),
      "Pressures whose no-load tip is at the goal: Newton-Raphson from random starts. "
      "model: a NoLoadModel; goal: a PoseGoal; random: a RandomStream. Not complete: "
      "if none is found, there may still be one. Raises InputError where the goal or "
      "a setting is out of range.");
}

}  // namespace limber::python
