#pragma once

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"

namespace limber {

inline constexpr int kShapeRows = 3;  ///< of a segment: bend about y, bend about z, extension

/// Bend and length of one segment in space.
struct SpaceSegmentShape {
  Eigen::Vector3d rotation_rad;  ///< from its beginning to its end; nothing twists it
  double length_m = 0.0;
};

/// The unloaded arm in space: strains of all chambers, (25), a matrix from them to the bend and the
/// extension of every segment, (26), and elements of constant strain, (24), of docs/model.md.
///
/// Sizes:   n chambers in all, s segments, m plates. Threads: constant after construction.
class SpaceNoLoad {
 public:
  explicit SpaceNoLoad(const ArmDescription& arm);

  /// (25): of every chamber, at `commands` (n); with sign, positive where it extends. Above a limit
  /// it goes on along its end slope.
  Eigen::VectorXd strains(const Eigen::Ref<const Eigen::VectorXd>& commands) const;
  SpaceSegmentShape segment_shape(int segment, const Eigen::VectorXd& strains) const;
  /// 3s × n: of each segment its bend about y and z [rad] and its extension [share of its length].
  const Eigen::MatrixXd& shape_of_strains() const { return shape_; }

  /// m poses of segments of given bends and extensions (3s, as shape_of_strains makes them), each
  /// an element of constant strain: kSpacePoseSize numbers a plate.
  void poses_of_shapes(const Eigen::Ref<const Eigen::VectorXd>& shapes,
                       Eigen::Ref<Eigen::VectorXf> numbers) const;
  /// The same at commands.
  void poses(const Eigen::Ref<const Eigen::VectorXd>& commands,
             Eigen::Ref<Eigen::VectorXf> numbers) const;

 private:
  ArmDescription arm_;
  Eigen::MatrixXd shape_;
};

/// The way back: 3s bends [rad] and extensions of segments whose plates are at `poses` (7m), summed
/// over their gaps, each taken for an arc.
Eigen::VectorXd shapes_of_poses(const ArmDescription& arm,
                                const Eigen::Ref<const Eigen::VectorXd>& poses);

}  // namespace limber
