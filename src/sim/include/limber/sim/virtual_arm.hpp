#pragma once
// For those who move an arm, real or virtual.

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/characterisation.hpp"
#include "limber/run/arm_driver.hpp"
#include "limber/run/collection.hpp"
#include "limber/run/executor.hpp"

namespace limber {

/// Faults of a real laboratory, all off by default; the same seed gives the same faults.
struct VirtualArmOptions {
  double noise_m = 0.0;      ///< standard deviation of every measured x, y and z, ≥ 0
  double noise_rad = 0.0;    ///< of every measured θ, in space about each axis, ≥ 0
  double noise_kpa = 0.0;    ///< of every measured pressure, ≥ 0
  double drop_rate = 0.0;    ///< probability that a frame has no backbone, in [0, 1]
  double latency_s = 0.0;    ///< what is measured was true this long ago, ≥ 0
  double lost_from_s = 0.0;  ///< what is true from then on has no backbone, ≥ 0
  double lost_for_s = 0.0;   ///< for so long, ≥ 0
  /// What it becomes in the middle of a run, as a load is picked up. Of it, `virtual_arm` counts,
  /// but for time step and dead time. None: it stays what it is.
  std::optional<ArmDescription> later = std::nullopt;
  double later_from_s = 0.0;  ///< ≥ 0
  std::uint64_t seed = 0;     ///< of noise and drops
  std::uint64_t stream = 0;   ///< unit of work (episode, trial), so that each has its own faults
};

/// A set point that has not reached the pressure controller yet.
struct PendingSetpoint {
  std::int64_t step = 0;  ///< the first simulator step that it acts in
  std::vector<double> setpoint_kpa;
};

/// Everything in a virtual arm that changes with time, exact to the bit: restoring it repeats the
/// same motion on any VirtualArm of the same arm and options. Copy it freely; only the simulator
/// should use its members.
struct VirtualArmState {
  std::int64_t step = 0;               ///< simulator steps since rest
  std::vector<double> position;        ///< MuJoCo's qpos: slide [m], hinge(s) [rad] of each gap
  std::vector<double> velocity;        ///< qvel
  std::vector<double> warm_start;      ///< qacc_warmstart
  std::vector<double> pressure_kpa;    ///< true, signed, one per channel
  std::vector<double> flow_kpa_per_s;  ///< what the valves let through
  std::vector<double> setpoint_kpa;    ///< set points that the pressure controller follows
  std::deque<PendingSetpoint> pending_setpoints;  ///< commanded, but still delayed (dead time)
  bool vented = false;  ///< `vent` was the last command, but for set points of zero
  std::vector<double>
      braid_anchor_m;           ///< spring-sliders of the braids, each side or chamber of each gap
  std::vector<double> creep_m;  ///< relaxed part of each side's stretch, left and right
  std::vector<double> table_anchor_m;    ///< spring-sliders of the plates, x and y of each
  std::vector<double> table_anchor_rad;  ///< their torsional ones
  std::vector<double> joint_anchor_rad;  ///< in space: of each gap's two bends and its twist
  std::uint64_t noise_position = 0;      ///< of the random stream
  std::deque<ArmState> delayed;          ///< frames measured but not yet delivered (latency)
  ArmState delivered;                    ///< what `state()` returns
};

/// Called after every simulator step with the time [s] and the true backbone (m×3).
using StepObserver = std::function<void(double time_s, const BackboneD& backbone)>;

/// A soft arm, simulated (docs/virtual-arm.md): one serial chain in MuJoCo, driven by actuators
/// with the hysteresis of their braids, and by valves with their pressure controller. In a plane it
/// lies on a table with friction, with a slide and a hinge per gap. In space it hangs or stands,
/// with a slide, two bending hinges and a twist per gap, and with friction in these.
///
/// Frame:   B, the arm's base; in a plane θ is the sum of the hinge angles, never wrapped.
/// Step:    the largest one that divides the frame period and does not exceed
///          `virtual_arm.time_step_s`.
/// Threads: one object, one thread; objects share nothing.
class VirtualArm final : public ArmDriver {
 public:
  /// At rest: straight, vented, at time 0.
  /// @throws InputError if an option or a parameter is out of its range.
  explicit VirtualArm(const ArmDescription& arm, const VirtualArmOptions& options = {});
  ~VirtualArm() override;
  VirtualArm(VirtualArm&&) noexcept;
  VirtualArm& operator=(VirtualArm&&) noexcept;

  const ArmState& state() const override;

  /// As ArmDriver::command. Set points that rounding put beyond a limit are clamped.
  /// @throws SystemFault if the simulation blows up, naming time and pressures.
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override;

  /// Opens every vent valve: all set points zero, no dead band, until the next `command` arrives.
  /// Acts at once: the controller has a dead time, the safety valve has none.
  void vent() noexcept override;

  /// Commands the same set points for at least `seconds`; returns the state at the end.
  /// @throws Interrupted if a signal comes.
  const ArmState& settle(const Eigen::Ref<const Pressures>& setpoint_kpa, double seconds);

  VirtualArmState save() const;
  /// @throws InputError if the state is another arm's (sizes differ).
  void restore(const VirtualArmState& state);

  /// Sets the function that is called after every simulator step (to watch for collisions). It is
  /// not part of the state; an empty function ends it.
  void set_observer(StepObserver observer);

  /// m×3, without noise, drops or latency. @throws InputError for an arm in space.
  BackboneD true_backbone() const;
  /// The same of an arm in space, m×7. @throws InputError for one in a plane.
  SpaceBackboneD true_plates() const;
  /// Signed, one per channel, without noise or latency.
  Eigen::VectorXd true_pressure_kpa() const;
  /// Change of a side's length over its unpressurised length, negative where it has contracted.
  /// @pre 0 ≤ segment < n.
  double left_strain(int segment) const;
  double right_strain(int segment) const;
  /// Of an arm in space: the same of a chamber, at its place. @pre 0 ≤ channel < n.
  double chamber_strain(int channel) const;
  /// Kinetic plus elastic energy [J], including that of the springs of friction and hysteresis, and
  /// that of height on a tilted table or in space (0 at the base). Only the work of pressurised
  /// actuators increases it.
  double energy_j() const;
  double time_step_s() const;

 private:
  class Simulation;
  std::unique_ptr<Simulation> simulation_;
};

/// As `execute` of any driver, but collisions, clearance, goal and prediction are judged on the
/// true backbone at every simulator step, whatever noise the arm adds to measured ones.
[[nodiscard]] ExecutionResult execute(const ArmDescription& arm, const Environment& environment,
                                      const Plan& plan, VirtualArm& driver,
                                      const ExecutionSettings& settings = {});

/// A fresh virtual arm per episode; `options.stream` is replaced by the episode's index, so that
/// each has noise and drops of its own.
DriverFactory virtual_arm_factory(const ArmDescription& arm, const VirtualArmOptions& options);

/// What decides a virtual arm's motion in addition to its set points, in one line: hash of its
/// parameters and the options that are on ("physics 1f2e3d4c, noise 0.001 m, drop rate 0.01").
std::string describe(const ArmDescription& arm, const VirtualArmOptions& options);

/// Settings for collection on the virtual arm, with source, driver and seed filled in.
CollectionSettings virtual_collection(const ArmDescription& arm, const ScheduleSettings& schedule,
                                      const VirtualArmOptions& options);

/// The characterisation experiment (docs/model.md (9)) on the virtual arm. Segment `segment` lies
/// alone on a frictionless table, without braid hysteresis, with every actuator of nominal
/// strength. One side is pressurised from 0 to the segment's limit in `steps` equal steps, each
/// held until the segment stands still. So the strain includes the segment's own elasticity.
/// @param steps  4, so that a quartic can be fitted, to 1000; `steps` + 1 points come back.
/// @throws InputError if `segment` or `steps` is out of range, SystemFault if the simulation
/// blows up or does not come to rest.
std::vector<BenchPoint> bench_test(const ArmDescription& arm, int segment, int steps = 20);

/// `bench_test` of every segment, base first.
std::vector<std::vector<BenchPoint>> bench_test_all(const ArmDescription& arm, int steps = 20);

/// The same of a chamber of an arm in space: its segment alone, without gravity, and the others of
/// its chambers vented. The strain is the chamber's own, (25): what its place is strained by over
/// its share in (26); it is negated where the chamber extends, as polynomials hold its size.
/// @throws InputError for an arm in a plane, or if `channel` or `steps` is out of range;
/// SystemFault as above.
std::vector<BenchPoint> bench_test_of_chamber(const ArmDescription& arm, int channel,
                                              int steps = 20);

}  // namespace limber
