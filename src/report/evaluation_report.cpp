#include "limber/report/training_report.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/mapped.hpp"

namespace limber {

namespace {

constexpr double kTooMuchNoise = 10.0;  // times: networks that learnt with noise have 1 to 4

Json to_json(const ErrorStatistics& value) {
  return {{"mean", json_number(value.mean)},
          {"std", json_number(value.std)},
          {"p95", json_number(value.p95)},
          {"worst_motion", json_number(value.worst_motion)}};
}

std::string cells(const ErrorStatistics& value, int digits) {
  std::string text;
  for (const double one : {value.mean, value.std, value.p95, value.worst_motion}) {
    text += std::isfinite(one) ? fmt::format(" {:6.{}f}", one, digits) : fmt::format(" {:>6}", "-");
  }
  return text;
}

std::string row(const char* name, const TipErrors& errors) {
  return fmt::format("{:<32}{}  {}\n", name, cells(errors.position_cm, 2),
                     cells(errors.orientation_rad, 3));
}

Json to_json(const NovelFrames& novel) {
  const auto count = [](const NovelFrames::Count& frames) {
    return Json{{"frames", frames.frames}, {"novel", frames.novel}};
  };
  return {{"pressures_within", count(novel.pressures_within)},
          {"pressures_beyond", count(novel.pressures_beyond)}};
}

std::string to_text(const NovelFrames& novel, const Command& command) {
  const auto share = [](const NovelFrames::Count& frames) {
    return frames.frames == 0
               ? "none"
               : fmt::format("{:.1f} % of {}", 100.0 * double(frames.novel) / double(frames.frames),
                             frames.frames);
  };
  return fmt::format(
      "frames beyond what the model learnt from: {} with {}s that it knows, {} with others\n",
      share(novel.pressures_within), followed_name(command), share(novel.pressures_beyond));
}

Json to_json(const EnsembleErrors& errors) {
  Json json = to_json(errors.mean);
  json["spread"] = {{"mean_cm", json_number(errors.spread.mean_cm)},
                    {"rank_correlation", json_number(errors.spread.rank_correlation)},
                    {"covered_by_two", json_number(errors.spread.covered_by_two)},
                    {"factor_for_95", json_number(errors.spread.factor_for_95)}};
  return json;
}

std::string row(const char* name, const EnsembleErrors& errors) {
  const ErrorStatistics& p = errors.mean.position_cm;
  const SpreadStatistics& s = errors.spread;
  return fmt::format("{:<32} {:7.2f} {:7.2f} {:7.2f}   {:7.2f} {:11.2f} {:8.0f} % {:8.1f}\n", name,
                     p.mean, p.std, p.p95, s.mean_cm, s.rank_correlation, 100.0 * s.covered_by_two,
                     s.factor_for_95);
}

}  // namespace

Json to_json(const std::vector<TraitEstimate>& traits) {
  return mapped<Json>(traits, [&](const TraitEstimate& trait) {
    return Json{{"name", trait.name},
                {"value", trait.value},
                {"sd", trait.deviation},
                {"reference", trait.reference}};
  });
}

Json to_json(const std::vector<ArmChange>& changes) {
  return mapped<Json>(changes, [&](const ArmChange& change) { return to_json(change); });
}

Json to_json(const TipErrors& value) {
  return {{"position_error_cm", to_json(value.position_cm)},
          {"orientation_error_rad", to_json(value.orientation_rad)},
          {"plates_error_cm", to_json(value.plates_cm)}};
}

Json to_json(const RolloutErrors& errors) {
  return {{"one_step", to_json(errors.one_step)},
          {"one_step_moving", to_json(errors.one_step_moving)},
          {"window_32", to_json(errors.window_32)},
          {"per_motion", to_json(errors.per_motion)},
          {"open_loop", to_json(errors.open_loop)}};
}

Json to_json(const LongRollout& rollout) {
  return {{"frames", rollout.frames},
          {"largest_distance_m", rollout.max_distance_m},
          {"largest_heading_rad", rollout.max_heading_rad},
          {"bounded", rollout.bounded},
          {"held_share", rollout.held_share}};
}

Json to_json(const Evaluation& evaluation) {
  Json json;
  json["frames"] = evaluation.frames;
  json["no_load"]["open_loop"] = to_json(evaluation.no_load_open_loop);
  json["network"] = nullptr;
  if (evaluation.network) {
    const std::optional<TipErrors>& planned = evaluation.network->open_loop_from_setpoints;
    json["network"] = to_json(*evaluation.network);
    json["network"]["open_loop_from_setpoints"] = planned ? to_json(*planned) : Json();
    json["noise_multiplied"] = evaluation.noise_multiplied;
    json["long_rollout"] = to_json(evaluation.long_rollout);
    json["novel_frames"] = evaluation.novel ? to_json(*evaluation.novel) : Json();
  }
  Json& baselines = json["baselines"];
  baselines["hold"] = {{"one_step", to_json(evaluation.hold_one_step)},
                       {"one_step_moving", to_json(evaluation.hold_one_step_moving)}};
  baselines["constant_velocity"] = {
      {"one_step", to_json(evaluation.constant_velocity_one_step)},
      {"one_step_moving", to_json(evaluation.constant_velocity_one_step_moving)}};
  json["reduction_percent"] = nullptr;
  if (evaluation.network) {
    json["reduction_percent"] = {
        {"position", json_number(evaluation.position_reduction_percent)},
        {"orientation", json_number(evaluation.orientation_reduction_percent)}};
  }
  return json;
}

std::string to_text(const Evaluation& evaluation) {
  const std::string columns = fmt::format("{:>6} {:>6} {:>6} {:>6}", "mean", "std", "p95", "worst");
  std::string text = fmt::format("{:<32} {:>27}   {:>27}\n{:<32} {}   {}\n",
                                 fmt::format("{} frames", evaluation.frames), "tip position [cm]",
                                 "tip orientation [rad]", "", columns, columns);
  text += row("no load, open loop", evaluation.no_load_open_loop);
  if (evaluation.network) {
    text += row("network, open loop", evaluation.network->open_loop);
    if (evaluation.network->open_loop_from_setpoints) {
      text += row("network, open loop, set points", *evaluation.network->open_loop_from_setpoints);
    }
    text += row("network, per motion", evaluation.network->per_motion);
    text += row("network, 32-frame windows", evaluation.network->window_32);
    text += row("network, one step", evaluation.network->one_step);
    text += row("network, one step, moving", evaluation.network->one_step_moving);
  }
  text += row("hold the pose, one step", evaluation.hold_one_step);
  text += row("hold the pose, one step, moving", evaluation.hold_one_step_moving);
  text += row("constant velocity, one step", evaluation.constant_velocity_one_step);
  text += row("the same, moving", evaluation.constant_velocity_one_step_moving);
  text +=
      "worst: the mean over the worst motion; moving: over "
      "frames in which the tip moves; -: there are none\n";
  if (evaluation.network) {
    const bool has_headings = std::isfinite(evaluation.no_load_open_loop.orientation_rad.mean);
    text += fmt::format("open loop, the network's errors are {:.1f} %{} smaller\n",
                        evaluation.position_reduction_percent,
                        has_headings
                            ? fmt::format(" and {:.1f} %", evaluation.orientation_reduction_percent)
                            : std::string());
    const LongRollout& rollout = evaluation.long_rollout;
    text += fmt::format(
        "{} frames without correction: {}, no plate is farther than {:.2f} m; in {:.1f} % of them "
        "the model's bounds held a gap\n",
        rollout.frames, rollout.bounded ? "bounded" : "NOT BOUNDED", rollout.max_distance_m,
        100.0 * rollout.held_share);
    text += fmt::format(
        "the noise of a tracker comes out of one step {:.1f} times as large (of a held pose 1, at "
        "constant velocity 2.2)\n",
        evaluation.noise_multiplied);
    if (const std::string warning = noise_warning(evaluation.noise_multiplied); !warning.empty()) {
      text += "warning: " + warning + "\n";
    }
    text += evaluation.novel ? to_text(*evaluation.novel, evaluation.command) : "";
  }
  return text;
}

std::string noise_warning(double noise_multiplied) {
  return noise_multiplied > kTooMuchNoise
             ? "a closed loop behind a tracker would act on that noise: learn from recordings that "
               "have it (of the virtual arm: limber collect --noise-m 0.0005 --noise-rad 0.005)"
             : "";
}

Json to_json(const EnsembleEvaluation& evaluation) {
  return {{"members", evaluation.members},
          {"one_step", to_json(evaluation.one_step)},
          {"window_32", to_json(evaluation.window_32)},
          {"per_motion", to_json(evaluation.per_motion)},
          {"open_loop", to_json(evaluation.open_loop)}};
}

std::string to_text(const EnsembleEvaluation& evaluation) {
  std::string text = fmt::format(
      "{:<32} {:>23}   {:>7} {:>11} {:>10} {:>8}\n{:<32} "
      "{:>7} {:>7} {:>7}   {:>7} {:>11} {:>10} {:>8}\n",
      fmt::format("mean of {} networks", evaluation.members), "tip position [cm]", "spread",
      "correlation", "error <= 2", "95 % <=", "", "mean", "std", "p95", "[cm]", "with error",
      "spreads", "spreads");
  text += row("open loop", evaluation.open_loop);
  text += row("per motion", evaluation.per_motion);
  text += row("32-frame windows", evaluation.window_32);
  text += row("one step", evaluation.one_step);
  return text;
}

}  // namespace limber
