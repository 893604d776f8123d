#pragma once

#include <memory>
#include <span>
#include <vector>

#include "limber/training/training_tables.hpp"
#include "limber/training/window_gradient.hpp"

namespace limber {

/// Loss and gradient of batches of windows of one length, over all cores: a batch is cut into fixed
/// chunks, whose gradients are added in the order of the chunks. So the result has the same bits
/// for any number of threads.
class BatchGradient {
 public:
  /// @param tables  must outlive this object.
  /// @param jobs    threads, 0: one a core.
  BatchGradient(const TrainingTables& tables, const ParameterLayout& layout, int window_frames,
                int windows_per_batch, int jobs);
  ~BatchGradient();

  /// Sum over the windows of their errors; its gradient goes to `gradient`.
  /// @param noise       standard deviation added to the first backbones, normalised; 0: none.
  /// @param seed,stream of that noise; chunk i of the batch draws from stream + i.
  double compute(std::span<const int> starts, const Eigen::VectorXf& parameters, double noise,
                 std::uint64_t seed, std::uint64_t stream, Eigen::VectorXf& gradient);

  /// Chunks that a full batch is cut into.
  int chunk_count() const;

 private:
  struct Threads;

  void compute_chunk(int chunk, std::span<const int> starts, const Eigen::VectorXf& parameters,
                     double noise, std::uint64_t seed, std::uint64_t stream);

  const TrainingTables& tables_;
  int windows_per_chunk_;
  std::vector<Eigen::VectorXf> gradients_;  ///< one a chunk
  std::vector<double> losses_;              ///< one a chunk
  std::unique_ptr<Threads> threads_;
};

}  // namespace limber
