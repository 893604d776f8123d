#pragma once

#include <memory>
#include <string>
#include <vector>

#include <mujoco/mujoco.h>

#include "limber/arm/arm_description.hpp"

namespace limber {

struct VirtualArmParameters;

/// The chain of chain_mjcf in MuJoCo, advanced under generalised forces; the only place that calls
/// MuJoCo. Generalised coordinates of each gap in turn: slide [m] and hinge [rad]; in space slide,
/// bend about y, bend about z and twist.
///
/// Threads: one object, one thread.
class MujocoChain {
 public:
  /// @throws SystemFault if MuJoCo refuses the model.
  MujocoChain(const ArmDescription& arm, const VirtualArmParameters& parameters,
              double time_step_s);

  int size() const { return model_->nv; }
  const double* position() const { return data_->qpos; }
  const double* velocity() const { return data_->qvel; }
  /// Everything that changes with time but the time itself, to be set again.
  void get_state(std::vector<double>& position, std::vector<double>& velocity,
                 std::vector<double>& warm_start) const;
  /// Overwrites the state; sizes are `size()` each.
  void set_state(const std::vector<double>& position, const std::vector<double>& velocity,
                 const std::vector<double>& warm_start, double time_s);

  /// Of the last step's mass matrix, at this velocity; with the joints' armature.
  double kinetic_energy_j() const;

  /// Forces of the next step, N and N m; write all of them before each `step`.
  double* applied_force() { return data_->qfrc_applied; }

  /// One step; the joints' damping is implicit.
  /// @return MuJoCo's warning or error; empty if there is none. After a warning the state is
  /// lost, because MuJoCo resets it.
  [[nodiscard]] std::string step();

 private:
  struct DeleteModel {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
  };
  struct DeleteData {
    void operator()(mjData* data) const { mj_deleteData(data); }
  };

  std::unique_ptr<mjModel, DeleteModel> model_;
  std::unique_ptr<mjData, DeleteData> data_;
  double time_step_s_;
  std::vector<double> damping_;
};

}  // namespace limber
