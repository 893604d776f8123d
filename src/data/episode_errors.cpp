#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/data/recording.hpp"
#include "limber/data/recording_inspection.hpp"
#include "limber/data/simple_model.hpp"
#include "limber/data/space_fit.hpp"

namespace limber {

namespace {

constexpr double kExplained = 0.7;   // of the error is left, or less
constexpr double kSuspicious = 1.5;  // times the middle error; others are not looked at
constexpr double kMaxLate_s = 3.0;   // of commands behind the motion, or before it
constexpr double kLateStep_s = 0.5;  // a slow arm's lag would explain less

/// Root of the mean square of what the segments' turns are off by [rad]; none tracked: 0.
double turn_error(const SimpleModel& model, const ArmDescription& arm, const Episode& episode) {
  const Eigen::MatrixXd told = lagged_turns(arm, episode, model.lag_s);
  double squares = 0.0;
  int count = 0;
  for (const int t : tracked_frames(episode)) {
    Eigen::Index column = 2;
    for (int i = 0; i < arm.segment_count(); ++i) {
      const Eigen::Index end = column + kPoseSize * arm.segments[i].gaps;
      const double seen = double(episode.backbone(t, end) - episode.backbone(t, column));
      const SimpleSegment& segment = model.segments[i];
      squares += std::pow(seen - segment.gain * told(t, i) - segment.offset_rad, 2);
      column = end;
      ++count;
    }
  }
  return count > 0 ? std::sqrt(squares / count) : 0.0;
}

/// The best explanation so far.
struct Explanation {
  double error;
  std::string what;
  void offer(double other, const std::string& words) {
    if (other < error) {
      error = other;
      what = words;
    }
  }
};

void exchange_columns(const SimpleModel& model, const ArmDescription& arm, Episode episode,
                      Explanation& best) {
  for (int a = 0; a < arm.segment_count(); ++a) {
    for (int b = a + 1; b < arm.segment_count(); ++b) {
      episode.pressure_kpa.col(a).swap(episode.pressure_kpa.col(b));
      best.offer(
          turn_error(model, arm, episode),
          fmt::format("the columns of {} and {} were exchanged", segment_name(a), segment_name(b)));
      episode.pressure_kpa.col(a).swap(episode.pressure_kpa.col(b));
    }
  }
}

void turn_signs(const SimpleModel& model, const ArmDescription& arm, Episode episode,
                Explanation& best) {
  for (int i = 0; i < arm.segment_count(); ++i) {
    episode.pressure_kpa.col(i) *= -1.0F;
    best.offer(turn_error(model, arm, episode),
               fmt::format("{}'s column had the other sign", segment_name(i)));
    episode.pressure_kpa.col(i) *= -1.0F;
  }
}

void shift_clock(const SimpleModel& model, const ArmDescription& arm, const Episode& episode,
                 Explanation& best) {
  const int last = episode.frame_count() - 1;
  Episode shifted = episode;
  for (double late_s = kLateStep_s; late_s <= kMaxLate_s; late_s += kLateStep_s) {
    const int frames = arm.frames_in(late_s);
    for (const int by : {frames, -frames}) {
      for (int t = 0; t <= last; ++t) {
        shifted.pressure_kpa.row(t) = episode.pressure_kpa.row(std::clamp(t + by, 0, last));
      }
      best.offer(turn_error(model, arm, shifted),
                 fmt::format("its commands were logged about {:.1f} s too {}", late_s,
                             by > 0 ? "late" : "early"));
    }
  }
}

/// What would explain episodes that err more than the others: two of a log's columns exchanged, one
/// of the other sign, commands by another clock: "moves as if the columns of segment 0 and segment
/// 2 were exchanged". What explains an episode's error says more than how large it is.
///
/// The simple model predicts the segments' turns under the commands as they are and as they would
/// be. A mistake is one that leaves less than kExplained of the error. On logs of stand-ins nothing
/// leaves less than 1.07 in whole ones, and the true mistake 0.10 to 0.56 in broken ones.
/// @pre some episode moves, or should
void mark_mistakes(const SimpleModel& model, const ArmDescription& arm,
                   const std::vector<Episode>& episodes, EpisodeErrors& errors) {
  std::vector<double> own(episodes.size(), 0.0);  // of those that rest: none
  std::vector<double> known;
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    if (errors.episodes[i].moves) {
      own[i] = turn_error(model, arm, episodes[i]);
      known.push_back(own[i]);
    }
  }
  const double suspicious = kSuspicious * median(std::move(known));
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    if (!(own[i] > suspicious)) {
      continue;
    }
    Explanation best{kExplained * own[i], {}};
    exchange_columns(model, arm, episodes[i], best);
    turn_signs(model, arm, episodes[i], best);
    shift_clock(model, arm, episodes[i], best);
    if (!best.what.empty()) {
      errors.episodes[i].why = "moves as if " + best.what;
    }
  }
}

constexpr std::size_t kMinEpisodes = 5;  // fewer don't say what is usual
constexpr double kDeviations = 4.0;      // of log errors; robust ones
constexpr double kMinRatio = 1.75;       // of the middle error, however alike the others are
constexpr double kUnrelated = 0.4;       // correlation below which turns are not what was told …
constexpr double kRelated = 0.6;         // … where the others' middle one is above this
constexpr double kMovedShare = 0.01;     // of the arm's length, by the tip

double mean_tip_error_cm(const FrameMatrix& expected, const Episode& episode) {
  const Eigen::Index tip = expected.cols() - pose_size(episode.dimension);
  const Eigen::Index numbers = position_size(episode.dimension);
  const std::vector<int> frames = tracked_frames(episode);
  const auto sum = sum_of<double>(frames, [&](const int t) {
    return double((expected.row(t) - episode.backbone.row(t)).segment(tip, numbers).norm());
  });
  return frames.empty() ? std::nan("") : kCmPerM * sum / double(frames.size());
}

bool tip_moves(const ArmDescription& arm, const FrameMatrix& backbones) {
  const auto tips = backbones.middleCols(backbones.cols() - pose_size(arm.dimension),
                                         position_size(arm.dimension));
  return double((tips.rowwise() - tips.row(0)).rowwise().norm().maxCoeff()) >
         kMovedShare * arm.length_m();
}

/// Of the segments' turns with the expected ones.
struct TurnCorrelation {
  double mean = 0.0;    ///< over those that moved
  double pooled = 0.0;  ///< of all of them at once: what moved most counts most
};

/// Over the tracked frames; NaN where they are fewer than two.
TurnCorrelation correlation_of(const ArmDescription& arm, const FrameMatrix& expected,
                               const Episode& episode) {
  const std::vector<int> tracked = tracked_frames(episode);
  if (tracked.size() < 2) {
    return {std::nan(""), std::nan("")};
  }
  double sum = 0.0;
  int moved = 0;
  double product = 0.0;
  double seen_squares = 0.0;
  double told_squares = 0.0;
  Eigen::Index column = 2;
  for (const Segment& segment : arm.segments) {
    const Eigen::Index end = column + kPoseSize * segment.gaps;
    const auto turn = [&](const FrameMatrix& poses) {
      const Eigen::VectorXd own = (poses(tracked, end) - poses(tracked, column)).cast<double>();
      return Eigen::VectorXd(own.array() - own.mean());
    };
    const Eigen::VectorXd seen = turn(episode.backbone);
    const Eigen::VectorXd told = turn(expected);
    const double size = seen.norm() * told.norm();
    sum += size > 0.0 ? seen.dot(told) / size : 0.0;
    moved += size > 0.0 ? 1 : 0;
    product += seen.dot(told);
    seen_squares += seen.squaredNorm();
    told_squares += told.squaredNorm();
    column = end;
  }
  if (moved == 0) {
    return {};
  }
  return {sum / moved, product / std::sqrt(seen_squares * told_squares)};
}

/// Where all episodes are far off (friction, long lags), the error of one whose commands are those
/// of another does not stand out. But it errs more than the middle one, and has nothing to do with
/// what it was told, as the others have.
void mark_unrelated(const std::vector<TurnCorrelation>& correlations, EpisodeErrors& errors) {
  std::vector<double> means;
  for (std::size_t i = 0; i < correlations.size(); ++i) {
    if (errors.episodes[i].moves && std::isfinite(correlations[i].mean)) {
      means.push_back(correlations[i].mean);
    }
  }
  const double usual = means.size() < kMinEpisodes ? 0.0 : median(std::move(means));
  if (usual < kRelated) {
    return;
  }
  for (std::size_t i = 0; i < correlations.size(); ++i) {
    EpisodeError& episode = errors.episodes[i];
    if (episode.moves && episode.why.empty() && episode.tip_cm > errors.median_cm &&
        correlations[i].mean < kUnrelated && correlations[i].pooled < kUnrelated) {
      episode.why = fmt::format("turns correlate by {:.2f} with what was told, {:.2f} is usual",
                                correlations[i].mean, usual);
    }
  }
}

/// @return of how many that move the error is known
std::size_t mark_far_off(EpisodeErrors& errors) {
  errors.limit_cm = std::numeric_limits<double>::infinity();
  std::vector<double> known;  // logarithms
  for (const EpisodeError& episode : errors.episodes) {
    if (episode.moves && episode.tip_cm > 0.0) {
      known.push_back(std::log(episode.tip_cm));
    }
  }
  if (known.empty()) {
    return 0;
  }
  const double middle = median(known);
  errors.median_cm = std::exp(middle);
  if (known.size() >= kMinEpisodes) {
    auto deviations =
        mapped<double>(known, [&](const double one) { return std::abs(one - middle); });
    const double spread = kDeviations * kScaleOfMedian * median(std::move(deviations));
    errors.limit_cm = std::exp(middle + std::max(spread, std::log(kMinRatio)));
  }
  for (EpisodeError& episode : errors.episodes) {
    if (episode.moves && episode.tip_cm > errors.limit_cm) {
      episode.why =
          fmt::format("{:.1f} cm at the tip, more than {:.1f} cm", episode.tip_cm, errors.limit_cm);
    }
  }
  return known.size();
}

/// Of one more episode, where `expected` is what a model makes of its commands.
void add_error(const ArmDescription& arm, const FrameMatrix& expected, const Episode& episode,
               double correlation, EpisodeErrors& errors) {
  errors.episodes.push_back(
      {episode_name(std::ssize(errors.episodes), episode.log), mean_tip_error_cm(expected, episode),
       correlation, tip_moves(arm, expected) || tip_moves(arm, episode.backbone), false, ""});
}

void mark_outliers(EpisodeErrors& errors) {
  for (EpisodeError& episode : errors.episodes) {
    episode.is_outlier = !episode.why.empty();
  }
}

}  // namespace

std::vector<int> EpisodeErrors::outliers() const {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    if (episodes[i].is_outlier) {
      numbers.push_back(int(i));
    }
  }
  return numbers;
}

EpisodeErrors episode_errors(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  require_episodes_of(episodes, arm);
  return errors_of_any(arm, episodes);
}

EpisodeErrors episode_errors(const SpaceFit& model, const ArmDescription& arm,
                             const std::vector<Episode>& episodes) {
  EpisodeErrors errors;
  for (const Episode& episode : episodes) {
    add_error(arm, predict(model, arm, episode), episode, std::nan(""), errors);
  }
  mark_far_off(errors);
  mark_outliers(errors);
  return errors;
}

EpisodeErrors errors_of_any(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  if (arm.is_spatial()) {
    return episode_errors(fit_space_model(arm, episodes), arm, episodes);
  }
  const SimpleModel model = fit_to_any(arm, episodes).model;
  EpisodeErrors errors;
  std::vector<TurnCorrelation> correlations;
  for (const Episode& episode : episodes) {
    const FrameMatrix expected = predict(model, arm, episode);
    correlations.push_back(correlation_of(arm, expected, episode));
    add_error(arm, expected, episode, correlations.back().mean, errors);
  }
  const std::size_t known = mark_far_off(errors);
  mark_unrelated(correlations, errors);
  if (known >= kMinEpisodes) {
    mark_mistakes(model, arm, episodes, errors);
  }
  mark_outliers(errors);
  return errors;
}

EpisodeErrors leave_out_broken(const ArmDescription& arm, std::vector<Episode>& episodes) {
  EpisodeErrors errors = episode_errors(arm, episodes);
  std::vector<Episode> whole;
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    if (!errors.episodes[i].is_outlier) {
      whole.push_back(std::move(episodes[i]));
    }
  }
  episodes = std::move(whole);
  return errors;
}

bool moves(const ArmDescription& arm, const Episode& episode) {
  return tip_moves(arm, episode.backbone);
}

std::string to_text(const EpisodeErrors& errors) {
  std::vector<std::string> parts;
  for (const int number : errors.outliers()) {
    const EpisodeError& episode = errors.episodes[number];
    parts.push_back(episode.name + ": " + episode.why);
  }
  return parts.empty()
             ? std::string()
             : fmt::format("{}; the middle one is {:.1f} cm: limber train leaves such logs out",
                           fmt::join(parts, ", "), errors.median_cm);
}

Json to_json(const EpisodeErrors& errors) {
  Json json;
  json["median_cm"] = json_number(errors.median_cm);
  json["limit_cm"] = json_number(errors.limit_cm);
  json["outliers"] = errors.outliers();
  json["episodes"] = Json::array();
  for (const EpisodeError& episode : errors.episodes) {
    json["episodes"].push_back({{"name", episode.name},
                                {"tip_error_cm", json_number(episode.tip_cm)},
                                {"correlation", json_number(episode.correlation)},
                                {"moves", episode.moves},
                                {"outlier", episode.is_outlier},
                                {"why", episode.why}});
  }
  return json;
}

}  // namespace limber
