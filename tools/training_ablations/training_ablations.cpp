// The table of levers in docs/training.md: the best preset, and it with one lever at a time set
// otherwise, trained on the same recordings with one seed and judged on one validation recording.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <functional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "limber/common/error.hpp"
#include "limber/training/evaluation.hpp"
#include "limber/training/trainer.hpp"

namespace limber {
namespace {

struct Lever {
  const char* name;
  std::function<void(TrainingSettings&)> set;
};

const std::vector<Lever> kLevers = {
    {"the preset", [](TrainingSettings&) {}},
    {"compensation (5) in place of a gated change (16)",
     [](TrainingSettings& s) { s.form = OutputForm::compensation; }},
    {"gates that start half open", [](TrainingSettings& s) { s.first_gate_bias = 0.0; }},
    {"gates that start at 12 %", [](TrainingSettings& s) { s.first_gate_bias = -2.0; }},
    {"gates that start at 0.25 %", [](TrainingSettings& s) { s.first_gate_bias = -6.0; }},
    {"poses about the base", [](TrainingSettings& s) { s.layout = BackboneLayout::base_poses; }},
    {"errors over the gaps' own numbers",
     [](TrainingSettings& s) { s.error_in_base_poses = false; }},
    {"windows of 32 from the start",
     [](TrainingSettings& s) {
       s.stages = {{32, 128, s.epoch_count()}};
     }},
    {"half windows of 32, then half of 8",
     [](TrainingSettings& s) {
       s.stages = {{32, 64, s.epoch_count() / 2}, {8, 128, s.epoch_count() / 2}};
     }},
    {"a third windows of 8, then of 32",
     [](TrainingSettings& s) {
       s.stages = {{8, 128, s.epoch_count() / 3}, {32, 64, s.epoch_count() * 2 / 3}};
     }},
    {"no limit on gradients", [](TrainingSettings& s) { s.gradient_norm_limit = 0.0; }},
    {"a moving average of the weights, 0.99", [](TrainingSettings& s) { s.average_decay = 0.99; }},
    {"noise of 0.05 on first backbones", [](TrainingSettings& s) { s.input_noise = 0.05; }},
    {"half the learning rate", [](TrainingSettings& s) { s.learning_rate *= 0.5; }},
    {"twice the learning rate", [](TrainingSettings& s) { s.learning_rate *= 2.0; }},
    {"3 × 64 units",
     [](TrainingSettings& s) {
       s.hidden_units = {64, 64, 64};
     }},
    {"3 × 160 units",
     [](TrainingSettings& s) {
       s.hidden_units = {160, 160, 160};
     }},
};

struct Options {
  std::string arm_file;
  std::vector<std::string> data;
  std::string validation;
  int epochs = 0;
  int jobs = 1;
  std::uint64_t seed = 1;
};

std::vector<Episode> read(const std::vector<std::string>& paths, const ArmDescription& arm) {
  std::vector<Episode> episodes;
  for (const std::string& path : paths) {
    Recording recording = read_recording(path);
    require_recording_of(recording, arm, path);
    std::ranges::move(recording.episodes, std::back_inserter(episodes));
  }
  return episodes;
}

void run_lever(const Lever& lever, const ArmDescription& arm, const TrainingData& data,
               const Options& options) {
  TrainingSettings settings = best_preset();
  set_epoch_count(settings, options.epochs);
  settings.seed = options.seed;
  settings.jobs = options.jobs;
  settings.validation_interval = options.epochs;  // the last epoch alone: nothing is chosen here
  lever.set(settings);
  const std::clock_t begin = std::clock();
  const TrainingResult result = train(arm, data, settings);
  const double cpu_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  if (result.status != TrainingStatus::finished) {
    fmt::print("| {} | {:.0f} | {} | | | |\n", lever.name, cpu_s, result.message);
    return;
  }
  const ForwardModel network(arm, result.model);
  const Evaluation evaluation =
      evaluate(ForwardModel(arm), &network, data.validation, options.jobs);
  const RolloutErrors& errors = *evaluation.network;
  fmt::print("| {} | {:.0f} | {:.2f} ({:.2f}) | {:.2f} | {:.2f} | {:.2f}{} |\n", lever.name, cpu_s,
             errors.one_step.position_cm.mean, errors.one_step_moving.position_cm.mean,
             errors.window_32.position_cm.mean, errors.per_motion.position_cm.mean,
             errors.open_loop.position_cm.mean,
             evaluation.long_rollout.bounded ? "" : ", not bounded");
  std::fflush(stdout);
}

int run(int argc, char** argv) {
  Options options;
  std::vector<int> chosen;
  CLI::App app("Trains with one lever of the best preset at a time set otherwise");
  app.add_option("--arm", options.arm_file, "Arm file")->required();
  app.add_option("--data", options.data, "Recording to learn from; repeat for more")->required();
  app.add_option("--validation", options.validation, "Recording to judge by")->required();
  app.add_option("--epochs", options.epochs, "Epochs of every training")->required();
  app.add_option("--levers", chosen, "Rows to run, from 0; all by default");
  app.add_option("--jobs", options.jobs, "Threads");
  app.add_option("--seed", options.seed, "Seed of every training");
  CLI11_PARSE(app, argc, argv);
  const ArmDescription arm = load_arm(options.arm_file);
  TrainingData data{read(options.data, arm), read({options.validation}, arm)};
  fmt::print(
      "| lever | CPU s | one step (moving) | 32 frames | per motion | open loop |\n"
      "|---|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < kLevers.size(); ++i) {
    if (chosen.empty() || std::ranges::find(chosen, static_cast<int>(i)) != chosen.end()) {
      run_lever(kLevers[i], arm, data, options);
    }
  }
  return 0;
}

}  // namespace
}  // namespace limber

int main(int argc, char** argv) {
  try {
    return limber::run(argc, argv);
  } catch (const limber::InputError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 3;
  }
}
