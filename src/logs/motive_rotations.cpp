#include "motive_rotations.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

namespace limber {

namespace {

constexpr double kUnitMiss = 0.02;  // quaternions are written with six digits

}  // namespace

Eigen::MatrixXd unit_quaternions(const CsvReader& csv, const std::string& object,
                                 const std::vector<double>& time_s, Eigen::MatrixXd rotation) {
  for (Eigen::Index t = 0; t < rotation.rows(); ++t) {
    const double length = rotation.row(t).norm();
    if (std::isfinite(length) && std::abs(length - 1.0) > kUnitMiss) {
      csv.refuse(1,
                 fmt::format("the rotation of '{}' at {} s is ({}, {}, {}, {}), of length {:.4g}; "
                             "expected a unit quaternion X, Y, Z, W",
                             object, time_s[std::size_t(t)], rotation(t, 0), rotation(t, 1),
                             rotation(t, 2), rotation(t, 3), length));
    }
    rotation.row(t) /= length;
  }
  return rotation;
}

bool is_euler_order(const std::string& order) {
  std::string axes = order;
  std::sort(axes.begin(), axes.end());
  return axes == "XYZ";
}

Eigen::Vector4d quaternion_of_euler(const Eigen::Vector3d& angles_rad, const std::string& order) {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  for (const char axis : order) {
    const int i = axis - 'X';
    rotation = rotation * Eigen::AngleAxisd(angles_rad[i], Eigen::Vector3d::Unit(i));
  }
  return rotation.coeffs();  // x, y, z, w
}

Eigen::MatrixXd quaternions_of_euler(const Eigen::MatrixXd& angles_deg, const std::string& order) {
  Eigen::MatrixXd rotation(angles_deg.rows(), 4);
  for (Eigen::Index t = 0; t < angles_deg.rows(); ++t) {
    rotation.row(t) = quaternion_of_euler(angles_deg.row(t).transpose() * (M_PI / 180.0), order);
  }
  return rotation;
}

}  // namespace limber
