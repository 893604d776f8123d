#include "limber/driver/driver_run.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <memory>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "run_origin.hpp"

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

std::string time_stamped_run_name() {
  return fmt::format("run_{:%Y%m%d_%H%M%S}", fmt::gmtime(std::time(nullptr)));
}

std::string free_name(const std::string& stem, std::string_view separator,
                      std::string_view suffix) {
  std::string name = fmt::format("{}{}", stem, suffix);
  for (int run = 1; std::filesystem::exists(name); ++run) {
    name = fmt::format("{}{}{}{}", stem, separator, run, suffix);
  }
  return name;
}

double allowed_start_error_m(const Plan& plan) {
  constexpr double kMeasuredM = 0.01;
  return std::max(plan.margin_m, kMeasuredM);
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

std::optional<double> scale_within(const ArmDescription& arm,
                                   const std::vector<PressureLimits>& allowed_kpa) {
  constexpr double kSteps = 100.0;
  double scale = 1.0;
  for (std::size_t s = 0; s < allowed_kpa.size(); ++s) {
    for (const double sign : {1.0, -1.0}) {
      const double own = arm.limits_of_channel(static_cast<int>(s)).side_kpa(sign);
      if (own != 0.0) {
        scale = std::min(scale, allowed_kpa[s].side_kpa(sign) / own);
      }
    }
  }
  constexpr double kRounding = 1e-9;  // of 0.3 times a hundred
  const double down = std::floor(kSteps * scale + kRounding) / kSteps;
  return down > 0.0 ? std::optional<double>(down) : std::nullopt;
}

std::string advice(const ShortReach& found, const ArmDescription& arm,
                   const std::vector<PressureLimits>& allowed_kpa, const char* flag) {
  const std::optional<double> scale = scale_within(arm, allowed_kpa);
  return fmt::format("the driver allows {:.1f} kPa in {}, and motions ask for {:.1f} kPa; {}",
                     found.allowed_kpa, channel_name(arm, found.segment), found.wanted_kpa,
                     scale ? fmt::format("{} stays within", fmt::format(fmt::runtime(flag), *scale))
                           : "no scale stays within: say in the arm file which side has no "
                             "pressure, as in pressure_limit_kpa: [0, 50]");
}

std::optional<ShortReach> first_short_reach(const ArmDescription& arm, double limit_scale,
                                            const std::vector<PressureLimits>& allowed_kpa) {
  for (std::size_t s = 0; s < allowed_kpa.size(); ++s) {
    for (const double sign : {1.0, -1.0}) {
      const double wanted = limit_scale * arm.limits_of_channel(static_cast<int>(s)).side_kpa(sign);
      const double allowed = allowed_kpa[s].side_kpa(sign);
      if (sign * allowed < sign * wanted - kSetpointRounding) {
        return ShortReach{static_cast<Eigen::Index>(s), wanted, allowed};
      }
    }
  }
  return std::nullopt;
}

}  // namespace limber
