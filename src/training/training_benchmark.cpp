#include "limber/training/training_benchmark.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <thread>

#include <tbb/task_arena.h>

#include <fmt/format.h>

#include "epoch_trainer.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/common/seconds_since.hpp"
#include "limber/common/statistics.hpp"
#include "limber/network/gemm_kernels.hpp"

namespace limber {

namespace {

using Clock = std::chrono::steady_clock;

constexpr long kPeakRounds = 20'000;   // some 50 µs
constexpr double kPeakSeconds = 0.03;  // a few of a scheduler's slices

/// Multiply-adds per second of all threads together, each in registers only.
double peak_gmac_per_s(int threads) {
  const GemmKernels& kernels = gemm_kernels();
  std::vector<double> rates(threads);
  std::vector<std::thread> running;
  for (double& rate : rates) {
    running.emplace_back([&rate, &kernels] {
      volatile float keep = 0.0F;  // or nothing would be computed
      const Clock::time_point begin = Clock::now();
      long passes = 0;
      while (seconds_since(begin) < kPeakSeconds) {
        keep = keep + kernels.multiply_add(kPeakRounds);
        ++passes;
      }
      rate = double(passes * kPeakRounds) * kernels.multiply_adds_per_round / seconds_since(begin) /
             1e9;
    });
  }
  for (std::thread& thread : running) {
    thread.join();
  }
  return std::accumulate(rates.begin(), rates.end(), 0.0);
}

/// The settings of one stage alone, at a constant rate; without a limit on growth, since PyTorch,
/// with which this is compared, has nothing like it.
TrainingSettings of_stage(TrainingSettings settings, const TrainingStage& stage) {
  settings.stages = {stage};
  settings.growth_limit = 0.0;
  settings.cosine_decay = false;
  return settings;
}

double useful_multiply_adds(const EpochTrainer& trainer, const TrainingStage& stage,
                            std::size_t windows) {
  const ParameterLayout& layout = trainer.layout();
  const auto all = sum_of<double>(layout.layer_count(), [&](int layer) {
    return double(layout.inputs(layer)) * layout.outputs(layer);
  });
  const double first = double(layout.inputs(0)) * layout.outputs(0);
  // Back in time lead the columns that read B_{t−1}, and those that read its change.
  const int read_twice = trainer.tables().map.reads_velocity() ? 2 : 1;
  const double carried = double(read_twice * trainer.tables().frames.state.rows()) *
                         layout.outputs(0) * (stage.window_frames - 1) / stage.window_frames;
  return (3.0 * all - first + carried) * stage.window_frames * double(windows) *
         trainer.member_count();
}

StageSpeed measure_stage(const ArmDescription& arm, const TrainingData& data,
                         const TrainingSettings& settings, const TrainingStage& stage, int epochs,
                         int threads) {
  throw_if_interrupted();
  EpochTrainer trainer(arm, data, settings, nullptr);
  StageSpeed speed;
  speed.window_frames = stage.window_frames;
  speed.windows_per_batch = stage.windows_per_batch;
  const std::size_t windows = trainer.shuffled_starts(stage).size();
  speed.windows = std::int64_t(windows);
  speed.multiply_adds = useful_multiply_adds(trainer, stage, windows);
  speed.first_epoch_loss = trainer.train_epoch(stage).mean;
  std::vector<double> seconds;
  std::vector<double> fractions;
  std::vector<double> peaks;
  double before = peak_gmac_per_s(threads);
  for (int epoch = 0; epoch < epochs; ++epoch) {
    throw_if_interrupted();
    const Clock::time_point begin = Clock::now();
    (void)trainer.train_epoch(stage);
    seconds.push_back(seconds_since(begin));
    const double after = peak_gmac_per_s(threads);
    peaks.push_back(0.5 * (before + after));
    fractions.push_back(speed.multiply_adds / seconds.back() / 1e9 / peaks.back());
    speed.peak_difference =
        std::max(speed.peak_difference, std::abs(after - before) / peaks.back());
    before = after;
  }
  speed.epoch_s = median(seconds);
  speed.peak_gmac_per_s = median(peaks);
  speed.fraction_of_fma_peak = median(fractions);
  return speed;
}

Tensor tensor_of(const Eigen::MatrixXf& columns) {
  return {{std::size_t(columns.cols()), std::size_t(columns.rows())},
          {columns.data(), columns.data() + columns.size()}};
}

}  // namespace

TrainingSpeed measure_training_speed(const ArmDescription& arm, const TrainingData& data,
                                     const TrainingSettings& settings, int epochs) {
  TrainingSpeed speed;
  speed.preset = settings.preset;
  speed.layout = to_string(settings.layout);
  speed.networks = settings.ensemble;
  speed.threads = tbb::task_arena(settings.jobs > 0 ? settings.jobs : tbb::task_arena::automatic)
                      .max_concurrency();
  for (const TrainingStage& stage : settings.stages) {
    const TrainingSettings own = of_stage(settings, stage);
    if (speed.shape.empty()) {
      const EpochTrainer trainer(arm, data, own, nullptr);
      speed.shape = trainer.model_of_member(trainer.state().parameters, 0).shape();
      speed.frames = trainer.tables().frames.state.cols();
    }
    speed.stages.push_back(measure_stage(arm, data, own, stage, epochs, speed.threads));
  }
  return speed;
}

void write_training_tables(const fs::path& path, const ArmDescription& arm,
                           const TrainingData& data, const TrainingSettings& settings) {
  Safetensors content;
  for (std::size_t k = 0; k < settings.stages.size(); ++k) {
    const TrainingStage& stage = settings.stages[k];
    const TrainingSettings own = of_stage(settings, stage);
    const EpochTrainer trainer(arm, data, own, nullptr);
    const TrainingTables& tables = trainer.tables();
    const std::vector<int> starts = trainer.shuffled_starts(stage);
    content.tensors[fmt::format("starts.{}", k)] = vector_tensor(starts);
    if (k > 0) {
      continue;
    }
    content.tensors["pressure"] = tensor_of(tables.frames.pressure);
    content.tensors["no_load"] = tensor_of(tables.frames.no_load);
    content.tensors["uncompensated"] = tensor_of(tables.frames.uncompensated);
    content.tensors["state"] = tensor_of(tables.frames.state);
    if (tables.map.reads_velocity()) {
      content.tensors["change"] = tensor_of(tables.frames.change);
      content.tensors["change_scale"] = tensor_of(tables.map.change_scale);
    }
    content.tensors["target"] = tensor_of(tables.frames.targets());
    content.tensors["output_scale"] = tensor_of(tables.map.output_scale);
    content.tensors["error.weight"] = tensor_of(tables.map.error.weight());
    if (tables.map.error.is_chained()) {
      content.tensors["error.scale"] = tensor_of(tables.map.error.scale());
      content.tensors["error.offset"] = tensor_of(tables.map.error.offset());
    }
    const std::vector<Layer> layers =
        to_layers(trainer.layout(), trainer.state().parameters.head(trainer.layout().size()));
    for (std::size_t l = 0; l < layers.size(); ++l) {
      content.tensors[fmt::format("layers.{}.weight", l)] = tensor_of(layers[l].weight.transpose());
      content.tensors[fmt::format("layers.{}.bias", l)] = tensor_of(layers[l].bias);
    }
  }
  const bool mean = settings.reduction == LossReduction::mean_over_batch;
  content.metadata = {{"optimiser", to_string(settings.optimiser)},
                      {"reduction", mean ? "mean" : "sum"},
                      {"output_form", to_string(settings.form)},
                      {"learning_rate", fmt::format("{}", settings.learning_rate)},
                      {"gradient_norm_limit", fmt::format("{}", settings.gradient_norm_limit)}};
  write_file_atomically(path, safetensors_bytes(content));
}

}  // namespace limber
