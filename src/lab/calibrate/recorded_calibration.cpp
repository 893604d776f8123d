#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "binomial_bound.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/lab/tube_calibration.hpp"
#include "limber/lab/tube_score.hpp"
#include "limber/world/pressure_box.hpp"

namespace limber {

namespace {

constexpr double kSameSetpointKpa = 0.06;  // a device that counts in mbar rounds to the nearest
constexpr double kMinPlateScale = 0.01;    // of the tip's

/// A shape without any run: errors grow in proportion along the arm, and its end is as wide as its
/// tip. Runs are few here, and none is spent on a shape.
Tube plain_shape(const ArmDescription& arm, const CompensationModel& model) {
  Tube tube;
  const int last = arm.point_count() - 1;
  for (int plate = 0; plate <= last; ++plate) {
    tube.plate_scale_m.push_back(0.01 * std::max(kMinPlateScale, double(plate) / last));
  }
  tube.end_scale_m = tube.plate_scale_m.back();
  tube.end_heading_scale_rad = 4.0 * tube.end_scale_m / arm.length_m();
  if (model.prediction_error && model.prediction_error->end_position_m > 0.0 &&
      model.prediction_error->end_orientation_rad.value_or(0.0) > 0.0) {
    tube.end_heading_scale_rad = tube.end_scale_m * *model.prediction_error->end_orientation_rad /
                                 model.prediction_error->end_position_m;
  }
  return tube;
}

/// @param same_kpa  largest difference of set points that are the same
void require_run_of(const Plan& plan, const Episode& run, double same_kpa,
                    const std::string& plan_file, const std::string& file) {
  const std::vector<int> shown = shown_frames(plan, run);
  for (int k = 1; k < std::min(plan.frame_count(), int(run.frame_count())); ++k) {
    const auto frame = std::size_t(shown[k]);
    const Pressures& planned = plan.frames[frame].setpoint_kpa;
    const double apart = (run.setpoint_kpa.row(k).transpose() - planned).cwiseAbs().maxCoeff();
    if (!(apart <= same_kpa)) {
      throw InputError(fmt::format(
          "{}: {}: set points are {:.3g} from those of {}: it is not that plan's run, open "
          "loop. Give --plans in the order of --recordings",
          file, frame_name(k), apart, plan_file));
    }
  }
  refuse_if(run.frame_count() < plan.frame_count(),
            "{}: {} frames; {} has {}: give runs that ended, open loop", file, run.frame_count(),
            plan_file, plan.frame_count());
}

double score_of(const RecordedCalibration& settings, std::size_t i, const Tube& shape,
                std::string& source) {
  const std::string file = settings.recordings[i].string();
  const Plan plan = read_plan(settings.plans[i]);
  require_plan_of(plan, settings.arm, settings.plans[i].string());
  if (plan.model_hash != settings.model_hash) {
    throw InputError(fmt::format("{}: made with another model (hash {}; --model has {})",
                                 settings.plans[i].string(), plan.model_hash, settings.model_hash));
  }
  const Recording recording = read_recording(file);
  require_sizes_of(recording, settings.arm, file);
  refuse_if(recording.episodes.size() != 1,
            "{}: {} episodes; expected 1, as limber execute --out writes it", file,
            recording.episodes.size());
  const Episode& run = recording.episodes.front();
  require_run_of(plan, run, kSameSetpointKpa * command_per_kpa(settings.arm),
                 settings.plans[i].string(), file);
  source = "recordings of " + recording.source;
  return tube_score(plan, run, shape);
}

/// The smallest of `scores` that at least `level` of all runs stay below, with that confidence; its
/// coverage has the distribution Beta(rank, n − rank + 1).
TubeLevel level_of(const std::vector<double>& scores, double level, double confidence) {
  const int runs = int(scores.size());
  for (int outside = runs - 1; outside >= 0; --outside) {
    if (share_at_most(outside, runs, confidence) <= 1.0 - level) {
      return {.level = level,
              .factor = scores[runs - 1 - outside],
              .runs = runs,
              .outside = outside,
              .confidence = confidence};
    }
  }
  throw InputError(fmt::format(
      "{} runs can't promise that {:.4g} % stay in any tube, {:.4g} % sure: the largest level is "
      "{:.3f} (--levels), or give at least {} runs",
      runs, 100.0 * level, 100.0 * confidence,
      std::floor(1e3 * std::pow(1.0 - confidence, 1.0 / runs)) / 1e3, min_runs(level, confidence)));
}

}  // namespace

void require_usable_levels(const std::vector<double>& levels, double confidence) {
  refuse_if(levels.empty() || std::adjacent_find(levels.begin(), levels.end(),
                                                 std::greater_equal<>()) != levels.end(),
            "--levels: expected rising shares, such as 0.9 0.95");
  for (const auto& [flag, share] :
       {std::pair{"--levels", levels.front()}, std::pair{"--levels", levels.back()},
        std::pair{"--confidence", confidence}}) {
    refuse_if(!(share > 0.0 && share < 1.0),
              "{}: a share of {}: expected more than 0 and less than 1", flag, share);
  }
}

Tube tube_from_recordings(const RecordedCalibration& settings) {
  refuse_if(settings.recordings.empty() || settings.plans.size() != settings.recordings.size(),
            "{} recordings and {} plans; expected one plan per recording",
            settings.recordings.size(), settings.plans.size());
  require_usable_levels(settings.levels, settings.confidence);
  std::map<std::string, std::string> path_of_hash;
  for (const fs::path& path : settings.recordings) {
    add_different(path_of_hash, path);  // a run counts once
  }
  Tube tube =
      settings.model.tube ? *settings.model.tube : plain_shape(settings.arm, settings.model);
  tube.levels.clear();
  auto scores = mapped<double>(settings.recordings.size(), [&](std::size_t i) {
    return score_of(settings, i, tube, tube.source);
  });
  std::sort(scores.begin(), scores.end());
  for (const double level : settings.levels) {
    tube.levels.push_back(level_of(scores, level, settings.confidence));
  }
  return tube;
}

}  // namespace limber
