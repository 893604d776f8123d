#include "arrays.hpp"

#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/error.hpp"
#include "limber/common/jobs.hpp"
#include "limber/common/refuse_if.hpp"
#include "planar.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

// In integers, so that the compiler makes vectors of it: an exponent of ones is NaN or infinity.
bool all_finite(const float* values, py::ssize_t count) {
  constexpr std::uint32_t kExponent = 0x7f800000U;
  std::uint32_t found = 0;
  for (py::ssize_t i = 0; i < count; ++i) {
    found |= std::uint32_t((std::bit_cast<std::uint32_t>(values[i]) & kExponent) == kExponent);
  }
  return found == 0;
}

bool all_finite(const double* values, py::ssize_t count) {
  return Eigen::Map<const Eigen::VectorXd>(values, count).allFinite();
}

template <class Array>
void require_all_finite(const Array& array, const char* name) {
  const auto* values = array.data();
  if (all_finite(values, array.size())) {
    return;
  }
  py::ssize_t at = 0;
  while (std::isfinite(values[at])) {
    ++at;
  }
  const float bad = float(values[at]);
  Shape index(std::size_t(array.ndim()));
  for (py::ssize_t axis = array.ndim(); axis-- > 0;) {
    index[axis] = at % array.shape(axis);
    at /= array.shape(axis);
  }
  throw InputError(
      fmt::format("{}[{}] = {}; expected finite numbers", name, fmt::join(index, ", "), bad));
}

}  // namespace

bool is_float_array(py::handle object) {
  // NumPy has one description of native float32, unless somebody makes another.
  static const PyObject* const float32 = py::dtype::of<float>().release().ptr();
  using Api = py::detail::npy_api;
  constexpr int kAsItIs = Api::NPY_ARRAY_C_CONTIGUOUS_ | Api::NPY_ARRAY_ALIGNED_;
  return Api::get().PyArray_Check_(object.ptr()) &&
         py::detail::array_proxy(object.ptr())->descr == float32 &&
         py::detail::check_flags(object.ptr(), kAsItIs);
}

void require_number(const char* name, double value, double lowest, double highest) {
  refuse_if(!(value >= lowest && value <= highest), "{} = {:.10g}; expected {:.10g} to {:.10g}",
            name, value, lowest, highest);
}

void require_jobs(int jobs) {
  refuse_if(jobs < 0 || jobs > kMaxJobs, "jobs = {}; expected 1 to {} threads, or 0: one per core",
            jobs, kMaxJobs);
}

void require_planar_model(Dimension dimension, const char* name) {
  refuse_if(dimension == Dimension::space,
            "{} can't use the model of an arm in space yet. ForwardModel.step, step_batch "
            "and rollout, predict and evaluate can",
            name);
}

bool has_numbers(const py::array& array) {
  return std::string_view("biuf").find(array.dtype().kind()) != std::string_view::npos;
}

std::string to_text(const Shape& shape) {
  return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

Shape shape_of(const py::array& array) {
  return {array.shape(), array.shape() + array.ndim()};
}

void require_shape(const py::array& array, const Shape& expected, const char* name) {
  bool same = array.ndim() == static_cast<py::ssize_t>(expected.size());
  for (std::size_t axis = 0; same && axis < expected.size(); ++axis) {
    same = array.shape(static_cast<py::ssize_t>(axis)) == expected[axis];
  }
  if (!same) {
    throw InputError(fmt::format("{} has shape {}; expected {}", name, to_text(shape_of(array)),
                                 to_text(expected)));
  }
}

void require_finite(const FloatArray& array, const char* name) {
  require_all_finite(array, name);
}

void require_finite(const DoubleArray& array, const char* name) {
  require_all_finite(array, name);
}

void require_finite(double value, const char* name) {
  refuse_if(!std::isfinite(value), "{} = {}; expected a finite number", name, value);
}

py::array_t<float> result_array(const py::object& out, const Shape& shape) {
  if (out.is_none()) {
    return py::array_t<float>(shape);
  }
  const bool fits = py::isinstance<py::array_t<float, py::array::c_style>>(out);
  if (!fits || !py::reinterpret_borrow<py::array>(out).writeable()) {
    throw InputError(
        fmt::format("out: expected a writable C-contiguous float32 array of shape {}, found {}",
                    to_text(shape), type_name(out)));
  }
  auto array = py::reinterpret_borrow<py::array_t<float>>(out);
  require_shape(array, shape, "out");
  return array;
}

void require_own_memory(const py::array& out, const py::array& input, const char* name,
                        bool may_be_input) {
  const auto* out_begin = static_cast<const char*>(out.data());
  const auto* in_begin = static_cast<const char*>(input.data());
  if ((out_begin != in_begin || !may_be_input) && out_begin < in_begin + input.nbytes() &&
      in_begin < out_begin + out.nbytes()) {
    throw InputError(fmt::format("out overlaps {}; expected {}memory of its own", name,
                                 may_be_input ? fmt::format("{} itself, or ", name) : ""));
  }
}

py::ssize_t batch_size(const py::array& array, const char* name) {
  if (array.ndim() < 2) {
    throw InputError(
        fmt::format("{} has shape {}; expected one row a query", name, to_text(shape_of(array))));
  }
  return array.shape(0);
}

py::array_t<float> limits_array(const std::vector<PressureLimits>& limits) {
  py::array_t<float> rows({limits.size(), std::size_t{2}});
  for (std::size_t i = 0; i < limits.size(); ++i) {
    rows.mutable_at(i, 0) = float(limits[i].lower_kpa);
    rows.mutable_at(i, 1) = float(limits[i].upper_kpa);
  }
  return rows;
}

Pressures pressures_from(const FloatArray& array, Eigen::Index n, const char* name) {
  require_shape(array, {n}, name);
  require_finite(array, name);
  return pressures_map(array);
}

Backbone backbone_from(const FloatArray& array, Eigen::Index m, const char* name) {
  require_shape(array, {m, kPoseSize}, name);
  require_finite(array, name);
  return backbone_map(array);
}

}  // namespace limber::python
