#include "run_identity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/content_hash.hpp"

namespace limber {

std::string run_identity(const ArmDescription& arm, const TrainingData& data,
                         const TrainingSettings& settings, const EpochTrainer& trainer) {
  const TrainingSettings& s = settings;
  std::string text = fmt::format(
      "{} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {}", arm.hash(), s.preset,
      fmt::join(s.hidden_units, "-"), static_cast<int>(s.layout), to_string(s.form),
      s.reads_velocity, s.growth_limit, kFirstGateBias, static_cast<int>(s.scaling),
      s.error_in_base_poses, s.error_in_user_units, s.bounded, static_cast<int>(s.reduction),
      static_cast<int>(s.optimiser), s.learning_rate, s.cosine_decay, s.gradient_norm_limit,
      s.weight_decay, s.average_decay, s.shift_windows, s.validation_interval, s.ensemble, s.seed);
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

}  // namespace limber
