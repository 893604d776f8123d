#pragma once

#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_rows.hpp"
#include "motive_csv.hpp"

namespace limber {

/// Finds the bodies and markers of a take by name. What it borrows has to outlive it.
class PlateFinder {
 public:
  /// @param log  begins messages
  PlateFinder(const std::string& log, const MotiveTake& take, RunReport& report)
      : log_(log), take_(take), report_(report) {}

  /// All rigid bodies or, without any, all markers, in the order of their names.
  /// @throws InputError where they are not as many as the arm has plates
  std::vector<PointSource> default_points(const ArmDescription& arm) const;

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

}  // namespace limber
