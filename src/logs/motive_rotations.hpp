#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/common/csv_reader.hpp"

namespace limber {

/// `rotation`, T×4 quaternions x, y, z, w as `csv` has them, with their length made 1. Rows with
/// NaN stay.
/// @param time_s  T times, for the message.
/// @throws InputError naming file, object and time if a length is not 1 up to rounding.
Eigen::MatrixXd unit_quaternions(const CsvReader& csv, const std::string& object,
                                 const std::vector<double>& time_s, Eigen::MatrixXd rotation);

/// Whether `order` is one of XYZ … ZYX.
bool is_euler_order(const std::string& order);

/// Unit quaternion x, y, z, w of relative rotations by `angles_rad` (about x, y, z) in `order`,
/// such as "XYZ": first about x, then about the new y, then about the new z.
Eigen::Vector4d quaternion_of_euler(const Eigen::Vector3d& angles_rad, const std::string& order);

/// The same of T×3 angles in degrees, T×4.
Eigen::MatrixXd quaternions_of_euler(const Eigen::MatrixXd& angles_deg, const std::string& order);

}  // namespace limber
