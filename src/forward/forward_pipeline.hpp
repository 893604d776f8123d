#pragma once

#include <optional>
#include <vector>

#include "forward/row_kernels.hpp"
#include "limber/common/aligned_floats.hpp"
#include "limber/network/backbone_layout.hpp"
#include "limber/network/packed_network.hpp"

namespace limber {

/// Columns of floats: column j begins at data + j·ld.
struct ConstColumns {
  const float* data;
  int ld;
  const float* column(int j) const { return data + static_cast<std::ptrdiff_t>(j) * ld; }
};
struct Columns {
  float* data;
  int ld;
  float* column(int j) const { return data + static_cast<std::ptrdiff_t>(j) * ld; }
};

/// How ForwardModel computes: a batch is cut into tiles of kTileQueries; a tile's numbers are
/// gathered into rows (one vector lane a query), pass through row kernels and the packed network
/// and are scattered back. Few queries share the row kernels, but ask the network one by one.
/// Constant after construction.
class ForwardPipeline {
 public:
  /// @param model  null for the no-load model. @pre valid, of this arm; this CPU runs `level`.
  ForwardPipeline(const ArmDescription& arm, const CompensationModel* model, CpuLevel level);

  /// Floats of scratch that `run` needs, whatever the batch.
  std::size_t scratch_size() const;

  /// `count` queries. `next` may be `previous`.
  void run(int count, ConstColumns previous_kpa, ConstColumns current_kpa, ConstColumns previous,
           Columns next, float* scratch) const;

 private:
  void run_tile(int count, ConstColumns previous_kpa, ConstColumns current_kpa,
                ConstColumns previous, Columns next, float* scratch) const;
  const float* compensate(int count, int stride, const float* input, float* scratch) const;

  int segments_;
  int points_;
  const RowKernels& rows_;
  std::vector<NoLoadSegment> no_load_;
  std::vector<int> segment_of_gap_;
  NetworkLayout layout_;
  std::optional<PackedNetwork> network_;
};

}  // namespace limber
