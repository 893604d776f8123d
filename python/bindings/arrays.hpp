#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "others_may_run.hpp"

namespace limber::python {

namespace py = pybind11;
using namespace py::literals;

/// What limber computes with. A C-contiguous float32 array is taken as it is; anything else that
/// NumPy understands is copied once. An own class for its caster: pybind11's makes an empty array
/// for every argument, and asks NumPy to convert what needs no conversion, half a microsecond each.
class FloatArray : public py::array_t<float, py::array::c_style | py::array::forcecast> {
 public:
  using Base = py::array_t<float, py::array::c_style | py::array::forcecast>;
  FloatArray() : Base(py::handle(), borrowed_t{}) {}  // none yet
  FloatArray(Base other) : Base(std::move(other)) {}  // NOLINT(google-explicit-constructor)
};
/// Whether that is such an array already.
bool is_float_array(py::handle object);

/// The same of float64.
class DoubleArray : public py::array_t<double, py::array::c_style | py::array::forcecast> {
 public:
  using Base = py::array_t<double, py::array::c_style | py::array::forcecast>;
  DoubleArray() : Base(py::handle(), borrowed_t{}) {}
  DoubleArray(Base other) : Base(std::move(other)) {}  // NOLINT(google-explicit-constructor)
};

/// Whether that holds real numbers: NumPy would drop a part of complex ones, and read texts and
/// dates as numbers.
bool has_numbers(const py::array& array);

using Shape = std::vector<py::ssize_t>;

/// @throws InputError unless it is a number of threads; 0 is one per core.
void require_jobs(int jobs);

/// @throws InputError "seconds = nan; expected 0 to 1000000".
void require_number(const char* name, double value, double lowest, double highest);
constexpr double kMaxSeconds = 1e6;

/// "(16, 3)", as NumPy prints it.
std::string to_text(const Shape& shape);
Shape shape_of(const py::array& array);

/// @throws InputError "previous_kpa has shape (4,); expected (3,)".
void require_shape(const py::array& array, const Shape& expected, const char* name);
/// @throws InputError naming the array and its first number that is not finite.
void require_finite(const FloatArray& array, const char* name);
void require_finite(const DoubleArray& array, const char* name);
void require_finite(double value, const char* name);

/// The array that results go to: `out` where one is given, else a fresh one.
/// @throws InputError unless `out` is None or a writable C-contiguous float32 array of the shape.
py::array_t<float> result_array(const py::object& out, const Shape& shape);
/// @throws InputError where `out` shares memory with an input. An input of the same rows, which are
/// read before they are written, may be `out` itself.
void require_own_memory(const py::array& out, const py::array& input, const char* name,
                        bool may_be_input);

/// The first axis of a batch: how many queries. @throws InputError where there is none.
py::ssize_t batch_size(const py::array& array, const char* name);

/// Without Python's lock, where there is so much that copying takes its time.
template <class Scalar, class Matrix>
py::array_t<Scalar> copy_of(const Matrix& matrix, const Shape& shape) {
  constexpr Eigen::Index kManyNumbers = 1 << 16;
  py::array_t<Scalar> array(shape);
  Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> copy(
      array.mutable_data(), matrix.rows(), matrix.cols());
  std::optional<OthersMayRun> others_may_run;
  if (matrix.size() > kManyNumbers) {
    others_may_run.emplace();
  }
  copy = matrix;
  return array;
}

/// A vector's numbers, shape (n,).
template <class Vector>
py::array_t<typename Vector::Scalar> vector_array(const Vector& vector) {
  return copy_of<typename Vector::Scalar>(vector, {vector.size()});
}

/// Lower and upper one of each, shape (n, 2).
py::array_t<float> limits_array(const std::vector<PressureLimits>& limits);

/// Shape (m, 3).
template <class Scalar>
py::array_t<Scalar> backbone_array(const BackboneOf<Scalar>& backbone) {
  return copy_of<Scalar>(backbone, {backbone.rows(), kPoseSize});
}

/// The same of an arm in space, shape (m, 7).
template <class Scalar>
py::array_t<Scalar> backbone_array(const SpaceBackboneOf<Scalar>& backbone) {
  return copy_of<Scalar>(backbone, {backbone.rows(), kSpacePoseSize});
}

/// The array itself, which Python can't write to any more.
template <class Scalar>
py::array_t<Scalar> read_only(py::array_t<Scalar> array) {
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// A view of numbers that `owner` holds: no copy, and `owner` lives as long as the view.
template <class Scalar>
py::array_t<Scalar> view_of(const Scalar* data, const Shape& shape, const py::object& owner) {
  return read_only(py::array_t<Scalar>(shape, data, owner));
}

/// Size n, finite.
Pressures pressures_from(const FloatArray& array, Eigen::Index n, const char* name);
/// m×3, finite.
Backbone backbone_from(const FloatArray& array, Eigen::Index m, const char* name);

/// What limber's functions borrow of an array: no copy.
inline Eigen::Map<const Pressures> pressures_map(const FloatArray& array) {
  return {array.data(), array.size()};
}
inline Eigen::Map<const Backbone> backbone_map(const FloatArray& array) {
  return {array.data(), array.size() / kPoseSize, kPoseSize};
}
inline Eigen::Map<const SpaceBackbone> space_backbone_map(const FloatArray& array) {
  return {array.data(), array.size() / kSpacePoseSize, kSpacePoseSize};
}
/// k rows of NumPy are k columns of limber's batches: the same numbers in the same order.
inline Eigen::Map<const Eigen::MatrixXf> batch_map(const FloatArray& array) {
  const py::ssize_t k = array.shape(0);
  return {array.data(), k == 0 ? 0 : array.size() / k, k};
}
inline Eigen::Map<Eigen::MatrixXf> batch_map(py::array_t<float>& array) {
  const py::ssize_t k = array.shape(0);
  return {array.mutable_data(), k == 0 ? 0 : array.size() / k, k};
}

/// Has NumPy make the array of anything that it understands.
template <class Array>
class ArrayCaster {
 public:
  using Value = Array;
  template <class>
  using cast_op_type = const Value&;

  operator const Value&() const { return value_; }  // NOLINT(google-explicit-constructor)

 protected:
  bool convert(pybind11::handle source, bool convert) {
    using Base = typename Value::Base;
    if (!convert && !Base::check_(source)) {
      return false;
    }
    const auto array = pybind11::array::ensure(source);
    if (!array || !has_numbers(array)) {
      return false;
    }
    value_ = Value(Base::ensure(array));
    return static_cast<bool>(value_);
  }

  Value value_;
};

}  // namespace limber::python

template <>
class pybind11::detail::type_caster<limber::python::FloatArray>
    : public limber::python::ArrayCaster<limber::python::FloatArray> {
 public:
  static constexpr auto name = const_name("numpy.ndarray[numpy.float32]");

  bool load(handle source, bool convert_too) {
    if (limber::python::is_float_array(source)) {
      value_ = Value(reinterpret_borrow<Value::Base>(source));
      return true;
    }
    return convert(source, convert_too);
  }
};

template <>
class pybind11::detail::type_caster<limber::python::DoubleArray>
    : public limber::python::ArrayCaster<limber::python::DoubleArray> {
 public:
  static constexpr auto name = const_name("numpy.ndarray[numpy.float64]");

  bool load(handle source, bool convert_too) { return convert(source, convert_too); }
};
