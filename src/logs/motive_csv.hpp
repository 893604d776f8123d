#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/common/filesystem.hpp"
#include "limber/logs/import_report.hpp"

namespace limber {

/// Something that Motive tracked: a rigid body, a bone, a marker. T rows.
struct MotiveObject {
  std::string type;            ///< as the file has it: "Rigid Body", "Marker", …
  std::string name;            ///< without quotes: "Plate01", "Plate01:Marker1"
  Eigen::MatrixXd position_m;  ///< T×3 in the file's axes, NaN if the cell is blank
  Eigen::MatrixXd rotation;    ///< T×4 unit quaternion x, y, z, w; 0×0 if the type has none
};

/// An OptiTrack Motive take, as its CSV export has it. The file's own axes (y up unless the export
/// says otherwise), metres.
struct MotiveTake {
  std::string rotation_type;  ///< "Quaternion" or the order of the Euler angles, "XYZ" …
  std::vector<double> time_s;
  std::vector<MotiveObject> objects;
};

/// Reads formats 1.2 to 1.25 (Motive 1.10 to 3.x). Heading rows are known by what they hold, not by
/// their number: extra ones (ID, Parent) and extra columns (time code, marker error, size, speed)
/// are passed over. Lengths in metres, centimetres or millimetres; rotations as quaternions or as
/// relative Euler angles of any order in degrees.
/// @throws InputError naming file and line: no header, format 1.1 and older, local coordinates,
/// duplicate names, rotations that are no unit quaternions.
MotiveTake read_motive_csv(const fs::path& path, RunReport& report);

}  // namespace limber
