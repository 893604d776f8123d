#include "limber/run/collection.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <tbb/partitioner.h>

#include "collection_parts.hpp"
#include "kernels/job_arena.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/seconds_since.hpp"
#include "limber/data/reach.hpp"
#include "limber/run/episode_recorder.hpp"
#include "limber/run/gated_driver.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

/// Drives one arm along one schedule.
class EpisodeRun {
 public:
  EpisodeRun(const ArmDescription& arm, ArmDriver& driver, const EpisodeSchedule& schedule,
             const CollectionSettings& settings)
      : arm_(arm),
        driver_(arm, driver, schedule.approach == Approach::straight),
        schedule_(schedule),
        settings_(settings),
        recorder_(arm) {}

  /// What was recorded so far; none where nothing saw the arm.
  std::optional<Episode> unfinished() {
    return recorder_.tracked_count() > 0 ? std::optional(recorder_.finish()) : std::nullopt;
  }

  Episode run(const std::function<void()>& motion_done) {
    if (!schedule_.first_kpa.isZero()) {  // leads to it, unrecorded
      move(Pressures::Zero(schedule_.first_kpa.size()),
           {schedule_.first_kpa, settings_.schedule.hold_s, true});
    }
    recorder_.add(driver_.state(), schedule_.first_kpa, 0);
    recording_ = true;
    Pressures from = schedule_.first_kpa;
    for (const Motion& motion : schedule_.motions) {
      move(from, motion);
      from = motion.setpoint_kpa;
      ++motion_index_;
      if (motion_done) {
        motion_done();
      }
    }
    return recorder_.finish();
  }

 private:
  void move(const Pressures& from, const Motion& motion) {
    if (schedule_.approach == Approach::straight) {
      const Pressures* here = &from;
      for (const Pressures& via : motion.via_kpa) {
        go_straight(*here, via);
        command(via);
        here = &via;
      }
      go_straight(*here, motion.setpoint_kpa);
    }
    hold(motion);
  }

  /// Up to the frame before the last.
  void go_straight(const Pressures& from, const Pressures& to) {
    std::vector<Pressures> setpoints_kpa =
        straight_setpoints(from, to, arm_.pressure_step_limit_kpa());
    setpoints_kpa.pop_back();
    for (const Pressures& setpoint_kpa : setpoints_kpa) {
      command(setpoint_kpa);
    }
  }

  void hold(const Motion& motion) {
    const int min_frames = std::max(1, arm_.frames_in(motion.hold_s));
    const int max_frames = std::max(min_frames, arm_.frames_in(settings_.hold_limit_s));
    for (int k = 0; k < min_frames || (motion.until_reached && !reached(motion.setpoint_kpa));
         ++k) {
      if (k == max_frames) {
        refuse_unreached(motion, max_frames * arm_.frame_period_s());
      }
      command(motion.setpoint_kpa);
    }
  }

  void command(const Pressures& setpoint_kpa) {
    throw_if_interrupted(settings_.should_stop);
    const ArmState& state = driver_.command(setpoint_kpa);
    if (recording_) {
      recorder_.add(state, setpoint_kpa, motion_index_);
    }
  }

  double tolerance_kpa(Eigen::Index channel) const {
    return kReachTolerance * arm_.limits_of_channel(int(channel)).largest_kpa();
  }

  Eigen::VectorXd distances_kpa(const Pressures& setpoint_kpa) const {
    return (driver_.state().pressure_kpa.cast<double>() - setpoint_kpa.cast<double>()).cwiseAbs();
  }

  bool reached(const Pressures& setpoint_kpa) const {
    const Eigen::VectorXd distance_kpa = distances_kpa(setpoint_kpa);
    for (Eigen::Index s = 0; s < setpoint_kpa.size(); ++s) {
      if (distance_kpa[s] > tolerance_kpa(s)) {
        return false;
      }
    }
    return true;
  }

  [[noreturn]] void refuse_unreached(const Motion& motion, double waited_s) const {
    Eigen::VectorXd in_tolerances = distances_kpa(motion.setpoint_kpa);
    for (Eigen::Index s = 0; s < in_tolerances.size(); ++s) {
      in_tolerances[s] /= tolerance_kpa(s);
    }
    Eigen::Index worst = 0;
    in_tolerances.maxCoeff(&worst);
    throw SystemFault(fmt::format(
        "{}: {} is at {:.1f} {unit} after {} s at set point {:.1f} {unit}; expected to be within "
        "{:.1f} {unit}{}",
        motion_name(motion_index_), channel_name(arm_, worst), driver_.state().pressure_kpa[worst],
        waited_s, motion.setpoint_kpa[worst], tolerance_kpa(worst),
        arm_.command.is_pressure_kpa() ? ". Check supply pressure and leaks" : "",
        fmt::arg("unit", arm_.command.unit)));
  }

  const ArmDescription& arm_;
  GatedDriver driver_;
  const EpisodeSchedule& schedule_;
  const CollectionSettings& settings_;
  EpisodeRecorder recorder_;
  int motion_index_ = 0;
  bool recording_ = false;
};

/// Removes old files, or finds the work already done; `collect` says what is refused.
std::vector<std::optional<Episode>> prepare(const CollectionSettings& settings,
                                            const CollectionParts& parts, std::size_t episodes) {
  std::vector<std::optional<Episode>> done(episodes);
  if (!parts.exist()) {
    return done;
  }
  if (settings.resume) {
    for (std::size_t i = 0; i < episodes; ++i) {
      done[i] = parts.read(i);
    }
  } else if (settings.force) {
    (void)parts.remove();
  } else {
    throw InputError(
        fmt::format("{}: left by a collection that did not finish; --resume goes on from "
                    "it, --force starts over",
                    parts.folder().string()));
  }
  return done;
}

/// @throws InputError if the file is another recording, or the parts hold other episodes.
Recording read_finished(const CollectionParts& parts, const fs::path& path, std::size_t episodes) {
  Recording finished = read_recording(path);
  parts.require_same_origin(finished, path.string());
  refuse_if(finished.episodes.size() != episodes,
            "{}: holds {} episodes; this run makes {}. --force replaces it", path.string(),
            finished.episodes.size(), episodes);
  for (std::size_t i = 0; i < episodes; ++i) {
    const std::optional<Episode> part = parts.read(i);
    refuse_if(
        part && !same_values(*part, finished.episodes[i]),
        "{}: exists already, and is not what the episodes in {} make; --resume --force goes on "
        "from them and replaces it",
        path.string(), parts.folder().string());
  }
  return finished;
}

/// The recording, if an earlier run finished it and was then killed or could not remove the parts.
std::optional<Recording> finished_before(const CollectionSettings& settings,
                                         const CollectionParts& parts, const fs::path& path,
                                         std::size_t episodes) {
  std::error_code error;
  if (!settings.resume || !fs::exists(path, error) || (settings.force && parts.exist())) {
    return std::nullopt;
  }
  try {
    return read_finished(parts, path, episodes);
  } catch (const InputError&) {
    if (settings.force) {
      return std::nullopt;  // it is the file to be replaced
    }
    throw;
  }
}

std::ptrdiff_t count_done(const std::vector<std::optional<Episode>>& done) {
  return std::ranges::count_if(done, [](const auto& episode) { return episode.has_value(); });
}

std::uint64_t motions_left(const std::vector<EpisodeSchedule>& schedule,
                           const std::vector<std::optional<Episode>>& done) {
  return sum_of<std::uint64_t>(
      schedule.size(), [&](std::size_t i) { return done[i] ? 0 : schedule[i].motions.size(); });
}

/// What the finished episodes and the frames of an unfinished one make, as `settings.partial`.
void write_partial(const CollectionSettings& settings, const Recording& identity,
                   const std::vector<std::optional<Episode>>& done,
                   std::optional<Episode> unfinished) {
  Recording recording = identity;
  recording.settings += "; not finished";
  for (const std::optional<Episode>& episode : done) {
    if (episode) {
      recording.episodes.push_back(*episode);
    }
  }
  if (unfinished) {
    recording.episodes.push_back(std::move(*unfinished));
  }
  if (!recording.episodes.empty()) {
    write_recording(settings.partial, recording);
  }
}

/// @param make_driver  which may find the arm stopped already, or stop it
Episode record_or_keep_a_part(const ArmDescription& arm,
                              const std::function<std::unique_ptr<ArmDriver>()>& make_driver,
                              const EpisodeSchedule& schedule, const CollectionSettings& settings,
                              const Recording& identity,
                              const std::vector<std::optional<Episode>>& done,
                              const std::function<void()>& motion_done) {
  std::unique_ptr<ArmDriver> driver;
  std::optional<EpisodeRun> run;
  try {
    throw_if_interrupted(settings.should_stop);
    driver = make_driver();
    run.emplace(arm, *driver, schedule, settings);
    const VentGuard vent_at_the_end(*driver);
    return run->run(motion_done);
  } catch (const std::runtime_error& stopped) {
    if (!settings.partial.empty()) {
      try {
        write_partial(settings, identity, done, run ? run->unfinished() : std::nullopt);
      } catch (const std::exception& lost) {
        throw SystemFault(fmt::format("{}. Its frames are lost: {}", stopped.what(), lost.what()));
      }
    }
    throw;
  }
}

/// Records what is not done yet, in parallel over episodes.
void record_missing(const ArmDescription& arm, const CollectionSettings& settings,
                    const DriverFactory& make_driver, const std::vector<EpisodeSchedule>& schedule,
                    const CollectionParts& parts, std::vector<std::optional<Episode>>& done) {
  Progress progress("collecting", "motions", motions_left(schedule, done), settings.progress);
  JobArena arena(settings.jobs);
  const auto record = [&](std::size_t i) {
    if (done[i]) {
      return;
    }
    try {
      done[i] = record_or_keep_a_part(
          arm, [&] { return make_driver(int(i)); }, schedule[i], settings, parts.identity(), done,
          [&] { progress.advance(); });
      if (settings.physics) {
        done[i]->physics = settings.physics(int(i));
      }
    } catch (const SystemFault& fault) {
      throw SystemFault(fmt::format("{}: {}", episode_name(i), fault.what()));
    }
    parts.write(i, *done[i]);
  };
  arena.for_each(schedule.size(), record, tbb::simple_partitioner());
}

void record_or_say_how_to_go_on(const ArmDescription& arm, const CollectionSettings& settings,
                                const DriverFactory& make_driver,
                                const std::vector<EpisodeSchedule>& schedule,
                                const CollectionParts& parts,
                                std::vector<std::optional<Episode>>& done) {
  try {
    record_missing(arm, settings, make_driver, schedule, parts, done);
  } catch (const Interrupted&) {
    if (count_done(done) == 0) {
      throw Interrupted("stopped on request, before the first episode was finished");
    }
    throw Interrupted(
        fmt::format("stopped on request; {} of {} episodes are kept in "
                    "{}: the same command with --resume goes on from there",
                    count_done(done), schedule.size(), parts.folder().string()));
  }
}

/// Writes the recording and reads it back: only then may its parts go.
void write_whole(const fs::path& path, const Recording& recording, const CollectionParts& parts) {
  try {
    write_recording(path, recording);
    const Recording found = read_recording(path);
    if (!std::equal(found.episodes.begin(), found.episodes.end(), recording.episodes.begin(),
                    recording.episodes.end(), same_values)) {
      throw SystemFault(fmt::format("{}: holds other values than were written", path.string()));
    }
  } catch (const std::exception& error) {
    throw SystemFault(
        fmt::format("{}. All episodes are kept in {}: the same command with --resume joins them",
                    error.what(), parts.folder().string()));
  }
}

}  // namespace

Episode record_episode(const ArmDescription& arm, ArmDriver& driver,
                       const EpisodeSchedule& schedule, const CollectionSettings& settings,
                       const std::function<void()>& motion_done) {
  const VentGuard vent_at_the_end(driver);
  return EpisodeRun(arm, driver, schedule, settings).run(motion_done);
}

CollectionResult collect(const ArmDescription& arm, const CollectionSettings& settings,
                         const DriverFactory& make_driver, const fs::path& path) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<EpisodeSchedule> schedule =
      settings.episodes.empty() ? make_schedule(arm, settings.schedule, settings.seed)
                                : settings.episodes;
  CollectionResult result;
  result.recording = make_recording(arm, settings.source, settings.seed);
  result.recording.settings =
      settings.episodes.empty() ? describe(settings.schedule) : settings.episodes_are;
  if (!settings.driver.empty()) {
    result.recording.settings += "; " + settings.driver;
  }
  const CollectionParts parts(path, result.recording);
  if (std::optional<Recording> finished = finished_before(settings, parts, path, schedule.size())) {
    result.recording = std::move(*finished);
    result.kept_episodes = int(schedule.size());
  } else {
    refuse_to_overwrite(path, settings.force);
    const CollectionParts::Use alone(parts);
    std::vector<std::optional<Episode>> done = prepare(settings, parts, schedule.size());
    result.kept_episodes = int(count_done(done));
    record_or_say_how_to_go_on(arm, settings, make_driver, schedule, parts, done);
    for (std::optional<Episode>& episode : done) {
      result.recording.episodes.push_back(std::move(*episode));
    }
    write_whole(path, result.recording, parts);
  }
  result.foreign_files = parts.remove();
  result.wall_time_s = seconds_since(start);
  return result;
}

}  // namespace limber
