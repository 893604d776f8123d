#include "log_resampling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "held_poses.hpp"
#include "limber/common/error.hpp"
#include "limber/common/statistics.hpp"
#include "limber/data/median_rate.hpp"
#include "longest_gap.hpp"

namespace limber {

namespace {

constexpr double kShortestPiece_s = 1.0;
constexpr double kMissingRow = 1.5;        // a longer step, in median steps, has lost a row
constexpr double kRounding_s = 1e-6;       // of times written with six digits
constexpr double kMovingSetpoint = 0.001;  // of the limit, between frames
constexpr double kMovingCommand = 0.01;    // the same where only noisy measurements are there
// Numbers of frames are whole in double: 45 million years at 20 Hz.
constexpr double kMaxFrameNumber = 1e15;
constexpr int kStillFrames = 4;  // before a motion begins, where only measurements are
// Between set points along a path, 4 or more per second; steps are held longer.
constexpr double kSlowestPath_s = 0.3;

/// The rows around a moment.
struct Bracket {
  Eigen::Index before = -1;
  Eigen::Index after = -1;
  double part = 0.0;  // fraction of the time from before to after
  bool valid() const { return before >= 0; }
};

/// Finds brackets at rising times.
class RowFinder {
 public:
  /// @param usual_step_s  0: the median step
  RowFinder(const std::vector<double>& time_s, double longest_gap_s, double usual_step_s = 0.0)
      : time_s_(time_s),
        longest_gap_s_(longest_gap_s),
        longest_step_s_(usual_step_s > 0.0 ? kMissingRow * usual_step_s
                                           : kMissingRow / median_rate_hz(time_s)) {}

  /// Invalid outside of the track and within long gaps.
  Bracket at(double time_s) {
    const bool holds = std::isinf(longest_gap_s_);
    if (time_s < time_s_.front() - kRounding_s ||
        (!holds && time_s > time_s_.back() + kRounding_s)) {
      return {};
    }
    while (next_ + 1 < time_s_.size() && time_s_[next_ + 1] <= time_s + kRounding_s) {
      ++next_;
    }
    const auto row = Eigen::Index(next_);
    if (std::abs(time_s_[next_] - time_s) <= kRounding_s || next_ + 1 == time_s_.size()) {
      return {row, row, 0.0};
    }
    const double step_s = time_s_[next_ + 1] - time_s_[next_];
    if (step_s > std::max(longest_gap_s_, longest_step_s_)) {
      return {};
    }
    return {row, row + 1, (time_s - time_s_[next_]) / step_s};
  }

  /// A step that is longer than usual, and than a frame: nothing finer is asked for.
  bool has_lost_row(const Bracket& bracket, double frame_period_s) const {
    return time_s_[std::size_t(bracket.after)] - time_s_[std::size_t(bracket.before)] >
           std::max(longest_step_s_, frame_period_s + kRounding_s);
  }

 private:
  const std::vector<double>& time_s_;
  double longest_gap_s_;
  double longest_step_s_;
  std::size_t next_ = 0;
};

Eigen::RowVectorXd row_at(const Eigen::MatrixXd& values, const Bracket& bracket) {
  return values.row(bracket.before) +
         bracket.part * (values.row(bracket.after) - values.row(bracket.before));
}

/// The same of poses, T×7m in space: rotations on the shortest way.
Eigen::RowVectorXd poses_at(const Eigen::MatrixXd& poses, const Bracket& bracket,
                            Dimension dimension) {
  Eigen::RowVectorXd row = row_at(poses, bracket);
  for (Eigen::Index q = 3; dimension == Dimension::space && q < row.size(); q += kSpacePoseSize) {
    const Eigen::Quaterniond before(poses.block<1, 4>(bracket.before, q).transpose());
    const Eigen::Quaterniond after(poses.block<1, 4>(bracket.after, q).transpose());
    row.segment<4>(q) = before.slerp(bracket.part, after).normalized().coeffs().transpose();
  }
  return row;
}

/// Frames in a row, to become an episode.
struct Piece {
  std::vector<double> time_s;
  std::vector<Eigen::RowVectorXd> measured;
  std::vector<Eigen::RowVectorXd> setpoint;
  std::vector<Eigen::RowVectorXd> backbone;
  std::vector<double> motion;
  std::vector<std::uint8_t> tracked;
};

FrameMatrix stacked(const std::vector<Eigen::RowVectorXd>& rows) {
  FrameMatrix matrix(Eigen::Index(rows.size()), rows.front().size());
  for (std::size_t t = 0; t < rows.size(); ++t) {
    matrix.row(Eigen::Index(t)) = rows[t].cast<float>();
  }
  return matrix;
}

/// Standard deviation of a column's noise, from second differences, which steady motion leaves out.
/// Neighbouring frames share rows where logs are hardly faster than the arm; three apart do not.
double noise_of(const FrameMatrix& values, Eigen::Index column) {
  constexpr double kOfSecondDifference = 2.449489742783;  // √6
  constexpr Eigen::Index kApart = 3;
  std::vector<double> sizes;
  for (Eigen::Index t = 2 * kApart; t < values.rows(); ++t) {
    sizes.push_back(std::abs(double(values(t, column)) - 2.0 * values(t - kApart, column) +
                             values(t - 2 * kApart, column)));
  }
  return sizes.empty() ? 0.0 : kScaleOfMedian * median(std::move(sizes)) / kOfSecondDifference;
}

/// Frames to take the mean of, before and after, so that `change` a frame is no noise.
Eigen::Index mean_of_frames(double noise, double change, Eigen::Index most) {
  constexpr double kNoNoise = 5.0;  // standard deviations
  const double frames = std::pow(kNoNoise * M_SQRT2 * noise / change, 2.0 / 3.0);
  return std::clamp(Eigen::Index(std::ceil(std::min(frames, double(most)))), Eigen::Index{1}, most);
}

/// Whether each frame moves by more than `min_change` of the limits.
std::vector<bool> moving_frames(const FrameMatrix& values, const ArmDescription& arm,
                                double min_change) {
  constexpr double kLongestMean_s = 0.5;
  std::vector<bool> moves(std::size_t(values.rows()), false);
  for (Eigen::Index i = 0; i < values.cols(); ++i) {
    const double change = min_change * arm.limits_of_channel(int(i)).half_width_kpa();
    const Eigen::Index mean_of =
        mean_of_frames(noise_of(values, i), change, std::max(arm.frames_in(kLongestMean_s), 1));
    for (Eigen::Index t = 1; t < values.rows(); ++t) {
      const Eigen::Index before = std::min(mean_of, t);
      const Eigen::Index after = std::min(mean_of, values.rows() - t);
      const double step = values.col(i).segment(t, after).cast<double>().mean() -
                          values.col(i).segment(t - before, before).cast<double>().mean();
      if (std::abs(step) > change * double(mean_of)) {
        moves[t] = true;
      }
    }
  }
  return moves;
}

/// Frames that set points stand still before a motion begins. Along a path they stand for some
/// frames after each change, and the motion goes on: one has to be given twice. Steps, which change
/// as often to another side, are motions of their own.
int still_frames_of(const FrameMatrix& setpoints, double frame_period_s) {
  std::vector<double> apart;  // frames from one change to the next
  std::size_t onward = 0;     // of those, to the same side
  Eigen::RowVectorXf before;
  Eigen::Index last = 0;
  for (Eigen::Index t = 1; t < setpoints.rows(); ++t) {
    if (setpoints.row(t) == setpoints.row(t - 1)) {
      continue;
    }
    const Eigen::RowVectorXf change = setpoints.row(t) - setpoints.row(t - 1);
    if (before.size() > 0) {
      apart.push_back(double(t - last));
      onward += change.dot(before) > 0.0F ? 1 : 0;
    }
    before = change;
    last = t;
  }
  if (2 * onward <= apart.size()) {
    return 1;
  }
  const double usual = median(std::move(apart));
  return usual * frame_period_s > kSlowestPath_s ? 1 : int(2.0 * usual) - 1;
}

/// Numbers of motions: a motion begins where something moves that stood still.
std::vector<int> number_motions(const FrameMatrix& values, const ArmDescription& arm,
                                bool are_setpoints) {
  const std::vector<bool> moves =
      moving_frames(values, arm, are_setpoints ? kMovingSetpoint : kMovingCommand);
  const int still_frames =
      are_setpoints ? still_frames_of(values, arm.frame_period_s()) : kStillFrames;
  std::vector<int> motions = {0};
  int still = still_frames;
  for (std::size_t t = 1; t < moves.size(); ++t) {
    const bool begins = moves[t] && still >= still_frames && t > 1;
    motions.push_back(motions.back() + int(begins));
    still = moves[t] ? 0 : still + 1;
  }
  return motions;
}

class Resampler {
 public:
  Resampler(const BackboneTrack& motion, const CommandTrack& commands, const ArmDescription& arm,
            const LongestGap& longest_gap, RunReport& report)
      : motion_(motion),
        commands_(commands),
        arm_(arm),
        motion_rows_(motion.time_s, longest_gap_in_s(longest_gap, motion.time_s),
                     motion.usual_step_s),
        // A set point holds until another one is given, however long that takes.
        command_rows_(commands.time_s, commands.measured
                                           ? longest_gap_in_s(longest_gap, commands.time_s)
                                           : std::numeric_limits<double>::infinity()),
        hang_(rows_that_hang(motion, commands, arm)),
        report_(report) {}

  std::vector<Episode> run() {
    note_rows_that_hang();
    const double period_s = arm_.frame_period_s();
    const double from = std::max(motion_.time_s.front(), commands_.time_s.front());
    const double to = commands_.measured ? std::min(motion_.time_s.back(), commands_.time_s.back())
                                         : motion_.time_s.back();  // the last set point holds
    const double begin = std::ceil((from - kRounding_s) / period_s);
    const double end = std::floor((to + kRounding_s) / period_s);
    if (!(begin <= end && -begin <= kMaxFrameNumber && end <= kMaxFrameNumber)) {
      return {};
    }
    const auto last = std::int64_t(end);
    for (auto k = std::int64_t(begin); k <= last; ++k) {
      add_frame(double(k) * period_s);
    }
    finish_piece();
    return std::move(episodes_);
  }

 private:
  void add_frame(double time_s) {
    const Bracket seen = motion_rows_.at(time_s);
    const Bracket told = command_rows_.at(time_s);
    const bool tracked =
        seen.valid() && told.valid() && is_tracked(seen.before) && is_tracked(seen.after);
    Eigen::RowVectorXd measured;
    if (tracked) {
      measured = commands_.measured ? row_at(commands_.values, told)
                                    : Eigen::RowVectorXd(commands_.values.row(told.before));
    }
    if (!tracked || !measured.allFinite()) {
      finish_piece();
      ++lost_;
      return;
    }
    piece_.time_s.push_back(time_s);
    piece_.measured.push_back(measured);
    if (commands_.setpoint.size() > 0) {
      // A set point jumps: the one in force is that of the row before, never something between.
      piece_.setpoint.emplace_back(commands_.setpoint.row(told.before));
    }
    if (!commands_.motion.empty()) {
      const double motion = commands_.motion[std::size_t(told.before)];
      const bool empty = !std::isfinite(motion) && !piece_.motion.empty();
      piece_.motion.push_back(empty ? piece_.motion.back() : motion);
    }
    piece_.backbone.push_back(poses_at(motion_.poses, seen, arm_.dimension));
    const bool filled =
        motion_.bridged[std::size_t(seen.before)] || motion_.bridged[std::size_t(seen.after)];
    const bool lost = motion_rows_.has_lost_row(seen, arm_.frame_period_s());
    piece_.tracked.push_back(!filled && !lost ? 1 : 0);
  }

  bool is_tracked(Eigen::Index row) const {
    return motion_.tracked[std::size_t(row)] && !hang_[std::size_t(row)];
  }

  void note_rows_that_hang() {
    const auto first = std::ranges::find(hang_, true);
    if (first != hang_.end()) {
      report_.note(
          fmt::format("rows left out that repeat a pose to the bit while a {} moves by more than "
                      "half of its range: the tracker hangs",
                      arm_.command.name),
          fmt::format("at {:.3f} s", motion_.time_s[std::size_t(first - hang_.begin())]),
          std::ranges::count(hang_, true));
    }
  }

  void finish_piece() {
    Piece piece = std::move(piece_);
    piece_ = {};
    const double length_s = double(piece.time_s.size()) * arm_.frame_period_s();
    if (piece.time_s.empty()) {
      return;
    }
    if (length_s < kShortestPiece_s) {
      report_.note(
          "frames left out in pieces shorter than a second",
          fmt::format("{} frames from {:.3f} s", piece.time_s.size(), piece.time_s.front()),
          std::int64_t(piece.time_s.size()));
      return;
    }
    if (lost_ > 0 && !episodes_.empty()) {
      report_.note("gaps too long to bridge, each ending an episode",
                   fmt::format("{} frames before {:.3f} s", lost_, piece.time_s.front()));
    }
    lost_ = 0;
    episodes_.push_back(episode_of(piece));
  }

  Episode episode_of(const Piece& piece) const {
    Episode episode;
    episode.time_s =
        Eigen::Map<const Eigen::VectorXd>(piece.time_s.data(), Eigen::Index(piece.time_s.size()));
    episode.pressure_kpa = stacked(piece.measured);
    episode.setpoints_only = !commands_.measured;
    episode.dimension = arm_.dimension;
    const bool has_setpoints = !piece.setpoint.empty() || episode.setpoints_only;
    episode.setpoint_kpa = piece.setpoint.empty() ? episode.pressure_kpa : stacked(piece.setpoint);
    if (!episode.setpoint_kpa.allFinite()) {
      carry_setpoints(episode);
    }
    episode.backbone = stacked(piece.backbone);
    episode.tracked = piece.tracked;
    if (!piece.motion.empty()) {
      // Numbers begin at 0 and never fall: a log's own may restart or begin anywhere.
      int number = 0;
      for (std::size_t t = 0; t < piece.motion.size(); ++t) {
        number += int(t > 0 && std::abs(piece.motion[t] - piece.motion[t - 1]) > 0.0);
        episode.motion_index.push_back(number);
      }
    } else {
      episode.motion_index = number_motions(episode.setpoint_kpa, arm_, has_setpoints);
    }
    return episode;
  }

  /// An empty set point is the last one given; before the first, the measured command.
  static void carry_setpoints(Episode& episode) {
    for (Eigen::Index t = 0; t < episode.setpoint_kpa.rows(); ++t) {
      for (Eigen::Index i = 0; i < episode.setpoint_kpa.cols(); ++i) {
        float& value = episode.setpoint_kpa(t, i);
        if (!std::isfinite(value)) {
          value = t > 0 ? episode.setpoint_kpa(t - 1, i) : episode.pressure_kpa(t, i);
        }
      }
    }
  }

  const BackboneTrack& motion_;
  const CommandTrack& commands_;
  const ArmDescription& arm_;
  RowFinder motion_rows_;
  RowFinder command_rows_;
  std::vector<bool> hang_;  // rows of the motion
  RunReport& report_;
  Piece piece_;
  std::int64_t lost_ = 0;
  std::vector<Episode> episodes_;
};

}  // namespace

std::vector<Episode> resample(const std::string& log, const BackboneTrack& motion,
                              const CommandTrack& commands, const ArmDescription& arm,
                              const LongestGap& longest_gap, RunReport& report) {
  std::vector<Episode> episodes = Resampler(motion, commands, arm, longest_gap, report).run();
  if (episodes.empty()) {
    throw InputError(
        fmt::format("{}: nothing is left: motion is logged from {:.12g} s to {:.12g} s, commands "
                    "from {:.12g} s to {:.12g} s on the same clock, and no second of both is "
                    "without a gap longer than {} s. Are the clocks and the time's unit right? A "
                    "longer recording is needed otherwise",
                    log, motion.time_s.front(), motion.time_s.back(), commands.time_s.front(),
                    commands.time_s.back(), longest_gap));
  }
  if (!commands.measured) {
    report.note("nothing measured: the recording holds set points only");
  } else if (commands.setpoint.size() == 0) {
    report.note("no set points logged: the measured commands take their place");
  }
  for (const Episode& episode : episodes) {
    ++report.episodes;
    report.frames += episode.frame_count();
    report.frames_not_tracked += episode.untracked_count();
  }
  return episodes;
}

}  // namespace limber
