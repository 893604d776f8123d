#pragma once
// For those who ask a model where the arm goes.

#include <memory>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"

namespace limber {

class SpaceNoLoad;

/// Curvature and length of one segment; positive curvature bends left.
struct SegmentShape {
  double curvature_per_m = 0.0;
  double length_m = 0.0;
};

/// A pressure that bends a segment to a wanted curvature.
struct SegmentPressure {
  double pressure_kpa = 0.0;  ///< within the segment's limits
  bool reachable =
      false;  ///< false if more than the limit would be needed; the pressure is then the limit
};

/// Shape of the unloaded, frictionless arm at given pressures: docs/model.md, (3), (4), (11) and
/// (12); of an arm in space, (24) to (26), and then `poses` alone.
///
/// Sizes:   n channels (in the plane: segments), m backbone points (plates, base included).
/// Frame:   B, the arm's base: x along the straight arm, y left, θ counter-clockwise and unwrapped.
/// Threads: constant after construction; share it freely.
class NoLoadModel {
 public:
  /// @throws InputError if a strain polynomial is not monotone over the pressure range, or reaches
  /// e ≥ 1.
  explicit NoLoadModel(const ArmDescription& arm);

  const std::string& arm_name() const { return arm_name_; }
  int segment_count() const { return int(segments_.size()); }
  int channel_count() const { return channel_count_; }  ///< as in ArmDescription
  Dimension dimension() const { return dimension_; }
  int point_count() const { return point_count_; }
  NoLoadKind kind() const { return kind_; }
  const Command& command() const { return command_; }

  /// Backbone B̃ at `pressures_kpa` (size n) of either kind of arm, written to `numbers`: m poses
  /// of pose_size(dimension()) numbers.
  void poses(const Eigen::Ref<const Eigen::VectorXf>& pressures_kpa,
             Eigen::Ref<Eigen::VectorXf> numbers) const;
  /// The model of an arm in space; else null.
  const SpaceNoLoad* in_space() const { return in_space_.get(); }

  // What follows is of planar arms.

  /// Backbone B̃ at `pressures_kpa` (size n), written to `backbone` (m×3). Above a pressure's limit
  /// the strain continues along the end slope of the polynomial, so that a measured overshoot is
  /// continuous.
  void backbone(const Eigen::Ref<const Eigen::VectorXf>& pressures_kpa,
                Eigen::Ref<Backbone> backbone) const;
  void backbone(const Eigen::Ref<const Eigen::VectorXd>& pressures_kpa,
                Eigen::Ref<BackboneD> backbone) const;

  /// (3), (4) of one segment, or (17) or (18). @pre 0 ≤ segment < n.
  SegmentShape segment_shape(int segment, double pressure_kpa) const;
  /// Contraction strain e = P(|p|) ≥ 0. @pre kind() is strain_polynomial.
  double strain(int segment, double pressure_kpa) const;
  /// Inverse of (3), (11): e = 2t|κ|/(2 + t|κ|), p = −sign(κ) P⁻¹(e); or of (17). With (18), where
  /// nothing bends the unloaded arm, 0.
  SegmentPressure pressure_for_curvature(int segment, double curvature_per_m) const;
  /// Length that goes with a curvature, l = 2 l0/(2 + t|κ|), (3) in (4); l0 by (17) and (18).
  double length_for_curvature(int segment, double curvature_per_m) const;
  /// Largest |κ| the pressure limits allow to either side.
  double curvature_limit_per_m(int segment) const;

  const Segment& segment(int i) const { return segments_[i]; }

 private:
  template <class Scalar>
  void chain(const Eigen::Ref<const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>>& pressures_kpa,
             Eigen::Ref<BackboneOf<Scalar>>& backbone) const;

  std::string arm_name_;
  std::vector<Segment> segments_;
  NoLoadKind kind_;
  Command command_;
  Dimension dimension_;
  int channel_count_ = 0;
  int point_count_ = 0;
  std::shared_ptr<const SpaceNoLoad> in_space_;
};

}  // namespace limber
