// The forward model's parts on the paper's arm with untrained weights: no-load model, network
// alone, whole queries, rollouts. Rates are queries.
#include <benchmark/benchmark.h>

#include "limber/common/data_folder.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "limber/network/packed_network.hpp"
#include "limber/network/untrained_model.hpp"

namespace limber {
namespace {

using Eigen::MatrixXf;

const ArmDescription& paper_arm() {
  static const ArmDescription arm = load_arm(data_folder() / "arms/three_segment.yaml");
  return arm;
}

CompensationModel network_of(BackboneLayout layout) {
  return untrained_model(paper_arm(), layout, {100, 100, 100}, 1);
}

MatrixXf random_pressures_kpa(int columns, std::uint64_t stream) {
  RandomStream random(1, stream);
  const ArmDescription& arm = paper_arm();
  return MatrixXf::NullaryExpr(arm.segment_count(), columns, [&](Eigen::Index i, Eigen::Index) {
    const PressureLimits& limits = arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa;
    return static_cast<float>(random.uniform(limits.lower_kpa, limits.upper_kpa));
  });
}

// Backbones of the unloaded arm, one per column.
MatrixXf unloaded(const MatrixXf& pressures_kpa) {
  MatrixXf backbones(3 * paper_arm().point_count(), pressures_kpa.cols());
  ForwardModel::Workspace workspace;
  ForwardModel(paper_arm())
      .step_batch(pressures_kpa, pressures_kpa, backbones, backbones, workspace);
  return backbones;
}

void step_batches(benchmark::State& state, const ForwardModel& model) {
  const int queries = static_cast<int>(state.range(0));
  const MatrixXf before = random_pressures_kpa(queries, 0);
  const MatrixXf current = random_pressures_kpa(queries, 1);
  const MatrixXf previous = unloaded(before);
  MatrixXf next(previous.rows(), queries);
  ForwardModel::Workspace workspace;
  for (auto _ : state) {
    model.step_batch(before, current, previous, next, workspace);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * queries);
}

void no_load_step(benchmark::State& state) {
  const ForwardModel model(paper_arm());
  step_batches(state, model);
}
BENCHMARK(no_load_step)->RangeMultiplier(4)->Range(1, 1024);

void step_batch(benchmark::State& state, BackboneLayout layout) {
  const ForwardModel model(paper_arm(), network_of(layout));
  step_batches(state, model);
}
BENCHMARK_CAPTURE(step_batch, base_poses, BackboneLayout::base_poses)
    ->RangeMultiplier(4)
    ->Range(1, 1024);
BENCHMARK_CAPTURE(step_batch, gap_poses, BackboneLayout::gap_poses)
    ->RangeMultiplier(4)
    ->Range(1, 1024);

void step(benchmark::State& state) {
  const ForwardModel model(paper_arm(), network_of(BackboneLayout::base_poses));
  constexpr int kQueries = 1024;  // different ones: the same again would train the CPU's predictors
  const MatrixXf before = random_pressures_kpa(kQueries, 0);
  const MatrixXf current = random_pressures_kpa(kQueries, 1);
  const MatrixXf previous = unloaded(before);
  MatrixXf next(previous.rows(), kQueries);
  ForwardModel::Workspace workspace;
  const int points = model.point_count();
  for (auto _ : state) {
    for (int j = 0; j < kQueries; ++j) {
      model.step(before.col(j), current.col(j),
                 Eigen::Map<const Backbone>(previous.col(j).data(), points, 3),
                 Eigen::Map<Backbone>(next.col(j).data(), points, 3), workspace);
    }
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * kQueries);
}
BENCHMARK(step);

enum class Way { single, columns, rows };

// The layers alone.
void network(benchmark::State& state, Way way) {
  const PackedNetwork packed(network_of(BackboneLayout::base_poses), cpu_level());
  const int queries = way == Way::single ? 1 : static_cast<int>(state.range(0));
  const int width = packed.input_size();
  RandomStream random(1, 2);
  AlignedFloats input(static_cast<std::size_t>(width) * static_cast<std::size_t>(queries));
  for (float& x : input) {
    x = static_cast<float>(random.uniform(-1.0, 1.0));
  }
  AlignedFloats scratch(2 * static_cast<std::size_t>(packed.padded_width()) *
                        static_cast<std::size_t>(queries));
  for (auto _ : state) {
    if (way == Way::single) {
      benchmark::DoNotOptimize(packed.evaluate(input.data(), scratch.data()));
    } else if (way == Way::columns) {
      benchmark::DoNotOptimize(
          packed.evaluate_columns(queries, input.data(), width, scratch.data()));
    } else {
      benchmark::DoNotOptimize(packed.evaluate_rows(queries, input.data(), scratch.data()));
    }
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * queries);
}
BENCHMARK_CAPTURE(network, single, Way::single);
BENCHMARK_CAPTURE(network, columns, Way::columns)->Arg(2)->Arg(8)->Arg(24);
BENCHMARK_CAPTURE(network, rows, Way::rows)->Arg(16)->Arg(32)->Arg(64);

// range(0) steps fed back.
void rollout(benchmark::State& state) {
  const ForwardModel model(paper_arm(), network_of(BackboneLayout::base_poses));
  const int steps = static_cast<int>(state.range(0));
  const MatrixXf pressures = random_pressures_kpa(steps + 1, 0);
  MatrixXf backbones = unloaded(pressures);
  ForwardModel::Workspace workspace;
  for (auto _ : state) {
    model.rollout(pressures, backbones, workspace);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * steps);
}
BENCHMARK(rollout)->Arg(20)->Arg(200);

// range(0) motions of 1 to 40 frames side by side, ended ones compacted away.
void rollouts(benchmark::State& state) {
  const ForwardModel model(paper_arm(), network_of(BackboneLayout::base_poses));
  const int motions = static_cast<int>(state.range(0));
  const MatrixXf from_kpa = random_pressures_kpa(motions, 0);
  const MatrixXf to_kpa = random_pressures_kpa(motions, 1);
  const MatrixXf from = unloaded(from_kpa);
  RolloutBatch batch(model);
  std::int64_t queries = 0;
  for (auto _ : state) {
    for (int i = 0; i < motions; ++i) {
      batch.add(i, from_kpa.col(i),
                Eigen::Map<const Backbone>(from.col(i).data(), model.point_count(), 3),
                to_kpa.col(i), 1 + i * 7 % 40);
    }
    while (batch.size() > 0) {
      queries += batch.size();
      batch.step();
      for (int c = batch.size() - 1; c >= 0; --c) {
        if (batch.has_ended(c)) {
          batch.remove(c);
        }
      }
    }
  }
  state.SetItemsProcessed(queries);
}
BENCHMARK(rollouts)->Arg(64)->Arg(256);

}  // namespace
}  // namespace limber
