#include "limber/training/training_tables.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/error.hpp"
#include "limber/network/backbone_layout.hpp"

namespace limber {

namespace {

// A column whose numbers spread by less than this (kPa, m or rad) is constant: float32's rounding.
constexpr float kConstantSpread = 1e-6F;

/// Unscaled columns: pressures n×F, no-load and recorded backbones D×F in the network's layout.
FrameTable<float> gather(const ArmDescription& arm, const std::vector<Episode>& episodes,
                         BackboneLayout layout, std::vector<EpisodeRange>& ranges) {
  int frames = 0;
  for (const Episode& episode : episodes) {
    ranges.push_back({frames, episode.frame_count()});
    frames += episode.frame_count();
  }
  if (frames == 0) {
    throw InputError("the training data hold no frame");
  }
  const int size = layout_size(layout, arm.point_count());
  FrameTable<float> table{Eigen::MatrixXf(arm.segment_count(), frames),
                          Eigen::MatrixXf(size, frames), Eigen::MatrixXf(size, frames)};
  const NoLoadModel no_load(arm);
  Backbone prior(arm.point_count(), 3);
  Eigen::Index column = 0;
  for (const Episode& episode : episodes) {
    for (int t = 0; t < episode.frame_count(); ++t, ++column) {
      table.pressure.col(column) = episode.pressure_kpa.row(t).transpose();
      no_load.backbone(table.pressure.col(column), prior);
      to_layout(layout, prior, table.prior.col(column));
      const Eigen::Map<const Backbone> recorded(episode.backbone.row(t).data(), arm.point_count(),
                                                3);
      to_layout(layout, recorded, table.state.col(column));
    }
  }
  return table;
}

/// Offset and scale of each row of `columns`.
Normalisation measure(const Eigen::MatrixXf& columns, Scaling scaling) {
  Normalisation result{Eigen::VectorXf(columns.rows()), Eigen::VectorXf(columns.rows())};
  for (Eigen::Index i = 0; i < columns.rows(); ++i) {
    const auto row = columns.row(i);
    const float low = row.minCoeff();
    const float range = row.maxCoeff() - low;
    float offset = low;
    float spread = range;
    if (scaling == Scaling::unit_spread) {
      const double mean = row.cast<double>().mean();
      offset = static_cast<float>(mean);
      spread = static_cast<float>(std::sqrt((row.cast<double>().array() - mean).square().mean()));
    }
    result.offset[i] = offset;
    result.scale[i] = range > kConstantSpread ? 1.0F / spread : 1.0F;
  }
  return result;
}

Normalisation stack(const std::vector<Normalisation>& parts) {
  Eigen::Index size = 0;
  for (const Normalisation& part : parts) {
    size += part.offset.size();
  }
  Normalisation result{Eigen::VectorXf(size), Eigen::VectorXf(size)};
  Eigen::Index at = 0;
  for (const Normalisation& part : parts) {
    result.offset.segment(at, part.offset.size()) = part.offset;
    result.scale.segment(at, part.scale.size()) = part.scale;
    at += part.offset.size();
  }
  return result;
}

void normalise(Eigen::MatrixXf& columns, const Normalisation& by, Eigen::Index first) {
  const Eigen::Index size = columns.rows();
  columns.colwise() -= by.offset.segment(first, size);
  columns.array().colwise() *= by.scale.segment(first, size).array();
}

void normalise(TrainingTables& tables) {
  const Eigen::Index n = tables.frames.pressure.rows();
  const Eigen::Index size = tables.frames.state.rows();
  normalise(tables.frames.pressure, tables.input, n);
  normalise(tables.frames.state, tables.input, 2 * n);
  normalise(tables.frames.prior, tables.input, 2 * n + size);
  tables.map = make_state_map(tables.input, tables.output, static_cast<int>(n));
}

void require_varying_pressures(const Eigen::MatrixXf& pressure_kpa) {
  const auto range = pressure_kpa.rowwise().maxCoeff() - pressure_kpa.rowwise().minCoeff();
  if (range.maxCoeff() <= kConstantSpread) {
    throw InputError(fmt::format(
        "no pressure changes in the training data ({} frames); expected recordings of an arm that "
        "moves, such as 'limber collect --schedule transitions' makes",
        pressure_kpa.cols()));
  }
}

}  // namespace

StateMap<float> make_state_map(const Normalisation& input, const Normalisation& output,
                               int segment_count) {
  const Eigen::Index size = output.scale.size();
  const Eigen::Index state = 2 * segment_count;
  const Eigen::ArrayXf state_scale = input.scale.segment(state, size);
  const Eigen::ArrayXf state_offset = input.offset.segment(state, size);
  const Eigen::ArrayXf prior_scale = input.scale.segment(state + size, size);
  const Eigen::ArrayXf prior_offset = input.offset.segment(state + size, size);
  StateMap<float> map;
  map.prior_scale = state_scale / prior_scale;
  map.offset = (prior_offset + output.offset.array() - state_offset) * state_scale;
  map.output_scale = state_scale / output.scale.array();
  map.loss_weight = output.scale.array() / state_scale;
  return map;
}

TrainingTables make_training_tables(const ArmDescription& arm, const std::vector<Episode>& episodes,
                                    BackboneLayout layout, Scaling scaling) {
  TrainingTables tables;
  tables.frames = gather(arm, episodes, layout, tables.episodes);
  require_varying_pressures(tables.frames.pressure);
  const Normalisation pressure = measure(tables.frames.pressure, scaling);
  tables.input = stack({pressure, pressure, measure(tables.frames.state, scaling),
                        measure(tables.frames.prior, scaling)});
  tables.output = measure(tables.frames.state - tables.frames.prior, scaling);
  normalise(tables);
  return tables;
}

TrainingTables make_training_tables(const ArmDescription& arm, const std::vector<Episode>& episodes,
                                    BackboneLayout layout, const Normalisation& input,
                                    const Normalisation& output) {
  TrainingTables tables;
  tables.input = input;
  tables.output = output;
  tables.frames = gather(arm, episodes, layout, tables.episodes);
  normalise(tables);
  return tables;
}

std::vector<int> window_starts(const std::vector<EpisodeRange>& episodes, int window_frames,
                               int shift) {
  std::vector<int> starts;
  for (const EpisodeRange& episode : episodes) {
    const int last = episode.count - 1 - window_frames;
    for (int start = std::min(shift, std::max(last, 0)); start <= last; start += window_frames) {
      starts.push_back(episode.first + start);
    }
  }
  return starts;
}

}  // namespace limber
