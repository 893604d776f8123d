#include <exception>
#include <utility>

#include "bindings.hpp"
#include "limber/common/error.hpp"
#include "others_may_run.hpp"

namespace limber::python {

namespace py = pybind11;

void bind_errors(py::module_& module) {
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError).attr("__doc__") =
      "A mistake of the caller or of a file: what was found, where, and what is allowed.";
  py::register_exception<SystemFault>(module, "SystemFault", PyExc_RuntimeError).attr("__doc__") =
      "The machine or a driver failed: disk full, simulation blown up, arm silent.";
  py::register_exception<Interrupted>(module, "Interrupted", PyExc_RuntimeError).attr("__doc__") =
      "Work stopped because it was asked to; what was written is valid.";
  // A thread that Python cuts off while it prints a traceback holds the lock of stderr for ever,
  // and Python aborts. SystemExit ends a thread without a word.
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      std::rethrow_exception(std::move(error));
    } catch (const Interrupted& stopped) {
      if (!python_leaves_this_thread()) {
        throw;
      }
      PyErr_SetString(PyExc_SystemExit, stopped.what());
    }
  });
}

}  // namespace limber::python
