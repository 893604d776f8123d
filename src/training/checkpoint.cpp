#include "checkpoint.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "network/safetensors.hpp"

namespace limber {

namespace {

using Json = nlohmann::json;

constexpr const char* kSchema = "limber/checkpoint/2";

Tensor to_tensor(const Eigen::VectorXf& vector) {
  return {{static_cast<std::size_t>(vector.size())}, {vector.begin(), vector.end()}};
}

Eigen::VectorXf to_vector(const Tensor& tensor) {
  return Eigen::Map<const Eigen::VectorXf>(tensor.values.data(),
                                           static_cast<Eigen::Index>(tensor.values.size()));
}

/// JSON has no NaN: null stands for an epoch that was not validated.
Json curve_to_json(const std::vector<LearningCurvePoint>& curve) {
  Json rows = Json::array();
  for (const LearningCurvePoint& p : curve) {
    const double error = p.validation_position_error_cm;
    rows.push_back({p.epoch, p.window_frames, p.learning_rate, p.loss,
                    std::isnan(error) ? Json() : Json(error), p.elapsed_s});
  }
  return rows;
}

std::vector<LearningCurvePoint> curve_from_json(const Json& rows) {
  std::vector<LearningCurvePoint> curve;
  for (const Json& row : rows) {
    const double error =
        row.at(4).is_null() ? std::numeric_limits<double>::quiet_NaN() : row.at(4).get<double>();
    curve.push_back({row.at(0), row.at(1), row.at(2), row.at(3), error, row.at(5)});
  }
  return curve;
}

Json stages_to_json(const std::vector<TrainingStage>& stages) {
  Json rows = Json::array();
  for (const TrainingStage& stage : stages) {
    rows.push_back({stage.window_frames, stage.windows_per_batch, stage.epochs});
  }
  return rows;
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  const TrainingState& state = checkpoint.state;
  Safetensors content;
  content.tensors["parameters"] = to_tensor(state.parameters);
  content.tensors["average"] = to_tensor(state.average);
  content.tensors["first_moment"] = to_tensor(state.optimiser.first_moment);
  content.tensors["second_moment"] = to_tensor(state.optimiser.second_moment);
  content.tensors["best"] = to_tensor(state.best);
  const Json numbers = {{"epochs_done", state.epochs_done},
                        {"step", state.optimiser.step},
                        {"stage_first_loss", state.stage_first_loss},
                        {"best_error_m", state.best_error_m},
                        {"best_members_m", state.best_members_m},
                        {"elapsed_s", checkpoint.elapsed_s},
                        {"best_epoch", state.best_epoch},
                        {"stages", stages_to_json(checkpoint.stages)},
                        {"curve", curve_to_json(state.curve)}};
  content.metadata = {
      {"schema", kSchema}, {"identity", checkpoint.identity}, {"state", numbers.dump()}};
  write_file_atomically(path, safetensors_bytes(content));
}

Checkpoint read_checkpoint(const std::filesystem::path& path, const std::string& identity) {
  const Safetensors content = parse_safetensors(read_file(path), path.string());
  Checkpoint result;
  try {
    if (content.metadata.at("schema") != kSchema) {
      throw InputError(fmt::format("{}: schema {}; expected {}", path.string(),
                                   content.metadata.at("schema"), kSchema));
    }
    result.identity = content.metadata.at("identity");
    TrainingState& state = result.state;
    state.parameters = to_vector(content.tensors.at("parameters"));
    state.average = to_vector(content.tensors.at("average"));
    state.optimiser.first_moment = to_vector(content.tensors.at("first_moment"));
    state.optimiser.second_moment = to_vector(content.tensors.at("second_moment"));
    state.best = to_vector(content.tensors.at("best"));
    const Json numbers = Json::parse(content.metadata.at("state"));
    state.epochs_done = numbers.at("epochs_done");
    state.optimiser.step = numbers.at("step");
    state.stage_first_loss = numbers.at("stage_first_loss").get<std::vector<double>>();
    state.best_error_m = numbers.at("best_error_m");
    state.best_members_m = numbers.at("best_members_m").get<std::vector<double>>();
    result.elapsed_s = numbers.at("elapsed_s");
    state.best_epoch = numbers.at("best_epoch");
    state.curve = curve_from_json(numbers.at("curve"));
    for (const Json& row : numbers.at("stages")) {
      result.stages.push_back({row.at(0), row.at(1), row.at(2)});
    }
  } catch (const std::out_of_range&) {
    throw InputError(
        fmt::format("{}: not a whole checkpoint; remove it and train anew", path.string()));
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: not a whole checkpoint ({}); remove it and train anew",
                                 path.string(), error.what()));
  }
  if (result.identity != identity) {
    throw InputError(
        fmt::format("{}: the checkpoint of a run with other data or settings; give the same, or "
                    "leave out --resume to start anew",
                    path.string()));
  }
  return result;
}

}  // namespace limber
