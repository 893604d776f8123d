#include "limber/training/rollout.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace limber {

namespace {

constexpr std::size_t kPiecesPerBatch = 64;

/// Rolls out pieces of a batch; they are sorted, longest first, so that those still running are the
/// first columns.
void roll_out_batch(const ForwardModel& model, const std::vector<Episode>& episodes,
                    std::span<const RolloutPiece> pieces, std::vector<FrameMatrix>& predicted) {
  const auto columns = static_cast<Eigen::Index>(pieces.size());
  const Eigen::Index size = 3 * model.point_count();
  Eigen::MatrixXf previous_kpa(model.segment_count(), columns);
  Eigen::MatrixXf current_kpa(model.segment_count(), columns);
  Eigen::MatrixXf state(size, columns);
  ForwardModel::Workspace workspace;
  Eigen::Index active = columns;
  for (int k = 0; k < pieces.front().frames; ++k) {
    while (pieces[static_cast<std::size_t>(active - 1)].frames <= k) {
      --active;
    }
    for (Eigen::Index j = 0; j < active; ++j) {
      const RolloutPiece& piece = pieces[static_cast<std::size_t>(j)];
      const Episode& episode = episodes[static_cast<std::size_t>(piece.episode)];
      previous_kpa.col(j) = episode.pressure_kpa.row(piece.first + k);
      current_kpa.col(j) = episode.pressure_kpa.row(piece.first + k + 1);
      if (k == 0) {
        state.col(j) = episode.backbone.row(piece.first);
      }
    }
    model.step_batch(previous_kpa.leftCols(active), current_kpa.leftCols(active),
                     state.leftCols(active), state.leftCols(active), workspace);
    for (Eigen::Index j = 0; j < active; ++j) {
      const RolloutPiece& piece = pieces[static_cast<std::size_t>(j)];
      predicted[static_cast<std::size_t>(piece.episode)].row(piece.first + k + 1) = state.col(j);
    }
  }
}

}  // namespace

std::vector<RolloutPiece> pieces_of_length(const std::vector<Episode>& episodes, int frames) {
  std::vector<RolloutPiece> pieces;
  for (int index = 0; index < static_cast<int>(episodes.size()); ++index) {
    const int last = episodes[static_cast<std::size_t>(index)].frame_count() - 1;
    for (int first = 0; first < last; first += frames) {
      pieces.push_back({index, first, std::min(frames, last - first)});
    }
  }
  return pieces;
}

std::vector<RolloutPiece> pieces_of_motions(const std::vector<Episode>& episodes) {
  std::vector<RolloutPiece> pieces;
  for (int index = 0; index < static_cast<int>(episodes.size()); ++index) {
    const std::vector<int>& motion = episodes[static_cast<std::size_t>(index)].motion_index;
    int first = 0;
    for (int t = 2; t <= static_cast<int>(motion.size()); ++t) {
      const auto at = static_cast<std::size_t>(t);
      if (at == motion.size() || motion[at] != motion[at - 1]) {
        pieces.push_back({index, first, t - 1 - first});
        first = t - 1;
      }
    }
  }
  return pieces;
}

std::vector<FrameMatrix> roll_out(const ForwardModel& model, const std::vector<Episode>& episodes,
                                  std::vector<RolloutPiece> pieces, int jobs) {
  std::vector<FrameMatrix> predicted;
  for (const Episode& episode : episodes) {
    predicted.push_back(episode.backbone);
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const RolloutPiece& a, const RolloutPiece& b) {
    return a.frames > b.frames;
  });
  const std::size_t batches = (pieces.size() + kPiecesPerBatch - 1) / kPiecesPerBatch;
  tbb::task_arena arena(jobs > 0 ? jobs : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, batches, [&](std::size_t batch) {
      const std::size_t first = batch * kPiecesPerBatch;
      const std::size_t count = std::min(kPiecesPerBatch, pieces.size() - first);
      roll_out_batch(model, episodes, std::span(pieces).subspan(first, count), predicted);
    });
  });
  return predicted;
}

double mean_tip_error_m(const std::vector<FrameMatrix>& predicted,
                        const std::vector<Episode>& episodes,
                        const std::vector<RolloutPiece>& pieces) {
  double sum = 0.0;
  std::int64_t count = 0;
  for (const RolloutPiece& piece : pieces) {
    const auto index = static_cast<std::size_t>(piece.episode);
    const FrameMatrix& recorded = episodes[index].backbone;
    const Eigen::Index tip = recorded.cols() - 3;
    const auto error = predicted[index].block(piece.first + 1, tip, piece.frames, 2) -
                       recorded.block(piece.first + 1, tip, piece.frames, 2);
    sum += error.rowwise().norm().cast<double>().sum();
    count += piece.frames;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}  // namespace limber
