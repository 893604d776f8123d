#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/error.hpp"
#include "limber/run/arm_driver.hpp"

namespace limber {

inline constexpr double kInstant_s = 1e-4;  // lag of a fake arm that is where it is told to be

/// A two-segment arm, three backbone points a segment, 10 kPa a frame.
inline ArmDescription small_arm(int segments = 2) {
  ArmDescription arm;
  arm.name = "small";
  arm.frame_rate_hz = 20.0;
  arm.pressure_rate_limit_kpa_per_s = 200.0;
  arm.actuator_radius_m = 0.006;
  arm.segments.assign(static_cast<std::size_t>(segments),
                      Segment{0.2, 0.04, 2, 100.0, {1e-3, 0.0, 0.0, 0.0}});
  return arm;
}

/// What the fake arm does wrong.
struct FakeFaults {
  int drop_every = 0;              ///< frames without a backbone: every k-th, 0 for none
  std::optional<float> stuck_kpa;  ///< segment 0 never exceeds this
  double lost_from_s = 1e9;        ///< no backbone from then on
  double fails_at_s = 1e9;         ///< throws SystemFault
  double returns_nan_at_s = 1e9;
};

/// An arm without dynamics but those of its pressures: first order, `lag_s`; shape by the no-load
/// model.
class FakeArm final : public ArmDriver {
 public:
  FakeArm(const ArmDescription& arm, double lag_s, FakeFaults faults = {}, int* vents = nullptr)
      : model_(arm), period_s_(arm.frame_period_s()), faults_(faults), vents_(vents) {
    blend_ = static_cast<float>(1.0 - std::exp(-period_s_ / lag_s));
    state_.pressure_kpa = Pressures::Zero(arm.segment_count());
    look();
  }

  const ArmState& state() const override { return state_; }

  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override {
    state_.time_s = ++frame_ * period_s_;
    if (state_.time_s >= faults_.fails_at_s) {
      throw SystemFault(fmt::format("hose came off at {:.2f} s", state_.time_s));
    }
    state_.pressure_kpa += blend_ * (setpoint_kpa - state_.pressure_kpa);
    if (faults_.stuck_kpa) {
      state_.pressure_kpa[0] = std::min(state_.pressure_kpa[0], *faults_.stuck_kpa);
    }
    look();
    if (state_.time_s >= faults_.returns_nan_at_s) {
      state_.pressure_kpa[0] = std::nanf("");
    }
    return state_;
  }

  void vent() noexcept override {
    if (vents_ != nullptr) {
      ++*vents_;
    }
  }

 private:
  void look() {
    if (state_.time_s >= faults_.lost_from_s ||
        (faults_.drop_every > 0 && frame_ % faults_.drop_every == faults_.drop_every - 1)) {
      state_.backbone.reset();
      return;
    }
    Backbone backbone(model_.point_count(), 3);
    model_.backbone(Eigen::Ref<const Eigen::VectorXf>(state_.pressure_kpa),
                    Eigen::Ref<Backbone>(backbone));
    state_.backbone = backbone;
  }

  NoLoadModel model_;
  double period_s_;
  FakeFaults faults_;
  int* vents_;
  float blend_;
  int frame_ = 0;
  ArmState state_;
};

}  // namespace limber
