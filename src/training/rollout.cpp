#include "rollout.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <span>

#include "kernels/job_arena.hpp"
#include "limber/arm/space_pose.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/mapped.hpp"

namespace limber {

namespace {

constexpr std::size_t kPiecesPerBatch = 64;
constexpr int kWindowFrames = 32;

std::vector<FrameMatrix> nothing_predicted(const std::vector<Episode>& episodes) {
  return mapped<FrameMatrix>(episodes, [&](const Episode& episode) {
    return FrameMatrix::Constant(episode.backbone.rows(), episode.backbone.cols(),
                                 std::numeric_limits<float>::quiet_NaN());
  });
}

/// Rolls out pieces of a batch; they are sorted, longest first, so that those still running are the
/// first columns.
void roll_out_batch(const ForwardModel& model, const std::vector<Episode>& episodes,
                    const std::vector<Eigen::MatrixXf>& commands,
                    std::span<const RolloutPiece> pieces, OnInterrupt on_interrupt,
                    std::vector<FrameMatrix>& predicted) {
  const auto columns = Eigen::Index(pieces.size());
  const Eigen::Index size = pose_size(model.dimension()) * model.point_count();
  Eigen::MatrixXf previous_kpa(model.command_size(), columns);
  Eigen::MatrixXf current_kpa(model.command_size(), columns);
  Eigen::MatrixXf state(size, columns);
  Eigen::MatrixXf before(size, columns);
  ForwardModel::Workspace workspace;
  std::vector<char> ran_off(pieces.size(), 0);  // their predictions stay NaN from there on
  Eigen::Index active = columns;
  for (int k = 0; k < pieces.front().frames; ++k) {
    if (on_interrupt == OnInterrupt::stop) {
      throw_if_interrupted();
    }
    while (pieces[active - 1].frames <= k) {
      --active;
    }
    for (Eigen::Index j = 0; j < active; ++j) {
      const RolloutPiece& piece = pieces[j];
      const Episode& episode = episodes[piece.episode];
      const Eigen::MatrixXf& told = commands[piece.episode];
      previous_kpa.col(j) = told.col(piece.first + k);
      current_kpa.col(j) = told.col(piece.first + k + 1);
      if (k == 0) {
        state.col(j) = episode.backbone.row(piece.first);
        before.col(j) = episode.backbone.row(before_start(episode, piece.first));
      }
    }
    model.step_batch(previous_kpa.leftCols(active), current_kpa.leftCols(active),
                     before.leftCols(active), state.leftCols(active), before.leftCols(active),
                     workspace);
    state.leftCols(active).swap(before.leftCols(active));
    for (Eigen::Index j = 0; j < active; ++j) {
      if (!state.col(j).allFinite()) {
        ran_off[j] = 1;
        state.col(j).setZero();  // the model asks for finite numbers
      }
      if (ran_off[j] == 0) {
        const RolloutPiece& piece = pieces[j];
        predicted[piece.episode].row(piece.first + k + 1) = state.col(j);
      }
    }
  }
}

}  // namespace

int before_start(const Episode& episode, int first) {
  return first > 0 && episode.was_tracked(first - 1) ? first - 1 : first;
}

std::vector<RolloutPiece> pieces_of_length(const std::vector<Episode>& episodes, int frames) {
  const auto whole = mapped<RolloutPiece>(episodes.size(), [&](std::size_t e) {
    return RolloutPiece{int(e), 0, episodes[e].frame_count() - 1};
  });
  return cut_pieces(whole, episodes, frames);
}

std::vector<RolloutPiece> cut_pieces(const std::vector<RolloutPiece>& pieces,
                                     const std::vector<Episode>& episodes, int frames) {
  std::vector<RolloutPiece> parts;
  for (const RolloutPiece& piece : pieces) {
    const Episode& episode = episodes[piece.episode];
    const int end = piece.first + piece.frames;
    int first = episode.next_tracked(piece.first, end);
    while (first < end) {
      const int count = std::min(frames, end - first);
      parts.push_back({piece.episode, first, count});
      first = episode.next_tracked(first + count, end);
    }
  }
  return parts;
}

std::vector<RolloutPiece> pieces_of_motions(const std::vector<Episode>& episodes) {
  std::vector<RolloutPiece> pieces;
  for (int index = 0; index < int(episodes.size()); ++index) {
    const Episode& episode = episodes[index];
    const std::vector<int>& motion = episode.motion_index;
    int first = 0;
    for (int t = 2; t <= int(motion.size()); ++t) {
      const auto at = std::size_t(t);
      if (at == motion.size() || motion[at] != motion[at - 1]) {
        const int start = episode.next_tracked(first, t - 1);
        if (start < t - 1) {
          pieces.push_back({index, start, t - 1 - start});
        }
        first = t - 1;
      }
    }
  }
  return pieces;
}

std::vector<RolloutPiece> pieces_for(const std::vector<Episode>& episodes, Restart restart) {
  switch (restart) {
    case Restart::every_frame:
      return pieces_of_length(episodes, 1);
    case Restart::every_32_frames:
      return pieces_of_length(episodes, kWindowFrames);
    case Restart::every_motion:
      return pieces_of_motions(episodes);
    case Restart::at_the_start_only:
      break;
  }
  return pieces_of_length(episodes, std::numeric_limits<int>::max());
}

std::int64_t measured_frames(const std::vector<Episode>& episodes,
                             const std::vector<RolloutPiece>& pieces) {
  std::int64_t count = 0;
  for (const RolloutPiece& piece : pieces) {
    const Episode& episode = episodes[piece.episode];
    for (int t = piece.first + 1; t <= piece.first + piece.frames; ++t) {
      count += episode.was_tracked(t) ? 1 : 0;
    }
  }
  return count;
}

std::vector<FrameMatrix> roll_out(const ForwardModel& model, const std::vector<Episode>& episodes,
                                  std::vector<RolloutPiece> pieces, int jobs,
                                  OnInterrupt on_interrupt) {
  std::vector<FrameMatrix> predicted = nothing_predicted(episodes);
  std::ranges::stable_sort(pieces, std::greater{}, &RolloutPiece::frames);
  std::vector<Eigen::MatrixXf> commands;  // as the model is told them, a frame in each column
  for (const Episode& episode : episodes) {
    commands.push_back(model.told_commands(episode.pressure_kpa.transpose()));
  }
  const std::size_t batches = (pieces.size() + kPiecesPerBatch - 1) / kPiecesPerBatch;
  const std::atomic<bool>* const stop = stop_of_thread();
  JobArena arena(jobs);
  arena.for_each(batches, [&](std::size_t batch) {
    const StopScope scope(stop);
    const std::size_t first = batch * kPiecesPerBatch;
    const std::size_t count = std::min(kPiecesPerBatch, pieces.size() - first);
    roll_out_batch(model, episodes, commands, std::span(pieces).subspan(first, count), on_interrupt,
                   predicted);
  });
  return predicted;
}

std::vector<FrameMatrix> predict_pieces(const PiecePrediction& predict_piece,
                                        const std::vector<Episode>& episodes,
                                        const std::vector<RolloutPiece>& pieces) {
  std::vector<FrameMatrix> predicted = nothing_predicted(episodes);
  for (const RolloutPiece& piece : pieces) {
    throw_if_interrupted();
    const auto index = std::size_t(piece.episode);
    predict_piece(episodes[index], piece, predicted[index]);
  }
  return predicted;
}

void hold(const Episode& episode, const RolloutPiece& piece, FrameMatrix& predicted) {
  for (int k = 1; k <= piece.frames; ++k) {
    predicted.row(piece.first + k) = episode.backbone.row(piece.first);
  }
}

void keep_velocity(const Episode& episode, const RolloutPiece& piece, FrameMatrix& predicted) {
  const int before = before_start(episode, piece.first);
  if (before == piece.first && piece.frames == 1) {
    return;
  }
  const auto start = episode.backbone.row(piece.first);
  const Eigen::RowVectorXf step = start - episode.backbone.row(before);
  for (int k = 1; k <= piece.frames; ++k) {
    predicted.row(piece.first + k) = start + float(k) * step;
  }
}

TipErrorSeries errors_over(const std::vector<FrameMatrix>& predicted,
                           const std::vector<Episode>& episodes) {
  TipErrorSeries all;
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    append(all, tip_errors(predicted[i], episodes[i]));
  }
  return all;
}

RolloutErrors errors_at_every_restart(
    const std::vector<Episode>& episodes,
    const std::function<std::vector<FrameMatrix>(Restart)>& predict) {
  const auto series = [&](Restart restart) { return errors_over(predict(restart), episodes); };
  const TipErrorSeries step = series(Restart::every_frame);
  return {summarise(step),
          summarise(moving_frames(step)),
          summarise(series(Restart::every_32_frames)),
          summarise(series(Restart::every_motion)),
          summarise(series(Restart::at_the_start_only)),
          std::nullopt};
}

std::vector<FrameMatrix> mean_of(const std::vector<std::vector<FrameMatrix>>& predicted,
                                 Dimension dimension) {
  std::vector<FrameMatrix> mean = predicted.front();
  for (std::size_t episode = 0; episode < mean.size(); ++episode) {
    for (std::size_t member = 1; member < predicted.size(); ++member) {
      mean[episode] += predicted[member][episode];
    }
    mean[episode] /= float(predicted.size());
    if (dimension == Dimension::space) {
      normalise_rotations(mean[episode]);
    }
  }
  return mean;
}

double mean_tip_error_m(const std::vector<FrameMatrix>& predicted,
                        const std::vector<Episode>& episodes,
                        const std::vector<RolloutPiece>& pieces) {
  double sum = 0.0;
  for (const RolloutPiece& piece : pieces) {
    const auto index = std::size_t(piece.episode);
    const Episode& episode = episodes[index];
    for (int t = piece.first + 1; t <= piece.first + piece.frames; ++t) {
      if (episode.was_tracked(t)) {
        const auto error = tip_place(predicted[index], t, episode.dimension) -
                           tip_place(episode.backbone, t, episode.dimension);
        sum += double(error.norm());
      }
    }
  }
  const std::int64_t count = measured_frames(episodes, pieces);
  return count > 0 ? sum / double(count) : std::numeric_limits<double>::quiet_NaN();
}

double tip_error_m(const ForwardModel& model, const std::vector<Episode>& episodes, int frames,
                   int jobs) {
  const std::vector<RolloutPiece> pieces = pieces_of_length(episodes, frames);
  return mean_tip_error_m(roll_out(model, episodes, pieces, jobs), episodes, pieces);
}

}  // namespace limber
