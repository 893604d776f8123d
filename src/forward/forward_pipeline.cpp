#include "forward_pipeline.hpp"

#include <algorithm>
#include <iterator>

#include "limber/arm/space_no_load.hpp"

namespace limber {

namespace {

// Queries of a tile: four AVX-512 vectors; a hidden layer of 100 then fits the first cache.
constexpr int kTileQueries = 64;

// Rows pay where at least two vectors of queries are nearly full; below, columns keep more lanes
// busy.
int min_rows(int lanes) {
  return 2 * lanes;
}
int max_columns(int lanes) {
  return min_rows(lanes) * 7 / 8;
}

StrainCurve pack(const StrainPolynomial& polynomial, double limit_kpa) {
  StrainCurve packed{};
  std::transform(polynomial.begin(), polynomial.end(), packed.coefficient,
                 [](double x) { return float(x); });
  packed.limit_kpa = float(limit_kpa);
  packed.at_limit = float(strain_at(polynomial, limit_kpa));
  packed.slope_per_kpa = float(std::max(0.0, strain_slope_at(polynomial, limit_kpa)));
  return packed;
}

NoLoadSegment pack(const Segment& segment, NoLoadKind kind) {
  NoLoadSegment packed{};
  packed.strain = pack(segment.strain_polynomial, segment.pressure_limit_kpa.largest_kpa());
  packed.length_m = float(segment.length_m);
  packed.width_m = float(segment.width_m);
  packed.gaps = segment.gaps;
  packed.has_strain = kind == NoLoadKind::strain_polynomial;
  packed.curvature_per_unit =
      kind == NoLoadKind::curvature ? float(segment.curvature_per_unit) : 0.0F;
  return packed;
}

NoLoadChamber pack(const Chamber& chamber) {
  const StrainPolynomial& polynomial = chamber.strain_polynomial;
  return {pack(polynomial, chamber.limit_kpa.largest_kpa()), float(chamber.sense),
          polynomial != StrainPolynomial{}};
}

int padded(int count, int lanes) {
  return (count + lanes - 1) / lanes * lanes;
}

}  // namespace

ForwardPipeline::ForwardPipeline(const ArmDescription& arm, const CompensationModel* model,
                                 CpuLevel level)
    : channels_(arm.channel_count()),
      points_(arm.point_count()),
      rows_(row_kernels(level)),
      gaps_(arm.is_spatial() ? rows_.in_space : rows_.in_plane),
      poses_(gaps_.pose_size * points_),
      layout_(model != nullptr ? model->layout : BackboneLayout::base_poses,
              model != nullptr ? model->form : OutputForm::compensation, arm,
              model != nullptr && model->reads_velocity,
              model != nullptr ? model->past_commands.size() : 0) {
  for (const Segment& segment : arm.segments) {
    no_load_.push_back(pack(segment, arm.no_load));
    for (const Chamber& chamber : segment.chambers) {
      in_space_.chambers.push_back(pack(chamber));
    }
    in_space_.gap_length_m.push_back(float(segment.length_m / segment.gaps));
    in_space_.gap_share.push_back(1.0F / float(segment.gaps));
  }
  if (arm.is_spatial()) {
    const SpaceNoLoad no_load(arm);
    for (const auto& row : no_load.shape_of_strains().rowwise()) {
      std::ranges::transform(row, std::back_inserter(in_space_.shape),
                             [](double share) { return float(share); });
    }
  }
  for (int gap = 0; gap + 1 < points_; ++gap) {
    segment_of_gap_.push_back(arm.segment_of_gap(gap));
  }
  if (model != nullptr) {
    network_.emplace(*model, level);
    for (int gap = 0; model->bounds && gap + 1 < points_; ++gap) {
      const GapBounds& b = *model->bounds;
      bounds_.push_back(gap_bound(b.min_length_m[gap], b.max_length_m[gap], b.min_turn_rad[gap],
                                  b.max_turn_rad[gap],
                                  arm.is_spatial() ? b.max_bend_rad[gap] : 0.0F));
    }
  }
}

std::size_t ForwardPipeline::scratch_size() const {
  // Base poses and gap poses as rows, then a network's input and two layers as rows or as columns.
  const int network = network_ ? layout_.input_size() + 2 * network_->padded_width() : channels_;
  return std::size_t((2 * poses_ + network) * kTileQueries);
}

void ForwardPipeline::run(int count, const QueryColumns& queries, float* scratch) const {
  for (int j = 0; j < count;) {
    int tile = std::min(kTileQueries, count - j);
    if (!network_) {
      run_no_load(tile, queries.from(j), scratch);
    } else if (tile <= max_columns(rows_.lanes)) {
      run_few(tile, queries.from(j), scratch);
    } else {
      // A remainder of few queries comes after the full vectors.
      const int rest = tile % min_rows(rows_.lanes);
      tile -= tile > rest && rest <= max_columns(rows_.lanes) ? rest : 0;
      run_many(tile, queries.from(j), scratch);
    }
    j += tile;
  }
}

void ForwardPipeline::run_no_load(int count, const QueryColumns& queries, float* scratch) const {
  const int stride = padded(count, rows_.lanes);
  float* const base = scratch;
  float* const gap = base + poses_ * stride;
  float* const pressure = gap + poses_ * stride;
  rows_.gather(channels_, count, queries.current_kpa.data, queries.current_kpa.ld, pressure,
               stride);
  no_load_rows(stride, pressure, gap);
  chain_no_load(stride, gap, base);
  rows_.scatter(poses_, count, base, stride, queries.next.data, queries.next.ld);
}

void ForwardPipeline::no_load_rows(int stride, const float* pressure, float* gap) const {
  if (layout_.dimension() == Dimension::space) {
    rows_.no_load_space_gaps(
        {layout_.segment_count(), channels_, in_space_.chambers.data(), in_space_.shape.data(),
         in_space_.gap_length_m.data(), in_space_.gap_share.data()},
        pressure, gap, stride);
  } else {
    rows_.no_load_gaps(no_load_.data(), layout_.segment_count(), pressure, gap, stride);
  }
}

// Of the segments' gaps to all plates. `gap` has room for all gaps.
void ForwardPipeline::chain_no_load(int stride, float* gap, float* base) const {
  if (layout_.dimension() == Dimension::plane) {
    rows_.chain_segments(no_load_.data(), layout_.segment_count(), gap, base, stride);
    return;
  }
  // In place, from the tip: a gap never lies before its segment's.
  const std::ptrdiff_t size = std::ptrdiff_t{gaps_.gap_size} * stride;
  for (int g = points_ - 2; g >= 0; --g) {
    std::copy_n(gap + size * segment_of_gap_[g], size, gap + size * g);
  }
  gaps_.decode(points_ - 1, gap, base, stride);
}

void ForwardPipeline::run_many(int count, const QueryColumns& queries, float* scratch) const {
  const int stride = padded(count, rows_.lanes);
  float* const base = scratch;
  float* const gap = base + poses_ * stride;
  float* const input = gap + poses_ * stride;
  float* const pressure = input + layout_.pressure_row() * stride;
  float* const backbone = input + layout_.backbone_row() * stride;
  float* const no_load = input + layout_.no_load_row() * stride;
  float* const change = input + layout_.change_row() * stride;
  float* const layers = input + layout_.input_size() * stride;
  const int commands = layout_.command_size();
  rows_.gather(commands, count, queries.previous_kpa.data, queries.previous_kpa.ld, input, stride);
  rows_.gather(commands, count, queries.current_kpa.data, queries.current_kpa.ld, pressure, stride);
  if (layout_.backbone_layout() == BackboneLayout::base_poses) {
    rows_.gather(poses_, count, queries.previous.data, queries.previous.ld, backbone, stride);
    if (layout_.reads_velocity()) {
      rows_.gather(poses_, count, queries.before.data, queries.before.ld, change, stride);
      subtract_from(backbone, poses_ * stride, change);
    }
    no_load_rows(stride, pressure, gap);
    chain_no_load(stride, gap, no_load);
    const float* output = network_->evaluate_rows(stride, input, layers);
    const int all = poses_ * stride;
    compose(all, backbone, no_load, output, output + all, base);
    if (!bounds_.empty()) {
      rows_.bound_base(points_ - 1, bounds_.data(), base, stride);
    }
  } else {
    rows_.gather(poses_, count, queries.previous.data, queries.previous.ld, base, stride);
    gaps_.encode(points_ - 1, base, backbone, stride);
    if (layout_.reads_velocity()) {
      rows_.gather(poses_, count, queries.before.data, queries.before.ld, base, stride);
      gaps_.encode(points_ - 1, base, change, stride);
      subtract_from(backbone, layout_.backbone_size() * stride, change);
    }
    no_load_rows(stride, pressure, no_load);
    compose_gaps(stride, backbone, no_load, network_->evaluate_rows(stride, input, layers), gap);
    if (!bounds_.empty()) {
      gaps_.bound(points_ - 1, bounds_.data(), gap, stride);
    }
    gaps_.decode(points_ - 1, gap, base, stride);
  }
  rows_.scatter(poses_, count, base, stride, queries.next.data, queries.next.ld);
}

void ForwardPipeline::run_few(int count, const QueryColumns& queries, float* scratch) const {
  const int stride = padded(count, rows_.lanes);
  const int ld = layout_.input_size();
  const int width = network_->padded_width();
  float* const base = scratch;
  float* const gap = base + poses_ * stride;
  float* const input = gap + poses_ * stride;  // columns from here on
  float* const layers = input + ld * count;
  float* const pressure = layers;  // rows again, read before the layers are written
  const bool has_gap_poses = layout_.backbone_layout() == BackboneLayout::gap_poses;
  for (int q = 0; q < count; ++q) {
    write_column(queries.from(q), input + q * ld);
  }
  rows_.gather(channels_, count, queries.current_kpa.data, queries.current_kpa.ld, pressure,
               stride);
  no_load_rows(stride, pressure, gap);
  if (!has_gap_poses) {
    chain_no_load(stride, gap, base);
  }
  rows_.scatter(layout_.no_load_size(), count, has_gap_poses ? gap : base, stride,
                input + layout_.no_load_row(), ld);
  const float* outputs = network_->evaluate_columns(count, input, ld, layers);
  for (int q = 0; q < count; ++q) {
    const float* const previous = input + q * ld + layout_.backbone_row();
    const float* const no_load = input + q * ld + layout_.no_load_row();
    const float* const output = outputs + q * width;
    const float* const gate = output + layout_.backbone_size();
    if (has_gap_poses) {
      spread_over_gaps(no_load, base);
      compose(layout_.backbone_size(), previous, base, output, gate, gap);
      if (!bounds_.empty()) {
        gaps_.bound_one(points_ - 1, bounds_.data(), gap);
      }
      gaps_.decode_one(points_ - 1, gap, queries.next.column(q));
    } else {
      float* const next = queries.next.column(q);
      compose(layout_.backbone_size(), previous, no_load, output, gate, next);
      if (!bounds_.empty()) {
        rows_.bound_base_of_one(points_ - 1, bounds_.data(), next);
      }
    }
  }
}

// All of the first query's input but B̃.
void ForwardPipeline::write_column(const QueryColumns& queries, float* column) const {
  const auto encode = [&](const float* base_poses, float* to) {
    if (layout_.backbone_layout() == BackboneLayout::gap_poses) {
      gaps_.encode_one(points_ - 1, base_poses, to);
    } else {
      std::copy_n(base_poses, poses_, to);
    }
  };
  std::copy_n(queries.previous_kpa.data, layout_.command_size(), column);
  std::copy_n(queries.current_kpa.data, layout_.command_size(), column + layout_.pressure_row());
  float* const backbone = column + layout_.backbone_row();
  encode(queries.previous.data, backbone);
  if (layout_.reads_velocity()) {
    float* const change = column + layout_.change_row();
    encode(queries.before.data, change);
    subtract_from(backbone, layout_.backbone_size(), change);
  }
}

void ForwardPipeline::subtract_from(const float* after, int count, float* change) {
  for (int i = 0; i < count; ++i) {
    change[i] = after[i] - change[i];
  }
}

// Of B̃ there is one gap pose per segment; every gap of it gets its own.
void ForwardPipeline::spread_over_gaps(const float* no_load, float* gaps) const {
  for (std::size_t g = 0; g < segment_of_gap_.size(); ++g) {
    const int size = gaps_.gap_size;
    std::copy_n(no_load + size * segment_of_gap_[g], size, gaps + size * int(g));
  }
}

// (5) or (16) for `count` numbers. `gate` is not read where the model has none.
void ForwardPipeline::compose(int count, const float* previous, const float* no_load,
                              const float* output, const float* gate, float* next) const {
  if (layout_.output_form() == OutputForm::gated_change) {
    rows_.gated_change(count, previous, no_load, output, gate, next);
  } else {
    rows_.add(count, no_load, output, next);
  }
}

// The same gap by gap: of B̃ there is one gap pose per segment.
void ForwardPipeline::compose_gaps(int stride, const float* previous, const float* no_load,
                                   const float* output, float* next) const {
  const float* gates = output + layout_.backbone_size() * stride;
  for (int g = 0; g + 1 < points_; ++g) {
    const int segment = segment_of_gap_[g];
    const int at = gaps_.gap_size * g * stride;
    compose(gaps_.gap_size * stride, previous + at, no_load + gaps_.gap_size * segment * stride,
            output + at, gates + at, next + at);
  }
}

}  // namespace limber
