#include <algorithm>
#include <cmath>
#include <limits>

#include "command_change.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/statistics.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/data/simple_model.hpp"

namespace limber {

namespace {

constexpr int kMaxRows = 20000;  // of a fit; frames between are left out, evenly
constexpr double kLongestLag_s = 1.0;
constexpr double kLagStep_s = 0.05;
constexpr double kClearlyBetter = 0.002;  // of the loss: no lag for less than that
constexpr int kIterations = 20;
constexpr double kHuber = 1.345;  // of the scale: 95 % efficient without outliers
constexpr int kBlocksOfOne = 10;
constexpr int kMaxBlocks = 50;
constexpr double kTiny_rad = 1e-9;
constexpr double kAtRest = 0.03;  // of the limit: a command that is about zero …
constexpr double kRest_s = 0.5;   // … for so long
constexpr std::size_t kMinFramesAtRest = 20;

/// A frame that is fitted to, and the piece that the jackknife leaves out with it.
struct FrameOf {
  int episode = 0;
  int frame = 0;
  int block = 0;
};

int block_count(const std::vector<Episode>& episodes) {
  return episodes.size() > 1 ? std::min(int(episodes.size()), kMaxBlocks) : kBlocksOfOne;
}

/// Frames in which the arm was tracked, thinned evenly.
std::vector<FrameOf> frames_of(const std::vector<Episode>& episodes) {
  const int blocks = block_count(episodes);
  const auto count = int(episodes.size());
  std::vector<FrameOf> tracked;
  for (std::size_t e = 0; e < episodes.size(); ++e) {
    const int frames = episodes[e].frame_count();
    for (const int t : tracked_frames(episodes[e])) {
      const int block = count > 1 ? int(e) * blocks / count : t * blocks / frames;
      tracked.push_back({int(e), t, block});
    }
  }
  const std::size_t step = tracked.size() / kMaxRows + 1;
  std::vector<FrameOf> kept;
  for (std::size_t k = 0; k < tracked.size(); k += step) {
    kept.push_back(tracked[k]);
  }
  return kept;
}

/// Heading of each segment's last plate less that of its first, and its length along the arcs
/// between its plates.
struct Shapes {
  Eigen::MatrixXd turn_rad;  // rows × n
  Eigen::MatrixXd length_m;
};

Shapes shapes_of(const ArmDescription& arm, const std::vector<Episode>& episodes,
                 const std::vector<FrameOf>& frames) {
  const auto rows = Eigen::Index(frames.size());
  Shapes shapes{Eigen::MatrixXd(rows, arm.segment_count()),
                Eigen::MatrixXd::Zero(rows, arm.segment_count())};
  for (Eigen::Index r = 0; r < rows; ++r) {
    const FrameOf& at = frames[r];
    const Eigen::RowVectorXd poses = episodes[at.episode].backbone.row(at.frame).cast<double>();
    Eigen::Index column = 0;
    for (int i = 0; i < arm.segment_count(); ++i) {
      const double first_rad = poses[column + 2];
      for (int gap = 0; gap < arm.segments[i].gaps; ++gap, column += kPoseSize) {
        const double turn_rad = poses[column + kPoseSize + 2] - poses[column + 2];
        const double chord_m =
            (poses.segment<2>(column + kPoseSize) - poses.segment<2>(column)).norm();
        shapes.length_m(r, i) += chord_m / std::max(chord_share(turn_rad), 0.1);
      }
      shapes.turn_rad(r, i) = poses[column + 2] - first_rad;
    }
  }
  return shapes;
}

struct Line {
  double slope = 0.0;
  double offset = 0.0;
};

/// Weighted sums of a straight line's fit.
struct Sums {
  double weight = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;

  void add(double w, double one_x, double one_y) {
    weight += w;
    x += w * one_x;
    y += w * one_y;
    xx += w * one_x * one_x;
    xy += w * one_x * one_y;
  }
  void add(const Sums& part) {
    weight += part.weight;
    x += part.x;
    y += part.y;
    xx += part.xx;
    xy += part.xy;
  }
  Sums without(const Sums& part) const {
    return {weight - part.weight, x - part.x, y - part.y, xx - part.xx, xy - part.xy};
  }
  /// @param slope  held there where `free` is false.
  Line line(double slope, bool free) const {
    const double spread = xx * weight - x * x;
    if (free && spread > 0.0) {
      slope = (xy * weight - x * y) / spread;
    }
    return {slope, weight > 0.0 ? (y - slope * x) / weight : 0.0};
  }
};

/// Huber's line through (x, y), and the sums of each block at its weights.
struct RobustLine {
  Line line;
  double loss = 0.0;  // median |residual|
  std::vector<Sums> blocks;
};

RobustLine fit_line(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                    const std::vector<FrameOf>& frames, double slope, bool free, int blocks) {
  RobustLine fit;
  double scale = 0.0;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    throw_if_interrupted();
    fit.blocks.assign(std::size_t(blocks), {});
    Sums all;
    for (Eigen::Index r = 0; r < x.size(); ++r) {
      const double residual = std::abs(y[r] - fit.line.slope * x[r] - fit.line.offset);
      const double weight =
          iteration == 0 || residual <= kHuber * scale ? 1.0 : kHuber * scale / residual;
      all.add(weight, x[r], y[r]);
      fit.blocks[frames[std::size_t(r)].block].add(weight, x[r], y[r]);
    }
    fit.line = all.line(slope, free);
    const Eigen::ArrayXd sizes = (y.array() - fit.line.slope * x.array() - fit.line.offset).abs();
    fit.loss = median(std::vector<double>(sizes.begin(), sizes.end()));
    scale = std::max(kScaleOfMedian * fit.loss, kTiny_rad);
  }
  return fit;
}

/// 95 % interval about `value` from its leave-one-out values.
Interval jackknife(double value, const std::vector<double>& left_out) {
  if (left_out.size() < 2) {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  const double half = kTwoSided95 * jackknife_error(left_out);
  return {value - half, value + half};
}

class SimpleFitter {
 public:
  SimpleFitter(const ArmDescription& arm, const std::vector<Episode>& episodes)
      : arm_(arm), episodes_(episodes), frames_(frames_of(episodes)) {
    refuse_if(
        episodes.empty(),
        "the simple model can't be fitted: no episodes given; expected at least one. Where one "
        "is kept for the end, it takes two");
    refuse_if(frames_.empty(),
              "the simple model can't be fitted: the arm was tracked in none of the frames of {} "
              "episodes",
              episodes.size());
    seen_ = shapes_of(arm, episodes, frames_);
    blocks_ = block_count(episodes);
  }

  SimpleFit run() {
    double best_loss = 0.0;
    std::vector<RobustLine> best;
    SimpleFit fit;
    for (int step = 0; step * kLagStep_s <= kLongestLag_s; ++step) {
      const double lag_s = step * kLagStep_s;
      Eigen::MatrixXd expected = rows_of(lag_s);
      std::vector<RobustLine> lines;
      double loss = 0.0;
      for (int i = 0; i < arm_.segment_count(); ++i) {
        lines.push_back(fit_line(expected.col(i), seen_.turn_rad.col(i), frames_, held_slope(),
                                 moved(i), blocks_));
        loss += lines.back().loss;
      }
      if (step == 0 || loss < (1.0 - kClearlyBetter) * best_loss) {
        best_loss = loss;
        best = std::move(lines);
        expected_ = std::move(expected);
        fit.model.lag_s = lag_s;
      }
    }
    fit.blocks = blocks_;
    for (int i = 0; i < arm_.segment_count(); ++i) {
      add_segment(i, best[i], fit);
    }
    return fit;
  }

 private:
  /// Of a segment whose command tells nothing: as the arm file has it.
  double held_slope() const { return arm_.no_load == NoLoadKind::straight ? 0.0 : 1.0; }

  bool moved(int segment) const { return command_changes(arm_, episodes_, segment); }

  Eigen::MatrixXd rows_of(double lag_s) const {
    std::vector<Eigen::MatrixXd> turns;
    for (const Episode& episode : episodes_) {
      throw_if_interrupted();
      turns.push_back(lagged_turns(arm_, episode, lag_s));
    }
    Eigen::MatrixXd rows(Eigen::Index(frames_.size()), arm_.segment_count());
    for (Eigen::Index r = 0; r < rows.rows(); ++r) {
      const FrameOf& at = frames_[r];
      rows.row(r) = turns[at.episode].row(at.frame);
    }
    return rows;
  }

  /// Measured lengths over what the no-load model expects.
  std::vector<double> length_ratios(int i, int without_block) const {
    const NoLoadModel no_load(arm_);
    std::vector<double> ratios;
    for (std::size_t r = 0; r < frames_.size(); ++r) {
      if (frames_[r].block == without_block) {
        continue;
      }
      const FrameOf& at = frames_[r];
      const double command = double(episodes_[at.episode].pressure_kpa(at.frame, i));
      const double expected_m = no_load.segment_shape(i, command).length_m;
      ratios.push_back(seen_.length_m(Eigen::Index(r), i) / expected_m);
    }
    return ratios;
  }

  /// Whether a segment's command has been about zero for a while.
  bool is_at_rest(const FrameOf& at, int i) const {
    const Episode& episode = episodes_[at.episode];
    const Segment& segment = arm_.segments[i];
    const double about_zero = kAtRest * segment.pressure_limit_kpa.half_width_kpa();
    const int first = at.frame - arm_.frames_in(kRest_s);
    return first >= 0 &&
           episode.pressure_kpa.col(i).segment(first, at.frame - first + 1).cwiseAbs().maxCoeff() <=
               float(about_zero);
  }

  /// Measured lengths at rest over the arm file's.
  std::optional<double> rest_length_ratio(int i) const {
    const Segment& segment = arm_.segments[i];
    std::vector<double> ratios;
    for (std::size_t r = 0; r < frames_.size(); ++r) {
      if (is_at_rest(frames_[r], i)) {
        ratios.push_back(seen_.length_m(Eigen::Index(r), i) / segment.length_m);
      }
    }
    return ratios.size() < kMinFramesAtRest ? std::nullopt : std::optional(median(ratios));
  }

  void add_segment(int i, const RobustLine& robust, SimpleFit& fit) const {
    SimpleSegment segment{robust.line.slope, robust.line.offset, median(length_ratios(i, -1))};
    Sums all;
    for (const Sums& block : robust.blocks) {
      all.add(block);
    }
    std::vector<double> gains;
    std::vector<double> offsets;
    std::vector<double> ratios;
    for (std::size_t b = 0; b < robust.blocks.size(); ++b) {
      throw_if_interrupted();
      if (robust.blocks[b].weight > 0.0 && robust.blocks[b].weight < all.weight) {
        const Line line = all.without(robust.blocks[b]).line(held_slope(), moved(i));
        gains.push_back(line.slope);
        offsets.push_back(line.offset);
        ratios.push_back(median(length_ratios(i, int(b))));
      }
    }
    const Eigen::VectorXd x = expected_.col(i).array() - expected_.col(i).mean();
    const Eigen::VectorXd y = seen_.turn_rad.col(i).array() - seen_.turn_rad.col(i).mean();
    const double size = x.norm() * y.norm();
    fit.model.segments.push_back(segment);
    fit.segments.push_back({jackknife(segment.gain, gains), jackknife(segment.offset_rad, offsets),
                            jackknife(segment.length_ratio, ratios), robust.loss,
                            size > 0.0 ? x.dot(y) / size : 0.0, moved(i), rest_length_ratio(i)});
  }

  const ArmDescription& arm_;
  const std::vector<Episode>& episodes_;
  std::vector<FrameOf> frames_;
  Shapes seen_;
  Eigen::MatrixXd expected_;
  int blocks_ = 0;
};

}  // namespace

SimpleFit fit_simple_model(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  require_episodes_of(episodes, arm);
  return fit_to_any(arm, episodes);
}

SimpleFit fit_to_any(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  return SimpleFitter(arm, episodes).run();
}

}  // namespace limber
