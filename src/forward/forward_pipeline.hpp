#pragma once

#include <optional>
#include <vector>

#include "limber/common/aligned_floats.hpp"
#include "limber/network/backbone_layout.hpp"
#include "limber/network/packed_network.hpp"
#include "row_kernels.hpp"

namespace limber {

/// Columns of floats: column j begins at data + j·ld.
template <class Float>
struct ColumnsOf {
  Float* data;
  int ld;
  Float* column(int j) const { return data + std::ptrdiff_t(j) * ld; }
  ColumnsOf from(int j) const { return {column(j), ld}; }
};
using ConstColumns = ColumnsOf<const float>;
using Columns = ColumnsOf<float>;

/// Queries and the addresses of their answers.
struct QueryColumns {
  ConstColumns previous_kpa;
  ConstColumns current_kpa;
  ConstColumns previous;
  Columns next;
  ConstColumns before;  ///< B_{t−2}; read where the model reads velocities
  QueryColumns from(int j) const {
    return {previous_kpa.from(j), current_kpa.from(j), previous.from(j), next.from(j),
            before.from(j)};
  }
};

/// How ForwardModel computes. Everything but the network, and the network for many queries, works
/// on rows: one number of all queries of a tile after the other, one vector lane per query. The
/// network for a few queries works on columns, so that no lane is idle. Both give the same bits.
/// Constant after construction.
class ForwardPipeline {
 public:
  /// @param model  null for the no-load model. @pre valid, of this arm; this CPU runs `level`.
  ForwardPipeline(const ArmDescription& arm, const CompensationModel* model, CpuLevel level);

  /// Floats of scratch that `run` needs, whatever the batch.
  std::size_t scratch_size() const;

  /// `count` queries. `next` may be `previous` or `before`.
  void run(int count, const QueryColumns& queries, float* scratch) const;

 private:
  void run_no_load(int count, const QueryColumns& queries, float* scratch) const;
  void run_many(int count, const QueryColumns& queries, float* scratch) const;
  void run_few(int count, const QueryColumns& queries, float* scratch) const;
  void write_column(const QueryColumns& queries, float* column) const;
  /// change = after − change.
  static void subtract_from(const float* after, int count, float* change);
  void compose(int count, const float* previous, const float* no_load, const float* output,
               const float* gate, float* next) const;
  void spread_over_gaps(const float* no_load, float* gaps) const;
  void compose_gaps(int stride, const float* previous, const float* no_load, const float* output,
                    float* next) const;

  void no_load_rows(int stride, const float* pressure, float* gap) const;
  void chain_no_load(int stride, float* gap, float* base) const;

  int channels_;
  int points_;
  const RowKernels& rows_;
  const GapKernels& gaps_;
  int poses_;  ///< numbers of all plates about the base
  std::vector<NoLoadSegment> no_load_;
  struct SpaceTables {
    std::vector<NoLoadChamber> chambers;
    std::vector<float> shape;
    std::vector<float> gap_length_m;
    std::vector<float> gap_share;
  };
  SpaceTables in_space_;  ///< of an arm in space
  std::vector<int> segment_of_gap_;
  std::vector<GapBound<float>> bounds_;  ///< of (20), one per gap; empty: none
  NetworkLayout layout_;
  std::optional<PackedNetwork> network_;
};

}  // namespace limber
