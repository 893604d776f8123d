#include "limber/training/trainer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "learnt_kind.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/episode_slice.hpp"
#include "rollout.hpp"
#include "shuffle.hpp"
#include "training_run.hpp"

namespace limber {

namespace {

// Streams of the seed that choose which episodes are held back, and for what.
constexpr std::uint64_t kValidationStream = 0;
constexpr std::uint64_t kUnseenStream = 0x756e7365656e;
// Of all frames: a drawn episode that is longer would leave too little to learn from.
constexpr double kTooMuch = 0.4;
constexpr int kMinUnseenFrames = 20;  // of an episode's end: less says nothing about a prediction

/// The last tracked frame that has another at most `frames` before it; −1 if there is none.
int last_measured_frame(const Episode& episode, int frames) {
  const std::vector<int> tracked = tracked_frames(episode);
  for (std::size_t i = tracked.size(); i > 1; --i) {
    if (tracked[i - 1] - tracked[i - 2] <= frames) {
      return tracked[i - 1];
    }
  }
  return -1;
}

/// Whether an error can be measured over it.
bool tells_an_error(const Episode& episode) {
  return last_measured_frame(episode, kValidationFrames) >= 0;
}

/// Frames of an episode of which something may be held back; of others 0.
int telling_frames(const Episode& episode) {
  return tells_an_error(episode) ? episode.frame_count() : 0;
}

std::int64_t telling_frames(const std::vector<Episode>& episodes) {
  return sum_of<std::int64_t>(episodes,
                              [&](const Episode& episode) { return telling_frames(episode); });
}

std::vector<Episode>::iterator longest_telling(std::vector<Episode>& episodes) {
  return std::ranges::max_element(episodes, {}, [](const Episode& e) { return telling_frames(e); });
}

/// Moves whole episodes that tell an error from `from` to `to`, in an order sampled by (seed,
/// stream), until `frames` would be exceeded: one at least goes, and one at least stays. Gives the
/// numbers of those that went. @pre two of them or more
std::vector<int> hold_back(std::vector<Episode>& from, std::vector<Episode>& to, double frames,
                           std::uint64_t seed, std::uint64_t stream) {
  std::vector<std::size_t> order(from.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  RandomStream random(seed, stream);
  shuffle(random, order);
  std::erase_if(order, [&](std::size_t i) { return !tells_an_error(from[i]); });
  std::int64_t held = 0;
  std::vector<bool> is_held(from.size(), false);
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const int count = from[order[i]].frame_count();
    if (held > 0 && double(held + count) > frames) {
      break;
    }
    is_held[order[i]] = true;
    held += count;
  }
  std::vector<Episode> kept;
  std::vector<int> numbers;
  for (std::size_t i = 0; i < from.size(); ++i) {
    (is_held[i] ? to : kept).push_back(std::move(from[i]));
    if (is_held[i]) {
      numbers.push_back(int(i));
    }
  }
  from = std::move(kept);
  return numbers;
}

/// Moves the last `frames` of an episode, up to the last in which an error can be measured; what is
/// behind them was not tracked, and goes. Where it was tracked for less, half of that moves.
void hold_back_end(Episode& from, int frames, std::vector<Episode>& to) {
  const int last = last_measured_frame(from, frames - 1);
  const int end = last < 0 ? from.frame_count() : last + 1;
  const int kept = end > frames ? end - frames : end / 2;
  to.push_back(slice(from, kept, end - kept));
  from = slice(from, 0, kept);
}

}  // namespace

TrainingData hold_back_validation(std::vector<Episode> episodes, double fraction,
                                  std::uint64_t seed) {
  refuse_if(!(fraction > 0.0 && fraction < 1.0) || episodes.empty(),
            "{} of {} episodes can't be held back for validation; expected a "
            "share of the frames above 0 and below 1, and an episode",
            fraction, episodes.size());
  TrainingData data;
  data.training = std::move(episodes);
  const auto telling = std::ranges::count_if(data.training, tells_an_error);
  refuse_if(
      telling == 0,
      "no frame of {} episodes was tracked behind another: no error can be measured to choose "
      "the best epoch by; look at them with limber inspect, or give others with --validation",
      data.training.size());
  const double all = double(telling_frames(data.training));
  const double frames = fraction * all;
  const int wanted = int(std::lround(frames));
  const auto longest = longest_telling(data.training);
  const bool is_alone = telling == 1;
  if (is_alone && (wanted < 1 || wanted >= longest->frame_count())) {
    throw InputError(fmt::format(
        "{} frames are too few to hold some of them back for validation; give more with --data, "
        "or a recording of its own with --validation",
        longest->frame_count()));
  }
  const double too_much = std::max(2.0 * frames, kTooMuch * all);
  if (is_alone || (wanted > 0 && longest->frame_count() > too_much)) {
    data.held_back = {int(longest - data.training.begin())};
    hold_back_end(*longest, wanted, data.validation);
    return data;
  }
  data.held_back = hold_back(data.training, data.validation, frames, seed, kValidationStream);
  return data;
}

void hold_back_unseen(TrainingData& data, double fraction, std::uint64_t seed) {
  refuse_if(!(fraction >= 0.0 && fraction < 1.0),
            "a share of {} can't be held back as unseen; expected a share of "
            "the frames from 0 to below 1",
            fraction);
  if (fraction == 0.0) {
    return;
  }
  const std::int64_t all = telling_frames(data.training) + telling_frames(data.validation);
  const double frames = fraction * double(all);
  const int wanted = int(std::lround(frames));
  const auto telling = std::ranges::count_if(data.training, tells_an_error);
  if (telling == 0) {
    return;
  }
  const auto longest = longest_telling(data.training);
  // With few long episodes, whole ones would take too much away from training.
  if (longest->frame_count() > 2 * wanted) {
    if (wanted >= kMinUnseenFrames) {
      hold_back_end(*longest, wanted, data.unseen);
    }
  } else if (telling > 1) {
    hold_back(data.training, data.unseen, frames, seed, kUnseenStream);
  }
}

TrainingData hold_back_arms(std::vector<Episode> episodes, const std::vector<int>& arms,
                            double fraction, std::uint64_t seed) {
  refuse_if(
      arms.size() != episodes.size() || !(fraction >= 0.0 && fraction < 1.0),
      "{} arms for {} episodes, of which a share of {} is to be held back; expected an arm for "
      "each episode, and a share from 0 to below 1",
      arms.size(), episodes.size(), fraction);
  std::vector<int> order = arms;
  std::ranges::sort(order);
  order.erase(std::unique(order.begin(), order.end()), order.end());
  RandomStream random(seed, kValidationStream);
  shuffle(random, order);
  const std::size_t held = order.size() < kMinArmsToHoldBack
                               ? 0
                               : std::size_t(std::lround(fraction * double(order.size())));
  TrainingData data;
  data.physics.resize(order.size() - held);
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    const auto place = std::size_t(std::ranges::find(order, arms[i]) - order.begin());
    if (place < held) {
      data.validation.push_back(std::move(episodes[i]));
      data.held_back.push_back(int(i));
    } else {
      data.physics[place - held] = episodes[i].physics;
      data.training.push_back(std::move(episodes[i]));
      data.arms.push_back(int(place - held));
    }
  }
  return data;
}

void add_arms_of(const Recording& recording, std::vector<int>& arms) {
  const int first = arms.empty() ? 0 : 1 + std::ranges::max(arms);
  std::map<std::string, int> numbers;
  for (const Episode& episode : recording.episodes) {
    const int next = first + int(numbers.size());
    arms.push_back(numbers.try_emplace(episode.physics, next).first->second);
  }
}

void add_mirrored_arms(const ArmDescription& arm, TrainingData& data) {
  if (data.arms.empty() || arm.is_spatial() ||
      !std::ranges::all_of(arm.segments, [](const Segment& segment) {
        return segment.pressure_limit_kpa.is_symmetric();
      })) {
    return;
  }
  const int arms = 1 + std::ranges::max(data.arms);
  const std::size_t episodes = data.training.size();
  for (std::size_t i = 0; i < episodes; ++i) {
    data.training.push_back(mirrored(data.training[i]));
    data.arms.push_back(arms + data.arms[i]);
  }
}

TrainingResult train(const ArmDescription& arm, const TrainingData& data,
                     const TrainingSettings& settings, const TrainingHooks& hooks) {
  return TrainingRun(arm, data, settings, nullptr, hooks).run();
}

TrainingResult fine_tune(const ArmDescription& arm, const TrainingData& data,
                         const TrainingSettings& settings, const CompensationModel& start,
                         const TrainingHooks& hooks) {
  require_model_of(start, arm, "the model to start from");
  validate(start, "the model to start from");
  require_data_of(data, arm);
  require_kind_learnt(start, data.training);
  return TrainingRun(arm, data, settings, &start, hooks).run();
}

void write_learning_curve_csv(const fs::path& path, const std::vector<LearningCurvePoint>& curve) {
  std::string text =
      "epoch,window_frames,learning_rate,loss,validation_position_error_cm,elapsed_s\n";
  for (const LearningCurvePoint& point : curve) {
    const double error = point.validation_position_error_cm;
    text += fmt::format("{},{},{:.6g},{:.6g},{},{:.3f}\n", point.epoch, point.window_frames,
                        point.learning_rate, point.loss,
                        std::isnan(error) ? std::string() : fmt::format("{:.5g}", error),
                        point.elapsed_s);
  }
  write_file_atomically(path, text);
}

}  // namespace limber
