#include "limber/certificate/certificate.hpp"

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "caller_thread.hpp"
#include "limber/common/error.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

Certificate certified(const Certifier& certifier, const Plan& plan) {
  CallerThread caller;
  return caller.run([&] { return certifier.certify(plan, [&] { return caller.should_stop(); }); });
}

void bind_certificate_findings(py::module_& module) {
  Record<CertificateFailure>(module, "CertificateFailure", "One thing that is wrong with a plan.")
      .read_only("check", &CertificateFailure::check, "\"limits\", \"collision\", \"goal\", ...")
      .read_only("frame", &CertificateFailure::frame, "The first that fails; -1: none to blame.")
      .read_only("message", &CertificateFailure::message, "A sentence with numbers.")
      .done();
  Record<Certificate>(module, "Certificate", "What an independent second look at a plan found.")
      .property("certified", &Certificate::certified, "Whether nothing is wrong.")
      .read_only("failures", &Certificate::failures, "Empty: certified.")
      .read_only("clearance_m", &Certificate::clearance_m, "Of the moving arm, from below [m].")
      .read_only("max_deviation_m", &Certificate::max_deviation_m,
                 "Of a plate, own simulation against the plan [m].")
      .read_only("cost_kpa", &Certificate::cost_kpa, "Sum of |dp| [kPa].")
      .read_only("goal_distance_m", &Certificate::goal_distance_m, "Of the last tip [m].")
      .read_only("goal_orientation_rad", &Certificate::goal_orientation_rad, "The same [rad].")
      .read_only("frames", &Certificate::frames, "Of the plan.")
      .done()
      .def_readonly("clearance_frame", &Certificate::clearance_frame, "Where it is smallest.")
      .def_readonly("clearance_gap", &Certificate::clearance_gap, "Between plates gap, gap + 1.")
      .def_readonly("clearance_obstacle", &Certificate::clearance_obstacle, "Index in the list.")
      .def_readonly("max_step_kpa", &Certificate::max_step_kpa, "Of a pressure in a frame [kPa].")
      .def_readonly("max_pressure_deviation_kpa", &Certificate::max_pressure_deviation_kpa,
                    "Of a predicted pressure [kPa].")
      .def_readonly("unfinished", &Certificate::unfinished, "Given up before the end.");
}

}  // namespace

void bind_certificate(py::module_& module) {
  bind_certificate_findings(module);
  py::class_<Certifier>(module, "Certifier",
                        "Certifies plans for one problem with nothing "
                        "of the planner's. Constant: share it freely.")
      .def(py::init<const ArmDescription&, const CompensationModel*, const ValveParameters&,
                    const Environment&>(),
           py::arg("arm"), py::arg("network"), py::arg("valves"), py::arg("environment"),
           py::keep_alive<1, 2>(), py::keep_alive<1, 3>(), py::keep_alive<1, 4>(),
           py::keep_alive<1, 5>(), py::call_guard<py::gil_scoped_release>(),
           "Without network (None): the no-load model.")
      .def("certify", &certified, py::arg("plan"),
           "Raises InputError where the plan was made for "
           "something else; all else is a failure in the result.")
      .def_property_readonly("environment_hash", &Certifier::environment_hash,
                             "What plans have to state.")
      .def("__repr__", [](const Certifier& certifier) {
        return "Certifier(environment_hash='" + certifier.environment_hash() + "')";
      });
  module.def(
      "certify",
      [](const Plan* plan, const ArmDescription& arm, const CompensationModel* network,
         const ValveParameters& valves, const Environment& environment) {
        if (plan == nullptr) {
          throw InputError("there is no plan: the reason of its PlanResult says why");
        }
        return certified(Certifier(arm, network, valves, environment), *plan);
      },
      py::arg("plan"), py::arg("arm"), py::arg("network"), py::arg("valves"),
      py::arg("environment"),
      "One plan, by a Certifier of its own: simulated, checked for collision and judged again, "
      "with nothing of the planner's. It says whether the plan is as the model has it, not whether "
      "the model is right. None is refused.");
}

}  // namespace limber::python
