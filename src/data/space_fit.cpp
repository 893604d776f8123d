#include "limber/data/space_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "command_change.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/arm/space_no_load.hpp"
#include "limber/arm/space_pose.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"
#include "limber/data/episode_slice.hpp"

namespace limber {

namespace {

constexpr int kMinFitFrames = 100;  // tracked: fewer tell a fit nothing
constexpr int kSpacePieces = 10;    // of the jackknife
constexpr int kRobustRounds = 3;
constexpr double kSpaceHuber = 2.0;  // medians beyond which a frame counts less
constexpr double kLongestDead_s = 0.6;
constexpr double kFinestStep_s = 0.005;
constexpr std::array<double, 14> kLags_s = {0.0,  0.02, 0.04, 0.06, 0.08, 0.1,  0.13,
                                            0.17, 0.22, 0.3,  0.4,  0.55, 0.75, 1.0};

/// Commands behind a dead time and a lag, T×n; the first frame's held before.
Eigen::MatrixXd lagged(const FrameMatrix& commands, double period_s, double dead_time_s,
                       double lag_s) {
  const Eigen::Index frames = commands.rows();
  Eigen::MatrixXd result(frames, commands.cols());
  const double open = lag_s > 0.0 ? 1.0 - std::exp(-period_s / lag_s) : 1.0;
  const double late = dead_time_s / period_s;
  const auto whole = Eigen::Index(std::floor(late));
  const double part = late - double(whole);
  const auto at = [&](Eigen::Index t) {
    return commands.row(std::max(t, Eigen::Index{0})).cast<double>();
  };
  Eigen::RowVectorXd now = at(0);
  for (Eigen::Index t = 0; t < frames; ++t) {
    const Eigen::RowVectorXd asked = (1.0 - part) * at(t - whole) + part * at(t - whole - 1);
    now += open * (asked - now);
    result.row(t) = now;
  }
  return result;
}

/// What one unit of each number of a shape moves the tip by, about [m].
Eigen::VectorXd levers_m(const ArmDescription& arm) {
  Eigen::VectorXd levers(kShapeRows * arm.segment_count());
  double beyond_m = 0.0;
  for (int i = arm.segment_count() - 1; i >= 0; --i) {
    const double length_m = arm.segments[i].length_m;
    const double lever_m = beyond_m + 0.5 * length_m;
    levers.segment<kShapeRows>(kShapeRows * i) << lever_m, lever_m, length_m;
    beyond_m += length_m;
  }
  return levers;
}

/// Where the parabola through errors one step apart is least, in steps from the middle one.
double vertex(const Eigen::Vector3d& off) {
  const double bend = off[0] - 2.0 * off[1] + off[2];
  return bend > 0.0 ? std::clamp(0.5 * (off[0] - off[2]) / bend, -1.0, 1.0) : 0.0;
}

/// Fits one model after the other to the same frames.
class SpaceFitter {
 public:
  SpaceFitter(const ArmDescription& arm, const std::vector<Episode>& episodes)
      : arm_(arm), no_load_(arm), episodes_(episodes), levers_m_(levers_m(arm)) {
    for (std::size_t e = 0; e < episodes.size(); ++e) {
      for (const int t : tracked_frames(episodes[e])) {
        frames_.emplace_back(e, t);
      }
    }
    refuse_if(!is_enough_for_space_fit(episodes),
              "the arm was tracked in {} frames; expected at least {} to fit a model to",
              frames_.size(), kMinFitFrames);
    shapes_.resize(Eigen::Index(frames_.size()), kShapeRows * arm.segment_count());
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const auto [episode, frame] = frames_[i];
      shapes_.row(Eigen::Index(i)) =
          shapes_of_poses(arm, episodes[episode].backbone.row(frame).transpose().cast<double>())
              .transpose();
    }
    weights_ = Eigen::VectorXd::Ones(shapes_.rows());
    hold_still_chambers();
  }

  SpaceFit run() {
    SpaceFit fit;
    double best = std::numeric_limits<double>::infinity();
    const auto consider = [&](double dead_time_s, double lag_s) {
      throw_if_interrupted();
      set_terms(dead_time_s, lag_s);
      const Eigen::MatrixXd shape = solve(weights_);
      if (const double off = mean_off_m(shape, weights_); off < best) {
        best = off;
        fit.shape = shape;
        fit.dead_time_s = dead_time_s;
        fit.lag_s = lag_s;
      }
    };
    const double step_s = std::max(0.5 * arm_.frame_period_s(), kFinestStep_s);
    for (int round = 0; round < kRobustRounds; ++round) {
      const double lag_s = fit.lag_s;
      for (double dead_s = 0.0; dead_s <= kLongestDead_s; dead_s += step_s) {
        consider(dead_s, lag_s);
      }
      for (const double lag : kLags_s) {
        for (const double shift : {-step_s, 0.0, step_s}) {
          consider(std::clamp(fit.dead_time_s + shift, 0.0, kLongestDead_s), lag);
        }
      }
      set_terms(fit.dead_time_s, fit.lag_s);
      weigh(fit.shape);
      fit.shape = solve(weights_);
      best = mean_off_m(fit.shape, weights_);
    }
    const double middle_s = std::max(fit.dead_time_s, step_s);
    const Eigen::Vector3d around_m =
        off_around_m(middle_s, fit.lag_s, step_s, {weights_}).row(0).transpose();
    consider(middle_s + step_s * vertex(around_m), fit.lag_s);
    set_terms(fit.dead_time_s, fit.lag_s);
    fit.shape_sd = shape_deviations();
    fit.dead_time_sd_s = dead_time_deviation_s(fit, step_s);
    for (Eigen::Index channel = 0; channel < arm_.channel_count(); ++channel) {
      fit.is_held.push_back(still_[channel] > 0.0);
      if (fit.is_held.back()) {
        fit.shape.col(channel) = no_load_.shape_of_strains().col(channel);
      }
    }
    return fit;
  }

 private:
  /// What a chamber does whose command never changes can't be told from what the arm does at rest:
  /// it does what the arm file says, and nothing is fitted to it.
  void hold_still_chambers() {
    still_ = Eigen::VectorXd::Zero(arm_.channel_count());
    for (int channel = 0; channel < arm_.channel_count(); ++channel) {
      still_[channel] = command_changes(arm_, episodes_, channel) ? 0.0 : 1.0;
    }
    for (Eigen::Index row = 0; still_.sum() > 0.0 && row < shapes_.rows(); ++row) {
      const auto [episode, frame] = frames_[std::size_t(row)];
      const Eigen::VectorXd strains =
          no_load_.strains(episodes_[episode].pressure_kpa.row(frame).transpose().cast<double>());
      shapes_.row(row) -= (no_load_.shape_of_strains() * strains.cwiseProduct(still_)).transpose();
    }
  }

  /// Of all frames but those of one piece of the jackknife.
  Eigen::VectorXd weights_without(Eigen::Index piece) const {
    Eigen::VectorXd weights = weights_;
    for (Eigen::Index row = 0; row < weights.size(); ++row) {
      weights[row] *= row * kSpacePieces / weights.size() == piece ? 0.0 : 1.0;
    }
    return weights;
  }

  void set_terms(double dead_time_s, double lag_s) {
    terms_.resize(shapes_.rows(), arm_.channel_count() + 1);
    Eigen::Index row = 0;
    for (std::size_t e = 0; e < episodes_.size(); ++e) {
      const Eigen::MatrixXd commands =
          lagged(episodes_[e].pressure_kpa, arm_.frame_period_s(), dead_time_s, lag_s);
      for (; row < shapes_.rows() && frames_[std::size_t(row)].first == e; ++row) {
        terms_.row(row) << no_load_
                               .strains(commands.row(frames_[std::size_t(row)].second).transpose())
                               .cwiseProduct((1.0 - still_.array()).matrix())
                               .transpose(),
            1.0;
      }
    }
  }

  /// Least squares.
  Eigen::MatrixXd solve(const Eigen::VectorXd& weights) const {
    const Eigen::MatrixXd weighted = terms_.array().colwise() * weights.array();
    Eigen::MatrixXd square = weighted.transpose() * terms_;
    // A chamber that never acts has no share; units of commands differ by orders.
    constexpr double kRidge = 1e-9;
    square.diagonal() +=
        kRidge * square.diagonal() +
        Eigen::VectorXd::Constant(square.rows(), std::numeric_limits<double>::min());
    return square.ldlt().solve(weighted.transpose() * shapes_).transpose();
  }

  /// How far each frame's shape is off, about, at the tip.
  Eigen::VectorXd off_m(const Eigen::MatrixXd& shape) const {
    return ((terms_ * shape.transpose() - shapes_) * levers_m_.asDiagonal()).rowwise().norm();
  }
  double mean_off_m(const Eigen::MatrixXd& shape, const Eigen::VectorXd& weights) const {
    return off_m(shape).dot(weights) / weights.sum();
  }

  void weigh(const Eigen::MatrixXd& shape) {
    const Eigen::VectorXd off = off_m(shape);
    const double middle = median(std::vector<double>(off.begin(), off.end()));
    weights_ = off.unaryExpr(
        [&](double one) { return one > kSpaceHuber * middle ? kSpaceHuber * middle / one : 1.0; });
  }

  Eigen::MatrixXd shape_deviations() const {
    auto without = mapped<Eigen::MatrixXd>(
        kSpacePieces, [&](Eigen::Index piece) { return solve(weights_without(piece)); });
    return Eigen::MatrixXd::NullaryExpr(
        shapes_.cols(), terms_.cols(), [&](Eigen::Index row, Eigen::Index column) {
          const auto numbers = mapped<double>(
              without, [&](const Eigen::MatrixXd& shape) { return shape(row, column); });
          return jackknife_error(numbers);
        });
  }

  /// How far it is off about a dead time, one step before it, there and one after, by the columns,
  /// with each of these weights.
  Eigen::MatrixXd off_around_m(double middle_s, double lag_s, double step_s,
                               const std::vector<Eigen::VectorXd>& weights) {
    Eigen::MatrixXd off_m(std::ssize(weights), 3);
    for (Eigen::Index k = 0; k < off_m.cols(); ++k) {
      set_terms(middle_s + double(k - 1) * step_s, lag_s);
      for (Eigen::Index i = 0; i < off_m.rows(); ++i) {
        const Eigen::VectorXd& those = weights[i];
        off_m(i, k) = mean_off_m(solve(those), those);
      }
    }
    return off_m;
  }

  double dead_time_deviation_s(const SpaceFit& fit, double step_s) {
    const auto weights = mapped<Eigen::VectorXd>(
        kSpacePieces, [&](Eigen::Index piece) { return weights_without(piece); });
    const Eigen::MatrixXd off_m =
        off_around_m(std::max(fit.dead_time_s, step_s), fit.lag_s, step_s, weights);
    const auto vertices_s = mapped<double>(
        off_m.rowwise(), [&](const auto& off) { return step_s * vertex(off.transpose()); });
    return jackknife_error(vertices_s);
  }

  const ArmDescription& arm_;
  SpaceNoLoad no_load_;
  const std::vector<Episode>& episodes_;
  Eigen::VectorXd levers_m_;
  std::vector<std::pair<std::size_t, int>> frames_;  // episode and frame
  Eigen::MatrixXd shapes_;                           // F × 3s
  Eigen::MatrixXd terms_;                            // F × (n + 1)
  Eigen::VectorXd weights_;
  Eigen::VectorXd still_;  // n: 1 where a chamber's command never changes, else 0
};

void measure(const ArmDescription& arm, const std::vector<Episode>& episodes, SpaceFit& fit) {
  double plates = 0.0;
  double tips = 0.0;
  double frames = 0.0;
  for (const Episode& episode : episodes) {
    Episode expected = episode;
    expected.backbone = predict(fit, arm, episode);
    for (const int t : tracked_frames(episode)) {
      double sum = 0.0;
      for (int plate = 1; plate < episode.point_count(); ++plate) {
        const double off = (expected.position_m(t, plate) - episode.position_m(t, plate)).norm();
        sum += off;
        tips += plate + 1 == episode.point_count() ? off : 0.0;
      }
      plates += sum / (episode.point_count() - 1);
      frames += 1.0;
    }
  }
  fit.plates_mm = kMmPerM * plates / frames;
  fit.tip_mm = kMmPerM * tips / frames;
}

}  // namespace

bool is_enough_for_space_fit(const std::vector<Episode>& episodes) {
  return tracked_count(episodes) >= kMinFitFrames;
}

SpaceFit fit_space_model(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  require_episodes_of(episodes, arm);
  SpaceFit fit = SpaceFitter(arm, episodes).run();
  measure(arm, episodes, fit);
  return fit;
}

FrameMatrix predict(const SpaceFit& fit, const ArmDescription& arm, const Episode& episode) {
  const SpaceNoLoad no_load(arm);
  const Eigen::MatrixXd commands =
      lagged(episode.pressure_kpa, arm.frame_period_s(), fit.dead_time_s, fit.lag_s);
  FrameMatrix poses(episode.frame_count(), kSpacePoseSize * arm.point_count());
  for (int t = 0; t < episode.frame_count(); ++t) {
    Eigen::VectorXd terms(arm.channel_count() + 1);
    terms << no_load.strains(commands.row(t).transpose()), 1.0;
    Eigen::VectorXf numbers(poses.cols());
    no_load.poses_of_shapes(fit.shape * terms, numbers);
    poses.row(t) = numbers.transpose();
  }
  return poses;
}

SegmentAtRest segment_at_rest(const SpaceFit& fit, const ArmDescription& arm, int segment) {
  const Eigen::Index row = kShapeRows * segment + kShapeRows - 1;
  const Eigen::Index constant = arm.channel_count();
  const double length_m = arm.segments[segment].length_m;
  return {length_m * (1.0 + fit.shape(row, constant)), length_m * fit.shape_sd(row, constant)};
}

ArmDescription with_space_fit(ArmDescription arm, const SpaceFit& fit) {
  const ArmDescription of_file = arm;
  arm.no_load = NoLoadKind::fitted;
  for (int i = 0; i < arm.segment_count(); ++i) {
    Segment& segment = arm.segments[i];
    const double length_m = segment_at_rest(fit, of_file, i).length_m;
    if (!(length_m > 0.0)) {
      throw InputError(
          fmt::format("the recordings have {} {:.4g} m long at rest; expected more "
                      "than 0. Is it the arm of the file?",
                      segment_name(i), length_m));
    }
    Eigen::MatrixXd shape = fit.shape.block(kShapeRows * i, 0, kShapeRows, arm.channel_count());
    shape.row(kShapeRows - 1) *= segment.length_m / length_m;  // shares of another length
    segment.shape_of_strains = shape.unaryExpr(&seven_digits);
    segment.length_m = seven_digits(length_m);
  }
  return arm;
}

}  // namespace limber
