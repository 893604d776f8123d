#include "limber/sim/mjcf.hpp"

#include <cmath>

#include <fmt/format.h>

#include "limber/common/printable.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "mujoco_chain.hpp"

namespace limber {

namespace {

// Streams of strength_seed: 0 … 2n − 1 are the sides' strengths (virtual_arm_parameters.cpp).
constexpr std::uint64_t kPlateOffsetStream = 1'000'000;
constexpr std::uint64_t kGapLengthStream = 2'000'000;

/// XML has no control characters, however they are written: they are spelled out.
std::string escape_xml(const std::string& text) {
  std::string escaped;
  for (const char c : printable(text)) {
    escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return escaped;
}

/// Of the body of plate `number`, which lies within those before.
std::string margin_of(std::size_t number) {
  constexpr std::size_t kFirst = 5;
  return std::string(kFirst + number, ' ');
}

/// Of plate `number`, not closed, with its slide.
std::string body_mjcf(const ChainLink& link, const VirtualArmParameters& p, std::size_t number,
                      double inertia_along, double inertia_across) {
  return fmt::format(
      "{0}<body name=\"plate_{1}\" pos=\"{2} 0 0\">\n"
      "{0}  <inertial pos=\"0 0 0\" mass=\"{3}\" diaginertia=\"{4} {5} {5}\"/>\n"
      "{0}  <joint name=\"slide_{1}\" type=\"slide\" "
      "axis=\"1 0 0\" damping=\"{6}\" armature=\"{7}\"/>\n",
      margin_of(number), number, link.length_m, link.mass_kg, inertia_along, inertia_across,
      p.slide_damping_n_s_per_m, p.slide_armature_kg);
}

/// Of every plate but the base, not closed.
std::vector<std::string> body_texts(const ArmDescription& arm, const VirtualArmParameters& p) {
  std::vector<std::string> texts;
  const auto add_body = [&](const ChainLink& link, double inertia_along, double inertia_across) {
    texts.push_back(body_mjcf(link, p, texts.size() + 1, inertia_along, inertia_across));
  };
  const auto add_hinge = [&](const ChainLink& link, const char* name, const char* axis,
                             double stiffness, double rest_rad, double damping) {
    texts.back() += fmt::format(
        "{}  <joint name=\"{}_{}\" type=\"hinge\" axis=\"{}\" pos=\"{} 0 0\" stiffness=\"{}\" "
        "springref=\"{}\" damping=\"{}\" armature=\"{}\"/>\n",
        margin_of(texts.size()), name, texts.size(), axis, -0.5 * link.length_m, stiffness,
        rest_rad, damping, p.hinge_armature_kg_m2);
  };
  const double bend = p.hinge_stiffness_n_m_per_rad;
  if (arm.is_spatial()) {
    for (const SpaceLink& link : space_chain_links(arm, p)) {
      const double damping = link.gap.hinge_damping_n_m_s_per_rad;
      add_body(link.gap, link.inertia_along_kg_m2, link.inertia_across_kg_m2);
      add_hinge(link.gap, "bend_y", "0 1 0", bend, link.rest_rad[0], damping);
      add_hinge(link.gap, "bend_z", "0 0 1", bend, link.rest_rad[1], damping);
      add_hinge(link.gap, "twist", "1 0 0", p.twist_stiffness_n_m_per_rad, 0.0,
                p.twist_damping_n_m_s_per_rad);
    }
  } else {
    for (const ChainLink& link : chain_links(arm, p)) {
      add_body(link, link.inertia_kg_m2, link.inertia_kg_m2);
      add_hinge(link, "hinge", "0 0 1", bend, link.rest_angle_rad,
                link.hinge_damping_n_m_s_per_rad);
    }
  }
  return texts;
}

}  // namespace

std::vector<ChainLink> chain_links(const ArmDescription& arm, const VirtualArmParameters& p) {
  RandomStream offsets(p.strength_seed, kPlateOffsetStream);
  RandomStream lengths(p.strength_seed, kGapLengthStream);
  std::vector<ChainLink> links;
  for (int s = 0; s < arm.segment_count(); ++s) {
    const Segment& segment = arm.segments[s];
    const double scale = segment.width_m / p.reference_width_m;
    ChainLink link;
    link.segment = s;
    link.width_m = segment.width_m;
    const double fixed = p.plate_mass_fixed_fraction;
    link.mass_kg = p.plate_mass_kg * (fixed + (1.0 - fixed) * scale) + p.plate_payload_kg;
    link.inertia_kg_m2 = link.mass_kg * segment.width_m * segment.width_m / 12.0;
    link.hinge_damping_n_m_s_per_rad = p.hinge_damping_n_m_s_per_rad * scale;
    for (int gap = 0; gap < segment.gaps; ++gap) {
      link.length_m = segment.length_m / segment.gaps *
                      (1.0 + p.gap_length_spread * lengths.uniform(-1.0, 1.0));
      link.rest_angle_rad = p.plate_offset_rad * offsets.uniform(-1.0, 1.0);
      links.push_back(link);
    }
  }
  // The load lies on the plate's middle: it adds mass, and no inertia about it.
  links.back().mass_kg += p.tip_load_kg;
  return links;
}

Eigen::Vector3d gravity_m_per_s2(const VirtualArmParameters& p) {
  const double downhill = p.gravity_m_per_s2 * std::sin(p.table_tilt_rad);
  return {downhill * std::cos(p.table_downhill_rad), downhill * std::sin(p.table_downhill_rad),
          -p.gravity_m_per_s2 * std::cos(p.table_tilt_rad)};
}

std::string chain_mjcf(const ArmDescription& arm, const VirtualArmParameters& p,
                       double time_step_s) {
  constexpr int kMostGaps = 95;  // MuJoCo reads XML 100 elements deep at most
  refuse_if(arm.point_count() - 1 > kMostGaps,
            "virtual arm: arm '{}' has {} gaps; expected at most {}", arm.name,
            arm.point_count() - 1, kMostGaps);
  const std::vector<std::string> links = body_texts(arm, p);
  const Eigen::Vector3d gravity =
      arm.is_spatial() ? Eigen::Vector3d(p.gravity_m_per_s2 * arm.gravity) : gravity_m_per_s2(p);
  std::string text = fmt::format(
      "<mujoco model=\"{}\">\n"
      "  <compiler angle=\"radian\"/>\n"
      "  <option timestep=\"{}\" integrator=\"Euler\" gravity=\"{} {} {}\">\n"
      "    <flag contact=\"disable\" constraint=\"disable\"/>\n"
      "  </option>\n"
      "  <worldbody>\n"
      "    <body name=\"base\" euler=\"0 0 {}\">\n",
      escape_xml(arm.name), time_step_s, gravity.x(), gravity.y(), gravity.z(),
      p.base_misalignment_rad);
  for (const std::string& link : links) {
    text += link;
  }
  for (std::size_t i = links.size(); i > 0; --i) {
    text += fmt::format("{}</body>\n", margin_of(i));
  }
  return text + "    </body>\n  </worldbody>\n</mujoco>\n";
}

}  // namespace limber
