#include <numeric>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "demo_arrivals.hpp"
#include "demo_stages.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/progress.hpp"
#include "limber/common/units.hpp"
#include "limber/common/version.hpp"
#include "limber/network/physical_traits.hpp"
#include "limber/report/planning_table.hpp"
#include "limber/report/report_page.hpp"
#include "limber/report/speed_report.hpp"
#include "limber/report/track_report.hpp"
#include "limber/report/training_report.hpp"
#include "limber/report/valve_plot.hpp"

namespace limber {

namespace {

constexpr const char* kNone = "–";  // where there is no mean

std::string mean_std(const ErrorStatistics& error, int digits) {
  return fmt::format("{:.{}f} ± {:.{}f}", error.mean, digits, error.std, digits);
}

std::string rate(double queries_per_s) {
  return queries_per_s >= 1e6 ? fmt::format("{:.2f} million", queries_per_s / 1e6)
                              : fmt::format("{:.0f}", queries_per_s);
}

double total_s(const std::vector<StageTime>& times) {
  return std::accumulate(times.begin(), times.end(), 0.0,
                         [](double sum, const StageTime& time) { return sum + time.seconds; });
}

std::string hours(const Recording& recording) {
  return fmt::format("{:.2f} h", recording.duration_s() / 3600.0);
}

void opening(ReportPage& page, const DemoResults& results) {
  const Evaluation& evaluation = results.evaluation;
  const TipErrors& network = evaluation.network->open_loop;
  const PlanningRow no_load_plans = planning_row(results.trials, "", "no_load");
  const PlanningRow network_plans = planning_row(results.trials, "", "network");
  page.key_figures(
      {{"network plans that arrive",
        fmt::format("{} of {}", network_plans.reached, network_plans.trials),
        fmt::format("{} collide, {} cm off on average; no-load plans {} of {}, {} cm",
                    network_plans.collided, shown(network_plans.distance_cm.mean, 1, kNone),
                    no_load_plans.reached, no_load_plans.trials,
                    shown(no_load_plans.distance_cm.mean, 1, kNone))},
       {"network, open loop", fmt::format("{:.1f} cm", network.position_cm.mean),
        fmt::format("no-load model {:.1f} cm; the paper 5.8 and 16.2",
                    evaluation.no_load_open_loop.position_cm.mean)},
       {"error taken away", fmt::format("{:.0f} %", evaluation.position_reduction_percent),
        fmt::format("orientation {:.0f} %; the paper 62 and 73",
                    evaluation.orientation_reduction_percent)},
       {"network queries per second", rate(results.speed.paper_shape.single.queries_per_s),
        "the paper's shape, one at a time, one core; the paper 510"}});
  if (results.settings->quick) {
    page.remark(
        "A quick run: little data, and a network that goes on from limber's family where it has "
        "one, so that the chain can be seen in a minute. "
        "For figures to judge by, run limber demo without --quick.");
  }
  page.remark(
      "The arm is simulated. Its friction, damping and plate weight were chosen "
      "so that the no-load model's error on it is that on the paper's hardware, "
      "and so that it stays bent after inflating and venting, as in the paper's "
      "Fig. 1; the rest is compared, not fitted. Nothing here was measured on a "
      "real arm, so no figure shows an improvement over the paper's.");
}

void what_was_done(ReportPage& page, const DemoResults& results) {
  const TrainingResult& training = results.training;
  const ErrorRoom room = error_room(*results.network);
  page.heading("What was done")
      .list({
          fmt::format("Characterise: each of the {} segments alone and free of friction, one side "
                      "inflated in steps; a quartic fitted to its contraction.",
                      results.arm().segment_count()),
          fmt::format("Collect: {} frames ({} of arm time) in {} episodes to learn from; a test of "
                      "{} frames, random motions in one unbroken episode, never trained on.",
                      results.training_recording.frame_count(), hours(results.training_recording),
                      results.training_recording.episodes.size(),
                      results.test_recording.frame_count()),
          fmt::format("Train: network {}, {}{} epochs in {:.0f} s; epoch "
                      "{} was best on the validation episode.",
                      training.model.shape(),
                      results.starts_from_family
                          ? "from limber's family, adapted to another minute of the arm, "
                          : "",
                      training.curve.size(), training.wall_time_s, training.best_epoch),
          "Evaluate: both models on the test, from one "
          "step ahead to the whole episode uncorrected.",
          fmt::format("Plan and execute: {} environments, {} {} of each model, {:.3g} "
                      "s each; every plan run open loop on the arm. Plans of the network "
                      "keep {:.1f} mm from obstacles and end {:.1f} mm inside the goal's "
                      "rim, the network's error in 95 % of the runs it had not seen; where the "
                      "goal's tolerance leaves no room for that, they aim at its centre. The "
                      "no-load model's error is not known, so its plans keep no distance.",
                      results.environments.size(), results.recipe.plans_per_environment,
                      results.recipe.plans_per_environment == 1 ? "plan" : "plans",
                      results.recipe.planning_time_limit_s, 10.0 * kCmPerM * room.margin_m,
                      10.0 * kCmPerM * room.goal_margin.position_m),
      });
}

ReportTable paper_table(const DemoResults& results) {
  const Evaluation& evaluation = results.evaluation;
  const RolloutErrors& network = *evaluation.network;
  ReportTable table{"End-effector error on the test set, mean ± standard deviation",
                    {"model", "position [cm]", "95 % below [cm]", "orientation [rad]"}};
  const auto add = [&](const std::string& name, const TipErrors& errors) {
    table.rows.push_back({name, mean_std(errors.position_cm, 2),
                          fmt::format("{:.1f}", errors.position_cm.p95),
                          mean_std(errors.orientation_rad, 3)});
  };
  table.rows.push_back({"paper (hardware), no load", "16.2 ± 8.8", "–", "0.61 ± 0.48"});
  add("no load, open loop", evaluation.no_load_open_loop);
  table.rows.push_back({"paper (hardware), network", "5.8 ± 4.7", "–", "0.16 ± 0.13"});
  table.highlighted_rows = {int(table.rows.size())};
  add("network, open loop", network.open_loop);
  add("network, restarted every motion", network.per_motion);
  add("network, restarted every 32 frames", network.window_32);
  add("network, one step", network.one_step);
  add("holding the last pose, one step", evaluation.hold_one_step);
  add("constant velocity, one step", evaluation.constant_velocity_one_step);
  return table;
}

void learning(ReportPage& page, const DemoResults& results) {
  page.heading("The simple model")
      .paragraph(
          "Pressure to contraction, contraction to curvature and length, segment by segment: the "
          "quasistatic no-load model. Here are the bench points and the fitted curves.")
      .figure({bench_chart(results.characterised, results.bench_points).svg(),
               "Contraction of the inflated side over its pressure, each segment alone"})
      .heading("Why it is not enough")
      .paragraph(
          "All right sides inflated fully, then vented: the model says that the arm is straight "
          "again, but friction keeps it bent. The paper shows the same in its Fig. 1.")
      .figure({results.inflate_deflate_svg, "After inflating the right side fully and venting it"})
      .heading("Between set points and pressures")
      .paragraph(
          "Pressures follow their set points late, at a limited rate, and through zero one side "
          "empties before the other inflates. This model of the valves was identified from the "
          "recording (docs/valves.md): " +
          to_text(results.training.model.identified_valves(), results.arm().command.unit) + ".")
      .figure({results.valve_plot_svg, "A recorded motion that the valves were not fitted to"})
      .heading("Learning")
      .figure({learning_curve_svg(results.training.curve),
               "Training loss, and tip error over validation rollouts"})
      .heading("Accuracy, compared with the paper's")
      .table(paper_table(results))
      .paragraph(
          "One step alone says little: holding the last pose is already good at it. Open loop "
          "means the model is never corrected over the whole test.")
      .figures({{results.evaluation_plots.error_over_time, "Open-loop tip error over the test"},
                {results.evaluation_plots.backbones, "Backbones, recorded and predicted"}})
      .figures({{results.evaluation_plots.position_distribution,
                 "Position errors, as in the paper's Fig. 4"},
                {results.evaluation_plots.orientation_distribution,
                 "Orientation errors, as in the paper's Fig. 4"}});
}

ReportTable trial_table(const DemoResults& results) {
  ReportTable table{
      "Plans and their execution; distances are means, including runs that collided",
      {"environment", "model", "solved", "reached", "collided", "distance [cm]", "heading [rad]",
       "first certified plan [s]: candidate + certificate", "cost [psi]"}};
  const auto add = [&](const std::string& label, const std::string& environment,
                       const std::string& model) {
    const PlanningRow sum = planning_row(results.trials, environment, model);
    if (model == "network") {
      table.highlighted_rows.push_back(int(table.rows.size()));
    }
    table.rows.push_back({label, model == "network" ? "network" : "no load",
                          fmt::format("{}/{}", sum.solved, sum.trials),
                          fmt::format("{}/{}", sum.reached, sum.executed),
                          fmt::format("{}/{}", sum.collided, sum.executed),
                          shown(sum.distance_cm.mean, 1, kNone),
                          shown(sum.orientation_rad.mean, 2, kNone),
                          shown(sum.first_candidate_s.mean, 3, kNone) + " + " +
                              shown(sum.first_certificate_s.mean, 3, kNone),
                          shown(sum.cost_psi.mean, 1, kNone)});
  };
  for (const EnvironmentCase& item : results.environments) {
    add(item.environment.name, item.id, "no_load");
    add(item.environment.name, item.id, "network");
  }
  add("all", "", "no_load");
  add("all", "", "network");
  return table;
}

std::string about_arrivals(const DemoResults& results) {
  return fmt::format(
      "No plan's outcome has chosen the random environments. Where the network's error, {:.1f} cm, "
      "does not fit between obstacles, no plan is found; more data makes it smaller. The clock "
      "ends these searches, so their figures differ a little from run to run.",
      error_room(*results.network).margin_m * kCmPerM);
}

void planning(ReportPage& page, const DemoResults& results) {
  page.heading("Plans and their outcomes")
      .paragraph(
          "The same planner with either model. A plan is a list of set points, executed as it "
          "stands; distance and heading are taken after the last one was held for a second. "
          "Reached means within the goal's tolerances, 2 cm (and 0.3 rad where a heading is asked "
          "for), without collision. Environments were chosen where the simple model is wrong "
          "(docs/environments.md). The paper's plans ended 3.3–14.9 cm off with one collision (no "
          "load), 1.0–6.4 cm with none (network).")
      .table(arrivals_table(results.arrivals))
      .paragraph(about_arrivals(results))
      .table(trial_table(results))
      .figures(results.plan_pictures);
}

void other_arms(ReportPage& page, const DemoResults& results) {
  if (results.other_arms.empty()) {
    return;
  }
  page.heading("Another arm in a minute")
      .paragraph(
          "Arms of other friction, load, strength, valves and table, drawn by chance. The network "
          "above learnt another arm, and is worth little on them. limber's family learnt from many "
          "virtual arms; a minute of motion says which of them an arm is like (docs/families.md). "
          "Mean tip error over other motions, open loop; then a plan in each of eight random "
          "environments about that arm's motions with the adapted model, executed on it: open "
          "loop, as it stands; and in closed loop, planned again from where the arm is measured "
          "(docs/experiments.md).");
  ReportTable table{
      "",
      {"arm", "network above [cm]", "family, after 20 s [cm]", "after 60 s [cm]", "solved",
       "arrived", "collided", "arrived, closed loop", "collided, closed loop"}};
  int number = 0;
  for (const OtherArmFigures& arm : results.other_arms) {
    table.rows.push_back(
        {std::to_string(++number), fmt::format("{:.1f}", arm.own_network_cm),
         fmt::format("{:.1f}", arm.after_20_s_cm), fmt::format("{:.1f}", arm.after_60_s_cm),
         fmt::format("{}/{}", arm.solved, arm.plans), fmt::format("{}/{}", arm.arrived, arm.solved),
         fmt::format("{}/{}", arm.collided, arm.solved),
         fmt::format("{}/{}", arm.arrived_closed_loop, arm.solved),
         fmt::format("{}/{}", arm.collided_closed_loop, arm.solved)});
  }
  page.table(table);
  ReportTable told{
      "What the minute told of each arm's physics, and how surely; in brackets what it is",
      {"arm", "moves like arms with"}};
  for (const OtherArmFigures& arm : results.other_arms) {
    told.rows.push_back({std::to_string(told.rows.size() + 1),
                         fmt::format("{}", fmt::join(trait_texts(arm.traits), "; "))});
  }
  page.table(told);
}

ReportTable speed_table(const SpeedReport& speed) {
  ReportTable table{fmt::format("Forward-model queries per second on {}", speed.cpu),
                    {"model", "one at a time", "in batches", "batch"}};
  const auto add = [&](const std::string& name, const QueryRate& single, const QueryRate& batch) {
    table.rows.push_back({name, rate(single.queries_per_s), rate(batch.queries_per_s),
                          std::to_string(batch.batch_size)});
  };
  table.rows.push_back({"paper, no load", rate(kPaperNoLoadQueriesPerS), "–", "–"});
  add("no load", speed.no_load_single, speed.no_load_batch);
  table.rows.push_back({"paper, network", rate(kPaperNetworkQueriesPerS), "–", "–"});
  add("network " + speed.paper_shape.shape, speed.paper_shape.single, speed.paper_shape.batch);
  for (const NetworkSpeed& model : speed.model) {
    add("this run's network " + model.shape, model.single, model.batch);
  }
  return table;
}

void times(ReportPage& page, const DemoResults& results) {
  page.heading("Speed")
      .table(speed_table(results.speed))
      .figure({speed_chart(results.speed).svg(), "Forward-model queries per second, one core"})
      .heading("Time");
  ReportTable table{"", {"stage", "time"}};
  for (const auto& [stage, seconds] : results.times) {
    table.rows.push_back({stage, format_duration(seconds)});
  }
  table.rows.push_back({"all", format_duration(total_s(results.times))});
  table.highlighted_rows = {int(table.rows.size()) - 1};
  page.table(table);
}

void whats_next(ReportPage& page) {
  page.heading("With your own arm")
      .paragraph(
          "Each stage works on its own, and reads and writes "
          "plain files; limber VERB --help has an example.")
      .code(
          "limber characterize --arm my_arm.yaml --csv bench.csv --out my_arm_fitted.yaml\n"
          "limber inspect my_recording.h5\n"
          "limber train --arm my_arm.yaml --data my_recording.h5 --out my_model.safetensors\n"
          "limber evaluate --arm my_arm.yaml --model my_model.safetensors --data my_test.h5\n"
          "limber plan --arm my_arm.yaml --model my_model.safetensors \\\n"
          "  --environment my_table.yaml --out my_plan.json --svg my_plan.svg");
}

Json to_json(const std::vector<StageTime>& times) {
  Json json;
  for (const auto& [stage, seconds] : times) {
    json[stage] = seconds;
  }
  json["total"] = total_s(times);
  return json;
}

Json to_json(const DemoResults& results) {
  const TrainingResult& training = results.training;
  return {{"networks", training.model.member_count()},
          {"shape", training.model.shape()},
          {"preset", training.model.preset},
          {"epochs", training.curve.back().epoch},
          {"best_epoch", training.best_epoch},
          {"best_validation_position_error_cm", training.best_validation_position_error_cm},
          {"frames", results.training_recording.frame_count()},
          {"wall_time_s", training.wall_time_s}};
}

Json to_json(const std::vector<PlanTrial>& trials) {
  Json json;
  for (const char* model : {"no_load", "network"}) {
    const PlanningRow sum = planning_row(trials, "", model);
    json[model] = {{"trials", sum.trials},
                   {"solved", sum.solved},
                   {"executed", sum.executed},
                   {"collided", sum.collided},
                   {"reached", sum.reached},
                   {"mean_first_solution_s", optional_json(sum.first_solution_s.mean)},
                   {"mean_cost_psi", optional_json(sum.cost_psi.mean)},
                   {"mean_distance_to_goal_cm", optional_json(sum.distance_cm.mean)},
                   {"mean_orientation_to_goal_rad", optional_json(sum.orientation_rad.mean)}};
  }
  return json;
}

}  // namespace

std::string demo_report(const DemoResults& results) {
  ReportPage page(
      "limber demo",
      fmt::format("arm {}, seed {}, {} run, limber {}", results.arm().name, results.settings->seed,
                  results.settings->quick ? "quick" : "full", version()));
  opening(page, results);
  what_was_done(page, results);
  learning(page, results);
  planning(page, results);
  other_arms(page, results);
  times(page, results);
  whats_next(page);
  return page.html();
}

Json demo_summary(const DemoResults& results) {
  Json json;
  json["schema"] = "limber/demo/1";
  json["program_version"] = version();
  json["arm"] = results.arm().name;
  json["seed"] = results.settings->seed;
  json["quick"] = results.settings->quick;
  json["training"] = to_json(results);
  json["valves"] = to_json(results.training.model.identified_valves());
  json["evaluation"] = to_json(results.evaluation);
  json["bench"] = to_json(results.speed);
  json["comparison"] = to_json(results.trials);
  json["arrivals"] = arrivals_to_json(results.arrivals);
  json["other_arms"] = Json::array();
  for (const OtherArmFigures& arm : results.other_arms) {
    json["other_arms"].push_back(to_json(arm));
  }
  json["plans"] = Json::array();
  json["executions"] = Json::array();
  for (const PlanTrial& trial : results.trials) {
    const Environment& environment = results.environment(trial.environment);
    json["plans"].push_back(planning_to_json(trial, environment));
    if (trial.execution) {
      json["executions"].push_back(execution_to_json(trial, environment));
    }
  }
  json["wall_time_s"] = to_json(results.times);
  return json;
}

}  // namespace limber
