#include "limber/report/training_report.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/json.hpp"
#include "limber/plot/chart.hpp"
#include "limber/training/training_benchmark.hpp"

namespace limber {

namespace {

Json to_json(const std::optional<FineTuningReport::Change>& change) {
  return change ? Json{{"before", to_json(change->before)}, {"after", to_json(change->after)}}
                : Json();
}

std::string row(const char* name, const RolloutErrors& errors) {
  return fmt::format("{:<24} {:8.2f} {:9.2f} {:10.2f} {:9.2f}\n", name,
                     errors.one_step.position_cm.mean, errors.window_32.position_cm.mean,
                     errors.per_motion.position_cm.mean, errors.open_loop.position_cm.mean);
}

}  // namespace

Json to_json(const FineTuningReport& report) {
  return {{"new_data", to_json(report.new_data)}, {"old_data", to_json(report.old_data)}};
}

std::string to_text(const FineTuningReport& report) {
  std::string text = fmt::format("{:<24} {:>8} {:>9} {:>10} {:>9}\n", "tip error [cm], held back",
                                 "one step", "32 frames", "per motion", "open loop");
  if (report.new_data) {
    text += row("new data, before", report.new_data->before);
    text += row("new data, after", report.new_data->after);
  }
  if (report.old_data) {
    text += row("old data, before", report.old_data->before);
    text += row("old data, after", report.old_data->after);
  }
  return text;
}

Json to_json(const TrainingSpeed& speed) {
  Json json = {{"preset", speed.preset},     {"shape", speed.shape},     {"layout", speed.layout},
               {"networks", speed.networks}, {"threads", speed.threads}, {"frames", speed.frames}};
  json["stages"] = Json::array();
  for (const StageSpeed& stage : speed.stages) {
    json["stages"].push_back({{"window_frames", stage.window_frames},
                              {"windows_per_batch", stage.windows_per_batch},
                              {"windows", stage.windows},
                              {"epoch_s", stage.epoch_s},
                              {"gmac_per_s", stage.multiply_adds / stage.epoch_s / 1e9},
                              {"fma_peak_gmac_per_s", stage.peak_gmac_per_s},
                              {"fma_peak_difference", stage.peak_difference},
                              {"fraction_of_fma_peak", stage.fraction_of_fma_peak},
                              {"first_epoch_loss", stage.first_epoch_loss}});
  }
  return json;
}

std::string to_text(const TrainingSpeed& speed) {
  std::string text = fmt::format(
      "preset {}, {} ({}), {} frames, {} threads{}\n", speed.preset, speed.shape, speed.layout,
      speed.frames, speed.threads,
      speed.networks > 1 ? fmt::format(", {} networks", speed.networks) : std::string());
  for (const StageSpeed& stage : speed.stages) {
    text += fmt::format(
        "  windows of {:>2} frames, batches of {:>4}: {:7.1f} ms per epoch, {:6.1f} GMAC/s, {:.1f} "
        "% of the FMA peak of {:.1f} ({:.0f} % apart)\n",
        stage.window_frames, stage.windows_per_batch, 1e3 * stage.epoch_s,
        stage.multiply_adds / stage.epoch_s / 1e9, 100.0 * stage.fraction_of_fma_peak,
        stage.peak_gmac_per_s, 100.0 * stage.peak_difference);
  }
  return text;
}

std::string learning_curve_svg(const std::vector<LearningCurvePoint>& curve) {
  std::vector<double> epoch, loss, validated_epoch, error_cm;
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
