#pragma once

#include <vector>

#include <pybind11/pybind11.h>

#include "limber/common/error.hpp"
#include "limber/data/recording.hpp"

namespace limber::python {

/// What a caller gives for a list: anything, so that what reads it can say what is wrong with it.
template <class Item>
class ListOf : public pybind11::object {
 public:
  PYBIND11_OBJECT_DEFAULT(ListOf, object, is_object)

 private:
  static bool is_object(PyObject* object) { return object != nullptr; }
};
using EpisodeList = ListOf<Episode>;

/// Copies of the episodes of a Python list. @throws TypeError naming what was found instead.
std::vector<Episode> episodes_from(const EpisodeList& episodes);
/// The way back: each moves to an object of its own.
pybind11::list episodes_to(std::vector<Episode> episodes);

}  // namespace limber::python

template <>
struct pybind11::detail::handle_type_name<limber::python::EpisodeList> {
  static constexpr auto name = const_name("Iterable");
};
