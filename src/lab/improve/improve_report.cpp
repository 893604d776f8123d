#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/units.hpp"
#include "limber/common/version.hpp"
#include "limber/plot/chart.hpp"
#include "limber/report/report_page.hpp"
#include "round_figures.hpp"

namespace limber {

namespace {

std::string cm(const std::optional<double>& value) {
  return value ? fmt::format("{:.2f}", kCmPerM * *value) : "–";
}

std::string plain(const std::optional<double>& value) {
  return value ? fmt::format("{:.2f}", *value) : "–";
}

ReportTable outcome_table(const std::vector<RoundFigures>& rounds, int best) {
  ReportTable table;
  table.caption = "Fresh environments in every round, which choose nothing";
  table.header = {"round",    "learnt from [min]", "solved",     "arrived",
                  "collided", "distance [cm]",     "median [cm]"};
  for (const RoundFigures& round : rounds) {
    const PlanFigures& plans = round.reported;
    table.rows.push_back({fmt::format("{}", round.round), fmt::format("{:.1f}", round.learning_min),
                          fmt::format("{}/{}", plans.solved, plans.environments),
                          fmt::format("{}/{}", plans.arrived, plans.environments),
                          fmt::format("{}/{}", plans.collided, plans.executed),
                          cm(plans.mean_m) + " ± " + cm(plans.standard_error_m),
                          cm(plans.median_m)});
  }
  table.highlighted_rows = {best};
  return table;
}

ReportTable error_table(const std::vector<RoundFigures>& rounds, int best) {
  ReportTable table;
  table.caption = "Backbone error [cm], open loop from set points: mean, and largest per run";
  table.header = {"round", "plans, mean",    "random motions, mean",
                  "ratio", "plans, largest", "random motions, largest",
                  "ratio"};
  for (const RoundFigures& round : rounds) {
    table.rows.push_back({fmt::format("{}", round.round), cm(round.on_plans.mean_m),
                          cm(round.on_motions.mean_m), plain(round.mean_error_ratio()),
                          cm(round.on_plans.largest_m), cm(round.on_motions.largest_m),
                          plain(round.largest_error_ratio())});
  }
  table.highlighted_rows = {best};
  return table;
}

ReportTable choice_table(const std::vector<RoundFigures>& rounds, const RoundChoice& choice) {
  ReportTable table;
  table.caption = "Selection: the same environments in every round, other than those above";
  table.header = {"round", "solved", "distance [cm]", "nearer by [cm]", "than round", "clear gain"};
  for (const RoundFigures& round : rounds) {
    std::vector<std::string> row = {
        fmt::format("{}", round.round),
        fmt::format("{}/{}", round.selection.solved, round.selection.environments),
        cm(round.selection.mean_m),
        "–",
        "–",
        "–"};
    if (round.round > 0) {
      const auto index = static_cast<std::size_t>(round.round) - 1;
      const DistanceGain& gain = choice.gains[index];
      row[3] =
          fmt::format("{:.2f} ± {:.2f}", kCmPerM * gain.mean_m, kCmPerM * gain.standard_error_m);
      row[4] = fmt::format("{}", choice.references[index]);
      row[5] = gain.is_clear() ? "yes" : "no";
    }
    table.rows.push_back(std::move(row));
  }
  table.highlighted_rows = {choice.best};
  return table;
}

}  // namespace

std::string improve_curve(const std::vector<RoundFigures>& rounds, const RoundChoice& choice) {
  std::vector<double> minutes, mean, error, median;
  for (const RoundFigures& round : rounds) {
    if (round.reported.mean_m) {
      minutes.push_back(round.learning_min);
      mean.push_back(kCmPerM * *round.reported.mean_m);
      error.push_back(kCmPerM * round.reported.standard_error_m.value_or(0.0));
      median.push_back(kCmPerM * *round.reported.median_m);
    }
  }
  Chart chart("Executed plans: distance from the goal");
  chart.x_axis("arm time learnt from [min]").y_axis("distance [cm]");
  chart.mean_band("mean ± standard error", minutes, mean, error);
  chart.points("mean", minutes, mean).line("median", minutes, median);
  chart.vertical_line(fmt::format("round {}, kept", choice.best),
                      rounds[static_cast<std::size_t>(choice.best)].learning_min);
  return chart.svg();
}

std::string improve_report(const ImproveSettings& settings, const std::vector<RoundFigures>& rounds,
                           const RoundChoice& choice) {
  const RoundFigures& first = rounds.front();
  const RoundFigures& best = rounds[static_cast<std::size_t>(choice.best)];
  ReportPage page("limber improve", fmt::format("arm {}, seed {}, limber {}", settings.arm.name,
                                                settings.seed, version()));
  page.key_figures(
      {{"executed plans end off by", cm(best.reported.mean_m) + " cm",
        fmt::format("round {}, kept; the model to start from: {} cm", choice.best,
                    cm(first.reported.mean_m))},
       {"plans that arrive",
        fmt::format("{} of {}", best.reported.arrived, best.reported.environments),
        fmt::format("before: {} of {}", first.reported.arrived, first.reported.environments)},
       {"error on plans over random motions", plain(best.mean_error_ratio()),
        "before: " + plain(first.mean_error_ratio())},
       {"arm time learnt from", fmt::format("{:.1f} min", best.learning_min),
        fmt::format("vented {} times for it; and {:.1f} min to judge all rounds",
                    best.learning_ventings, rounds.back().judging_min)}});
  page.heading("Rounds")
      .table(outcome_table(rounds, choice.best))
      .figure({improve_curve(rounds, choice), "Each round in environments of its own"})
      .heading("Error of the model")
      .table(error_table(rounds, choice.best))
      .paragraph(
          "Plans start from the vented arm, random motions from where the one before came to rest. "
          "No model has seen any of these runs.")
      .heading("Choice")
      .table(choice_table(rounds, choice))
      .paragraph(fmt::format(
          "A gain is clear if it is larger than its standard error. After {} rounds without one, "
          "one after another, no more are made. Round {} is kept.",
          kMaxRoundsWithoutGain, choice.best));
  return page.html();
}

}  // namespace limber
