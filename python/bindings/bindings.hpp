#pragma once

#include <pybind11/pybind11.h>

namespace limber::python {

/// Each adds one subject's classes and functions to the module.
void bind_errors(pybind11::module_& module);
void bind_arm(pybind11::module_& module);
void bind_no_load_model(pybind11::module_& module);
void bind_characterisation(pybind11::module_& module);
void bind_random(pybind11::module_& module);
void bind_goals(pybind11::module_& module);
void bind_inverse_kinematics(pybind11::module_& module);
void bind_valves(pybind11::module_& module);
void bind_networks(pybind11::module_& module);
void bind_forward_model(pybind11::module_& module);
void bind_ensemble_forward(pybind11::module_& module);
void bind_motion_model(pybind11::module_& module);
void bind_recordings(pybind11::module_& module);
void bind_logs(pybind11::module_& module);
void bind_environments(pybind11::module_& module);
void bind_collision(pybind11::module_& module);
void bind_plans(pybind11::module_& module);
void bind_certificate(pybind11::module_& module);
void bind_planning(pybind11::module_& module);
void bind_virtual_arm(pybind11::module_& module);
void bind_process_driver(pybind11::module_& module);
void bind_collection(pybind11::module_& module);
void bind_execution(pybind11::module_& module);
void bind_training_settings(pybind11::module_& module);
void bind_training(pybind11::module_& module);
void bind_families(pybind11::module_& module);
void bind_evaluation(pybind11::module_& module);
void bind_pictures(pybind11::module_& module);
void bind_json(pybind11::module_& module);

}  // namespace limber::python
