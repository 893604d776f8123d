#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace limber::python {

namespace py = pybind11;
using namespace py::literals;

/// Of an object's class, for messages: "list".
inline std::string type_name(py::handle of) {
  return py::str(py::type::of(of).attr("__name__"));
}

/// "PlannerLimits(time_s=1.0, iterations=None)", the fields read as Python sees them.
std::string record_to_text(const py::object& object, const std::vector<std::string>& names);

/// Sets the fields of `object` that `values` names. @throws TypeError naming the fields there are,
/// or the field whose value is of another type.
void set_fields(const py::object& object, const py::kwargs& values,
                const std::vector<std::string>& names);

/// A copy that Python can't change: see Record::fixed.
template <class T>
struct Fixed : T {};

/// Whatever it is, signatures call it T.
template <class T>
class SeenAs : public py::object {
 public:
  SeenAs(py::object seen) : py::object(std::move(seen)) {}  // NOLINT(google-explicit-constructor)
};

template <class T>
SeenAs<T> fixed_copy(const T& value) {
  return py::cast(Fixed<T>{value});
}

template <class T>
std::optional<SeenAs<T>> fixed_copy(const std::optional<T>& value) {
  return value ? std::optional(fixed_copy(*value)) : std::nullopt;
}

template <class T>
SeenAs<std::vector<T>> fixed_copies(const std::vector<T>& values) {
  py::list list;
  for (const T& value : values) {
    list.append(fixed_copy(value));
  }
  return list;
}

/// @throws InputError unless one of the enumeration's values is that number.
void require_value(py::handle enumeration, int value);

/// An enumeration of limber's. pybind11's own would take any integer.
template <class T>
class Choice : public py::enum_<T> {
 public:
  Choice(py::module_& module, const char* name, const char* doc) : py::enum_<T>(module, name, doc) {
    py::delattr(*this, "__init__");
    this->def(py::init([](int value) {
                require_value(py::type::of<T>(), value);
                return static_cast<T>(value);
              }),
              "value"_a);
  }
};

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
  /// A vector of records: given as copies that can't be changed, as a reference to one of them
  /// would outlive it where another list is assigned.
  template <class Member>
  Record& list(const char* name, Member member, const char* doc) {
    class_.def_property(
        name, [member](const T& one) { return fixed_copies(one.*member); },
        [member](T& one, const std::decay_t<decltype(std::declval<T&>().*member)>& values) {
          one.*member = values;
        },
        doc);
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

  /// Also as part of something that does not change: what that gives is a copy, whose fields can't
  /// be set, as the whole would not notice. copy.copy gives one whose fields can.
  /// @param nested  makes the same of fields that have fields.
  template <class Nested = void (*)(py::class_<Fixed<T>, T>&)>
  Record& fixed(const Nested& nested = [](py::class_<Fixed<T>, T>&) {}) {
    const py::str name = class_.attr("__name__");
    py::class_<Fixed<T>, T> fixed(class_, "_Fixed");
    fixed.def("__setattr__", [name](const py::object&, const py::str& field, const py::object&) {
      throw py::attribute_error(fmt::format(
          "{0}.{1}: this {0} is part of something that does not change; make that from a copy of "
          "it (copy.copy)",
          std::string(name), std::string(field)));
    });
    fixed.attr("__name__") = name;
    fixed.attr("__doc__") = class_.attr("__doc__");
    nested(fixed);
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

template <class T>
struct pybind11::detail::handle_type_name<limber::python::SeenAs<T>> {
  static constexpr auto name = make_caster<T>::name;
};
