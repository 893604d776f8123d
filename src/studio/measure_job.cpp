#include <algorithm>

#include "jobs.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/training/yardsticks.hpp"
#include "scene_json.hpp"

namespace limber {

namespace {

constexpr std::uintmax_t kMaxBytes = 256U << 20U;  // of a file: it is read whole
constexpr std::int64_t kMaxFrames = 36000;         // half an hour at 20 Hz: seconds of work

/// Up to kMaxFrames of them.
std::vector<Episode> first_frames(const std::vector<Episode>& episodes) {
  constexpr Eigen::Index kFewest = 3;  // that an error can be taken over
  std::vector<Episode> part;
  Eigen::Index left = kMaxFrames;
  for (const Episode& episode : episodes) {
    const Eigen::Index count = std::min<Eigen::Index>(left, episode.frame_count());
    if (count >= kFewest) {
      part.push_back(slice(episode, 0, int(count)));
      left -= count;
    }
  }
  return part;
}

Recording read_small(const fs::path& path, const std::string& name, const ArmDescription& arm) {
  refuse_if(fs::file_size(path) > kMaxBytes,
            "{}: larger than {} MB: ask 'limber evaluate' on the command line", name,
            kMaxBytes >> 20U);
  Recording recording = read_recording(path);
  require_recording_of(recording, arm, name);
  return recording;
}

Json curves_to_json(const YardstickReport& report) {
  Json json = {{"frames", report.horizon_frames}};
  for (const PredictorErrors& curve : report.predictors) {
    for (const double error_cm : curve.tip_cm) {
      json["tip_error_cm"][curve.key].push_back(json_number(error_cm));
    }
  }
  return json;
}

}  // namespace

void run_measure_job(const MeasureJob& job, const ProjectFolder& project, const StudioScene& scene,
                     const std::atomic<bool>& stop, EventQueue& events) {
  scene.require_one_arm();
  const auto note = [&](double share) {
    events.push("measuring", Json{{"request", job.request}, {"share", share}}.dump());
  };
  note(0.0);
  const fs::path path = project.find(ProjectItem::recording, job.recording);
  Recording recording = read_small(path, job.recording, scene.arm());
  const std::int64_t frames = recording.frame_count();
  std::vector<Episode> episodes = first_frames(recording.episodes);
  const std::int64_t frames_used = frame_count(episodes);
  const Json coverage = coverage_to_json(scene.arm(), episodes);
  const ForwardModel* network = scene.has_network() ? &scene.motion().forward() : nullptr;
  if (network != nullptr && network->compensation().learnt_from_setpoints) {
    episodes = with_setpoints_only(std::move(episodes));
  }
  const YardstickReport report =
      measure_horizons(scene.simple().forward(), network, episodes, kJobThreads, note);
  if (stop) {
    return;
  }
  Json json = {{"request", job.request},
               {"recording", job.recording},
               {"frame_rate_hz", recording.rate_hz},
               {"frames", frames},
               {"frames_used", frames_used}};
  json["learnt_from_it"] =
      network != nullptr && learnt_from(network->compensation(), file_hash(path));
  json["horizons"] = curves_to_json(report);
  json["coverage"] = coverage;
  events.push("measured", json.dump());
}

}  // namespace limber
