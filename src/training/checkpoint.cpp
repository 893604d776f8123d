#include "checkpoint.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/common/utf8.hpp"

namespace limber {

namespace {

using PlainJson = nlohmann::json;

constexpr const char* kSchema = "limber/checkpoint/5";
constexpr double kMaxSeconds = 1e9;  // 30 years
constexpr std::uint64_t kMaxSteps = 1'000'000'000'000;

std::string rival_name(std::size_t rival) {
  return fmt::format("rivals.{}", rival);
}

/// JSON has no NaN: null stands for an epoch that was not validated.
PlainJson to_json(const std::vector<LearningCurvePoint>& curve) {
  PlainJson rows = PlainJson::array();
  for (const LearningCurvePoint& p : curve) {
    const double error = p.validation_position_error_cm;
    rows.push_back({p.epoch, p.window_frames, p.learning_rate, p.loss,
                    std::isnan(error) ? PlainJson() : PlainJson(error), p.elapsed_s});
  }
  return rows;
}

PlainJson to_json(const std::vector<TrainingStage>& stages) {
  return mapped<PlainJson>(stages, [&](const TrainingStage& stage) {
    return PlainJson{stage.window_frames, stage.windows_per_batch, stage.epochs};
  });
}

/// One checkpoint's parts, each checked against the run that continues it.
class CheckpointReader {
 public:
  CheckpointReader(const fs::path& path, const RunShape& run)
      : where_(path.string()), run_(run), content_(parse_safetensors(read_file(path), where_)) {}

  Checkpoint read(const std::string& identity) {
    if (text("schema") != kSchema) {
      refuse(fmt::format("schema '{}'; expected {}", shortened(text("schema")), kSchema));
    }
    refuse_if(text("identity") != identity,
              "{}: the checkpoint of a run with other data or settings; give the same, or "
              "leave out --resume to start over",
              where_);
    const PlainJson numbers = parse_json_object(text("state"), where_ + ": state");
    const JsonReader state(numbers, where_, "state");
    try {
      return read_state(state, identity);
    } catch (const InputError& error) {
      throw InputError(std::string(error.what()) + kRemedy);
    }
  }

 private:
  static constexpr const char* kRemedy = "; the checkpoint is damaged: remove it and train again";

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(fmt::format("{}: {}", where_, what));
  }

  const std::string& text(const std::string& key) const {
    const auto found = content_.metadata.find(key);
    if (found == content_.metadata.end()) {
      refuse(fmt::format("no metadata {}{}", key, kRemedy));
    }
    return found->second;
  }

  /// A vector of finite numbers ≥ low. @param size  what it has to have
  Eigen::VectorXf vector(const char* name, Eigen::Index size,
                         float low = std::numeric_limits<float>::lowest()) const {
    const auto found = content_.tensors.find(name);
    if (found == content_.tensors.end()) {
      refuse(fmt::format("no tensor {}", name));
    }
    const Tensor& tensor = found->second;
    if (tensor.values.size() != std::size_t(size)) {
      refuse(fmt::format("tensor {}: {} numbers found; expected {}", name, tensor.values.size(),
                         size));
    }
    for (std::size_t i = 0; i < tensor.values.size(); ++i) {
      if (!std::isfinite(tensor.values[i]) || tensor.values[i] < low) {
        refuse(fmt::format("tensor {}: {} found at {}; expected a finite number{}", name,
                           tensor.values[i], i, low == 0.0F ? ", not negative" : ""));
      }
    }
    return Eigen::Map<const Eigen::VectorXf>(tensor.values.data(), size);
  }

  Checkpoint read_state(const JsonReader& json, const std::string& identity) const {
    Checkpoint result;
    result.identity = identity;
    result.elapsed_s = json.at("elapsed_s").number(0.0, kMaxSeconds);
    result.stages = stages(json.at("stages"));
    const Eigen::Index moments = run_.keeps_moments ? run_.parameters : 0;
    TrainingState& state = result.state;
    state.parameters = vector("parameters", run_.parameters);
    state.optimiser.first_moment = vector("first_moment", moments);
    state.optimiser.second_moment = vector("second_moment", moments, 0.0F);
    state.optimiser.rotations = vector("rotations", run_.rotations);
    state.optimiser.step = std::int64_t(json.at("step").count(kMaxSteps));
    read_progress(json, result.stages, state);
    read_rivals(json, state);
    return result;
  }

  static std::vector<TrainingStage> stages(const JsonReader& field) {
    std::vector<TrainingStage> result;
    int epochs = 0;
    for (const JsonReader& row : field.elements("a list of stages")) {
      const std::vector<JsonReader> items = row.elements("a stage of 3 numbers");
      if (items.size() != 3) {
        row.refuse(fmt::format("{} numbers found; expected 3", items.size()));
      }
      result.push_back({items[0].integer(1, kMaxEpochs), items[1].integer(1, kMaxEpochs),
                        items[2].integer(1, kMaxEpochs - epochs)});
      epochs += result.back().epochs;
    }
    return result;
  }

  void read_progress(const JsonReader& json, const std::vector<TrainingStage>& stages,
                     TrainingState& state) const {
    const auto epochs =
        sum_of<int>(stages, [&](const TrainingStage& stage) { return stage.epochs; });
    state.epochs_done = json.at("epochs_done").integer(0, epochs);
    state.curve = curve(json.at("curve"));
    if (state.curve.size() != std::size_t(state.epochs_done)) {
      json.at("curve").refuse(fmt::format("{} epochs found; expected the {} that are done",
                                          state.curve.size(), state.epochs_done));
    }
    // The first loss of a stage is known from its first epoch to its last but one.
    int end = 0;
    bool within = state.epochs_done > 0;
    for (const TrainingStage& stage : stages) {
      end += stage.epochs;
      within = within && state.epochs_done != end;
    }
    state.stage_first_loss =
        json.at("stage_first_loss").numbers(within ? std::size_t(run_.members) : 0, "losses", 0.0);
  }

  std::vector<LearningCurvePoint> curve(const JsonReader& field) const {
    std::vector<LearningCurvePoint> result;
    for (const JsonReader& row : field.elements("a list of epochs")) {
      const std::vector<JsonReader> items = row.elements("an epoch of 6 numbers");
      if (items.size() != 6) {
        row.refuse(fmt::format("{} numbers found; expected 6", items.size()));
      }
      const int epoch = int(result.size()) + 1;
      const double error =
          items[4].is_null() ? std::numeric_limits<double>::quiet_NaN() : items[4].number(0.0);
      result.push_back({items[0].integer(epoch, epoch), items[1].integer(1, kMaxEpochs),
                        items[2].number(0.0), items[3].number(0.0), error,
                        items[5].number(0.0, kMaxSeconds)});
    }
    return result;
  }

  void read_rivals(const JsonReader& json, TrainingState& state) const {
    int min_epoch = 1;
    for (const JsonReader& row : json.at("rivals").elements("a list of epochs")) {
      ValidatedEpoch rival;
      rival.epoch = row.at("epoch").integer(min_epoch, state.epochs_done);
      rival.error_m = row.at("error_m").number(0.0);
      rival.members_m = row.at("members_m")
                            .numbers(std::size_t(run_.validates ? run_.members : 0), "errors", 0.0);
      rival.weights = vector(rival_name(state.rivals.size()).c_str(), run_.parameters);
      min_epoch = rival.epoch + 1;
      state.rivals.push_back(std::move(rival));
    }
  }

  std::string where_;
  const RunShape& run_;
  Safetensors content_;
};

}  // namespace

void write_checkpoint(const fs::path& path, const Checkpoint& checkpoint) {
  const TrainingState& state = checkpoint.state;
  Safetensors content;
  content.tensors["parameters"] = vector_tensor(state.parameters);
  content.tensors["first_moment"] = vector_tensor(state.optimiser.first_moment);
  content.tensors["second_moment"] = vector_tensor(state.optimiser.second_moment);
  content.tensors["rotations"] = vector_tensor(state.optimiser.rotations);
  PlainJson rivals = PlainJson::array();
  for (std::size_t i = 0; i < state.rivals.size(); ++i) {
    const ValidatedEpoch& rival = state.rivals[i];
    rivals.push_back(
        {{"epoch", rival.epoch}, {"error_m", rival.error_m}, {"members_m", rival.members_m}});
    content.tensors[rival_name(i)] = vector_tensor(rival.weights);
  }
  const PlainJson numbers = {{"epochs_done", state.epochs_done},
                             {"step", state.optimiser.step},
                             {"stage_first_loss", state.stage_first_loss},
                             {"elapsed_s", checkpoint.elapsed_s},
                             {"rivals", std::move(rivals)},
                             {"stages", to_json(checkpoint.stages)},
                             {"curve", to_json(state.curve)}};
  content.metadata = {
      {"schema", kSchema}, {"identity", checkpoint.identity}, {"state", numbers.dump()}};
  write_file_atomically(path, safetensors_bytes(content));
}

Checkpoint read_checkpoint(const fs::path& path, const std::string& identity, const RunShape& run) {
  return CheckpointReader(path, run).read(identity);
}

}  // namespace limber
