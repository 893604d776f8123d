#include "batch_gradient.hpp"

#include <algorithm>
#include <cassert>

#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include "flushed_subnormals.hpp"
#include "training_kernels.hpp"

namespace limber {

namespace {

// Frames of a chunk: many enough for efficient products, few enough that every core gets some.
constexpr int kFramesPerChunk = 512;
constexpr int kWindowsPerChunk = 32;
constexpr int kMinWindowsPerChunk = 16;  // of a small batch, which is halved; fewer are inefficient
// Numbers of the chunks' gradients that one task adds up.
constexpr std::size_t kNumbersPerSum = 8192;

int windows_per_chunk(int window_frames, int windows_per_batch) {
  const int windows = std::max(kFramesPerChunk / window_frames, kWindowsPerChunk);
  const int half = std::max(windows_per_batch / 2, kMinWindowsPerChunk);
  return std::min({windows, half, windows_per_batch});
}

}  // namespace

BatchGradient::BatchGradient(const TrainingTables& tables, const ParameterLayout& layout,
                             int window_frames, int windows_per_batch, int jobs, int networks)
    : tables_(tables),
      parameters_(layout.size()),
      networks_(std::size_t(networks)),
      windows_per_chunk_(windows_per_chunk(window_frames, windows_per_batch)),
      arena_(jobs) {
  const int chunks = (windows_per_batch + windows_per_chunk_ - 1) / windows_per_chunk_;
  gradients_.assign(std::size_t(chunks), Eigen::VectorXf::Zero(layout.size() * networks));
  losses_.assign(std::size_t(chunks) * networks_, 0.0);
  const int segments = int(tables.frames.pressure.rows());
  for (int thread = 0; thread < arena_.jobs(); ++thread) {
    workspaces_.emplace_back(layout, tables.map, segments, window_frames, windows_per_chunk_);
  }
}

void BatchGradient::compute_chunk(std::size_t chunk, std::span<const int> starts,
                                  const Eigen::VectorXf& parameters) {
  const FlushedSubnormals flushed;
  const auto thread = std::size_t(tbb::this_task_arena::current_thread_index());
  const std::size_t first = chunk * std::size_t(windows_per_chunk_);
  const std::size_t count = std::min(starts.size() - first, std::size_t(windows_per_chunk_));
  WindowGradient<float>& workspace = workspaces_[thread];
  workspace.load(tables_.frames, starts.subspan(first, count));
  for (std::size_t network = 0; network < networks_; ++network) {
    const Eigen::Index offset = Eigen::Index(network) * parameters_;
    losses_[chunk * networks_ + network] = workspace.forward(parameters.data() + offset);
    workspace.backward(parameters.data() + offset, gradients_[chunk].data() + offset);
  }
}

void BatchGradient::add_chunks(std::size_t first, std::size_t count, std::size_t chunks,
                               Eigen::VectorXf& gradient) const {
  const FlushedSubnormals flushed;
  float* sum = gradient.data() + first;
  std::copy_n(gradients_[0].data() + first, count, sum);
  for (std::size_t chunk = 1; chunk < chunks; ++chunk) {
    optimiser_kernels().add(int(count), gradients_[chunk].data() + first, sum);
  }
}

std::span<const double> BatchGradient::compute(std::span<const int> starts,
                                               const Eigen::VectorXf& parameters,
                                               Eigen::VectorXf& gradient) {
  const std::size_t per_chunk = std::size_t(windows_per_chunk_);
  const std::size_t chunks = (starts.size() + per_chunk - 1) / per_chunk;
  assert(chunks >= 1 && chunks <= gradients_.size());
  arena_.for_each(
      chunks, [&](std::size_t chunk) { compute_chunk(chunk, starts, parameters); },
      tbb::simple_partitioner());
  gradient.resize(gradients_.front().size());
  const auto size = std::size_t(gradient.size());
  arena_.for_each((size + kNumbersPerSum - 1) / kNumbersPerSum,
                  [&](std::size_t part) {
                    const std::size_t first = part * kNumbersPerSum;
                    add_chunks(first, std::min(kNumbersPerSum, size - first), chunks, gradient);
                  },
                  tbb::simple_partitioner());
  for (std::size_t chunk = 1; chunk < chunks; ++chunk) {
    for (std::size_t network = 0; network < networks_; ++network) {
      losses_[network] += losses_[chunk * networks_ + network];
    }
  }
  return std::span(losses_).first(networks_);
}

}  // namespace limber
