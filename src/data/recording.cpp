#include "limber/data/recording.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "episode_check.hpp"
#include "episode_path.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/data/log_units.hpp"
#include "recorded_backbones.hpp"
#include "recording_hdf5.hpp"

namespace limber {

std::string episode_path(std::size_t index) {
  return fmt::format("episodes/{:06}", index);
}

int Episode::untracked_count() const {
  return int(std::count(tracked.begin(), tracked.end(), 0));
}

Eigen::Vector3d Episode::position_m(Eigen::Index t, Eigen::Index plate) const {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  const Eigen::Index first = pose_size(dimension) * plate;
  for (Eigen::Index i = 0; i < position_size(dimension); ++i) {
    position[i] = double(backbone(t, first + i));
  }
  return position;
}

std::int64_t Recording::frame_count() const {
  return limber::frame_count(episodes);
}

std::int64_t Recording::untracked_count() const {
  return frame_count() - tracked_count(episodes);
}

double Recording::duration_s() const {
  return double(frame_count()) / rate_hz;
}

Recording make_recording(const ArmDescription& arm, const std::string& source, std::uint64_t seed) {
  Recording recording;
  const ArmIdentity identity = identity_of(arm);
  recording.arm_name = identity.name;
  recording.arm_hash = identity.hash;
  recording.arm_description = identity.description;
  recording.command = arm.command;
  recording.dimension = arm.dimension;
  recording.segment_count = arm.segment_count();
  recording.chamber_count = arm.is_spatial() ? arm.channel_count() : 0;
  recording.point_count = arm.point_count();
  recording.rate_hz = arm.frame_rate_hz;
  recording.seed = seed;
  recording.source = source;
  return recording;
}

std::vector<Episode> with_setpoints_only(std::vector<Episode> episodes) {
  for (Episode& episode : episodes) {
    episode.pressure_kpa = episode.setpoint_kpa;
    episode.setpoints_only = true;
  }
  return episodes;
}

void validate_header(const Recording& recording, const std::string& file) {
  for (const std::string* text :
       {&recording.arm_name, &recording.arm_hash, &recording.arm_description, &recording.source,
        &recording.settings, &recording.command.name, &recording.command.unit}) {
    refuse_if(!can_be_kept(*text),
              "{}: a name or text of the recording is not UTF-8, or holds a zero byte", file);
    if (text->size() > kLongestText) {
      throw InputError(fmt::format("{}: a text of the recording has {} bytes; expected up to {}",
                                   file, text->size(), kLongestText));
    }
  }
  const auto require = [&](bool holds, const char* name, auto found, const char* expected) {
    refuse_if(!holds, "{}: attribute '{}' is {}; expected {}", file, name, found, expected);
  };
  require(recording.dimension != Dimension::space || recording.chamber_count >= 1, "chambers",
          recording.chamber_count, "a whole number ≥ 1");
  require(recording.segment_count >= 1, "segments", recording.segment_count, "a whole number ≥ 1");
  require(recording.point_count >= 2, "points", recording.point_count, "a whole number ≥ 2");
  require(std::isfinite(recording.rate_hz) && recording.rate_hz > 0.0, "rate_hz", recording.rate_hz,
          "a rate in Hz, > 0");
}

void validate(const Recording& recording, const std::string& file) {
  validate_header(recording, file);
  refuse_if(recording.episodes.empty(), "{}: episodes: none found; expected at least one", file);
  for (std::size_t i = 0; i < recording.episodes.size(); ++i) {
    const Episode& episode = recording.episodes[i];
    const EpisodeCheck check(file, recording.number(i));
    if (episode.dimension != recording.dimension || episode.lifted != recording.lifted()) {
      check.refuse("backbone", "poses of another kind than the recording says; expected one kind");
    }
    validate_episode(episode, check, recording.channel_count(), recording.point_count);
    if (episode.setpoints_only != recording.setpoints_only()) {
      check.refuse("pressure_kpa",
                   fmt::format("{}, other than in episode 0; expected one kind in a "
                               "recording: make two of it",
                               episode.setpoints_only ? "nothing was measured" : "measured"));
    }
  }
}

void require_sizes_of(const Recording& recording, const ArmDescription& arm,
                      const std::string& file) {
  const auto refuse = [&](const std::string& found, const std::string& expected) {
    throw InputError(fmt::format(
        "{}: recording of arm '{}' has {}; arm '{}' has {}. Give the arm file that it was recorded "
        "with (--arm), or import its logs again for this one",
        file, recording.arm_name, found, arm.name, expected));
  };
  if (recording.command.name != arm.command.name || recording.command.unit != arm.command.unit) {
    refuse(fmt::format("the command '{}' in {}", recording.command.name, recording.command.unit),
           fmt::format("'{}' in {}", arm.command.name, arm.command.unit));
  }
  if (recording.dimension != arm.dimension) {
    const auto in_words = [](Dimension dimension) {
      return dimension == Dimension::space ? "poses in space" : "poses in a plane";
    };
    refuse(in_words(recording.dimension), in_words(arm.dimension));
  }
  const auto require_equal = [&](int found, int expected, const char* what) {
    if (found != expected) {
      refuse(fmt::format("{} {}", found, what), fmt::format("{}", expected));
    }
  };
  require_equal(recording.segment_count, arm.segment_count(), "segments");
  require_equal(recording.channel_count(), arm.channel_count(), "commands");
  require_equal(recording.point_count, arm.point_count(), "backbone points");
  constexpr double kRateTolerance = 1e-6;  // relative; a rate is written once and copied
  if (std::abs(recording.rate_hz - arm.frame_rate_hz) > kRateTolerance * arm.frame_rate_hz) {
    refuse(fmt::format("{} frames per second", recording.rate_hz),
           fmt::format("{}", arm.frame_rate_hz));
  }
}

namespace {

/// Other shares of the arm file's `commands` make other commands of segments.
void require_same_sums(const Recording& recording, const ArmDescription& arm,
                       const std::string& file) {
  if (arm.commands.empty() || recording.arm_description.empty() ||
      recording.arm_hash == arm.hash()) {
    return;
  }
  const ArmDescription there = read_arm_keys(recording.arm_description, file + ": arm_description",
                                             PolynomialsOf::characterisation);
  for (const std::string& difference : arm_differences(there, arm)) {
    refuse_if(
        !there.commands.empty() && difference.starts_with("commands"),
        "{}: recorded with arm '{}', whose commands make other commands of segments: {}. Give "
        "the arm file that it was recorded with (--arm), or import its logs again for this one",
        file, recording.arm_name, difference);
  }
}

constexpr double kNeverBelieved = 3.0;  // of the limit, even once: a spike that ruins the ranges
constexpr double kAnotherUnit = 10.0;   // off by more: no broken log, but numbers in another unit

[[noreturn]] void refuse_command(double kpa, Eigen::Index channel, Eigen::Index frame,
                                 const ArmDescription& arm, const std::string& file,
                                 const std::string& where) {
  const PressureLimits& limits = arm.limits_of_channel(int(channel));
  throw InputError(fmt::format(
      "{}: {}: {} is at {:.4g} {} in {}; the limit of {} is {} {}. If the "
      "arm can take that, raise the limit in its arm file; if not, the unit or the column was "
      "wrong when the recording was made: import it again",
      file, where, channel_name(arm, channel), kpa, arm.command.unit, frame_name(frame),
      arm_in_words(arm), limits_to_yaml(limits), arm.command.unit));
}

void require_commands_within(const FrameMatrix& commands, const ArmDescription& arm,
                             const std::string& file, const std::string& where) {
  for (Eigen::Index i = 0; i < commands.cols(); ++i) {
    const PressureLimits& limits = arm.limits_of_channel(int(i));
    const double limit = limits.largest_kpa();
    const Eigen::VectorXd sizes = commands.col(i).cast<double>().unaryExpr(
        [&](double value) { return limits.size_kpa(value); });
    const auto beyond = (sizes.array() > kFarBeyond * limit).count();
    Eigen::Index worst = 0;
    const double largest = sizes.maxCoeff(&worst);
    if (double(beyond) > kMaxFarBeyond * double(commands.rows()) ||
        largest > kNeverBelieved * limit) {
      refuse_command(double(commands(worst, i)), i, worst, arm, file, where);
    }
  }
}

/// Pa are a thousand times kPa, and whatever an arm overshoots its limit by is less than ten times.
void require_unit(const FrameMatrix& commands, const ArmDescription& arm, const std::string& file,
                  const std::string& where) {
  for (Eigen::Index i = 0; i < commands.cols(); ++i) {
    Eigen::Index worst = 0;
    const double largest = double(commands.col(i).cwiseAbs().maxCoeff(&worst));
    if (largest > kAnotherUnit * arm.limits_of_channel(int(i)).largest_kpa()) {
      refuse_command(double(commands(worst, i)), i, worst, arm, file, where);
    }
  }
}

}  // namespace

void require_recording_of(const Recording& recording, const ArmDescription& arm,
                          const std::string& file) {
  require_sizes_of(recording, arm, file);
  const std::string why =
      recording.arm_name == arm.name ? "" : why_another_arm(recording.arm(), arm, file);
  if (!why.empty()) {
    throw InputError(fmt::format(
        "{}: recorded with arm '{}' (hash {}); this is arm '{}' (hash {}): {}. Give the arm file "
        "that it was recorded with (--arm); if both are the same arm, give them the same name",
        file, recording.arm_name, recording.arm_hash, arm.name, arm.hash(), why));
  }
  require_same_sums(recording, arm, file);
  for (std::size_t e = 0; e < recording.episodes.size(); ++e) {
    const std::string where = episode_path(recording.number(e));
    const Episode& episode = recording.episodes[e];
    if (!episode.setpoints_only) {
      require_commands_within(episode.pressure_kpa, arm, file, where + ", measured");
    }
    require_commands_within(episode.setpoint_kpa, arm, file, where + ", set points");
  }
  const std::int64_t frames = recording.numbers.empty() ? recording.frame_count() : 0;
  refuse_if(
      frames > 0 && recording.untracked_count() == frames,
      "{}: the arm was tracked in none of its {} frames: there is nothing to learn from or to "
      "compare with. Record it again with the arm in the tracker's view",
      file, recording.frame_count());
  for (std::size_t e = 0; e < recording.episodes.size(); ++e) {
    const std::string where = fmt::format("{}: {}", file, episode_path(recording.number(e)));
    require_backbones_of(recording.episodes[e], arm, 1.0, where);
    require_motion(recording.episodes[e], arm, where);
  }
}

void require_episodes_of(const std::vector<Episode>& episodes, const ArmDescription& arm,
                         const std::string& where) {
  const auto refuse = [&](std::size_t index, Eigen::Index found, const char* what, int expected) {
    throw InputError(
        fmt::format("{}: {} has {} {}; {} has {}. Give the arm that it was recorded with", where,
                    episode_path(index), found, what, arm_in_words(arm), expected));
  };
  for (std::size_t e = 0; e < episodes.size(); ++e) {
    const Episode& episode = episodes[e];
    for (const FrameMatrix* commands : {&episode.pressure_kpa, &episode.setpoint_kpa}) {
      if (commands->cols() != arm.channel_count()) {
        refuse(e, commands->cols(), arm.is_spatial() ? "chambers" : "segments",
               arm.channel_count());
      }
    }
    const int size = pose_size(arm.dimension);
    if (episode.dimension != arm.dimension) {
      refuse(e, position_size(episode.dimension), "numbers per position",
             position_size(arm.dimension));
    }
    if (episode.backbone.cols() != size * arm.point_count()) {
      refuse(e, episode.backbone.cols() / size, "backbone points", arm.point_count());
    }
    validate_episode(episode, EpisodeCheck(where, e), arm.channel_count(), arm.point_count());
    const std::string path = episode_path(e);
    require_unit(episode.pressure_kpa, arm, where, path + ", measured");
    require_unit(episode.setpoint_kpa, arm, where, path + ", set points");
    require_backbones_of(episode, arm, kAnotherUnit, fmt::format("{}: {}", where, path));
  }
}

void require_alike(const std::vector<Episode>& episodes, int channel_count, int point_count,
                   const std::string& where) {
  if (channel_count == 0 && !episodes.empty()) {
    channel_count = int(episodes.front().pressure_kpa.cols());
    point_count = int(episodes.front().backbone.cols() / pose_size(episodes.front().dimension));
  }
  for (std::size_t e = 0; e < episodes.size(); ++e) {
    if (episodes[e].dimension != episodes.front().dimension) {
      throw InputError(fmt::format("{}: {} has {} numbers per position; {} has {}", where,
                                   episode_path(e), position_size(episodes[e].dimension),
                                   episode_path(0), position_size(episodes.front().dimension)));
    }
    validate_frames(episodes[e], EpisodeCheck(where, e), channel_count, point_count);
  }
  if (!episodes.empty() && (channel_count < 1 || point_count < 2)) {
    throw InputError(fmt::format("{}: {} has {} commands and {} plates; expected at least 1 and 2",
                                 where, episode_path(0), channel_count, point_count));
  }
}

void require_episodes_of(const std::vector<Episode>& episodes, const NoLoadModel& model,
                         const std::string& where) {
  ArmDescription arm;  // what of it a model knows
  arm.command = model.command();
  arm.dimension = model.dimension();
  for (int i = 0; i < model.segment_count(); ++i) {
    arm.segments.push_back(model.segment(i));
  }
  require_episodes_of(episodes, arm, where);
}

}  // namespace limber
