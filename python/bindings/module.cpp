#include "bindings.hpp"
#include "limber/common/version.hpp"
#include "others_may_run.hpp"

namespace {

namespace py = pybind11;

newfunc new_of_bound_classes = nullptr;

/// pickle makes a plain base of what it can't pickle, which pybind11 answers by ending the process.
PyObject* new_object(PyTypeObject* type, PyObject* arguments, PyObject* keywords) {
  if (reinterpret_cast<PyObject*>(type) == py::detail::get_internals().instance_base) {
    PyErr_SetString(PyExc_TypeError,
                    "this object can't be pickled or copied, nor its base be made; limber writes "
                    "files of arms, models, plans, environments and recordings");
    return nullptr;
  }
  return new_of_bound_classes(type, arguments, keywords);
}

void refuse_plain_bases() {
  auto* base = reinterpret_cast<PyTypeObject*>(py::detail::get_internals().instance_base);
  if (base->tp_new != &new_object) {
    new_of_bound_classes = base->tp_new;
    base->tp_new = &new_object;
    PyType_Modified(base);
  }
}

}  // namespace

// Classes before the functions that take them, so that docstrings name them as Python does.
PYBIND11_MODULE(_limber, module) {
  using namespace limber::python;
  module.doc() = "limber's C++ library; import limber instead.";
  module.attr("__version__") = limber::version();
  bind_errors(module);
  bind_random(module);
  bind_goals(module);
  bind_arm(module);
  bind_no_load_model(module);
  bind_inverse_kinematics(module);
  bind_valves(module);
  bind_recordings(module);
  bind_characterisation(module);
  bind_logs(module);
  bind_networks(module);
  bind_environments(module);
  bind_collision(module);
  bind_forward_model(module);
  bind_ensemble_forward(module);
  bind_motion_model(module);
  bind_plans(module);
  bind_certificate(module);
  bind_planning(module);
  bind_virtual_arm(module);
  bind_process_driver(module);
  bind_collection(module);
  bind_training(module);
  bind_families(module);  // names what execution tells of an arm
  bind_execution(module);
  bind_evaluation(module);
  bind_pictures(module);
  bind_json(module);
  refuse_plain_bases();
  stop_at_exit();
}
