#pragma once
// For those who train and evaluate models.

#include <filesystem>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"

namespace limber {

/// Gauges read a little below zero at rest: bench pressures down to this part of −p_max count as 0.
inline constexpr double kBenchNoiseAroundZero = 0.01;

/// One settled reading of a bench test: a segment free of load and friction, one side inflated.
///
/// The strain is that of the side as mounted in its segment, change of length over l0, so it
/// includes the segment's own elasticity. A bare actuator on the bench contracts about a third
/// more; the error of a model fitted to that is half as large again.
struct BenchPoint {
  double pressure_kpa = 0.0;  ///< gauge, of the inflated side, ≥ 0
  double strain = 0.0;        ///< ε, negative where the side contracts
};

/// Bench points of every segment, base first.
using BenchData = std::vector<std::vector<BenchPoint>>;

/// A strain polynomial and how well it fits. Residuals are of strain, as fractions of full strain.
struct StrainFit {
  StrainPolynomial polynomial{};  ///< rounded to 7 significant digits: the same on every machine
  double pressure_limit_kpa = 0.0;
  double full_strain = 0.0;  ///< P(p_max)
  double rms_residual = 0.0;
  double max_residual = 0.0;
  int points = 0;                     ///< used; see `warnings` for points left out
  bool refitted = false;              ///< the plain fit fell somewhere: slope held ≥ 0 instead
  bool kept = false;                  ///< `characterise` only: the arm file said the same already
  std::vector<std::string> warnings;  ///< sentences for the user
};

/// Least-squares fit of (9) over [0, p_max].
///
/// If the plain fit is not monotone, the result is the least-squares fit among all quartics without
/// constant term whose slope is ≥ 0 on [0, p_max] (docs/model.md (10)); exact, not a restriction.
/// Pressures down to −1 % of the limit count as 0; those above 1.05 p_max are left out.
/// @throws InputError if a value is not finite, a pressure is negative, fewer than 5 pressures
/// are distinct, they do not cover the range up to p_max, the strain extends instead of contracting
/// or exceeds 1, or the monotone fit leaves a residual above 10 % of full strain.
StrainFit fit_strain_polynomial(const std::vector<BenchPoint>& points, double pressure_limit_kpa);

/// An arm with fitted polynomials, and the fit of every segment.
struct CharacterisedArm {
  ArmDescription arm;
  std::vector<StrainFit> fits;
};

/// @throws InputError if there is nothing to fit: another command than pressures in kPa, or
/// another no-load model. To be asked before the bench test.
void require_characterisable(const ArmDescription& arm);

/// Fits every segment. If the arm's own polynomial agrees with the fit within kSameStrain, it
/// stays: characterising the same arm again, or on another machine, does not make it another arm.
/// @throws InputError as above, with the segment's number before the message.
CharacterisedArm characterise(const ArmDescription& arm, const BenchData& bench);

/// `yaml`, the text of the arm's file, with what a fit changes: no_load, and each segment's
/// length_m, strain_polynomial, curvature_per_unit and shape_of_strains. Everything else, comments
/// too, stays as it is. If the text cannot be edited in place, or differs from `arm` in anything
/// else, the result is `arm_to_yaml`. @throws InputError if it is not an arm file.
std::string with_strain_polynomials(const std::string& yaml, const ArmDescription& arm);

/// Bench data from a CSV file: a header line naming the columns `pressure_kpa` and `strain`, and
/// optionally `segment` (0 is the base), in any order; without it every row is used for every
/// segment. Blank lines and lines that begin with # are skipped.
/// @throws InputError "file:line:column: …".
BenchData read_bench_csv(const std::filesystem::path& path, const ArmDescription& arm);

}  // namespace limber
