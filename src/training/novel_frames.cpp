#include "limber/training/evaluation.hpp"

namespace limber {

NovelFrames find_novel_frames(const LearntRegion& learnt, const std::vector<Episode>& episodes) {
  require_alike(episodes, learnt.segment_count(), learnt.point_count());
  NovelFrames found;
  for (const Episode& episode : episodes) {
    for (int t = 0; t < episode.frame_count(); ++t) {
      if (!episode.was_tracked(t)) {
        continue;
      }
      const Pressures kpa = episode.pressure_kpa.row(t).transpose();
      const auto shape = backbone_at(episode.backbone, t);
      const bool follows = t > 0 && episode.was_tracked(t - 1);
      const double novelty =
          follows ? learnt.novelty(kpa, shape, episode.pressure_kpa.row(t - 1).transpose(),
                                   backbone_at(episode.backbone, t - 1))
                  : learnt.novelty(kpa, shape);
      NovelFrames::Count& count =
          learnt.holds(kpa) ? found.pressures_within : found.pressures_beyond;
      ++count.frames;
      count.novel += novelty > 1.0 ? 1 : 0;
    }
  }
  return found;
}

}  // namespace limber
