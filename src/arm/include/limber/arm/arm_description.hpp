#pragma once
// For everyone.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/pose_size.hpp"
#include "limber/arm/strain_polynomial.hpp"

namespace limber {

class YamlReader;

/// An arm of more segments is refused; sizes the stack storage of solvers.
inline constexpr int kMaxSegments = 64;
inline constexpr double kMaxMotionFrames = 1e6;  ///< from limit to limit: else no motion would end

/// What a segment is given, one signed number, and its unit. If the command is not a pressure,
/// names that end in `_kpa` hold numbers in the command's unit; messages and files name it.
struct Command {
  std::string name = "pressure";
  std::string unit = "kPa";
  bool is_pressure_kpa() const { return name == "pressure" && unit == "kPa"; }
};

/// What a segment may be given: from `lower_kpa` to `upper_kpa`. A vented segment is at 0, so that
/// 0 lies between them or is one of them.
struct PressureLimits {
  double lower_kpa = 0.0;  ///< ≤ 0
  double upper_kpa = 0.0;  ///< ≥ 0, > lower_kpa

  PressureLimits() = default;
  /// The same on both sides, ± `limit_kpa`.
  PressureLimits(double limit_kpa) : lower_kpa(-limit_kpa), upper_kpa(limit_kpa) {}
  PressureLimits(double lower, double upper) : lower_kpa(lower), upper_kpa(upper) {}

  bool is_symmetric() const { return lower_kpa == -upper_kpa; }
  /// The largest pressure of either side.
  double largest_kpa() const { return std::max(-lower_kpa, upper_kpa); }
  /// What distances between pressures are measured in; of symmetric limits the limit itself.
  double half_width_kpa() const { return 0.5 * (upper_kpa - lower_kpa); }
  /// The limit of one side: of positive pressures or, with `sign` < 0, of negative ones.
  double side_kpa(double sign) const { return sign < 0.0 ? lower_kpa : upper_kpa; }
  /// |kpa|, and by how much the limit of its side is smaller than the largest: more than
  /// `largest_kpa` beyond a limit, and |kpa| where limits are symmetric.
  double size_kpa(double kpa) const {
    return std::abs(kpa) + (largest_kpa() - std::abs(side_kpa(kpa)));
  }
  double clamped(double kpa) const { return std::clamp(kpa, lower_kpa, upper_kpa); }
  /// Set points are float32: a limit as one is inside, too. False for NaN.
  bool contains(double kpa) const;
  bool contains(const PressureLimits& other) const {
    return contains(other.lower_kpa) && contains(other.upper_kpa);
  }
  /// Wider at each end by `factor` − 1 of the largest pressure.
  PressureLimits widened(double factor) const;
  /// Both ends times `factor`.
  PressureLimits& operator*=(double factor);
  /// What both allow.
  PressureLimits within(const PressureLimits& other) const;
  bool operator==(const PressureLimits&) const = default;
};

/// "± 100", or "-11 to 13.8": for messages.
std::string to_string(const PressureLimits& limits);

/// What the no-load model takes a command for (docs/model.md, (3), (17) and (18)).
enum class NoLoadKind {
  strain_polynomial,  ///< the pressure of one side, which contracts by P(|p|)
  curvature,          ///< proportional to the segment's curvature; its length stays
  straight,           ///< nothing: the unloaded arm is straight, the network learns the rest
  chambers,           ///< in space: strains of chambers, by where they lie in the segment
  fitted,             ///< in space: a matrix from all strains to the segment's bend and extension
};

/// "strain_polynomial", "curvature", "straight", "chambers" or "fitted", as arm files have it.
const char* to_string(NoLoadKind kind);

/// What bends a segment in space: a chamber, a bellows, a muscle or a tendon, with a command of its
/// own. Angle and radius say where it lies in the segment's cross-section, seen from the tip.
struct Chamber {
  double angle_deg = 0.0;  ///< from y (left) toward z (up)
  double radius_m = 0.0;   ///< from the segment's axis; > 0 with NoLoadKind::chambers
  int sense = 1;           ///< 1 where it extends under positive commands, −1 where it contracts
  PressureLimits limit_kpa;              ///< in the command's unit
  StrainPolynomial strain_polynomial{};  ///< of its strain; all 0: the strain is the command itself
};

/// One bending segment: in the plane, two actuators on each side; in space, chambers.
struct Segment {
  double length_m = 0.0;                 ///< l0, unpressurised, > 0
  double width_m = 0.0;                  ///< t, between the two sides, > 0; in space its diameter
  int gaps = 0;                          ///< spaces between support plates, ≥ 1
  PressureLimits pressure_limit_kpa;     ///< ± p_max, or of each side its own
  StrainPolynomial strain_polynomial{};  ///< NoLoadKind::strain_polynomial only
  /// κ in 1/m over the command, positive to the left, ≠ 0; NoLoadKind::curvature only.
  double curvature_per_unit = 1.0;
  std::vector<Chamber> chambers{};  ///< of an arm in space, ≥ 1; else none
  /// 3 × all chambers of the arm: bend about y and about z [rad] and extension [share of length_m]
  /// over their strains. NoLoadKind::fitted only.
  Eigen::MatrixXd shape_of_strains{};
};

/// A command of the real arm, such as a motor's, where segments have none of their own
/// (limber/arm/arm_commands.hpp).
struct ArmCommand {
  std::string name;            ///< of its column in logs
  std::vector<double> shares;  ///< n: how much of it is in each segment's command, with sign
};

/// What an arm's file says under `virtual_arm`, not read yet: whoever simulates the arm does so
/// (limber/sim/virtual_arm_parameters.hpp).
struct VirtualArmSection {
  std::string yaml;          ///< `virtual_arm:` and its entries, on the lines of the file; or empty
  std::string file = "arm";  ///< stands for the file in messages
};

/// An arm as its file describes it (docs/formats.md, schema limber/arm/1). Plain values;
/// `validate`d by the reader.
struct ArmDescription {
  std::string name;
  Dimension dimension = Dimension::plane;
  Command command;
  NoLoadKind no_load = NoLoadKind::strain_polynomial;
  std::vector<Segment> segments;     ///< base first
  std::vector<ArmCommand> commands;  ///< M, where they are not one for each segment; else none
  double frame_rate_hz = 20.0;       ///< of recordings, models and plans
  double pressure_rate_limit_kpa_per_s =
      0.0;                         ///< what the valves can follow; bounds a plan's frames
  double actuator_radius_m = 0.0;  ///< collision radius of a gap is width/2 + this
  /// Where things fall in the frame of the base, of unit length; 0 where the file does not say.
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  VirtualArmSection virtual_arm;
  std::string safety_yaml;  ///< `safety:` and its entries, not read yet, for arms that are moved

  /// What bends: shapes, lengths and curvatures have one of each.
  int segment_count() const { return int(segments.size()); }
  bool is_spatial() const { return dimension == Dimension::space; }
  /// What is commanded: n of Pressures, of valves and of their limits. In the plane a segment has
  /// one, in space one for each of its chambers, base first.
  int channel_count() const;
  const PressureLimits& limits_of_channel(int channel) const;
  /// Chamber of that channel. @pre is_spatial()
  const Chamber& chamber(int channel) const;
  /// Backbone points m: every plate, base included.
  int point_count() const;
  double length_m() const;
  double frame_period_s() const { return 1.0 / frame_rate_hz; }
  /// The smallest number of frames that take at least so long.
  int frames_in(double seconds) const;
  /// Largest change of a set point within one frame.
  double pressure_step_limit_kpa() const { return pressure_rate_limit_kpa_per_s / frame_rate_hz; }
  /// That a command takes from one limit to the other, where these are farthest apart.
  double max_motion_frames() const;
  /// Segment that gap g (between plates g and g + 1) belongs to.
  int segment_of_gap(int gap) const;

  /// Hash of everything that the no-load model and planning depend on, virtual-arm parameters and
  /// name excluded.
  std::string hash() const;
};

/// @throws InputError "WHAT can't use an arm in space …" for one, and names what can.
void require_planar(const ArmDescription& arm, const std::string& what);

/// @throws InputError "WHAT needs an arm that is driven by pressures in kPa …" for any other.
void require_pressure_driven(const ArmDescription& arm, const std::string& what);

/// Whether an arm file must hold strain polynomials that a model can use. Characterisation, which
/// is about to fit them, and whoever moves an arm to record it for that do not need them: there the
/// key may be missing, empty or outdated, and the polynomial is then zero.
enum class PolynomialsOf { model, characterisation };

/// Reads and validates an arm file. @throws InputError naming file, line, field, what was found and
/// what is allowed.
ArmDescription load_arm(const std::filesystem::path& path,
                        PolynomialsOf polynomials = PolynomialsOf::model);
ArmDescription read_arm(const YamlReader& root, PolynomialsOf polynomials = PolynomialsOf::model);

/// The arm as YAML, readable by `load_arm`; floating-point values survive the round trip exactly.
std::string arm_to_yaml(const ArmDescription& arm);

/// The same without schema, `virtual_arm` and `safety`: the keys that `hash` covers, and the name.
/// Other files hold it as text.
std::string arm_keys_to_yaml(const ArmDescription& arm);

/// The inverse. @param name  stands for the file in messages. @throws InputError as `read_arm`.
/// @param polynomials  of recordings: arms are also recorded before they are characterised
ArmDescription read_arm_keys(const std::string& keys, const std::string& name,
                             PolynomialsOf polynomials = PolynomialsOf::model);

/// Distance along the arm at rest from the base to each plate, m numbers.
std::vector<double> rest_positions_m(const ArmDescription& arm);

}  // namespace limber
