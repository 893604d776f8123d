#pragma once

#include <cstddef>
#include <string>

#include "limber/common/yaml_reader.hpp"
#include "limber/driver/tracker_plane.hpp"

namespace limber {

/// The mapping `plane` of a calibration file's tracker (docs/formats.md), and what of it people
/// want to know.
std::string to_yaml(const TrackerPlane& plane);
std::string in_words(const TrackerPlane& plane);

/// @throws InputError naming line and field where axes are not orthonormal, or there are not as
/// many rotations as `bodies`.
TrackerPlane read_plane(const YamlReader& node, std::size_t bodies);

}  // namespace limber
