#include "bindings.hpp"
#include "limber/common/error.hpp"

namespace limber::python {

namespace py = pybind11;

void bind_errors(py::module_& module) {
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError).attr("__doc__") =
      "A mistake of the caller or of a file: what was found, where, and what is allowed.";
  py::register_exception<SystemFault>(module, "SystemFault", PyExc_RuntimeError).attr("__doc__") =
      "The machine or a driver failed: disk full, simulation blown up, arm silent.";
  py::register_exception<Interrupted>(module, "Interrupted", PyExc_RuntimeError).attr("__doc__") =
      "Work stopped because it was asked to; what was written is valid.";
}

}  // namespace limber::python
