#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "limber/arm/space_pose.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "space_tracks.hpp"

namespace limber {

/// Frame B of an arm in space in the log's frame, and what bodies' axes have to do with it.
struct SpaceFrame {
  SpacePose X_LB;
  std::vector<Eigen::Quaterniond> body_to_plate;  ///< k; a plate's axes in its body's
};

/// Finds frame B by `alignment`, fills in the report's axes, and moves all tracks into it.
/// A base that scatters by less than 5 mm is put at its median pose in every row: what it hides is
/// no loss.
/// @throws InputError, its message beginning with `log`, where the tip was never seen at rest, or
/// axes lie along each other.
void align_in_space(const std::string& log, const SpaceAlignment& alignment, SpaceTracks& tracks,
                    RunReport& report);

/// The mean of rotations near the one from which most are least far: those that are far off, the
/// fewer ones, do not count. @pre at least one
Eigen::Quaterniond mean_rotation(const std::vector<Eigen::Quaterniond>& rotations);

}  // namespace limber
