#include "studio_scene.hpp"

#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/gap_bounds.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

ArmDescription checked_arm(const fs::path& file) {
  ArmDescription arm = load_arm(file);
  require_planar(arm, "limber studio");
  virtual_arm_parameters(arm);  // refuses what is wrong there
  return arm;
}

std::optional<CompensationModel> network_of(const fs::path& model_file) {
  return model_file.empty() ? std::nullopt : std::optional(read_model(model_file));
}

ForwardModel forward_of(const ArmDescription& arm, std::optional<CompensationModel> network,
                        const fs::path& model_file) {
  if (!network) {
    return ForwardModel(arm);
  }
  if (is_family(*network)) {
    const Eigen::Index size = network->family->size();
    network = model_of_arm(*std::move(network), {"", Eigen::VectorXf::Zero(size),
                                                 Eigen::MatrixXf::Identity(size, size)});
  }
  require_bounded(*network, model_file.filename().string());
  return ForwardModel(arm, *std::move(network));
}

ValveModel valves_of(const ArmDescription& arm, const ForwardModel& forward) {
  return ValveModel(arm, forward.has_network()
                             ? forward.compensation().valves.value_or(ValveParameters{})
                             : ValveParameters{});
}

}  // namespace

StudioScene::StudioScene(const ProjectFolder& project, SceneNames names)
    : names_(std::move(names)),
      arm_file_(project.find(ProjectItem::arm, names_.arm)),
      model_file_(names_.model.empty() ? fs::path()
                                       : project.find(ProjectItem::model, names_.model)),
      arm_time_(fs::last_write_time(arm_file_)),
      model_time_(model_file_.empty() ? fs::file_time_type() : fs::last_write_time(model_file_)),
      arm_(checked_arm(arm_file_)),
      network_(network_of(model_file_)),
      forward_(forward_of(arm_, network_, model_file_)),
      simple_(arm_),
      motion_(forward_, valves_of(arm_, forward_)),
      simple_motion_(simple_) {
  if (!model_file_.empty()) {
    model_hash_ = file_hash(model_file_);
  }
  refuse_if(!is_current(names_), "'{}', '{}': written while they were read; choose them again",
            names_.arm, names_.model);
}

void StudioScene::require_one_arm() const {
  if (network_) {
    limber::require_one_arm(*network_, model_file_.string());
  }
}

void StudioScene::require_model(const std::string& hash) const {
  refuse_if(hash != model_hash_,
            "'{}': the plan was made with another model, or it has changed since: plan again",
            names_.model);
}

ForwardModel StudioScene::model_of(const Eigen::VectorXf& e) const {
  const Eigen::Index size = network_ && network_->family ? network_->family->size() : 0;
  refuse_if(size == 0 || e.size() != size, "e: {} numbers; the model's family has {}", e.size(),
            size);
  return ForwardModel(arm_,
                      model_of_arm(*network_, {"", e, Eigen::MatrixXf::Identity(size, size)}));
}

MotionModel StudioScene::motion_of(const ForwardModel& forward) const {
  return MotionModel(forward, valves_of(arm_, forward));
}

bool StudioScene::is_current(const SceneNames& names) const {
  std::error_code error;
  return names == names_ && fs::last_write_time(arm_file_, error) == arm_time_ &&
         (model_file_.empty() || fs::last_write_time(model_file_, error) == model_time_);
}

}  // namespace limber
