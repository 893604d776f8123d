#include "plane_kinematics.hpp"

#include <cmath>

namespace limber {

namespace {

Eigen::Vector2d perpendicular(const Eigen::Vector2d& v) {
  return {-v.y(), v.x()};
}

}  // namespace

PlaneKinematics::PlaneKinematics(const std::vector<ChainLink>& links, double base_angle_rad)
    : plates_(links.size() + 1), hinge_(links.size(), Eigen::Vector2d::Zero()) {
  for (const ChainLink& link : links) {
    half_length_m_.push_back(0.5 * link.length_m);
  }
  plates_[0].theta_rad = base_angle_rad;
  plates_[0].axis = {std::cos(base_angle_rad), std::sin(base_angle_rad)};
}

void PlaneKinematics::update(const double* position, const double* velocity) {
  for (std::size_t gap = 0; gap < half_length_m_.size(); ++gap) {
    const Plate& before = plates_[gap];
    Plate& after = plates_[gap + 1];
    const double reach = half_length_m_[gap] + position[2 * gap];
    hinge_[gap] = before.position + reach * before.axis;
    after.theta_rad = before.theta_rad + position[2 * gap + 1];
    after.rate_rad_per_s = before.rate_rad_per_s + velocity[2 * gap + 1];
    after.axis = {std::cos(after.theta_rad), std::sin(after.theta_rad)};
    after.position = hinge_[gap] + half_length_m_[gap] * after.axis;
    after.velocity = before.velocity + velocity[2 * gap] * before.axis +
                     before.rate_rad_per_s * reach * perpendicular(before.axis) +
                     after.rate_rad_per_s * half_length_m_[gap] * perpendicular(after.axis);
  }
}

void PlaneKinematics::add_joint_forces(const std::vector<Load>& loads, double* joint_force) const {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  double moment = 0.0;  // about the origin
  for (std::size_t gap = half_length_m_.size(); gap-- > 0;) {
    const Load& load = loads[gap];
    const Eigen::Vector2d& at = plates_[gap + 1].position;
    force += load.force_n;
    moment += load.torque_n_m + at.x() * load.force_n.y() - at.y() * load.force_n.x();
    const Eigen::Vector2d& hinge = hinge_[gap];
    joint_force[2 * gap] += force.dot(plates_[gap].axis);
    joint_force[2 * gap + 1] += moment - (hinge.x() * force.y() - hinge.y() * force.x());
  }
}

}  // namespace limber
