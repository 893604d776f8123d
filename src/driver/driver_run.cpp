#include "limber/driver/driver_run.hpp"

#include <pwd.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/cpu_level.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/seconds_since.hpp"
#include "limber/common/utf8.hpp"
#include "limber/common/version.hpp"
#include "limber/run/safety_gate.hpp"

namespace limber {

namespace {

/// "user@host": who started a run on an arm, as far as the system knows.
std::string who_started_this() {
  std::array<char, 4096> room{};
  passwd entry{};
  passwd* found = nullptr;
  ::getpwuid_r(::getuid(), &entry, room.data(), room.size(), &found);
  const std::string user = found != nullptr ? found->pw_name : fmt::format("user {}", ::getuid());
  return fmt::format("{}@{}", user, host_name());
}

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
  std::vector<PressureLimits> limits_kpa() const override { return driver_.limits_kpa(); }

 private:
  ArmDriver& driver_;
};

constexpr std::size_t kMaxLogged = 4096;  // of a line that is no JSON: what a broken driver sends

std::string as_text(std::string_view text) {
  return nlohmann::json(std::string(text.substr(0, kMaxLogged)))
      .dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

}  // namespace

std::string describe(const ProcessDriver& driver) {
  const DriverHello& hello = driver.hello();
  const auto or_unnamed = [](const std::string& text) { return text.empty() ? "unnamed" : text; };
  return fmt::format("driver {} (device: {}){}{}", or_unnamed(hello.driver),
                     or_unnamed(hello.device), kStartedBy, who_started_this());
}

std::string how_it_is_moved(const ProcessDriver& driver) {
  const std::string by = "on an arm, by its driver";
  return driver.calibration()
             ? fmt::format("{}, calibration {}", by, content_hash(to_yaml(*driver.calibration())))
             : by;
}

std::string time_stamped_run_name() {
  return fmt::format("run_{:%Y%m%d_%H%M%S}", fmt::gmtime(std::time(nullptr)));
}

std::string free_name(const std::string& stem, std::string_view separator,
                      std::string_view suffix) {
  std::string name = fmt::format("{}{}", stem, suffix);
  for (int run = 1; fs::exists(name); ++run) {
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
    if (setpoint.size() != std::ssize(limits)) {
      throw InputError(fmt::format("{}: {} set points; the driver moves {} segments",
                                   frame_name(Eigen::Index(k)), setpoint.size(), limits.size()));
    }
    for (Eigen::Index s = 0; s < setpoint.size(); ++s) {
      const double value = setpoint[s];
      const PressureLimits& sides = limits[s];
      if (!allow(sides, value, kSetpointRoundingShare * sides.largest_kpa())) {
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
      const double own = arm.limits_of_channel(int(s)).side_kpa(sign);
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
  return fmt::format("the driver allows {:.6g} kPa in {}, and motions ask for {:.6g} kPa; {}",
                     found.allowed_kpa, channel_name(arm, found.segment), found.wanted_kpa,
                     scale ? fmt::format("{} stays within", fmt::format(fmt::runtime(flag), *scale))
                           : "no scale stays within: say in the arm file which side has no "
                             "pressure, as in pressure_limit_kpa: [0, 50]");
}

std::optional<ShortReach> first_short_reach(const ArmDescription& arm, double limit_scale,
                                            const std::vector<PressureLimits>& allowed_kpa) {
  for (std::size_t s = 0; s < allowed_kpa.size(); ++s) {
    for (const double sign : {1.0, -1.0}) {
      const double wanted = limit_scale * arm.limits_of_channel(int(s)).side_kpa(sign);
      const double allowed = allowed_kpa[s].side_kpa(sign);
      if (sign * (wanted - allowed) > kSetpointRoundingShare * allowed_kpa[s].largest_kpa()) {
        return ShortReach{Eigen::Index(s), wanted, allowed};
      }
    }
  }
  return std::nullopt;
}

DriverLog::DriverLog(const fs::path& path, std::string_view command, bool append) {
  if (path.empty()) {
    return;
  }
  file_.reset(std::fopen(path.c_str(), append ? "ae" : "we"));
  if (!file_) {
    throw SystemFault(fmt::format("{}: {}", path.string(), std::generic_category().message(errno)));
  }
  const Json first = {
      {"schema", "limber/driver_log/1"},
      {"limber", version()},
      {"started_by", who_started_this()},
      {"started_at", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
      {"command", std::string(command)}};
  fmt::print(file_.get(), "{}\n",
             first.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  std::fflush(file_.get());
}

void DriverLog::note(std::string_view text) {
  write("note", as_text(text));
}

void DriverLog::write(const char* key, std::string_view line) {
  if (!file_) {
    return;
  }
  const double at_s = seconds_since(start_);
  // A byte order mark only a whole text may have.
  const bool is_json = !line.starts_with(kByteOrderMark) && nlohmann::json::accept(line);
  const std::string body = is_json ? std::string(line) : as_text(line);
  const std::string text = fmt::format("{{\"at_s\": {:.6f}, \"{}\": {}}}\n", at_s, key, body);
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0) {
    file_.reset();
  }
}

}  // namespace limber
