// The demo's stages from the bench test to the evaluated model.
#include <nlohmann/json.hpp>

#include "demo_stages.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/version.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/lab/unseen_arm.hpp"
#include "limber/report/speed_report.hpp"
#include "limber/report/training_report.hpp"
#include "limber/report/valve_plot.hpp"
#include "limber/run/collection.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "limber/training/adaptation.hpp"
#include "limber/training/fine_tuning.hpp"
#include "limber/training/learnt_region_fit.hpp"
#include "limber/training/unseen_error.hpp"

namespace limber {

namespace {

// Parts of a run that sample by chance, so that none shares another's (derived_seed).
enum DemoSeed : std::uint64_t {
  kTestSeed = 0,
  kValidationSeed = 1,
  kTrainingSeed = 2,
  kUnseenSeed = 3,
  kMinuteSeed = 4,
  kScheduleSeed = 16
};

constexpr double kInflateS = 3.0;
constexpr double kDeflateS = 4.0;

Recording record(const DemoResults& results, const ScheduleSettings& schedule, std::uint64_t seed,
                 const std::string& name) {
  CollectionSettings settings = virtual_collection(results.arm(), schedule, {});
  settings.seed = seed;
  settings.jobs = results.settings->jobs;
  settings.progress = results.settings->progress;
  settings.force = true;  // over what a run that was killed left; the folder knows whose it is
  Recording recording;
  results.output->write_with({name}, [&] {
    recording =
        collect(results.arm(), settings, virtual_arm_factory(results.arm(), {}), results.file(name))
            .recording;
  });
  return recording;
}

/// limber's family as a network of this arm, known by a minute; none where the recipe starts anew.
std::optional<CompensationModel> adapted_family(const DemoResults& results) {
  constexpr double kAdaptedToS = 60.0;
  const std::optional<CompensationModel> family =
      results.recipe.starts_from_family ? own_family(results.settings->arm) : std::nullopt;
  if (!family) {
    return std::nullopt;
  }
  AdaptationSettings settings;
  settings.jobs = results.settings->jobs;
  const Episode minute = identifying_run(results.arm(), kAdaptedToS,
                                         derived_seed(results.settings->seed, kMinuteSeed), 0);
  return adapt(results.arm(), *family, {minute}, settings).model;
}

/// Few epochs: the family has learnt most of it.
TrainingSettings after_family() {
  constexpr int kEpochs = 40;
  TrainingSettings settings = fine_tuning_of(best_preset());
  set_epoch_count(settings, kEpochs);
  return settings;
}

/// The run behind the paper's Fig. 1: the right side of every segment inflated fully, then vented.
Episode inflate_and_deflate(const ArmDescription& arm) {
  EpisodeSchedule schedule;
  schedule.first_kpa = Pressures::Zero(arm.channel_count());
  Pressures full(arm.channel_count());
  for (int i = 0; i < arm.channel_count(); ++i) {
    full[i] = float(arm.segments[i].pressure_limit_kpa.upper_kpa);
  }
  schedule.motions.push_back({full, kInflateS, true});
  schedule.motions.push_back({Pressures::Zero(arm.channel_count()), kDeflateS, true});
  VirtualArm driver(arm);
  return record_episode(arm, driver, schedule, {});
}

}  // namespace

void characterise_stage(DemoResults& results) {
  results.bench_points = bench_test_all(results.settings->arm);
  results.characterised = characterise(results.settings->arm, results.bench_points);
  results.output->write("arm.yaml", virtual_arm_to_yaml(results.arm()));
  results.output->write("characterisation.svg",
                        bench_chart(results.characterised, results.bench_points).svg());
}

void collect_stage(DemoResults& results) {
  const std::uint64_t seed = results.settings->seed;
  Recording& training = results.training_recording;
  std::uint64_t index = kScheduleSeed;
  for (const ScheduleSettings& schedule : results.recipe.training_schedules) {
    const std::string part = "train_part.h5";
    Recording recording = record(results, schedule, derived_seed(seed, index++), part);
    results.output->remove(part);
    if (training.episodes.empty()) {
      training = std::move(recording);
    } else {
      training.settings += "; " + recording.settings;
      std::move(recording.episodes.begin(), recording.episodes.end(),
                std::back_inserter(training.episodes));
    }
  }
  training.seed = seed;
  results.output->write_with({"train.h5"},
                             [&] { write_recording(results.file("train.h5"), training); });
  results.validation = record(results, results.recipe.validation_schedule,
                              derived_seed(seed, kValidationSeed), "validation.h5")
                           .episodes;
  results.unseen =
      record(results, results.recipe.unseen_schedule, derived_seed(seed, kUnseenSeed), "unseen.h5")
          .episodes;
  results.test_recording =
      record(results, results.recipe.test_schedule, derived_seed(seed, kTestSeed), "test.h5");
}

void train_stage(DemoResults& results) {
  const std::optional<CompensationModel> start = adapted_family(results);
  results.starts_from_family = start.has_value();
  TrainingSettings settings = start ? after_family() : results.recipe.training;
  settings.seed = derived_seed(results.settings->seed, kTrainingSeed);
  settings.jobs = results.settings->jobs;
  settings.progress = results.settings->progress;
  const TrainingData data{results.training_recording.episodes, results.validation};
  results.training = start ? fine_tune(results.arm(), data, settings, *start)
                           : train(results.arm(), data, settings);
  throw_if_interrupted();
  if (results.training.status == TrainingStatus::diverged) {
    throw SystemFault("training diverged: " + results.training.message);
  }
  results.training.model.set_valves(
      identify_valves(results.training_recording.episodes, results.arm(), "train.h5"));
  results.training.model.learnt = learnt_region_of(data);
  note_unseen(results.arm(), results.training.model, results.unseen, settings.jobs);
  results.training.model.training["data"] = "train.h5 " + file_hash(results.file("train.h5"));
  results.output->write_with({"model.safetensors"}, [&] {
    write_model(results.file("model.safetensors"), results.training.model);
  });
  results.model_hash = file_hash(results.file("model.safetensors"));
  results.output->write_with({"learning_curve.csv"}, [&] {
    write_learning_curve_csv(results.file("learning_curve.csv"), results.training.curve);
  });
  results.output->write("learning_curve.svg", learning_curve_svg(results.training.curve));
  results.valve_plot_svg = valve_plot_svg(results.training.model.identified_valves().parameters,
                                          results.training_recording);
  results.output->write("plots/valves.svg", results.valve_plot_svg);
  results.no_load.emplace(results.arm());
  results.network.emplace(results.arm(), results.training.model);
}

void evaluate_stage(DemoResults& results) {
  const ForwardModel& no_load = *results.no_load;
  const ForwardModel* network = &*results.network;
  const std::vector<Episode>& test = results.test_recording.episodes;
  results.evaluation = evaluate(no_load, network, test, results.settings->jobs);
  results.evaluation_plots =
      plot_evaluation(results.arm(), no_load, network, test, results.settings->jobs);
  const auto plots = mapped<std::string>(evaluation_plot_paths("plots", Dimension::plane),
                                         [&](const fs::path& path) { return path.string(); });
  results.output->write_with(
      plots, [&] { write_evaluation_plots(results.file("plots"), results.evaluation_plots); });
  results.inflate_deflate_svg =
      plot_inflate_deflate(no_load, network, inflate_and_deflate(results.arm()));
  results.output->write("plots/inflate_deflate.svg", results.inflate_deflate_svg);
  results.output->write("evaluation.json", to_json(results.evaluation).dump(2) + "\n");
}

void bench_stage(DemoResults& results) {
  SpeedSettings settings;
  settings.queries = results.recipe.bench_queries;
  settings.optional_peers = false;  // limber bench has them
  settings.jobs = results.settings->jobs;
  settings.progress = results.settings->progress;
  results.speed = measure_speed(results.arm(), &results.training.model, settings);
  results.output->write("bench.json", to_json(results.speed).dump(2) + "\n");
  results.output->write("plots/bench.svg", speed_chart(results.speed).svg());
}

}  // namespace limber
