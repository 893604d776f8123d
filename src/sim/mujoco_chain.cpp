#include "mujoco_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <mutex>
#include <string_view>

#include <fmt/format.h>

#include "limber/arm/space_pose.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/sim/mjcf.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

constexpr const char* kFileName = "arm.xml";

[[noreturn]] void fail(const char* message) {
  throw SystemFault(fmt::format("MuJoCo: {}", message));
}

// Warnings are read from mjData after each step; MuJoCo's own way is a MUJOCO_LOG.TXT in the
// working folder.
void ignore_warning(const char*) {}

// Without our own handlers an error would wait for Enter.
void install_handlers() {
  static std::once_flag once;
  std::call_once(once, [] {
    mju_user_error = fail;
    mju_user_warning = ignore_warning;
  });
}

/// MuJoCo allots, and tries out, room for 500 constraints and 100 contacts where nothing is said of
/// them: 20 ms and 11 MB for each arm, whose constraints and contacts are off.
std::string without_room_for_contacts(std::string xml) {
  const std::string_view before = "  <worldbody>";
  return xml.insert(xml.find(before), "  <size njmax=\"1\" nconmax=\"1\"/>\n");
}

mjModel* load_model(const std::string& xml) {
  // The XML compiler keeps state of its own between calls.
  static std::mutex compiler;
  const std::lock_guard lock(compiler);
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  const int made = mj_makeEmptyFileVFS(files.get(), kFileName, int(xml.size()));
  if (made != 0) {
    throw SystemFault(fmt::format("MuJoCo cannot hold the arm's model ({} bytes)", xml.size()));
  }
  const int index = mj_findFileVFS(files.get(), kFileName);
  std::memcpy(files->filedata[index], xml.data(), xml.size());
  std::array<char, 1000> message{};
  mjModel* model = mj_loadXML(kFileName, files.get(), message.data(), int(message.size()));
  mj_deleteVFS(files.get());
  if (model == nullptr) {
    throw SystemFault(fmt::format("MuJoCo refuses the arm's model: {}", message.data()));
  }
  return model;
}

Eigen::Vector2d perpendicular(const Eigen::Vector2d& v) {
  return {-v.y(), v.x()};
}

constexpr std::uint64_t kOffsetAboutYStream = 3'000'000;  // of strength_seed, beside mjcf.cpp's

Eigen::Quaterniond turn(double angle_rad, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, axis));
}

}  // namespace

MujocoChain::MujocoChain(const ArmDescription& arm, const VirtualArmParameters& parameters,
                         double time_step_s)
    : time_step_s_(time_step_s) {
  install_handlers();
  model_.reset(load_model(without_room_for_contacts(chain_mjcf(arm, parameters, time_step_s))));
  // MuJoCo's Euler solves (M + h D) a = f − D v for implicit damping, with a second factorisation
  // of its own. The same system, factorised once: h D goes into the armature, −D v into f.
  damping_.assign(model_->dof_damping, model_->dof_damping + size());
  for (int dof = 0; dof < size(); ++dof) {
    model_->dof_armature[dof] += time_step_s * model_->dof_damping[dof];
    model_->dof_damping[dof] = 0.0;
  }
  data_.reset(mj_makeData(model_.get()));
}

void MujocoChain::save(VirtualArmState& state) const {
  state.position.assign(data_->qpos, data_->qpos + size());
  state.velocity.assign(data_->qvel, data_->qvel + size());
  state.warm_start.assign(data_->qacc_warmstart, data_->qacc_warmstart + size());
}

void MujocoChain::restore(const VirtualArmState& state) {
  mj_resetData(model_.get(), data_.get());
  std::ranges::copy(state.position, data_->qpos);
  std::ranges::copy(state.velocity, data_->qvel);
  std::ranges::copy(state.warm_start, data_->qacc_warmstart);
  data_->time = double(state.step) * time_step_s_;
}

double MujocoChain::kinetic_energy_j() const {
  std::vector<double> momentum(size());
  mj_mulM(model_.get(), data_.get(), momentum.data(), data_->qvel);
  double energy = 0.0;
  for (std::size_t dof = 0; dof < momentum.size(); ++dof) {
    const double rate = data_->qvel[dof];
    energy += 0.5 * rate * (momentum[dof] - time_step_s_ * damping_[dof] * rate);
  }
  return energy;
}

std::string MujocoChain::step() {
  for (std::size_t dof = 0; dof < damping_.size(); ++dof) {
    data_->qfrc_applied[dof] -= damping_[dof] * data_->qvel[dof];
  }
  mj_step(model_.get(), data_.get());
  for (int kind = 0; kind < mjNWARNING; ++kind) {
    if (data_->warning[kind].number > 0) {
      return mju_warningText(kind, data_->warning[kind].lastinfo);
    }
  }
  const bool finite = std::all_of(data_->qpos, data_->qpos + model_->nq,
                                  [](double value) { return std::isfinite(value); });
  return finite ? "" : "a joint position is not finite";
}

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

void write_space_plates(const std::vector<SpaceLink>& links, double base_angle_rad,
                        const double* position, SpaceBackboneD& plates) {
  plates.resize(Eigen::Index(links.size()) + 1, kSpacePoseSize);
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
    plates.row(Eigen::Index(gap) + 1) = numbers_of(pose).transpose();
  }
}

}  // namespace limber
