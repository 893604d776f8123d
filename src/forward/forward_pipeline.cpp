#include "forward/forward_pipeline.hpp"

#include <algorithm>

namespace limber {

namespace {

// Queries in flight: four AVX-512 vectors; a hidden layer of 100 then fits the first cache.
constexpr int kTileQueries = 64;
// Up to here queries ask the network one by one: their weights come from the second cache each
// time, but none of their lanes is idle.
constexpr int kFewQueries = 3;

NoLoadSegment pack(const Segment& segment) {
  const StrainPolynomial& c = segment.strain_polynomial;
  const double p = segment.pressure_limit_kpa;
  NoLoadSegment packed{};
  std::transform(c.begin(), c.end(), packed.strain_coefficient,
                 [](double x) { return static_cast<float>(x); });
  packed.pressure_limit_kpa = static_cast<float>(p);
  packed.strain_at_limit = static_cast<float>(p * (c[0] + p * (c[1] + p * (c[2] + p * c[3]))));
  packed.slope_at_limit_per_kpa = static_cast<float>(
      std::max(0.0, c[0] + p * (2.0 * c[1] + p * (3.0 * c[2] + p * 4.0 * c[3]))));
  packed.length_m = static_cast<float>(segment.length_m);
  packed.width_m = static_cast<float>(segment.width_m);
  packed.gaps = segment.gaps;
  return packed;
}

int padded(int count, int lanes) {
  return (count + lanes - 1) / lanes * lanes;
}

}  // namespace

ForwardPipeline::ForwardPipeline(const ArmDescription& arm, const CompensationModel* model,
                                 CpuLevel level)
    : segments_(arm.segment_count()),
      points_(arm.point_count()),
      rows_(row_kernels(level)),
      layout_(model != nullptr ? model->layout : BackboneLayout::base_poses, arm) {
  for (const Segment& segment : arm.segments) {
    no_load_.push_back(pack(segment));
  }
  for (int gap = 0; gap + 1 < points_; ++gap) {
    segment_of_gap_.push_back(arm.segment_of_gap(gap));
  }
  if (model != nullptr) {
    network_.emplace(*model, level);
  }
}

std::size_t ForwardPipeline::scratch_size() const {
  const int base = 3 * points_;
  const int gaps = 3 * segments_;
  const int network = network_ ? layout_.input_size() + 2 * network_->padded_width() : segments_;
  // The gathered input of one query and its padding, for `compensate`.
  const int alone = network_ ? layout_.input_size() + 2 * network_->padded_width() : 0;
  return static_cast<std::size_t>((base + gaps + network) * kTileQueries + alone);
}

void ForwardPipeline::run(int count, ConstColumns previous_kpa, ConstColumns current_kpa,
                          ConstColumns previous, Columns next, float* scratch) const {
  for (int j = 0; j < count; j += kTileQueries) {
    run_tile(std::min(kTileQueries, count - j), {previous_kpa.column(j), previous_kpa.ld},
             {current_kpa.column(j), current_kpa.ld}, {previous.column(j), previous.ld},
             {next.column(j), next.ld}, scratch);
  }
}

void ForwardPipeline::run_tile(int count, ConstColumns previous_kpa, ConstColumns current_kpa,
                               ConstColumns previous, Columns next, float* scratch) const {
  const int stride = padded(count, rows_.lanes);
  float* const base = scratch;
  float* const gap = base + 3 * points_ * stride;
  float* const input = gap + 3 * segments_ * stride;
  if (!network_) {
    rows_.gather(segments_, count, current_kpa.data, current_kpa.ld, input, stride);
    rows_.no_load_gaps(no_load_.data(), segments_, input, gap, stride);
    rows_.chain_segments(no_load_.data(), segments_, gap, base, stride);
    rows_.scatter(3 * points_, count, base, stride, next.data, next.ld);
    return;
  }
  const bool in_base_poses = layout_.backbone_layout() == BackboneLayout::base_poses;
  float* const pressure = input + layout_.pressure_row() * stride;
  float* const backbone = input + layout_.backbone_row() * stride;
  float* const no_load = input + layout_.no_load_row() * stride;
  float* const behind = input + layout_.input_size() * stride;
  rows_.gather(segments_, count, previous_kpa.data, previous_kpa.ld, input, stride);
  rows_.gather(segments_, count, current_kpa.data, current_kpa.ld, pressure, stride);
  if (in_base_poses) {
    rows_.gather(3 * points_, count, previous.data, previous.ld, backbone, stride);
    rows_.no_load_gaps(no_load_.data(), segments_, pressure, gap, stride);
    rows_.chain_segments(no_load_.data(), segments_, gap, no_load, stride);
    const float* compensation = compensate(count, stride, input, behind);
    rows_.add(3 * points_ * stride, no_load, compensation, base);
  } else {
    rows_.gather(3 * points_, count, previous.data, previous.ld, base, stride);
    rows_.encode_gaps(points_ - 1, base, backbone, stride);
    rows_.no_load_gaps(no_load_.data(), segments_, pressure, no_load, stride);
    const float* compensation = compensate(count, stride, input, behind);
    // B_{t−1} has been read: its place takes the gap poses of B_t.
    for (int g = 0; g + 1 < points_; ++g) {
      const int segment = segment_of_gap_[static_cast<std::size_t>(g)];
      rows_.add(3 * stride, no_load + 3 * segment * stride, compensation + 3 * g * stride,
                backbone + 3 * g * stride);
    }
    rows_.decode_gaps(points_ - 1, backbone, base, stride);
  }
  rows_.scatter(3 * points_, count, base, stride, next.data, next.ld);
}

const float* ForwardPipeline::compensate(int count, int stride, const float* input,
                                         float* scratch) const {
  if (count > kFewQueries) {
    return network_->evaluate_rows(stride, input, scratch);
  }
  float* const alone = scratch + network_->padded_width() * stride;
  for (int q = 0; q < count; ++q) {
    for (int r = 0; r < network_->input_size(); ++r) {
      alone[r] = input[r * stride + q];
    }
    const float* output = network_->evaluate(alone, alone + network_->input_size());
    for (int r = 0; r < network_->output_size(); ++r) {
      scratch[r * stride + q] = output[r];
    }
  }
  return scratch;
}

}  // namespace limber
