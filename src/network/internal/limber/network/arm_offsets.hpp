#pragma once

#include <Eigen/Core>

namespace limber {

// How e is told from how far plates are off their predictions (docs/families.md).

inline constexpr float kArmStep = 0.05F;            // of e, for derivatives of offsets
inline constexpr double kSquareUpToM = 0.003;       // offsets beyond count by their length
inline constexpr double kIndependentFrames = 20.0;  // that tell as much as one that stands alone

/// What one plate's offset in one frame counts, beside the prior's |e|² / 2.
/// @param usual_m  mean offset of the plates  @param plates  of a frame
inline double offset_share(double usual_m, Eigen::Index plates) {
  return 1.0 / (kIndependentFrames * usual_m * double(plates));
}

/// Least squares' weights of the numbers of offsets with these lengths: x, y, x, y, …; in space x,
/// y, z, …
inline Eigen::VectorXf offset_weights(const Eigen::ArrayXf& length_m, double share, int numbers) {
  Eigen::VectorXf weights(numbers * length_m.size());
  weights.reshaped(numbers, length_m.size()).rowwise() =
      (float(share) / length_m.max(float(kSquareUpToM))).matrix().transpose();
  return weights;
}

}  // namespace limber
