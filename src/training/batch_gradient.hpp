#pragma once

#include <span>
#include <vector>

#include "kernels/job_arena.hpp"
#include "limber/training/window_gradient.hpp"
#include "training_tables.hpp"

namespace limber {

/// Loss and gradient of batches of windows of one length, over all cores, for one network or for
/// several of one shape, which share what is gathered for a batch. A batch is cut into fixed
/// chunks, whose gradients are added in the order of the chunks. So the result has the same bits
/// for any number of threads. Letters: P parameters per network, N networks.
class BatchGradient {
 public:
  /// @param tables  must outlive this object.
  /// @param jobs    threads, 0: one per core.
  /// @param networks  N ≥ 1.
  BatchGradient(const TrainingTables& tables, const ParameterLayout& layout, int window_frames,
                int windows_per_batch, int jobs, int networks = 1);

  /// Sums of the windows' errors, one per network; their gradients go to `gradient`.
  /// Valid until the next call. It allocates nothing of its own.
  /// @param parameters  N·P, one network after the other; so is `gradient`, resized where it must.
  std::span<const double> compute(std::span<const int> starts, const Eigen::VectorXf& parameters,
                                  Eigen::VectorXf& gradient);

 private:
  void compute_chunk(std::size_t chunk, std::span<const int> starts,
                     const Eigen::VectorXf& parameters);

  /// Sum over the chunks of their numbers `first`, first + 1, …
  void add_chunks(std::size_t first, std::size_t count, std::size_t chunks,
                  Eigen::VectorXf& gradient) const;

  const TrainingTables& tables_;
  Eigen::Index parameters_;  ///< P
  std::size_t networks_;     ///< N
  int windows_per_chunk_;
  std::vector<Eigen::VectorXf> gradients_;  ///< N·P per chunk
  std::vector<double> losses_;              ///< N per chunk, the first chunk's become the sums
  JobArena arena_;
  std::vector<WindowGradient<float>> workspaces_;  ///< one for each thread of the arena
};

}  // namespace limber
