#pragma once

#include <string>

#include "limber/arm/backbone.hpp"
#include "limber/hardware/process_driver.hpp"
#include "limber/hardware/safety_settings.hpp"

namespace limber {

/// "; segment 0 rose by 8.0 kPa while venting": what rose by more than `rise_kpa` from `first` to
/// `now`; empty where nothing did.
std::string what_rose(const Pressures& first_kpa, const Pressures& now_kpa, double rise_kpa);

/// "vented: 0.8 kPa after 0.6 s", or "VENT NOT CONFIRMED: segment 1 at 43 kPa,
/// shut off the supply".
std::string vent_message(const VentResult& vent, const Pressures& now_kpa,
                         const std::string& rising);

/// Why an arm that reads `pressure_kpa` when vented can't be driven.
std::string not_zero_message(double pressure_kpa, const SafetySettings& safety);

}  // namespace limber
