#include "vent_words.hpp"

#include <cmath>

#include <fmt/format.h>

#include "limber/arm/names.hpp"

namespace limber {

std::string what_rose(const Pressures& first_kpa, const Pressures& now_kpa, double rise_kpa) {
  for (Eigen::Index s = 0; s < now_kpa.size(); ++s) {
    const double rose_kpa = std::abs(double(now_kpa[s])) - std::abs(double(first_kpa[s]));
    if (rose_kpa > rise_kpa) {
      return fmt::format("; {} rose by {:.1f} kPa while venting", segment_name(s), rose_kpa);
    }
  }
  return "";
}

std::string vent_message(const VentResult& vent, const Pressures& now_kpa,
                         const std::string& rising) {
  if (vent.confirmed) {
    return fmt::format("vented: {:.1f} kPa after {:.1f} s{}{}", vent.pressure_kpa, vent.after_s,
                       rising, rising.empty() ? "" : ", then fell");
  }
  Eigen::Index worst = 0;
  now_kpa.cwiseAbs().maxCoeff(&worst);
  return fmt::format("VENT NOT CONFIRMED: {} at {:.0f} kPa, shut off the supply{}",
                     segment_name(worst), now_kpa[worst], rising);
}

std::string not_zero_message(double pressure_kpa, const SafetySettings& safety) {
  constexpr double kAmbientLowKpa = 80.0;    // what an absolute sensor reads of a vented arm …
  constexpr double kAmbientHighKpa = 110.0;  // … from high mountains to the sea
  const bool ambient = pressure_kpa > kAmbientLowKpa && pressure_kpa < kAmbientHighKpa;
  return fmt::format("the vented arm reads {:.1f} kPa; expected at most {} kPa. {}", pressure_kpa,
                     safety.vented_kpa,
                     ambient
                         ? "Pressures on the wire are gauge, not absolute: "
                           "the driver has to subtract the ambient pressure"
                         : "Check supply, valves, the sensors' zero and the driver's unit (kPa)");
}

}  // namespace limber
