#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>
#include <nlohmann/json.hpp>

#include "bindings.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/network/prediction_error.hpp"
#include "limber/report/execution_report.hpp"
#include "limber/report/plan_report.hpp"
#include "limber/report/training_report.hpp"
#include "others_may_run.hpp"

namespace limber::python {

namespace py = pybind11;
using namespace py::literals;

namespace {

/// What the program prints with --json, as Python's own dicts and numbers.
template <class MakeJson>
py::object to_python(const MakeJson& make_json) {
  std::string text;
  {
    const OthersMayRun others_may_run;
    text = make_json().dump();
  }
  return py::module_::import("json").attr("loads")(text);
}

}  // namespace

void bind_json(py::module_& module) {
  module.def(
      "to_json",
      [](const Evaluation& evaluation) { return to_python([&] { return to_json(evaluation); }); },
      "evaluation"_a, "The dict of `limber evaluate --json`.");
  module.def(
      "to_json",
      [](const Certificate& certificate, const Environment& environment, const Command& command) {
        return to_python([&] { return to_json(certificate, command, environment); });
      },
      "certificate"_a, "environment"_a, py::arg_v("command", Command(), "..."),
      "The dict of `limber verify --json`. `command`: the arm's, where that is no pressure.");
  module.def(
      "to_json",
      [](const PlanResult& result, const PoseGoal& goal, const std::string& planner,
         const std::string& model, std::uint64_t seed, const Command& command) {
        return to_python([&] { return to_json(result, command, goal, planner, model, seed); });
      },
      "result"_a, "goal"_a, "planner"_a, "model"_a, "seed"_a,
      py::arg_v("command", Command(), "..."),
      "The dict of `limber plan --json`. `command`: the arm's, where that is no pressure.");
  module.def(
      "to_json",
      [](const ExecutionResult& result, const Environment& environment) {
        const auto obstacles = int(environment.obstacles.size());
        for (const std::optional<Contact>& contact : {result.first_collision, result.closest}) {
          if (contact && contact->clearance.obstacle >= obstacles) {
            throw InputError(
                fmt::format("environment: of {} obstacles; the run tells of obstacle {}, "
                            "counted from 0. Expected the environment that it was executed in",
                            obstacles, contact->clearance.obstacle));
          }
        }
        return to_python([&] { return to_json(result, environment); });
      },
      "result"_a, "environment"_a, "The dict of `limber execute --json`.");
  module.def(
      "to_json",
      [](const IdentifiedValves& valves) { return to_python([&] { return to_json(valves); }); },
      "valves"_a, "Valves as a dict, with the keys of a valve file.");
  module.def(
      "to_json",
      [](const PredictionError& error) { return to_python([&] { return to_json(error); }); },
      "error"_a, "The object `prediction_error` of `limber train --json`.");
  module.def(
      "content_hash", [](const fs::path& path) { return content_hash(read_file(path)); }, "path"_a,
      py::call_guard<OthersMayRun>(),
      "Hash of a file, a text: what plans and models say of the files they were made with.");
}

}  // namespace limber::python
