#include "limber/lab/witness.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limber/forward/motion_simulator.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/hold.hpp"
#include "limber/world/pressure_box.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

constexpr double kShapePeriodS = 0.01;  // an arm that speeds up by 5 m/s² leaves a chord by 0.06 mm
constexpr float kSettledShare = 0.01F;  // of the limit: pressures this near have arrived

/// A virtual arm whose shapes are kept.
class RecordedArm {
 public:
  explicit RecordedArm(const ArmDescription& arm) : arm_(arm), driver_(arm) {
    const auto every = std::max(1L, std::lround(kShapePeriodS / driver_.time_step_s()));
    shapes_.push_back(driver_.true_backbone().cast<float>());
    driver_.set_observer([this, every, step = 0L](double, const BackboneD& shape) mutable {
      if (++step % every == 0) {
        shapes_.push_back(shape.cast<float>());
      }
    });
  }

  std::vector<Backbone> run(const std::vector<Pressures>& waypoints_kpa) {
    Pressures at_kpa = start_state(Environment{}, arm_).pressures_kpa;
    Pressures sent_kpa = at_kpa;
    for (const Pressures& to_kpa : waypoints_kpa) {
      const int count = motion_frame_count(at_kpa, to_kpa, arm_.pressure_step_limit_kpa());
      for (int k = 1; k <= count; ++k) {
        motion_setpoint(at_kpa, to_kpa, k, count, sent_kpa);
        (void)driver_.command(sent_kpa);
      }
      at_kpa = to_kpa;
    }
    hold(at_kpa);
    shapes_.push_back(driver_.true_backbone().cast<float>());
    return std::move(shapes_);
  }

 private:
  void hold(const Pressures& kpa) {
    const int least = arm_.frames_in(kHoldS);
    for (int k = 0; k < least || (k < arm_.frames_in(kLongestHoldS) && !is_settled(kpa)); ++k) {
      (void)driver_.command(kpa);
    }
  }

  bool is_settled(const Pressures& kpa) const {
    const Pressures off_kpa = (driver_.true_pressure_kpa().cast<float>() - kpa).cwiseAbs();
    const auto band_kpa = static_cast<float>(virtual_arm_parameters(arm_).pressure_dead_band_kpa);
    const Pressures near_kpa = kSettledShare * pressure_limits_kpa(arm_);
    return (off_kpa.array() <= near_kpa.array().max(band_kpa)).all();
  }

  const ArmDescription& arm_;
  VirtualArm driver_;
  std::vector<Backbone> shapes_;
};

}  // namespace

Witness virtual_witness(const ArmDescription& arm) {
  return [&arm](const std::vector<Pressures>& waypoints_kpa) {
    return RecordedArm(arm).run(waypoints_kpa);
  };
}

Witness model_witness(const ArmDescription& arm, const MotionModel& model) {
  return [&arm, model](const std::vector<Pressures>& waypoints_kpa) {
    const CollisionChecker nothing(arm, {});
    MotionSimulator simulator(arm, model, nothing);
    const ArmStart rest = start_state(Environment{}, arm);
    std::vector<PlanFrame> frames{{rest.pressures_kpa, rest.pressures_kpa, rest.backbone}};
    for (const Pressures& to_kpa : waypoints_kpa) {
      simulator.append_motion(to_kpa, frames);
    }
    simulator.append_hold(frames);
    std::vector<Backbone> shapes;
    shapes.reserve(frames.size());
    for (PlanFrame& frame : frames) {
      shapes.push_back(std::move(frame.backbone));
    }
    return shapes;
  };
}

}  // namespace limber
