#pragma once

#include <vector>

#include "forward_pipeline.hpp"

namespace limber {

/// What a model answers: its network or, where an ensemble's mean is asked for, the mean of what
/// all its networks say of the same queries, (21). Columns stay independent of each other.
/// Constant after construction.
class EnsemblePipeline {
 public:
  /// @param model  null for the no-load model. @pre valid, of this arm; this CPU runs `level`.
  EnsemblePipeline(const ArmDescription& arm, const CompensationModel* model, CpuLevel level);

  /// Floats of scratch that `run` needs, whatever the batch.
  std::size_t scratch_size() const;

  /// `count` queries. `next` may be `previous`.
  void run(int count, const QueryColumns& queries, float* scratch) const;

 private:
  void run_mean(int count, const QueryColumns& queries, float* scratch) const;

  std::vector<ForwardPipeline> members_;
  int numbers_;  // of a backbone, 3m
};

}  // namespace limber
