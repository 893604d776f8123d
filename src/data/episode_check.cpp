#include "episode_check.hpp"

namespace limber {

void validate_frames(const Episode& episode, const EpisodeCheck& check, int channel_count,
                     int point_count) {
  check.times(episode.time_s);
  const Eigen::Index frames = episode.time_s.size();
  check.shape("pressure_kpa", episode.pressure_kpa, frames, channel_count);
  check.shape("setpoint_kpa", episode.setpoint_kpa, frames, channel_count);
  check.shape("backbone", episode.backbone, frames,
              Eigen::Index{pose_size(episode.dimension)} * point_count);
  check.finite("pressure_kpa", episode.pressure_kpa);
  check.finite("setpoint_kpa", episode.setpoint_kpa);
  check.finite("backbone", episode.backbone);
  if (!episode.tracked.empty()) {
    check.length("tracked", episode.tracked, frames);
  }
  if (episode.dimension == Dimension::space) {
    check.unit_quaternions(episode.backbone);
  }
}

void validate_episode(const Episode& episode, const EpisodeCheck& check, int channel_count,
                      int point_count) {
  validate_frames(episode, check, channel_count, point_count);
  check.length("motion_index", episode.motion_index, episode.time_s.size());
  check.motions(episode.motion_index);
  if (!can_be_kept(episode.physics) || !can_be_kept(episode.log)) {
    check.refuse(can_be_kept(episode.log) ? "physics" : "log",
                 "is not UTF-8, or holds a zero byte");
  }
  if (episode.setpoints_only && episode.pressure_kpa != episode.setpoint_kpa) {
    check.refuse("pressure_kpa",
                 "differs from setpoint_kpa, though the episode says that nothing was measured; "
                 "expected the set points");
  }
}

}  // namespace limber
