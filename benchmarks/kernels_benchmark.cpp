// Matrix kernels, each on every CPU level that runs here. Rates are multiply-adds, to be held
// against multiply_add, the machine's peak.
#include <string>

#include <benchmark/benchmark.h>

#include "limber/common/aligned_floats.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/network/gemm_kernels.hpp"

namespace limber {
namespace {

constexpr int kUnits = 100;  // of the paper's hidden layers

AlignedFloats random_floats(int count, std::uint64_t stream) {
  RandomStream random(1, stream);
  AlignedFloats floats(static_cast<std::size_t>(count));
  for (float& x : floats) {
    x = static_cast<float>(random.uniform(-1.0, 1.0));
  }
  return floats;
}

void report_multiply_adds(benchmark::State& state, double per_iteration) {
  state.counters["MAC"] =
      benchmark::Counter(per_iteration, benchmark::Counter::kIsIterationInvariantRate);
}

void multiply_add(benchmark::State& state, CpuLevel level) {
  constexpr long kRounds = 100'000;
  const GemmKernels& kernels = gemm_kernels(level);
  for (auto _ : state) {
    benchmark::DoNotOptimize(kernels.multiply_add(kRounds));
  }
  report_multiply_adds(state, static_cast<double>(kRounds) * kernels.multiply_adds_per_round);
}

// A hidden layer over range(0) queries, one per column.
void layer(benchmark::State& state, CpuLevel level) {
  const GemmKernels& kernels = gemm_kernels(level);
  const int queries = static_cast<int>(state.range(0));
  const AlignedFloats weight = random_floats(kUnits * kUnits, 0);
  const AlignedFloats input = random_floats(kUnits * queries, 1);
  const AlignedFloats bias = random_floats(kUnits, 2);
  AlignedFloats output(input.size());
  for (auto _ : state) {
    kernels.layer(kUnits, queries, kUnits, weight.data(), kUnits, input.data(), kUnits, bias.data(),
                  true, output.data(), kUnits);
    benchmark::ClobberMemory();
  }
  report_multiply_adds(state, 1.0 * kUnits * kUnits * queries);
}

// The same, one per row.
void layer_of_rows(benchmark::State& state, CpuLevel level) {
  const GemmKernels& kernels = gemm_kernels(level);
  const int queries = static_cast<int>(state.range(0));
  const AlignedFloats input = random_floats(queries * kUnits, 0);
  const AlignedFloats weight = random_floats(kUnits * kUnits, 1);
  const AlignedFloats bias = random_floats(kUnits, 2);
  AlignedFloats output(input.size());
  for (auto _ : state) {
    kernels.layer_of_rows(queries, kUnits, kUnits, input.data(), queries, weight.data(), kUnits,
                          bias.data(), true, output.data(), queries);
    benchmark::ClobberMemory();
  }
  report_multiply_adds(state, 1.0 * kUnits * kUnits * queries);
}

// Names are kernel/level/queries.
const bool kRegistered = [] {
  for (const CpuLevel level : available_cpu_levels()) {
    const auto named = [level](const char* kernel) {
      return std::string(kernel) + '/' + to_string(level);
    };
    const auto sized = [](benchmark::internal::Benchmark* benchmark) {
      benchmark->Arg(1)->Arg(16)->Arg(64)->Arg(512);
    };
    benchmark::RegisterBenchmark(named("multiply_add").c_str(), multiply_add, level);
    sized(benchmark::RegisterBenchmark(named("layer").c_str(), layer, level));
    sized(benchmark::RegisterBenchmark(named("layer_of_rows").c_str(), layer_of_rows, level));
  }
  return true;
}();

}  // namespace
}  // namespace limber
