#pragma once

#include <vector>

#include "limber/data/recording.hpp"
#include "limber/forward/forward_model.hpp"

namespace limber {

/// A stretch of an episode that is predicted without correction: from the recorded backbone of
/// frame `first`, the `frames` frames after it.
struct RolloutPiece {
  int episode = 0;
  int first = 0;
  int frames = 0;
};

/// Pieces of `frames` frames (the last one shorter) that cover every frame but the first of each
/// episode.
std::vector<RolloutPiece> pieces_of_length(const std::vector<Episode>& episodes, int frames);

/// A piece for each commanded motion: it starts from the last frame before the motion.
std::vector<RolloutPiece> pieces_of_motions(const std::vector<Episode>& episodes);

/// Predicted backbones of every episode (T×3m), fed with its measured pressures; frames that no
/// piece covers are the recorded ones. Pieces are rolled out side by side, in batches and over
/// `jobs` threads (0: one a core); the result does not depend on their number.
std::vector<FrameMatrix> roll_out(const ForwardModel& model, const std::vector<Episode>& episodes,
                                  std::vector<RolloutPiece> pieces, int jobs);

/// Mean distance of the predicted tips from the recorded ones over all pieces' frames.
double mean_tip_error_m(const std::vector<FrameMatrix>& predicted,
                        const std::vector<Episode>& episodes,
                        const std::vector<RolloutPiece>& pieces);

}  // namespace limber
