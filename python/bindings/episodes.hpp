#pragma once

#include <vector>

#include <pybind11/pybind11.h>

#include "limber/common/error.hpp"
#include "limber/data/recording.hpp"

namespace limber::python {

/// Copies of the episodes of a Python list.
std::vector<Episode> episodes_from(const pybind11::iterable& episodes);
/// The way back: each moves to an object of its own.
pybind11::list episodes_to(std::vector<Episode> episodes);

}  // namespace limber::python
