#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "limber/common/filesystem.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/world/environment.hpp"
#include "project_folder.hpp"

namespace limber {

/// Names of an arm and a model as the project folder has them; no model: the simple one.
struct SceneNames {
  std::string arm;
  std::string model;
  bool operator==(const SceneNames&) const = default;
};

/// An arm and what its motions are predicted with. Threads: constant after construction.
class StudioScene {
 public:
  /// Of a family, its middle arm.
  /// @throws InputError if a file does not fit, as `limber plan` would.
  StudioScene(const ProjectFolder& project, SceneNames names);

  /// Whether those are its files, and they have not been written since.
  bool is_current(const SceneNames& names) const;

  const ArmDescription& arm() const { return arm_; }
  /// The one that plans are made with: the network, or the simple model.
  const MotionModel& motion() const { return motion_; }
  const MotionModel& simple() const { return simple_motion_; }
  bool has_network() const { return motion_.has_network(); }
  /// As its file has it; null: the simple model.
  const CompensationModel* network() const { return network_ ? &*network_ : nullptr; }
  bool has_virtual_arm() const { return arm_.command.is_pressure_kpa(); }
  /// @throws InputError, with the command that makes it one arm's, if the model is a family's.
  void require_one_arm() const;
  /// @throws InputError unless that is model_hash(): the file may have been written since.
  void require_model(const std::string& hash) const;
  /// The model of another arm of its family. @throws InputError unless e has the family's size.
  ForwardModel model_of(const Eigen::VectorXf& e) const;
  /// With the valves of the model.
  MotionModel motion_of(const ForwardModel& forward) const;
  /// Content hash of the model's file; empty for the simple model.
  const std::string& model_hash() const { return model_hash_; }

 private:
  using FileTime = fs::file_time_type;

  SceneNames names_;
  fs::path arm_file_;
  fs::path model_file_;  // empty: the simple model
  FileTime arm_time_;
  FileTime model_time_{};
  ArmDescription arm_;
  std::string model_hash_;
  std::optional<CompensationModel> network_;  // as its file has it
  ForwardModel forward_;
  ForwardModel simple_;
  MotionModel motion_;
  MotionModel simple_motion_;
};

}  // namespace limber
