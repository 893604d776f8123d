#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_rows.hpp"
#include "motive_csv.hpp"
#include "space_tracks.hpp"

namespace limber {

/// `rotation`, T×4 quaternions x, y, z, w as `file` has them, with their length made 1. Rows with
/// NaN stay.
/// @param time_s  T times, for the message.
/// @throws InputError naming file, object and time if a length is not 1 up to rounding.
Eigen::MatrixXd unit_quaternions(const std::string& file, const std::string& object,
                                 const std::vector<double>& time_s, Eigen::MatrixXd rotation);

/// Whether `order` is one of XYZ … ZYX.
bool is_euler_order(const std::string& order);

/// Unit quaternion x, y, z, w of relative rotations by `angles_rad` (about x, y, z) in `order`,
/// such as "XYZ": first about x, then about the new y, then about the new z.
Eigen::Vector4d quaternion_of_euler(const Eigen::Vector3d& angles_rad, const std::string& order);

/// The same of T×3 angles in degrees, T×4.
Eigen::MatrixXd quaternions_of_euler(const Eigen::MatrixXd& angles_deg, const std::string& order);

/// Finds the bodies and markers of a take by name. What it borrows has to outlive it.
class PlateFinder {
 public:
  /// @param log  begins messages
  PlateFinder(const std::string& log, const MotiveTake& take, RunReport& report)
      : log_(log), take_(take), report_(report) {}

  /// All rigid bodies or, without any, all markers, in the order of their names.
  /// @throws InputError where they are not as many as the arm has plates
  std::vector<PointSource> default_points(const ArmDescription& arm) const;

  /// Those of the mapping, or the default ones where it names none.
  std::vector<PointSource> points(const ImportMapping& mapping, const ArmDescription& arm) const {
    return mapping.points.empty() ? default_points(arm) : mapping.points;
  }

  /// @throws InputError naming those that are there
  const MotiveObject& body(const std::string& name) const;
  /// A measured one before a solved one. @throws InputError as `body`
  const MotiveObject& marker(const std::string& name) const;

 private:
  template <class Kind>
  const MotiveObject* find(const std::string& name, Kind is_kind) const;
  template <class Kind>
  [[noreturn]] void refuse_missing(const char* what, const std::string& name, Kind is_kind) const;

  const std::string& log_;
  const MotiveTake& take_;
  RunReport& report_;
};

/// The plates of an arm among what Motive tracked, in the plane that `mapping.up` leaves: by the
/// mapping's points, or, without any, all rigid bodies (markers, if there are none) in the order
/// of their names, if there are as many as plates.
/// @throws InputError, its message beginning with `log`, where an object is missing (with what is
/// there), or where the motion leaves that plane.
PointTracks motive_points(const std::string& log, const MotiveTake& take,
                          const ImportMapping& mapping, const ArmDescription& arm,
                          RunReport& report);

/// Bodies and markers of a take in the file's own axes, nothing projected.
/// @throws InputError naming what is missing, and what is there
SpaceTracks space_motive_tracks(const std::string& log, const MotiveTake& take,
                                const ImportMapping& mapping, const ArmDescription& arm,
                                RunReport& report);

}  // namespace limber
