#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "limber/data/recording.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/training/evaluation.hpp"
#include "limber/training/tip_errors.hpp"

namespace limber {

/// A stretch of an episode that is predicted without correction: from the recorded backbone of
/// frame `first`, the `frames` frames after it.
struct RolloutPiece {
  int episode = 0;
  int first = 0;
  int frames = 0;
};

/// Pieces of `frames` frames, the last one shorter, from the start of each episode on. A piece
/// begins at a frame in which the arm was tracked: a guessed backbone is no start.
std::vector<RolloutPiece> pieces_of_length(const std::vector<Episode>& episodes, int frames);

/// A piece for each commanded motion: it starts from the last frame before the motion, or the first
/// after that in which the arm was tracked.
std::vector<RolloutPiece> pieces_of_motions(const std::vector<Episode>& episodes);

/// The same pieces in parts of up to `frames` frames. A part begins at a frame in which the arm was
/// tracked, too.
std::vector<RolloutPiece> cut_pieces(const std::vector<RolloutPiece>& pieces,
                                     const std::vector<Episode>& episodes, int frames);
std::vector<RolloutPiece> pieces_for(const std::vector<Episode>& episodes, Restart restart);

/// The frame that tells how the arm moves in frame `first`; itself where nobody saw that.
int before_start(const Episode& episode, int first);

/// How many of the frames that pieces predict were tracked: an error is a mean over these.
std::int64_t measured_frames(const std::vector<Episode>& episodes,
                             const std::vector<RolloutPiece>& pieces);

/// Of the pieces by which networks and fits are validated, half a minute at 20 Hz.
inline constexpr int kValidationFrames = 600;

/// What a rollout does on Ctrl-C: training needs the whole validation.
enum class OnInterrupt { finish, stop };

/// Predicted backbones of every episode (T×3m), fed with its measured pressures. A piece's first
/// frame is given, not predicted: frames that no piece predicts are NaN. Pieces are rolled out side
/// by side, in batches and over `jobs` threads (0: one per core); the result does not depend on
/// their number. @throws Interrupted if Ctrl-C is to stop it.
std::vector<FrameMatrix> roll_out(const ForwardModel& model, const std::vector<Episode>& episodes,
                                  std::vector<RolloutPiece> pieces, int jobs,
                                  OnInterrupt on_interrupt = OnInterrupt::finish);

/// Predicts the frames of a piece from the recorded backbone at its start; leaves them NaN where it
/// can't.
using PiecePrediction =
    std::function<void(const Episode&, const RolloutPiece&, FrameMatrix& predicted)>;
std::vector<FrameMatrix> predict_pieces(const PiecePrediction& predict_piece,
                                        const std::vector<Episode>& episodes,
                                        const std::vector<RolloutPiece>& pieces);

void hold(const Episode& episode, const RolloutPiece& piece, FrameMatrix& predicted);
/// Needs two tracked frames. Without them it holds the pose; a single step then says nothing.
void keep_velocity(const Episode& episode, const RolloutPiece& piece, FrameMatrix& predicted);

TipErrorSeries errors_over(const std::vector<FrameMatrix>& predicted,
                           const std::vector<Episode>& episodes);
/// Of what `predict` makes of them; `open_loop_from_setpoints` stays empty.
RolloutErrors errors_at_every_restart(
    const std::vector<Episode>& episodes,
    const std::function<std::vector<FrameMatrix>(Restart)>& predict);

/// Where the tip is in frame `t`: x and y, in space z.
inline auto tip_place(const FrameMatrix& backbones, Eigen::Index t, Dimension dimension) {
  return backbones.row(t).segment(backbones.cols() - pose_size(dimension),
                                  position_size(dimension));
}

/// Angle between the tip's headings in frame `t`; NaN where nobody measured them (`lifted`).
double heading_apart_rad(const FrameMatrix& predicted, const Episode& recorded, Eigen::Index t);

/// Mean over an ensemble's members of what `roll_out` gave for each, episode by episode.
std::vector<FrameMatrix> mean_of(const std::vector<std::vector<FrameMatrix>>& predicted,
                                 Dimension dimension);

/// Mean distance of the predicted tips from the recorded ones over those of the pieces' frames in
/// which the arm was tracked; NaN if there are none.
double mean_tip_error_m(const std::vector<FrameMatrix>& predicted,
                        const std::vector<Episode>& episodes,
                        const std::vector<RolloutPiece>& pieces);

/// The same of `model` rolled out over pieces of `frames` frames.
double tip_error_m(const ForwardModel& model, const std::vector<Episode>& episodes, int frames,
                   int jobs);

}  // namespace limber
