#include "limber/certificate/certificate.hpp"

#include <memory>
#include <optional>
#include <utility>

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "caller_thread.hpp"
#include "limber/arm/arm_identity.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/network/compensation_model.hpp"
#include "others_may_run.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

/// A certifier with copies of what Python may change.
struct OwnCertifier {
  OwnCertifier(const ArmDescription& arm, std::optional<CompensationModel> of_network,
               ValveParameters of_valves, const Environment& environment)
      : network(std::move(of_network)),
        valves(std::move(of_valves)),
        certifier(arm, network ? &*network : nullptr, valves, environment) {}

  const std::optional<CompensationModel> network;
  const ValveParameters valves;
  const Certifier certifier;
};

Certificate certified(const OwnCertifier& own, const Plan& plan) {
  CallerThread caller;
  return caller.run(
      [&] { return own.certifier.certify(plan, [&] { return caller.should_stop(); }); });
}

void bind_certificate_findings(py::module_& module) {
  Record<CertificateFailure>(module, "CertificateFailure",
                             "One thing that is wrong with a plan, and in which frame.")
      .read_only("check", &CertificateFailure::check,
                 "\"limits\", \"rate\", \"start\", \"waypoints\", \"cost\", \"hold\", "
                 "\"valves\", \"model\", \"collision\", \"goal\", \"claims\", \"tube\", "
                 "\"seal\", \"sizes\" or \"unfinished\".")
      .read_only("frame", &CertificateFailure::frame,
                 "The first frame that fails, from 0; -1: no frame is to blame.")
      .read_only("message", &CertificateFailure::message, "What is wrong, a sentence with numbers.")
      .done();
  Record<Certificate>(module, "Certificate", "What an independent second look at a plan found.")
      .property("certified", &Certificate::certified,
                "Whether nothing is wrong: failures is empty.")
      .read_only("failures", &Certificate::failures,
                 "List of CertificateFailure; empty: certified.")
      .read_only("clearance_m", &Certificate::clearance_m,
                 "Smallest distance of the moving arm from an obstacle, a lower bound [m]; "
                 "negative: how deep; inf without obstacles; NaN: not checked.")
      .read_only("max_deviation_m", &Certificate::max_deviation_m,
                 "Largest distance of a plate between the certificate's own simulation and the "
                 "plan [m]; up to 1e-4 is allowed.")
      .read_only("cost_kpa", &Certificate::cost_kpa, "Sum of |dp| over segments and frames [kPa].")
      .read_only("goal_distance_m", &Certificate::goal_distance_m,
                 "Of the tip from the goal's centre after the hold, by its own simulation [m]; "
                 "NaN: not checked.")
      .read_only("goal_orientation_rad", &Certificate::goal_orientation_rad,
                 "Difference of the tip's heading from the goal's after the hold [rad], 0 to pi; "
                 "0 where the goal has no heading.")
      .read_only("frames", &Certificate::frames, "Frames of the plan, T.")
      .done()
      .def_readonly(
          "clearance_frame", &Certificate::clearance_frame,
          "Frame that the motion with the smallest clearance leads to, from 0, the start; "
          "-1: none.")
      .def_readonly("clearance_gap", &Certificate::clearance_gap,
                    "Where on the arm it is smallest: between plates gap and gap + 1; -1: nowhere.")
      .def_readonly("clearance_obstacle", &Certificate::clearance_obstacle,
                    "Index of that obstacle in the environment's list, from 0; -1: none.")
      .def_readonly("max_step_kpa", &Certificate::max_step_kpa,
                    "Largest change of a set point in one frame [kPa].")
      .def_readonly(
          "max_pressure_deviation_kpa", &Certificate::max_pressure_deviation_kpa,
          "Largest difference of a pressure between its own valves and the plan [kPa]; up "
          "to 1e-5 of the segment's largest command is allowed.")
      .def_readonly("unfinished", &Certificate::unfinished,
                    "Whether it was given up before the end; what was not checked has no figure.");
}

}  // namespace

void bind_certificate(py::module_& module) {
  bind_certificate_findings(module);
  Record<OwnCertifier>(module, "Certifier",
                       "Certifies plans for one problem with nothing "
                       "of the planner's. Constant: share it freely.")
      .property(
          "environment_hash",
          [](const OwnCertifier& own) { return own.certifier.environment_hash(); },
          "environment_hash of the environment, which plans have to state.")
      .done()
      .def(py::init([](const ArmDescription& arm, std::optional<CompensationModel> network,
                       ValveParameters valves, const Environment& environment) {
             const OthersMayRun others_may_run;
             require_planar(arm, "limber.Certifier");
             return std::make_unique<OwnCertifier>(arm, std::move(network), std::move(valves),
                                                   environment);
           }),
           "arm"_a, "network"_a, "valves"_a, "environment"_a, py::keep_alive<1, 2>(),
           py::keep_alive<1, 5>(),
           "network: a CompensationModel, None: the no-load model; valves: "
           "ValveParameters, ideal ones for a plan without valves. None of them is taken "
           "from a plan.")
      .def("certify", &certified, "plan"_a,
           "The Certificate of one plan. Raises InputError where the plan was made for "
           "another arm, environment or valves; all else is a failure in the result. "
           "Ctrl-C raises KeyboardInterrupt.");
  module.def(
      "certify",
      [](const Plan* plan, const ArmDescription& arm, std::optional<CompensationModel> network,
         ValveParameters valves, const Environment& environment) {
        refuse_if(plan == nullptr, "there is no plan: the reason of its PlanResult says why");
        require_planar(arm, "limber.certify");
        const ArmDescription slowed = at_rate_of(plan->arm(), arm, "the plan");
        return certified(OwnCertifier(slowed, std::move(network), std::move(valves), environment),
                         *plan);
      },
      "plan"_a, "arm"_a, "network"_a, "valves"_a, "environment"_a,
      "One plan, by a Certifier of its own: simulated, checked for collision and judged again, "
      "with nothing of the planner's. It says whether the plan is as the model has it, not whether "
      "the model is right. None is refused.");
}

}  // namespace limber::python
