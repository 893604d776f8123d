#include "run_identity.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"

namespace limber {

namespace {

bool same_windows(const std::vector<TrainingStage>& a, const std::vector<TrainingStage>& b) {
  return std::ranges::equal(a, b, [](const TrainingStage& x, const TrainingStage& y) {
    return x.window_frames == y.window_frames && x.windows_per_batch == y.windows_per_batch;
  });
}

std::string in_words(const std::vector<TrainingStage>& stages) {
  std::string text;
  for (const TrainingStage& stage : stages) {
    text += fmt::format("{}{} epochs of {}-frame windows, {} per batch", text.empty() ? "" : ", ",
                        stage.epochs, stage.window_frames, stage.windows_per_batch);
  }
  return text;
}

}  // namespace

std::string run_identity(const ArmDescription& arm, const TrainingData& data,
                         const TrainingSettings& settings, const EpochTrainer& trainer) {
  const TrainingSettings& s = settings;
  std::string text =
      fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {}", arm.hash(),
                  s.preset, fmt::join(s.hidden_units, "-"), int(s.layout), to_string(s.form),
                  s.reads_velocity, s.growth_limit, kFirstGateBias, int(s.scaling),
                  s.error_in_base_poses, s.error_in_user_units, s.bounded, int(s.reduction),
                  int(s.optimiser), s.learning_rate, s.cosine_decay, s.gradient_norm_limit,
                  s.weight_decay, s.shift_windows, s.validation_interval, s.ensemble, s.seed);
  if (s.family_size > 0) {
    text += fmt::format(" family {} {}", s.family_size, fmt::join(data.arms, " "));
  }
  if (s.keep_epoch > 0 || s.first_frames_power > 0) {
    text += fmt::format(" epoch {} power {}", s.keep_epoch, s.first_frames_power);
  }
  if (!data.replay.empty()) {
    text += fmt::format(" replay {} of {} episodes", s.replay_share, data.replay.size());
  }
  const FrameTable<float>& frames = trainer.tables().frames;
  text += content_hash(number_bytes(frames.pressure)) + content_hash(number_bytes(frames.state));
  text += content_hash(number_bytes(trainer.state().parameters));  // the weights that it began with
  const GapBounds& bounds = trainer.survey().bounds;
  for (const Eigen::VectorXf* bound :
       {&bounds.min_length_m, &bounds.max_length_m, &bounds.min_turn_rad, &bounds.max_turn_rad,
        &bounds.max_bend_rad}) {
    text += content_hash(number_bytes(*bound));
  }
  text += content_hash(std::string(frames.tracked.begin(), frames.tracked.end()));
  text += trainer.survey().content + hash_of(data.validation);
  return content_hash(text);
}

void require_same_stages(const TrainingSettings& settings,
                         const std::vector<TrainingStage>& begun) {
  // A time limit fixed the epochs of the run that began, and these alone.
  const bool same =
      settings.time_limit_s > 0.0 ? same_windows(settings.stages, begun) : settings.stages == begun;
  if (!same) {
    throw InputError(
        fmt::format("{}: the checkpoint of a run of {}; this one is to be {}. Give the --epochs or "
                    "--time-limit-s that it was started with, or leave out --resume to start over",
                    settings.checkpoint.string(), in_words(begun), in_words(settings.stages)));
  }
}

}  // namespace limber
