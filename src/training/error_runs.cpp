#include "error_runs.hpp"

#include <cmath>

#include "limber/arm/plate_distance.hpp"
#include "limber/common/mapped.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/training/unseen_error.hpp"

namespace limber {

namespace {

constexpr double kStillM = 1e-3;          // of any plate from frame to frame
constexpr int kStillFrames = 4;           // in a row
constexpr std::size_t kMinFromRest = 19;  // for a 95 % quantile

/// Whether anything is commanded to move: standing still is easily predicted.
/// @param noise  of commands, as a share of half their range
bool moves(const ArmDescription& arm, const Episode& episode, const RolloutPiece& piece,
           double noise) {
  for (int i = 0; i < arm.channel_count(); ++i) {
    const auto commands = episode.setpoint_kpa.col(i).segment(piece.first, piece.frames + 1);
    if (double((commands.array() - commands[0]).abs().maxCoeff()) >
        noise * arm.limits_of_channel(i).half_width_kpa()) {
      return true;
    }
  }
  return false;
}

/// Whether the arm was seen to have come to rest in frame `frame`, as it has before a plan.
bool stands_still(const Episode& episode, int frame) {
  if (frame < kStillFrames) {
    return false;
  }
  for (int k = frame - kStillFrames; k < frame; ++k) {
    if (!episode.was_tracked(k) || !episode.was_tracked(k + 1) ||
        largest_place_distance_m(places_at(episode.backbone, k + 1, episode.dimension),
                                 places_at(episode.backbone, k, episode.dimension)) > kStillM) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<RolloutPiece> error_runs(const ArmDescription& arm,
                                     const std::vector<Episode>& unseen) {
  const int max_frames = int(std::lround(kLongestErrorRun_s * arm.frame_rate_hz));
  constexpr double kNoise = 0.02;  // of a sensor, where set points are what was measured
  const auto noise = mapped<double>(unseen, [&](const Episode& episode) {
    return !episode.setpoints_only && setpoints_are_measured(episode) ? kNoise : 0.0;
  });
  std::vector<RolloutPiece> moving;
  std::vector<RolloutPiece> from_rest;
  // Motions as they were recorded, including holds, cut if they are long.
  for (const RolloutPiece& piece : cut_pieces(pieces_of_motions(unseen), unseen, max_frames)) {
    const Episode& episode = unseen[piece.episode];
    if (moves(arm, episode, piece, noise[piece.episode])) {
      moving.push_back(piece);
      if (stands_still(episode, piece.first)) {
        from_rest.push_back(piece);
      }
    }
  }
  return from_rest.size() >= kMinFromRest ? from_rest : moving;
}

}  // namespace limber
