#include "limber/training/trainer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/plot/chart.hpp"
#include "training_run.hpp"

namespace limber {

namespace {

/// Frames [first, first + count) as an episode of their own.
Episode slice(const Episode& episode, int first, int count) {
  Episode part;
  part.time_s = episode.time_s.segment(first, count);
  part.pressure_kpa = episode.pressure_kpa.middleRows(first, count);
  part.setpoint_kpa = episode.setpoint_kpa.middleRows(first, count);
  part.backbone = episode.backbone.middleRows(first, count);
  part.motion_index.assign(episode.motion_index.begin() + first,
                           episode.motion_index.begin() + first + count);
  if (!episode.tracked.empty()) {
    part.tracked.assign(episode.tracked.begin() + first, episode.tracked.begin() + first + count);
  }
  return part;
}

}  // namespace

TrainingData hold_back_validation(std::vector<Episode> episodes, double fraction,
                                  std::uint64_t seed) {
  TrainingData data;
  if (episodes.size() == 1) {
    const Episode& whole = episodes.front();
    const int held = static_cast<int>(std::lround(fraction * whole.frame_count()));
    if (held < 1 || held >= whole.frame_count()) {
      throw InputError(fmt::format(
          "{} frames are too few to hold some of them back for validation; give more with --data, "
          "or a recording of its own with --validation",
          whole.frame_count()));
    }
    data.training.push_back(slice(whole, 0, whole.frame_count() - held));
    data.validation.push_back(slice(whole, whole.frame_count() - held, held));
    return data;
  }
  std::int64_t frames = 0;
  for (const Episode& episode : episodes) {
    frames += episode.frame_count();
  }
  // Whole episodes in a seeded order until the fraction is held back, one at least staying.
  std::vector<std::size_t> order(episodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  RandomStream random(seed, 0);
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[random.index(static_cast<std::uint32_t>(i))]);
  }
  std::int64_t held = 0;
  std::vector<bool> is_held(episodes.size(), false);
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const int count = episodes[order[i]].frame_count();
    if (held > 0 && static_cast<double>(held + count) > fraction * static_cast<double>(frames)) {
      break;
    }
    is_held[order[i]] = true;
    held += count;
  }
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    (is_held[i] ? data.validation : data.training).push_back(std::move(episodes[i]));
  }
  return data;
}

TrainingResult train(const ArmDescription& arm, const TrainingData& data,
                     const TrainingSettings& settings) {
  return TrainingRun(arm, data, settings, nullptr).run();
}

TrainingResult fine_tune(const ArmDescription& arm, const TrainingData& data,
                         const TrainingSettings& settings, const CompensationModel& start) {
  require_model_of(start, arm, "the model to start from");
  return TrainingRun(arm, data, settings, &start).run();
}

void write_learning_curve_csv(const std::filesystem::path& path,
                              const std::vector<LearningCurvePoint>& curve) {
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

std::string learning_curve_svg(const std::vector<LearningCurvePoint>& curve) {
  std::vector<double> epoch;
  std::vector<double> loss;
  std::vector<double> validated_epoch;
  std::vector<double> error_cm;
  Chart losses("Training loss");
  for (const LearningCurvePoint& point : curve) {
    if (!epoch.empty() && point.window_frames != curve[epoch.size() - 1].window_frames) {
      losses.vertical_line(fmt::format("windows of {}", point.window_frames), point.epoch);
    }
    epoch.push_back(point.epoch);
    loss.push_back(point.loss);
    if (!std::isnan(point.validation_position_error_cm)) {
      validated_epoch.push_back(point.epoch);
      error_cm.push_back(point.validation_position_error_cm);
    }
  }
  losses.x_axis("epoch").y_axis("mean frame error [normalised]").logarithmic_y();
  losses.line("loss", epoch, loss);
  Chart validation("Validation: open-loop tip error");
  validation.x_axis("epoch").y_axis("position error [cm]").logarithmic_y().without_legend();
  validation.line("validation", validated_epoch, error_cm);
  return ChartGrid(2).add(losses).add(validation).svg();
}

}  // namespace limber
