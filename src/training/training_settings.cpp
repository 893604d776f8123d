#include "limber/training/training_settings.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/jobs.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

void require(bool usable, const char* name, double found, const char* allowed) {
  refuse_if(!usable, "training setting {} = {}; expected {}", name, found, allowed);
}

}  // namespace

const char* to_string(Optimiser optimiser) {
  switch (optimiser) {
    case Optimiser::sgd:
      return "sgd";
    case Optimiser::adam:
      return "adam";
    case Optimiser::soap:
      break;
  }
  return "soap";
}

int TrainingSettings::epoch_count() const {
  return sum_of<int>(stages, [&](const TrainingStage& stage) { return stage.epochs; });
}

TrainingSettings paper_preset() {
  TrainingSettings settings;
  settings.preset = "paper";
  settings.layout = BackboneLayout::base_poses;
  settings.form = OutputForm::compensation;
  settings.reads_velocity = false;
  settings.scaling = Scaling::unit_range;
  settings.reduction = LossReduction::sum_over_batch;
  settings.stages = {{32, 128, 6000}};
  settings.optimiser = Optimiser::sgd;
  settings.learning_rate = 1e-4;
  // The first batches' gradients are this long, later ones' a tenth of it: only exploding gradients
  // are ever shortened. Without a limit, one explodes after some hundred epochs.
  settings.gradient_norm_limit = 5000.0;
  settings.cosine_decay = false;
  settings.shift_windows = false;
  settings.validation_interval = 10;
  return settings;
}

TrainingSettings best_preset() {
  TrainingSettings settings;
  settings.hidden_units = {200};
  settings.stages = {{32, 32, 180}};
  settings.first_frames_power = 1.0;
  settings.optimiser = Optimiser::soap;
  settings.weight_decay = 0.1;
  settings.validation_interval = 2;
  settings.gradient_norm_limit = 1.0;
  settings.growth_limit = 1.5;
  return settings;
}

TrainingSettings training_preset(const std::string& name) {
  if (name == "paper") {
    return paper_preset();
  }
  if (name == "best") {
    return best_preset();
  }
  throw InputError(fmt::format("--preset {}: expected paper or best", name));
}

void set_epoch_count(TrainingSettings& settings, int epochs) {
  const int stages = int(settings.stages.size());
  refuse_if(epochs < stages,
            "{} epochs; preset '{}' has {} stages (windows of "
            "growing length) and needs at least one epoch each",
            epochs, settings.preset, stages);
  const int before = settings.epoch_count();
  int left = epochs;
  int left_before = before;
  for (int k = 0; k < stages; ++k) {
    TrainingStage& stage = settings.stages[k];
    const int share = int(std::lround(double(left) * stage.epochs / left_before));
    left_before -= stage.epochs;
    stage.epochs = std::clamp(share, 1, left - (stages - 1 - k));
    left -= stage.epochs;
  }
}

void set_window_frames(TrainingSettings& settings, const std::vector<int>& window_frames) {
  constexpr int kFramesInBatch = 1024;
  constexpr int kMaxWindows = 256;
  const int epochs = settings.epoch_count();
  settings.stages.clear();
  require(!window_frames.empty(), "windows", 0, "at least one stage");
  for (const int frames : window_frames) {
    require(frames >= 1, "stages.window_frames", frames, ">= 1");
    settings.stages.push_back({frames, std::clamp(kFramesInBatch / frames, 1, kMaxWindows), 1});
  }
  set_epoch_count(settings, epochs);
}

void take_adam_for_soap(TrainingSettings& settings) {
  if (settings.optimiser == Optimiser::soap) {
    settings.optimiser = Optimiser::adam;
    settings.weight_decay = 0.0;
    settings.first_frames_power = 0.0;
  }
}

void set_family_size(TrainingSettings& settings, int size) {
  constexpr int kWindowFrames = 32;
  constexpr int kValidationInterval = 25;
  // Lowers the error on other arms (docs/families.md).
  constexpr double kWeightDecay = 0.1;
  set_window_frames(settings, {kWindowFrames});
  settings.hidden_units = TrainingSettings().hidden_units;
  settings.first_frames_power = 0.0;
  settings.family_size = size;
  settings.optimiser = Optimiser::soap;
  settings.weight_decay = kWeightDecay;
  settings.validation_interval = kValidationInterval;
}

TrainingSettings in_form_of(const CompensationModel& model, TrainingSettings settings) {
  settings.layout = model.layout;
  settings.form = model.form;
  settings.reads_velocity = model.reads_velocity;
  settings.reads_past_commands = !model.past_commands.empty();
  settings.ensemble = model.member_count();
  settings.hidden_units.clear();
  for (std::size_t layer = 0; layer + 1 < model.layers.size(); ++layer) {
    settings.hidden_units.push_back(int(model.layers[layer].bias.size()));
  }
  return settings;
}

void require_usable(const TrainingSettings& settings) {
  require(!settings.stages.empty(), "stages", 0, "at least one");
  for (const TrainingStage& stage : settings.stages) {
    require(stage.window_frames >= 1, "stages.window_frames", stage.window_frames, ">= 1");
    require(stage.windows_per_batch >= 1, "stages.windows_per_batch", stage.windows_per_batch,
            ">= 1");
    require(stage.epochs >= 1, "stages.epochs", stage.epochs, ">= 1");
  }
  require(!settings.hidden_units.empty(), "hidden_units", 0, "at least one layer");
  for (const int units : settings.hidden_units) {
    require(units >= 1 && units <= 4096, "hidden_units", units, "1 to 4096 a layer");
  }
  const bool shared = settings.scaling == Scaling::shared_range;
  if ((shared || settings.scaling == Scaling::range_by_unit) &&
      (settings.form != OutputForm::compensation ||
       settings.layout != BackboneLayout::base_poses)) {
    throw InputError(fmt::format(
        "scaling = {} with output_form {} and layout {}; it is for compensation of base_poses",
        shared ? "shared_range" : "range_by_unit", to_string(settings.form),
        to_string(settings.layout)));
  }
  require(settings.jobs >= 0 && settings.jobs <= kMaxJobs, "jobs", settings.jobs,
          fmt::format("0 (one per core) to {}", kMaxJobs).c_str());
  const double rate = settings.learning_rate;
  require(std::isfinite(rate) && rate > 0.0, "learning_rate", rate, "a finite number > 0");
  require(std::isfinite(settings.time_limit_s) && settings.time_limit_s >= 0.0, "time_limit_s",
          settings.time_limit_s, "a finite number of seconds, 0: no limit");
  require(settings.gradient_norm_limit >= 0.0, "gradient_norm_limit", settings.gradient_norm_limit,
          ">= 0 (0: no limit)");
  require(std::isfinite(settings.growth_limit) && settings.growth_limit >= 0.0, "growth_limit",
          settings.growth_limit, "a finite number >= 0 (0: no limit)");
  require(std::isfinite(settings.first_frames_power) && settings.first_frames_power >= 0.0,
          "first_frames_power", settings.first_frames_power, "a finite number >= 0 (0: all alike)");
  require(settings.keep_epoch >= 0 && settings.keep_epoch <= settings.epoch_count(), "keep_epoch",
          settings.keep_epoch, "0 (the best one) to the number of epochs");
  require(settings.weight_decay >= 0.0, "weight_decay", settings.weight_decay, ">= 0 (0: none)");
  require(settings.weight_decay * rate < 1.0, "learning_rate", rate,
          fmt::format("below 1 / weight_decay ({:g})", settings.weight_decay).c_str());
  require(settings.ensemble >= 1 && settings.ensemble <= 64, "ensemble", settings.ensemble,
          "1 to 64 networks");
  require(settings.family_size >= 0 && settings.family_size <= ArmFamily::kMaxSize, "family_size",
          settings.family_size, "0 to 64 numbers");
  require(settings.family_size == 0 || settings.ensemble == 1, "ensemble", settings.ensemble,
          "1 network for a family");
  require(settings.replay_share >= 0.0 && settings.replay_share <= 0.95, "replay_share",
          settings.replay_share, "0 to 0.95");
  require(settings.validation_interval >= 1, "validation_interval", settings.validation_interval,
          ">= 1");
}

}  // namespace limber
