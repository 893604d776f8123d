#include "training_tables.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/network/backbone_layout.hpp"
#include "limber/network/past_commands.hpp"
#include "row_spread.hpp"

namespace limber {

namespace {

// What rotations count that nobody measured: enough for states to stay what they were made.
constexpr float kLiftedWeight = 0.1F;

/// Columns of all episodes' frames in user units, backbones in the network's layout.
struct RawFrames {
  Eigen::MatrixXf pressure_kpa;       // c×F: with past commands below
  Eigen::MatrixXf poses;              // 3m×F (7m in space), recorded, about the base
  Eigen::MatrixXf no_load_poses;      // the same of the unloaded arm
  Eigen::MatrixXf state;              // D×F, recorded, in the network's layout
  Eigen::MatrixXf no_load;            // D×F
  std::vector<std::uint8_t> tracked;  // F; empty: the arm was tracked in all frames
  std::vector<int> tracked_columns;   // those in which it was; empty: in all
  bool lifted = false;                // rotations in space were made from positions
};

/// Marks the frames in which the arm was not tracked.
void mark_untracked(const std::vector<Episode>& episodes, RawFrames& raw) {
  if (tracked_count(episodes) == frame_count(episodes)) {
    return;
  }
  for (const Episode& episode : episodes) {
    for (int t = 0; t < episode.frame_count(); ++t) {
      raw.tracked.push_back(episode.tracked.empty() ? 1 : episode.tracked[t]);
      if (raw.tracked.back() != 0) {
        raw.tracked_columns.push_back(int(raw.tracked.size()) - 1);
      }
    }
  }
  refuse_if(raw.tracked_columns.empty(),
            "the arm was tracked in none of the training "
            "data's {} frames: there is nothing to learn from",
            raw.tracked.size());
}

RawFrames gather(const ArmDescription& arm, const std::vector<Episode>& episodes,
                 const NetworkLayout& layout, const std::vector<int>& past_commands,
                 std::vector<EpisodeRange>& ranges) {
  if (layout.backbone_layout() == BackboneLayout::base_poses) {
    require_planar(arm, "a network of base poses (the preset paper)");
  }
  int count = 0;
  for (const Episode& episode : episodes) {
    ranges.push_back({count, episode.frame_count()});
    count += episode.frame_count();
  }
  refuse_if(count == 0,
            "the training data hold no frame in {} episodes; expected at least one "
            "episode to learn from",
            episodes.size());
  const int poses = pose_size(arm.dimension) * arm.point_count();
  RawFrames raw;
  raw.pressure_kpa.resize(layout.command_size(), count);
  raw.poses.resize(poses, count);
  raw.no_load_poses.resize(poses, count);
  const NoLoadModel no_load(arm);
  for (std::size_t index = 0; index < episodes.size(); ++index) {
    const EpisodeRange range = ranges[index];
    raw.pressure_kpa.middleCols(range.first, range.count) =
        with_past_commands(episodes[index].pressure_kpa.transpose(), past_commands);
    raw.poses.middleCols(range.first, range.count) = episodes[index].backbone.transpose();
  }
  for (Eigen::Index column = 0; column < count; ++column) {
    no_load.poses(raw.pressure_kpa.col(column).head(arm.channel_count()),
                  raw.no_load_poses.col(column));
  }
  raw.no_load = layout.encode(raw.no_load_poses);
  raw.state = layout.encode(raw.poses);
  if (arm.is_spatial()) {
    // Chained from the base, so that quaternions have the signs that predictions have.
    raw.poses = layout.decode(raw.state);
    raw.no_load_poses = layout.decode(raw.no_load);
    raw.lifted = !episodes.empty() && episodes.front().lifted;
  }
  mark_untracked(episodes, raw);
  return raw;
}

/// The columns in which the arm was tracked: guesses in between say nothing about ranges.
Eigen::MatrixXf tracked_only(Eigen::MatrixXf columns, const RawFrames& raw) {
  return raw.tracked_columns.empty() ? std::move(columns)
                                     : Eigen::MatrixXf(columns(Eigen::all, raw.tracked_columns));
}

Normalisation stack(const std::vector<Normalisation>& parts) {
  const auto size =
      sum_of<Eigen::Index>(parts, [&](const Normalisation& part) { return part.offset.size(); });
  Normalisation result{Eigen::VectorXf(size), Eigen::VectorXf(size)};
  Eigen::Index at = 0;
  for (const Normalisation& part : parts) {
    result.offset.segment(at, part.offset.size()) = part.offset;
    result.scale.segment(at, part.scale.size()) = part.scale;
    at += part.offset.size();
  }
  return result;
}

/// What changed since the frame before, in the episodes' first frames nothing.
Eigen::MatrixXf changes_of(const RawFrames& raw, const std::vector<EpisodeRange>& episodes) {
  Eigen::MatrixXf changes = Eigen::MatrixXf::Zero(raw.state.rows(), raw.state.cols());
  for (const EpisodeRange episode : episodes) {
    const int steps = std::max(episode.count - 1, 0);
    changes.middleCols(episode.first + 1, steps) =
        raw.state.middleCols(episode.first + 1, steps) - raw.state.middleCols(episode.first, steps);
  }
  return changes;
}

/// Scale of the changes from one tracked frame to the next. They are not shifted, so that no change
/// stays no change.
Normalisation measure_changes(const RawFrames& raw, const std::vector<EpisodeRange>& episodes,
                              const NetworkLayout& layout, Scaling scaling) {
  Eigen::MatrixXf changes = changes_of(raw, episodes);
  std::vector<Eigen::Index> known;
  for (std::size_t t = 0; t < raw.tracked.size(); ++t) {
    if (raw.tracked[t] != 0 && (t == 0 || raw.tracked[t - 1] != 0)) {
      known.push_back(Eigen::Index(t));
    }
  }
  if (!known.empty()) {
    changes = Eigen::MatrixXf(changes(Eigen::all, known));
  }
  Normalisation result = measure(changes, scaling, {angles_of_states(layout), kOfChanges});
  result.offset.setZero();
  return result;
}

Eigen::MatrixXf normalised(Eigen::MatrixXf columns, const Normalisation& by, Eigen::Index first) {
  const Eigen::Index size = columns.rows();
  columns.colwise() -= by.offset.segment(first, size);
  columns.array().colwise() *= by.scale.segment(first, size).array();
  return columns;
}

/// What the errors of each number count: in user units all the same.
Eigen::VectorXf error_weights(const Normalisation& spread, const TrainingSettings& settings) {
  return settings.error_in_user_units ? Eigen::VectorXf::Ones(spread.scale.size()) : spread.scale;
}

/// Frame errors over base poses, in units of the spread that compensation has in each of them.
FrameError<float> chained_error(const RawFrames& raw, const Normalisation& input,
                                const NetworkLayout& layout, const TrainingSettings& settings) {
  const Eigen::Index size = layout.backbone_size();
  const Eigen::Index poses = raw.poses.rows() - pose_size(layout.dimension());
  const Normalisation spread =
      measure(tracked_only((raw.poses - raw.no_load_poses).bottomRows(poses), raw),
              settings.scaling, {angles_of_poses(layout)});
  Eigen::VectorXf weights = error_weights(spread, settings);
  for (Eigen::Index row = 0; raw.lifted && row < poses; ++row) {
    weights[row] *= is_quaternion(row) ? kLiftedWeight : 1.0F;
  }
  return FrameError<float>(weights, input.scale.segment(layout.backbone_row(), size).cwiseInverse(),
                           input.offset.segment(layout.backbone_row(), size), layout.dimension());
}

/// Normalisations of state, no-load model and network's answer.
struct PoseScales {
  Normalisation state, no_load, output;
};

PoseScales measure_poses(const RawFrames& raw, const std::vector<EpisodeRange>& episodes,
                         const NetworkLayout& layout, const TrainingSettings& settings) {
  const Scaling scaling = settings.scaling;
  if (scaling == Scaling::shared_range || scaling == Scaling::range_by_unit) {
    const Eigen::MatrixXf state = tracked_only(raw.state, raw);
    Eigen::MatrixXf both(state.rows(), state.cols() + raw.no_load.cols());
    both << state, raw.no_load;
    const Normalisation shared =
        scaling == Scaling::shared_range
            ? measure(both, Scaling::unit_range, {angles_of_states(layout)})
            : joined_by_unit(both, angles_of_states(layout));
    return {shared, shared, {Eigen::VectorXf::Zero(state.rows()), shared.scale}};
  }
  const LeastSpread least{angles_of_states(layout)};
  return {measure(tracked_only(raw.state, raw), scaling, least),
          measure(tracked_only(layout.no_load_input(raw.no_load), raw), scaling),
          settings.form == OutputForm::gated_change
              ? measure_changes(raw, episodes, layout, scaling)
              : measure(tracked_only(raw.state - raw.no_load, raw), scaling, least)};
}

bool counts_base_poses(const NetworkLayout& layout, const TrainingSettings& settings) {
  return layout.backbone_layout() == BackboneLayout::gap_poses && settings.error_in_base_poses;
}

/// How network and state go together, by the normalisation and what the frames spread by.
void set_map(const RawFrames& raw, const NetworkLayout& layout, const TrainingSettings& settings,
             TrainingTables& tables) {
  const Eigen::Index size = layout.backbone_size();
  const auto state_scale = tables.input.scale.segment(layout.backbone_row(), size).array();
  tables.map.output_scale = state_scale / tables.output.scale.array();
  tables.map.form = settings.form;
  if (counts_base_poses(layout, settings)) {
    tables.map.error = chained_error(raw, tables.input, layout, settings);
  } else {
    // In units of the spread that compensation has.
    const Normalisation spread =
        settings.form == OutputForm::gated_change
            ? measure(tracked_only(raw.state - raw.no_load, raw), settings.scaling)
            : tables.output;
    tables.map.error = FrameError<float>(error_weights(spread, settings).array() / state_scale);
  }
  tables.map.growth_limit = float(settings.growth_limit);
  tables.map.first_frames_power = settings.first_frames_power;
  if (settings.reads_velocity) {
    tables.map.change_scale =
        tables.input.scale.segment(layout.change_row(), size).array() / state_scale;
  }
}

void normalise(RawFrames raw, const NetworkLayout& layout, const TrainingSettings& settings,
               TrainingTables& tables) {
  FrameTable<float>& frames = tables.frames;
  if (counts_base_poses(layout, settings)) {
    frames.target = raw.poses.bottomRows(raw.poses.rows() - pose_size(layout.dimension()));
  }
  if (settings.reads_velocity) {
    frames.change = changes_of(raw, tables.episodes).array().colwise() *
                    tables.input.scale.segment(layout.change_row(), layout.backbone_size()).array();
  }
  frames.tracked = std::move(raw.tracked);
  frames.pressure = normalised(std::move(raw.pressure_kpa), tables.input, layout.pressure_row());
  frames.state = normalised(std::move(raw.state), tables.input, layout.backbone_row());
  frames.no_load =
      normalised(layout.no_load_input(raw.no_load), tables.input, layout.no_load_row());
  raw.no_load.colwise() += tables.output.offset;
  frames.uncompensated = normalised(std::move(raw.no_load), tables.input, layout.backbone_row());
}

void require_varying_pressures(const Eigen::MatrixXf& pressure_kpa, const Command& command) {
  const auto range = pressure_kpa.rowwise().maxCoeff() - pressure_kpa.rowwise().minCoeff();
  if (range.maxCoeff() <= kConstantSpread) {
    throw InputError(fmt::format(
        "no {} changes in the training data ({} frames); expected recordings of a moving arm, "
        "such as those of 'limber collect --schedule transitions'",
        followed_name(command), pressure_kpa.cols()));
  }
}

}  // namespace

std::vector<int> past_commands_of(const ArmDescription& arm, const TrainingSettings& settings) {
  return settings.reads_past_commands ? default_past_commands(arm) : std::vector<int>();
}

TrainingTables make_training_tables(const ArmDescription& arm, const std::vector<Episode>& episodes,
                                    const TrainingSettings& settings, const TrainingTables* like) {
  const std::vector<int> past = past_commands_of(arm, settings);
  const NetworkLayout layout(settings.layout, settings.form, arm, settings.reads_velocity,
                             past.size());
  TrainingTables tables;
  RawFrames raw = gather(arm, episodes, layout, past, tables.episodes);
  if (like != nullptr) {
    tables.input = like->input;
    tables.output = like->output;
    tables.map = like->map;
  } else {
    require_varying_pressures(raw.pressure_kpa, arm.command);
    const Normalisation pressure = measure(tracked_only(raw.pressure_kpa, raw), settings.scaling);
    const PoseScales poses = measure_poses(raw, tables.episodes, layout, settings);
    tables.input = stack({pressure, pressure, poses.state, poses.no_load});
    if (settings.reads_velocity) {
      tables.input =
          stack({tables.input, measure_changes(raw, tables.episodes, layout, settings.scaling)});
    }
    tables.output = poses.output;
  }
  if (tables.map.output_scale.size() == 0) {
    set_map(raw, layout, settings, tables);
  }
  normalise(std::move(raw), layout, settings, tables);
  return tables;
}

void set_bounds(TrainingTables& tables, const TrainingSettings& settings, const GapBounds& bounds) {
  // The input's numbers are both pressures, the backbone and B̃; the output's are the backbone's.
  const Eigen::Index size = tables.map.output_scale.size();
  const Eigen::Index first = 2 * tables.frames.pressure.rows();
  StateBounds<float>& states = tables.map.bounds;
  states.layout = settings.layout;
  const bool in_space = bounds.max_bend_rad.size() > 0;
  states.dimension = in_space ? Dimension::space : Dimension::plane;
  states.scale = tables.input.scale.segment(first, size).cwiseInverse();
  states.offset = tables.input.offset.segment(first, size);
  states.gaps.clear();
  if (!settings.bounded) {
    return;
  }
  for (Eigen::Index i = 0; i < bounds.min_length_m.size(); ++i) {
    states.gaps.push_back(gap_bound(bounds.min_length_m[i], bounds.max_length_m[i],
                                    bounds.min_turn_rad[i], bounds.max_turn_rad[i],
                                    in_space ? bounds.max_bend_rad[i] : 0.0F));
  }
}

std::vector<int> window_starts(std::span<const EpisodeRange> episodes,
                               std::span<const std::uint8_t> tracked, int window_frames,
                               int shift) {
  const auto is_tracked = [&](int frame) { return tracked.empty() || tracked[frame] != 0; };
  std::vector<int> starts;
  for (const EpisodeRange& episode : episodes) {
    const int last = episode.first + episode.count - 1 - window_frames;
    int start = std::min(episode.first + shift, std::max(last, episode.first));
    while (start <= last) {
      if (!is_tracked(start)) {
        ++start;
        continue;
      }
      bool useful = false;
      for (int frame = start + 1; frame <= start + window_frames && !useful; ++frame) {
        useful = is_tracked(frame);
      }
      if (useful) {
        starts.push_back(start);
      }
      start += window_frames;
    }
  }
  return starts;
}

}  // namespace limber
