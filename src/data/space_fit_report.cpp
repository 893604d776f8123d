// What a fit to an arm in space says of its chambers.
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/arm/space_no_load.hpp"
#include "limber/common/json.hpp"
#include "limber/common/units.hpp"
#include "limber/data/space_fit.hpp"

namespace limber {

namespace {

constexpr double kHardly_rad = 0.02;    // over the whole range: noise bends that much
constexpr double kOtherWay_deg = 60.0;  // between neighbours of three

double turned_deg(double from_deg, double to_deg) {
  return std::abs(std::remainder(to_deg - from_deg, 360.0));
}

/// Direction that a segment bends to: toward y about z, toward z about −y.
double direction_deg(double bend_y, double bend_z) {
  return kDegPerRad * std::atan2(-bend_y, bend_z);
}

/// Where the arm file says that a chamber bends its segment to.
double expected_deg(const Chamber& chamber) {
  return chamber.angle_deg + (chamber.sense > 0 ? 180.0 : 0.0);
}

/// @param angle_deg  that it bends to
std::string suspicion_of(const ArmDescription& arm, int segment, const Chamber& chamber,
                         const ChamberFinding& found) {
  if (found.bend_rad < kHardly_rad && std::abs(found.extension) < kHardly_rad) {
    return "hardly acts: is its column the right one?";
  }
  if (chamber.radius_m == 0.0 ||
      turned_deg(found.angle_deg, expected_deg(chamber)) < kOtherWay_deg) {
    return {};
  }
  const auto& chambers = arm.segments[segment].chambers;
  for (std::size_t other = 0; other < chambers.size(); ++other) {
    if (turned_deg(found.angle_deg, expected_deg(chambers[other])) < 0.5 * kOtherWay_deg) {
      return fmt::format("bends as the arm file says of chamber {}: are columns in another order?",
                         other);
    }
  }
  return turned_deg(found.angle_deg, expected_deg(chamber) + 180.0) < kOtherWay_deg
             ? "bends to the other side: its sense, or the sign of its column"
             : "bends another way than its angle says";
}

}  // namespace

std::vector<ChamberFinding> chamber_findings(const ArmDescription& arm, const SpaceFit& fit) {
  const SpaceNoLoad no_load(arm);
  std::vector<ChamberFinding> findings;
  int channel = 0;
  for (int i = 0; i < arm.segment_count(); ++i) {
    for (const Chamber& chamber : arm.segments[i].chambers) {
      Eigen::VectorXd full = Eigen::VectorXd::Zero(arm.channel_count());
      full[channel] = chamber.limit_kpa.upper_kpa > 0.0 ? chamber.limit_kpa.upper_kpa
                                                        : chamber.limit_kpa.lower_kpa;
      const double strain = no_load.strains(full)[channel];
      const Eigen::Vector3d shape = strain * fit.shape.block<3, 1>(3 * i, channel);
      ChamberFinding found;
      found.name = channel_name(arm, channel);
      found.bend_rad = shape.head<2>().norm();
      found.angle_deg = direction_deg(shape[0], shape[1]);
      found.extension = shape[2];
      found.sd_rad = std::abs(strain) * fit.shape_sd.block<2, 1>(3 * i, channel).norm();
      ChamberFinding as_pressed = found;
      as_pressed.angle_deg += full[channel] < 0.0 ? 180.0 : 0.0;
      found.suspicion = fit.is_held[channel]
                            ? "hardly changes, and is taken to do what the arm file says"
                            : suspicion_of(arm, i, chamber, as_pressed);
      findings.push_back(std::move(found));
      ++channel;
    }
  }
  return findings;
}

Json to_json(const SpaceFit& fit, const ArmDescription& arm) {
  Json json = {{"dead_time_s", fit.dead_time_s},
               {"dead_time_sd_s", fit.dead_time_sd_s},
               {"lag_s", fit.lag_s},
               {"plates_mm", fit.plates_mm},
               {"tip_mm", fit.tip_mm},
               {"segments", Json::array()},
               {"chambers", Json::array()}};
  for (int i = 0; i < arm.segment_count(); ++i) {
    const SegmentAtRest rest = segment_at_rest(fit, arm, i);
    json["segments"].push_back({{"length_m", rest.length_m}, {"length_sd_m", rest.length_sd_m}});
  }
  for (const ChamberFinding& found : chamber_findings(arm, fit)) {
    json["chambers"].push_back({{"name", found.name},
                                {"bend_rad", found.bend_rad},
                                {"bend_sd_rad", found.sd_rad},
                                {"toward_deg", found.angle_deg},
                                {"extension", found.extension},
                                {"suspicion", found.suspicion}});
  }
  return json;
}

std::string to_text(const SpaceFit& fit, const ArmDescription& arm) {
  std::string text = fmt::format(
      "constant curvature behind {:.3f} ± {:.3f} s of dead time and a lag of {:.2f} s: {:.1f} mm "
      "off over the plates, {:.1f} mm at the tip\n",
      fit.dead_time_s, fit.dead_time_sd_s, fit.lag_s, fit.plates_mm, fit.tip_mm);
  for (int i = 0; i < arm.segment_count(); ++i) {
    const SegmentAtRest rest = segment_at_rest(fit, arm, i);
    text += fmt::format("  {}: {:.1f} ± {:.1f} mm long at rest; the arm file has {:.1f} mm\n",
                        segment_name(i), kMmPerM * rest.length_m, kMmPerM * rest.length_sd_m,
                        kMmPerM * arm.segments[i].length_m);
  }
  for (const ChamberFinding& found : chamber_findings(arm, fit)) {
    text +=
        fmt::format("  {}: bends by {:.3f} ± {:.3f} rad toward {:.0f}°, extends by {:.1f} %{}{}\n",
                    found.name, found.bend_rad, found.sd_rad, found.angle_deg,
                    100.0 * found.extension, found.suspicion.empty() ? "" : "; ", found.suspicion);
  }
  return text;
}

}  // namespace limber
