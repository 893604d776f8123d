#include "space_chain.hpp"

#include <cmath>

#include <fmt/format.h>

#include "limber/arm/space_pose.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kOffsetAboutYStream = 3'000'000;  // of strength_seed, beside mjcf.cpp's

Eigen::Quaterniond turn(double angle_rad, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, axis));
}

}  // namespace

std::vector<SpaceLink> space_chain_links(const ArmDescription& arm, const VirtualArmParameters& p) {
  RandomStream offsets(p.strength_seed, kOffsetAboutYStream);
  std::vector<SpaceLink> links;
  for (const ChainLink& gap : chain_links(arm, p)) {
    // A disc as thick as the gap: what lies between the plates is part of it.
    const double ring = gap.width_m * gap.width_m / 16.0;
    const double thickness = gap.length_m * gap.length_m / 12.0;
    SpaceLink link;
    link.gap = gap;
    link.inertia_along_kg_m2 = 2.0 * gap.mass_kg * ring;
    link.inertia_across_kg_m2 = gap.mass_kg * (ring + thickness);
    link.rest_rad = {p.plate_offset_rad * offsets.uniform(-1.0, 1.0), gap.rest_angle_rad};
    links.push_back(link);
  }
  return links;
}

std::string space_link_mjcf(const SpaceLink& link, const VirtualArmParameters& p,
                            std::size_t number, const std::string& margin) {
  const auto hinge = [&](const char* name, const char* axis, double stiffness, double rest_rad,
                         double damping) {
    return fmt::format(
        "{}  <joint name=\"{}_{}\" type=\"hinge\" axis=\"{}\" pos=\"{} 0 0\" stiffness=\"{}\" "
        "springref=\"{}\" damping=\"{}\" armature=\"{}\"/>\n",
        margin, name, number, axis, -0.5 * link.gap.length_m, stiffness, rest_rad, damping,
        p.hinge_armature_kg_m2);
  };
  const double bend = p.hinge_stiffness_n_m_per_rad;
  const double damping = link.gap.hinge_damping_n_m_s_per_rad;
  return fmt::format(
             "{0}<body name=\"plate_{1}\" pos=\"{2} 0 0\">\n"
             "{0}  <inertial pos=\"0 0 0\" mass=\"{3}\" diaginertia=\"{4} {5} {5}\"/>\n"
             "{0}  <joint name=\"slide_{1}\" type=\"slide\" "
             "axis=\"1 0 0\" damping=\"{6}\" armature=\"{7}\"/>\n",
             margin, number, link.gap.length_m, link.gap.mass_kg, link.inertia_along_kg_m2,
             link.inertia_across_kg_m2, p.slide_damping_n_s_per_m, p.slide_armature_kg) +
         hinge("bend_y", "0 1 0", bend, link.rest_rad[0], damping) +
         hinge("bend_z", "0 0 1", bend, link.rest_rad[1], damping) +
         hinge("twist", "1 0 0", p.twist_stiffness_n_m_per_rad, 0.0, p.twist_damping_n_m_s_per_rad);
}

void write_space_plates(const std::vector<SpaceLink>& links, double base_angle_rad,
                        const double* position, SpaceBackboneD& plates) {
  plates.resize(static_cast<Eigen::Index>(links.size()) + 1, kSpacePoseSize);
  SpacePose pose{Eigen::Vector3d::Zero(), turn(base_angle_rad, Eigen::Vector3d::UnitZ())};
  plates.row(0) = numbers_of(pose).transpose();
  for (std::size_t gap = 0; gap < links.size(); ++gap) {
    const double* joints = position + kSpaceJoints * gap;
    const double half_m = 0.5 * links[gap].gap.length_m;
    SpacePose step;
    step.rotation = turn(joints[1], Eigen::Vector3d::UnitY()) *
                    turn(joints[2], Eigen::Vector3d::UnitZ()) *
                    turn(joints[3], Eigen::Vector3d::UnitX());
    step.position_m = (half_m + joints[0]) * Eigen::Vector3d::UnitX() +
                      half_m * (step.rotation * Eigen::Vector3d::UnitX());
    pose = compose(pose, step);
    pose.rotation.normalize();
    plates.row(static_cast<Eigen::Index>(gap) + 1) = numbers_of(pose).transpose();
  }
}

}  // namespace limber
