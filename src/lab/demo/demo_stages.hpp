#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "demo_recipe.hpp"
#include "limber/arm/characterisation.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/data/recording.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/lab/demo.hpp"
#include "limber/lab/output_folder.hpp"
#include "limber/lab/planning_experiment.hpp"
#include "limber/lab/speed_benchmark.hpp"
#include "limber/report/evaluation_plots.hpp"
#include "limber/report/planning_table.hpp"
#include "limber/report/report_page.hpp"
#include "limber/training/evaluation.hpp"
#include "limber/training/trainer.hpp"

namespace limber {

/// Wall time of a stage that is finished.
struct StageTime {
  std::string stage;
  double seconds = 0.0;
};

/// What became of the network's plans of one planning time, in one group of environments.
struct Arrivals {
  std::string environments;
  double planning_time_s = kFirstPlan;
  int plans = 0;
  int solved = 0;
  int arrived = 0;  ///< ended within the goal's tolerances, without collision
  int collided = 0;
  SampleFigures distance_cm;  ///< of all runs, to the goal's centre
};

/// What limber's family comes to on an arm that nobody has recorded: errors of the tip over other
/// motions, open loop, and what became of plans with the adapted model.
struct OtherArmFigures {
  double own_network_cm = 0.0;  ///< of the network that the demo trained on its own arm
  double after_20_s_cm = 0.0;   ///< of the family, adapted to so much of that arm's motion
  double after_60_s_cm = 0.0;
  int plans = 0;  ///< after 60 s
  int solved = 0;
  int arrived = 0;  ///< executed open loop
  int collided = 0;
  int arrived_closed_loop = 0;  ///< the same plans
  int collided_closed_loop = 0;
  std::vector<TraitEstimate> traits;  ///< what 60 s told of its physics, beside what that is
};
Json to_json(const OtherArmFigures& figures);

/// What the stages leave behind for each other and for the report. A stage reads what earlier ones
/// have set.
struct DemoResults {
  const DemoSettings* settings = nullptr;
  OutputFolder* output = nullptr;
  DemoRecipe recipe;
  std::vector<StageTime> times;

  BenchData bench_points;
  CharacterisedArm characterised;

  Recording training_recording;
  std::vector<Episode> validation;
  std::vector<Episode> unseen;
  Recording test_recording;

  TrainingResult training;
  bool starts_from_family = false;  ///< its weights; limber has one for this arm
  std::optional<ForwardModel> no_load;
  std::optional<ForwardModel> network;
  std::string model_hash;
  std::string valve_plot_svg;

  Evaluation evaluation;
  EvaluationPlots evaluation_plots;
  std::string inflate_deflate_svg;  ///< the paper's Fig. 1

  SpeedReport speed;

  std::vector<EnvironmentCase> environments;
  std::vector<PlanTrial> trials;            ///< environment by environment, no load before network
  std::vector<ReportFigure> plan_pictures;  ///< planned and executed, environment by environment

  std::vector<Arrivals> arrivals;  ///< group by group, over planning time

  std::vector<OtherArmFigures> other_arms;  ///< none where limber has no family for the arm

  /// What motions are predicted with: the no-load model or the network, after the network's valves.
  MotionModel motion_model(const ForwardModel& forward) const;
  const Environment& environment(const std::string& id) const;
  const ArmDescription& arm() const { return characterised.arm; }
  fs::path file(const std::string& name) const { return output->path() / name; }
};

void characterise_stage(DemoResults& results);
void collect_stage(DemoResults& results);
void train_stage(DemoResults& results);
void evaluate_stage(DemoResults& results);
void bench_stage(DemoResults& results);
/// Plans with both models in every environment, and executes every plan at once.
void plan_stage(DemoResults& results);
void execute_stage(DemoResults& results);
/// Plans and executes in limber's own and in random environments, over planning time.
void arrival_stage(DemoResults& results);
/// Adapts limber's family to other arms from a minute of their motion.
void another_arm_stage(DemoResults& results);

/// The page and the summary of a finished run.
std::string demo_report(const DemoResults& results);
Json demo_summary(const DemoResults& results);

}  // namespace limber
