#include "round_figures.hpp"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

std::optional<double> ratio(double of, double over) {
  return of > 0.0 && over > 0.0 ? std::optional<double>(of / over) : std::nullopt;
}

Json number(const std::optional<double>& value, double factor = 1.0) {
  return value ? Json(*value * factor) : Json(nullptr);
}

Json to_json(const PlanFigures& figures) {
  return {{"environments", figures.environments},
          {"solved", figures.solved},
          {"executed", figures.executed},
          {"collided", figures.collided},
          {"arrived", figures.arrived},
          {"distance_to_goal_cm",
           {{"mean", number(figures.mean_m, kCmPerM)},
            {"standard_error", number(figures.standard_error_m, kCmPerM)},
            {"median", number(figures.median_m, kCmPerM)}}}};
}

Json to_json(const OpenLoopError& error) {
  if (error.runs == 0) {
    return nullptr;
  }
  return {{"runs", error.runs},
          {"mean", kCmPerM * error.mean_m},
          {"largest", kCmPerM * error.largest_m}};
}

}  // namespace

PlanFigures figures_of(const std::vector<PlanRun>& runs) {
  PlanFigures figures;
  std::vector<double> distances;
  for (const PlanRun& run : runs) {
    ++figures.environments;
    figures.solved += run.status == "solved" ? 1 : 0;
    figures.executed += run.executed ? 1 : 0;
    figures.collided += run.collided ? 1 : 0;
    figures.arrived += run.arrived ? 1 : 0;
    if (run.distance_m) {
      distances.push_back(*run.distance_m);
    }
  }
  if (distances.empty()) {
    return figures;
  }
  figures.mean_m = mean(distances);
  if (distances.size() > 1) {
    figures.standard_error_m = standard_error(distances);
  }
  figures.median_m = median(std::move(distances));
  return figures;
}

EndDistances end_distances(const std::vector<PlanRun>& runs) {
  EndDistances distances;
  for (const PlanRun& run : runs) {
    distances.push_back(run.distance_m);
  }
  return distances;
}

std::optional<double> RoundFigures::mean_error_ratio() const {
  return ratio(on_plans.mean_m, on_motions.mean_m);
}

std::optional<double> RoundFigures::largest_error_ratio() const {
  return ratio(on_plans.largest_m, on_motions.largest_m);
}

Json to_json(const RoundFigures& figures) {
  Json json = {{"round", figures.round},
               {"model_hash", figures.model_hash},
               {"learning_arm_time_min", figures.learning_min},
               {"learning_ventings", figures.learning_ventings},
               {"judging_arm_time_min", figures.judging_min},
               {"selection", to_json(figures.selection)},
               {"reported", to_json(figures.reported)},
               {"error_on_plans_cm", to_json(figures.on_plans)},
               {"error_on_random_motions_cm", to_json(figures.on_motions)},
               {"error_ratio",
                {{"mean", number(figures.mean_error_ratio())},
                 {"largest", number(figures.largest_error_ratio())}}}};
  json["prediction_error"] =
      figures.prediction_error ? to_json(*figures.prediction_error) : Json(nullptr);
  return json;
}

std::string to_text(const RoundFigures& figures) {
  const PlanFigures& plans = figures.reported;
  const auto cm = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.2f}", kCmPerM * *value) : std::string("–");
  };
  const std::optional<double> errors = figures.mean_error_ratio();
  return fmt::format(
      "round {}: {:.1f} min learnt from; {} of {} plans arrive, {} collide; {} ± {} cm off, median "
      "{}; error on plans over random motions {}",
      figures.round, figures.learning_min, plans.arrived, plans.environments, plans.collided,
      cm(plans.mean_m), cm(plans.standard_error_m), cm(plans.median_m),
      errors ? fmt::format("{:.2f}", *errors) : "–");
}

Json improve_summary(const ImproveSettings& settings, const std::vector<RoundFigures>& rounds,
                     const RoundChoice& choice) {
  Json json = {{"schema", "limber/improve-summary/1"},
               {"arm", settings.arm.name},
               {"seed", settings.seed},
               {"best_round", choice.best},
               {"model_hash", rounds[static_cast<std::size_t>(choice.best)].model_hash},
               {"stopped_early", choice.rounds_without_gain >= kMaxRoundsWithoutGain},
               {"rounds", Json::array()}};
  for (const RoundFigures& round : rounds) {
    Json one = to_json(round);
    one["gain_cm"] = nullptr;
    if (round.round > 0) {
      const auto index = static_cast<std::size_t>(round.round) - 1;
      const DistanceGain& gain = choice.gains[index];
      one["gain_cm"] = {{"over_round", choice.references[index]},
                        {"pairs", gain.pairs},
                        {"mean", kCmPerM * gain.mean_m},
                        {"standard_error", kCmPerM * gain.standard_error_m},
                        {"clear", gain.is_clear()}};
    }
    json["rounds"].push_back(std::move(one));
  }
  return json;
}

}  // namespace limber
