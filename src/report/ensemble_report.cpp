#include "limber/report/training_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/json_number.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

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
