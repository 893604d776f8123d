#include "limber/hardware/driver_run.hpp"

#include <memory>

#include <fmt/format.h>

#include "limber/hardware/run_origin.hpp"

namespace limber {

namespace {

constexpr double kSetpointRounding = 1e-3;  // of float32 set points

/// A driver that somebody else owns, for those who take one of their own.
class BorrowedDriver final : public ArmDriver {
 public:
  explicit BorrowedDriver(ArmDriver& driver) : driver_(driver) {}

  const ArmState& state() const override { return driver_.state(); }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override {
    return driver_.command(setpoint_kpa);
  }
  bool is_real_time() const override { return driver_.is_real_time(); }
  void vent() noexcept override { driver_.vent(); }

 private:
  ArmDriver& driver_;
};

}  // namespace

std::string describe(const ProcessDriver& driver) {
  const DriverHello& hello = driver.hello();
  const auto or_unnamed = [](const std::string& text) { return text.empty() ? "unnamed" : text; };
  return fmt::format("driver {} (device: {}), started by {}", or_unnamed(hello.driver),
                     or_unnamed(hello.device), who_started_this());
}

DriverFactory on_one_driver(ProcessDriver& driver) {
  return [&driver](int /*index*/) {
    driver.look();
    return std::make_unique<BorrowedDriver>(driver);
  };
}

std::optional<ForbiddenSetpoint> first_beyond(const Plan& plan,
                                              const std::vector<PressureLimits>& limits) {
  for (std::size_t k = 0; k < plan.frames.size(); ++k) {
    const auto& setpoint = plan.frames[k].setpoint_kpa;
    for (Eigen::Index s = 0; s < setpoint.size(); ++s) {
      const double value = setpoint[s];
      const PressureLimits& sides = limits[static_cast<std::size_t>(s)];
      const bool is_within =  // no NaN is
          value <= sides.upper_kpa + kSetpointRounding &&
          value >= sides.lower_kpa - kSetpointRounding;
      if (!is_within) {
        return ForbiddenSetpoint{k, s, value, sides};
      }
    }
  }
  return std::nullopt;
}

std::optional<ShortReach> first_short_reach(const ArmDescription& arm, double limit_scale,
                                            const std::vector<PressureLimits>& allowed_kpa) {
  for (std::size_t s = 0; s < allowed_kpa.size(); ++s) {
    for (const double sign : {1.0, -1.0}) {
      const double wanted = limit_scale * arm.segments[s].pressure_limit_kpa.side_kpa(sign);
      const double allowed = allowed_kpa[s].side_kpa(sign);
      if (sign * allowed < sign * wanted) {
        return ShortReach{static_cast<Eigen::Index>(s), wanted, allowed};
      }
    }
  }
  return std::nullopt;
}

}  // namespace limber
