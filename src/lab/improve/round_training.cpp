#include "round_training.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/training/learnt_region_fit.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/unseen_error.hpp"
#include "run_roles.hpp"

namespace limber {

namespace {

TrainingResult trained(const ImproveSettings& settings, TrainingSettings training,
                       const CompensationModel& from, const TrainingData& data) {
  if (settings.from_start) {
    return train(settings.arm, with_replay_as_data(data), in_form_of(from, std::move(training)));
  }
  return fine_tune(settings.arm, settings.prior_file.empty() ? data : with_replay_as_data(data),
                   training, from);
}

}  // namespace

CompensationModel learn_round(const ImproveSettings& settings, const CompensationModel& start,
                              const CompensationModel& from, const std::string& from_hash,
                              const TrainingData& data, const std::string& sources) {
  TrainingSettings training = settings.training;
  training.seed = settings.seed;
  training.jobs = settings.jobs;
  training.progress = settings.progress;
  TrainingResult result = trained(settings, std::move(training), from, data);
  throw_if_interrupted();
  if (result.status == TrainingStatus::diverged) {
    throw SystemFault("training diverged: " + result.message);
  }
  CompensationModel& model = result.model;
  model.set_valves(start.valves ? start.identified_valves()
                                : identify_valves(data.training, settings.arm, sources));
  model.learnt = learnt_region_of(data, start.learnt ? &*start.learnt : nullptr);
  note_unseen(settings.arm, model, data.unseen, settings.jobs);
  model.prediction_error = kept_error(start.prediction_error, model.prediction_error);
  const auto known = start.training.find("data");
  model.training["data"] = known == start.training.end() ? sources : known->second + ", " + sources;
  model.training["from"] = from_hash;
  model.training["validation"] = "limber improve: of ten runs of a recording, run 1";
  return std::move(model);
}

TrainingData with_replay_as_data(TrainingData data) {
  for (std::size_t i = 0; i < data.replay.size(); ++i) {
    const bool validates = role_of(static_cast<int>(i)) == RunRole::validation;
    (validates ? data.validation : data.training).push_back(std::move(data.replay[i]));
  }
  data.replay.clear();
  return data;
}

std::optional<PredictionError> kept_error(const std::optional<PredictionError>& known,
                                          const std::optional<PredictionError>& measured) {
  if (!measured || !known || measured->runs >= kMinRunsForError) {
    return measured ? measured : known;
  }
  PredictionError kept = *known;
  kept.max_position_m = std::max(kept.max_position_m, measured->max_position_m);
  kept.off_path_m = std::max(kept.off_path_m, measured->off_path_m);
  kept.end_position_m = std::max(kept.end_position_m, measured->end_position_m);
  kept.end_orientation_rad = std::max(kept.end_orientation_rad, measured->end_orientation_rad);
  return kept;
}

}  // namespace limber
