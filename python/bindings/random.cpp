#include <string>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber::python {

namespace py = pybind11;
using namespace py::literals;

void bind_random(py::module_& module) {
  py::class_<RandomStream>(
      module, "RandomStream",
      "Counter-based random numbers (Philox): the k-th sample depends on seed, "
      "stream and k alone. One stream, one thread.")
      .def(py::init<std::uint64_t, std::uint64_t>(), "seed"_a, "stream"_a = 0,
           "seed: >= 0; stream: >= 0, names the unit of work. Streams of one seed are independent.")
      .def("next_u32", &RandomStream::next_u32, "The next word, uniform over all 32-bit integers.")
      .def(
          "uniform",
          [](RandomStream& random, double low, double high) {
            require_finite(low, "low");
            require_finite(high, "high");
            refuse_if(low > high, "low = {}, high = {}; expected low <= high", low, high);
            return random.uniform(low, high);
          },
          "low"_a = 0.0, "high"_a = 1.0,
          "The next number, uniform in [low, high); both finite, low <= high.")
      .def("normal", &RandomStream::normal,
           "The next number, normal with mean 0 and standard deviation 1.")
      .def("position", &RandomStream::position,
           "How far the stream is, in 32-bit words; seek goes there again.")
      .def("seek", &RandomStream::seek, "position"_a,
           "Goes on from a position, as `position` returned it.")
      .def("__repr__", [](const RandomStream& random) {
        return "RandomStream(position=" + std::to_string(random.position()) + ")";
      });
}

}  // namespace limber::python
