#pragma once
// For those who plan.

#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "limber/arm/backbone.hpp"
#include "limber/common/aligned_floats.hpp"
#include "limber/common/cpu_level.hpp"
#include "limber/network/gemm_kernels.hpp"

namespace limber {

struct Command;

/// What the recordings held that a model was trained on (docs/training.md). Plain values.
///
/// The joint vector z of a frame is its pressures (n), then each plate's pose about the plate
/// before it (3(m − 1)). It is standardised, x = (z − joint_offset)·joint_scale, and projected on k
/// principal axes: a = axes · x.
struct LearntRegion {
  Pressures low_kpa;   ///< n, lowest measured pressure or set point
  Pressures high_kpa;  ///< n, the highest
  /// n, ≥ 0: of measured pressures, held for half a second and for a second. Set points jump: their
  /// rates say nothing.
  Pressures steepest_fall_kpa_per_s;
  Pressures steepest_rise_kpa_per_s;
  Eigen::VectorXf joint_offset;  ///< n + 3(m − 1)
  Eigen::VectorXf joint_scale;   ///< the same, not 0
  Eigen::MatrixXf axes;          ///< k × (n + 3(m − 1)), orthonormal rows
  Eigen::VectorXf axis_low;      ///< k, recorded range of a, a little widened
  Eigen::VectorXf axis_high;     ///< k, > axis_low
  /// n + 3(m − 1), > 0: the largest |z_t − z_{t−1}| of neighbouring frames, a little widened. The
  /// last 3(m − 1) bound the velocity that networks read. Empty: of a model from before there was
  /// one, to which no speed is novel.
  Eigen::VectorXf joint_change;

  int segment_count() const { return int(low_kpa.size()); }
  /// Whether these pressures lie within those that were recorded.
  bool holds(const Eigen::Ref<const Pressures>& kpa) const {
    return (kpa.array() >= low_kpa.array()).all() && (kpa.array() <= high_kpa.array()).all();
  }
  int point_count() const { return int(axes.cols() - low_kpa.size()) / kPoseSize + 1; }

  /// How far (pressures, backbone) lies from the middle of what was recorded: 1 on the border,
  /// less inside, growing linearly outside. It is the largest of |a − middle| / half range over the
  /// axes, and of the same over the pressures. In double precision; NoveltyMeasure is the fast one.
  /// @param pressures_kpa  n
  /// @param backbone       m×3
  double novelty(const Eigen::Ref<const Pressures>& pressures_kpa,
                 const Eigen::Ref<const Backbone>& backbone) const;
  /// The same of a frame that follows another: also the largest of |z_t − z_{t−1}| / joint_change.
  double novelty(const Eigen::Ref<const Pressures>& pressures_kpa,
                 const Eigen::Ref<const Backbone>& backbone,
                 const Eigen::Ref<const Pressures>& before_kpa,
                 const Eigen::Ref<const Backbone>& backbone_before) const;
};

/// Measured pressures count as beyond the recorded range only if they exceed it by more than this
/// share of its half: this allows for noise, and for the rounding of a set point on the border.
inline constexpr double kPressureSlack = 0.01;

/// `LearntRegion::novelty` for inner loops: one matrix-vector product in float, no allocation.
///
/// Threads: constant after construction; share it freely, with a workspace per thread.
class NoveltyMeasure {
 public:
  /// @pre the region is valid and this CPU runs `level`.
  explicit NoveltyMeasure(const LearntRegion& region, CpuLevel level = cpu_level());

  struct Workspace {
    AlignedFloats numbers;
  };
  Workspace make_workspace() const;

  int segment_count() const { return segment_count_; }
  int point_count() const { return point_count_; }

  /// Novelty of pressures (n) and backbone (3m numbers, (x_m, y_m, theta_rad) plate by plate, as
  /// Backbone::data() has them), without those a frame before or with them.
  /// @pre all finite, headings within ±100 rad
  float novelty(const float* pressures_kpa, const float* backbone, Workspace& workspace) const;
  float novelty(const float* pressures_kpa, const float* backbone, const float* before_kpa,
                const float* backbone_before, Workspace& workspace) const;

 private:
  const GemmKernels* kernels_;
  int segment_count_;
  int point_count_;
  int joint_size_;
  int padded_rows_;
  int padded_gaps_;
  AlignedFloats weight_;  // padded_rows × joint_size, column-major: distances in half ranges
  AlignedFloats bias_;    // padded_rows
  Eigen::VectorXf joint_change_;
};

/// @throws InputError beginning with `where` and naming the tensor, unless sizes fit n segments and
/// m points, every number is finite and every range is one.
void validate(const LearntRegion& region, int segment_count, int point_count,
              const std::string& where);

/// The object `learnt` of `train` and `inspect` with --json: ranges per segment.
nlohmann::ordered_json to_json(const LearntRegion& region, const Command& command);
/// One line for each segment: "segment 0: pressures −98.2 … 97.5 kPa, rates −120 … 115 kPa/s".
std::vector<std::string> learnt_region_lines(const LearntRegion& region, const Command& command);

}  // namespace limber
