#include "mujoco_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <mutex>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/sim/mjcf.hpp"

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

mjModel* load_model(const std::string& xml) {
  // The XML compiler keeps state of its own between calls.
  static std::mutex compiler;
  const std::lock_guard lock(compiler);
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  const int made = mj_makeEmptyFileVFS(files.get(), kFileName, static_cast<int>(xml.size()));
  if (made != 0) {
    throw SystemFault(fmt::format("MuJoCo cannot hold the arm's model ({} bytes)", xml.size()));
  }
  const int index = mj_findFileVFS(files.get(), kFileName);
  std::memcpy(files->filedata[index], xml.data(), xml.size());
  std::array<char, 1000> message{};
  mjModel* model =
      mj_loadXML(kFileName, files.get(), message.data(), static_cast<int>(message.size()));
  mj_deleteVFS(files.get());
  if (model == nullptr) {
    throw SystemFault(fmt::format("MuJoCo refuses the arm's model: {}", message.data()));
  }
  return model;
}

}  // namespace

MujocoChain::MujocoChain(const ArmDescription& arm, const VirtualArmParameters& parameters,
                         double time_step_s)
    : time_step_s_(time_step_s) {
  install_handlers();
  model_.reset(load_model(chain_mjcf(arm, parameters, time_step_s)));
  // MuJoCo's Euler solves (M + h D) a = f − D v for implicit damping, with a second factorisation
  // of its own. The same system, factorised once: h D goes into the armature, −D v into f.
  damping_.assign(model_->dof_damping, model_->dof_damping + size());
  for (int dof = 0; dof < size(); ++dof) {
    model_->dof_armature[dof] += time_step_s * model_->dof_damping[dof];
    model_->dof_damping[dof] = 0.0;
  }
  data_.reset(mj_makeData(model_.get()));
}

void MujocoChain::get_state(std::vector<double>& position, std::vector<double>& velocity,
                            std::vector<double>& warm_start) const {
  position.assign(data_->qpos, data_->qpos + size());
  velocity.assign(data_->qvel, data_->qvel + size());
  warm_start.assign(data_->qacc_warmstart, data_->qacc_warmstart + size());
}

void MujocoChain::set_state(const std::vector<double>& position,
                            const std::vector<double>& velocity,
                            const std::vector<double>& warm_start, double time_s) {
  mj_resetData(model_.get(), data_.get());
  std::copy(position.begin(), position.end(), data_->qpos);
  std::copy(velocity.begin(), velocity.end(), data_->qvel);
  std::copy(warm_start.begin(), warm_start.end(), data_->qacc_warmstart);
  data_->time = time_s;
}

double MujocoChain::kinetic_energy_j() const {
  std::vector<double> momentum(static_cast<std::size_t>(size()));
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

}  // namespace limber
