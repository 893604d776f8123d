#pragma once

#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/space_pose.hpp"
#include "space_tracks.hpp"

namespace limber {

/// Puts points that are missing for at most `longest_gap_s` between their neighbours in time,
/// rotations on the shortest way, and says in `track` which rows are tracked or bridged.
/// @throws InputError, its message beginning with `log`, where a point was never tracked or no row
/// is left
void fill_space_gaps(const std::string& log, double longest_gap_s, SpaceTracks& tracks,
                     BackboneTrack& track, RunReport& report);

/// Distances and directions from each point to the next, over the rows of a log.
class GapMeasurement {
 public:
  /// @param plates  of the points; `rest_m`: how far along the arm at rest each plate lies
  GapMeasurement(std::vector<int> plates, std::vector<double> rest_m);

  void add(const std::vector<SpacePose>& points);

  /// Requires distances and directions of the arm in the median row.
  /// @throws InputError, its message beginning with `log`
  void require_of(const std::string& log, const ImportMapping& mapping, const ArmDescription& arm,
                  const SpaceTracks& tracks) const;

  std::vector<SpaceGapReport> report() const;

 private:
  struct Gap {
    std::vector<double> chord_m;
    std::vector<double> length_m;     // along the arc
    std::vector<double> off_arc_rad;  // of the rotation there
    std::vector<double> off_x_rad;    // of the chord
  };

  double rest_m(std::size_t gap) const;

  std::vector<int> plates_;
  std::vector<double> rest_m_;
  std::vector<Gap> gaps_;
};

}  // namespace limber
