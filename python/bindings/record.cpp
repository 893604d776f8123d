#include "record.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/numpy.h>

#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"

namespace limber::python {

namespace {

constexpr std::size_t kLongestShown = 6;  // numbers or values of a list

std::string value_to_text(const py::object& value) {
  if (py::isinstance<py::array>(value)) {
    const auto array = py::reinterpret_borrow<py::array>(value);
    if (array.ndim() > 1 || std::size_t(array.size()) > kLongestShown) {
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

/// What a field takes, as its getter's signature ends: "Optional[int]".
std::string type_of(const py::object& object, const std::string& field) {
  const py::object getter = py::type::of(object).attr(field.c_str()).attr("fget");
  const std::string signature = py::str(getter.attr("__doc__"));
  const std::size_t at = signature.rfind("-> ") + 3;
  return signature.substr(at, signature.find('\n', at) - at);
}

}  // namespace

std::string record_to_text(const py::object& object, const std::vector<std::string>& names) {
  const auto fields = mapped<std::string>(names, [&](const std::string& name) {
    return fmt::format("{}={}", name, value_to_text(object.attr(name.c_str())));
  });
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
    try {
      object.attr(name.c_str()) = value;
    } catch (const py::error_already_set& error) {
      if (!error.matches(PyExc_TypeError)) {
        throw;
      }
      throw py::type_error(fmt::format("{}({}={}): expected {}", type_name(object), name,
                                       value_to_text(py::reinterpret_borrow<py::object>(value)),
                                       type_of(object, name)));
    }
  }
}

void require_value(py::handle enumeration, int value) {
  std::vector<std::string> allowed;
  for (const auto& [name, one] : py::dict(enumeration.attr("__members__"))) {
    const int number = one.attr("value").cast<int>();
    if (number == value) {
      return;
    }
    allowed.push_back(fmt::format("{} ({})", number, std::string(py::str(name))));
  }
  throw InputError(fmt::format("{}({}): expected {}",
                               std::string(py::str(enumeration.attr("__name__"))), value,
                               fmt::join(allowed, ", ")));
}

}  // namespace limber::python
