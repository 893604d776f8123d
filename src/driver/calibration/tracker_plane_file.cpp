#include "tracker_plane_file.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limber {

namespace {

constexpr double kMaxOrigin = 1e8;  // in the tracker's unit, which may be mm
constexpr double kRounding = 1e-6;  // of a length of 1, or a product of 0

template <class Vector>
std::string numbers(const Vector& vector) {
  return fmt::format("[{}]", fmt::join(vector.begin(), vector.end(), ", "));
}

/// `size` finite numbers.
Eigen::VectorXd read_vector(const YamlReader& node, const char* what, std::size_t size) {
  const std::vector<double> found = node.numbers(what);
  if (found.size() != size) {
    node.refuse(fmt::format("{} numbers; expected {}", found.size(), size));
  }
  return Eigen::Map<const Eigen::VectorXd>(found.data(), static_cast<Eigen::Index>(size));
}

Eigen::VectorXd read_unit_vector(const YamlReader& node, const char* what, std::size_t size) {
  const Eigen::VectorXd vector = read_vector(node, what, size);
  if (!(std::abs(vector.norm() - 1.0) <= kRounding)) {
    node.refuse(fmt::format("of length {:.7g}; expected 1", vector.norm()));
  }
  return vector.normalized();
}

}  // namespace

std::string to_yaml(const TrackerPlane& plane) {
  std::string text = fmt::format(
      "  plane:                  # in the frame and unit of a tracker that sees in 3D\n"
      "    origin: {}\n    x_axis: {}\n    y_axis: {}\n"
      "    out_of_plane_m: {}\n    tilt_rad: {}\n"
      "    body_rotations:       # [qx, qy, qz, qw] of each body at heading 0, in these axes\n",
      numbers(plane.origin), numbers(plane.x_axis), numbers(plane.y_axis), plane.out_of_plane_m,
      plane.tilt_rad);
  for (const Eigen::Quaterniond& rotation : plane.body_rotations) {
    text += "      - " + numbers(rotation.coeffs()) + "\n";
  }
  return text;
}

std::string in_words(const TrackerPlane& plane) {
  const Eigen::Vector3d normal = plane.normal();
  return fmt::format(
      "the tracker sees in 3D: the arm moves in a plane with normal ({:.4f}, {:.4f}, {:.4f}); "
      "bodies left it by at most {:.1f} mm and {:.4f} rad",
      normal.x(), normal.y(), normal.z(), 1e3 * plane.out_of_plane_m, plane.tilt_rad);
}

TrackerPlane read_plane(const YamlReader& node, std::size_t bodies) {
  node.refuse_unknown_keys(
      {"origin", "x_axis", "y_axis", "out_of_plane_m", "tilt_rad", "body_rotations"});
  TrackerPlane plane;
  plane.origin = read_vector(node.at("origin"), "x, y and z", 3);
  if (!(plane.origin.cwiseAbs().maxCoeff() <= kMaxOrigin)) {
    node.at("origin").refuse(fmt::format("expected numbers up to {:g}", kMaxOrigin));
  }
  plane.x_axis = read_unit_vector(node.at("x_axis"), "x, y and z", 3);
  plane.y_axis = read_unit_vector(node.at("y_axis"), "x, y and z", 3);
  if (!(std::abs(plane.x_axis.dot(plane.y_axis)) <= kRounding)) {
    node.at("y_axis").refuse("not perpendicular to x_axis");
  }
  plane.out_of_plane_m = node.at("out_of_plane_m").number("a length in metres", 0.0);
  plane.tilt_rad = node.at("tilt_rad").number("an angle in rad", 0.0);
  for (const YamlReader& rotation : node.at("body_rotations").elements()) {
    plane.body_rotations.emplace_back(
        Eigen::Vector4d(read_unit_vector(rotation, "qx, qy, qz and qw", 4)));
  }
  if (plane.body_rotations.size() != bodies) {
    node.at("body_rotations")
        .refuse(fmt::format("{} rotations; marker_offsets has {} bodies",
                            plane.body_rotations.size(), bodies));
  }
  return plane;
}

}  // namespace limber
