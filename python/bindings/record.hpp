#pragma once

#include <string>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace limber::python {

namespace py = pybind11;

/// "PlannerLimits(time_s=1.0, iterations=None)", the fields read as Python sees them.
std::string record_to_text(const py::object& object, const std::vector<std::string>& names);

/// Sets the fields of `object` that `values` names. @throws TypeError naming the fields there are.
void set_fields(const py::object& object, const py::kwargs& values,
                const std::vector<std::string>& names);

/// A plain struct of limber's as a Python class: fields, keyword arguments and a repr.
template <class T>
class Record {
 public:
  /// @param extra  what else pybind11 is told of the class, such as py::dynamic_attr().
  template <class... Extra>
  Record(py::module_& module, const char* name, const char* doc, const Extra&... extra)
      : class_(module, name, doc, extra...) {}

  template <class Member>
  Record& field(const char* name, Member member, const char* doc) {
    class_.def_readwrite(name, member, doc);
    names_.emplace_back(name);
    return *this;
  }
  template <class Member>
  Record& read_only(const char* name, Member member, const char* doc) {
    class_.def_readonly(name, member, doc);
    names_.emplace_back(name);
    return *this;
  }
  /// Made from others: a function of the object.
  template <class Function>
  Record& property(const char* name, Function function, const char* doc) {
    class_.def_property_readonly(name, function, doc);
    names_.emplace_back(name);
    return *this;
  }

  /// A constructor that takes every field as a keyword argument, all with limber's defaults.
  Record& keywords() {
    const std::string doc = "Fields are keyword arguments, all optional. The defaults: " +
                            record_to_text(py::cast(T{}), names_) + ".";
    class_.def(py::init([names = names_](const py::kwargs& values) {
                 const py::object object = py::cast(T{});
                 set_fields(object, values, names);
                 return object.cast<T>();
               }),
               doc.c_str());
    class_.attr("_fields") = py::tuple(py::cast(names_));  // for pickles
    return *this;
  }

  /// The class, with its repr.
  py::class_<T>& done() {
    class_.def("__repr__",
               [names = names_](const py::object& self) { return record_to_text(self, names); });
    return class_;
  }

 private:
  py::class_<T> class_;
  std::vector<std::string> names_;
};

}  // namespace limber::python
