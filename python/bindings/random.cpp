#include <string>

#include "bindings.hpp"
#include "limber/common/random_stream.hpp"

namespace limber::python {

namespace py = pybind11;

void bind_random(py::module_& module) {
  py::class_<RandomStream>(
      module, "RandomStream",
      "Counter-based random numbers (Philox): the k-th sample depends on seed, "
      "stream and k alone. One stream, one thread.")
      .def(py::init<std::uint64_t, std::uint64_t>(), py::arg("seed"), py::arg("stream") = 0)
      .def("next_u32", &RandomStream::next_u32, "Uniform over all 32-bit words.")
      .def("uniform", py::overload_cast<double, double>(&RandomStream::uniform),
           py::arg("low") = 0.0, py::arg("high") = 1.0, "Uniform in [low, high).")
      .def("normal", &RandomStream::normal, "Standard normal deviate.")
      .def("position", &RandomStream::position, "Draws made so far, in 32-bit words.")
      .def("seek", &RandomStream::seek, py::arg("position"), "Goes on from a position.")
      .def("__repr__", [](const RandomStream& random) {
        return "RandomStream(position=" + std::to_string(random.position()) + ")";
      });
}

}  // namespace limber::python
