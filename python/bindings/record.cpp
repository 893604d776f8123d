#include "record.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/numpy.h>

namespace limber::python {

namespace {

constexpr std::size_t kLongestShown = 6;  // numbers or values of a list

std::string value_to_text(const py::object& value) {
  if (py::isinstance<py::array>(value)) {
    const auto array = py::reinterpret_borrow<py::array>(value);
    if (array.ndim() > 1 || static_cast<std::size_t>(array.size()) > kLongestShown) {
      return fmt::format("<{} {}>", std::string(py::str(array.dtype())),
                         std::string(py::str(array.attr("shape"))));
    }
    return py::repr(array.attr("tolist")());
  }
  if ((py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) &&
      py::len(value) > kLongestShown) {
    return fmt::format("<{} of them>", py::len(value));
  }
  return py::repr(value);
}

}  // namespace

std::string record_to_text(const py::object& object, const std::vector<std::string>& names) {
  std::vector<std::string> fields;
  fields.reserve(names.size());
  for (const std::string& name : names) {
    fields.push_back(fmt::format("{}={}", name, value_to_text(object.attr(name.c_str()))));
  }
  return fmt::format("{}({})", type_name(object), fmt::join(fields, ", "));
}

void set_fields(const py::object& object, const py::kwargs& values,
                const std::vector<std::string>& names) {
  for (const auto& [key, value] : values) {
    const std::string name = py::str(key);
    if (std::ranges::find(names, name) == names.end()) {
      throw py::type_error(fmt::format("{}() has no field '{}'; it has {}", type_name(object), name,
                                       fmt::join(names, ", ")));
    }
    object.attr(name.c_str()) = value;
  }
}

}  // namespace limber::python
