#include "data_survey.hpp"

#include "learnt_kind.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/network/gap_bounds.hpp"
#include "limber/training/episode_slices.hpp"
#include "limber/training/gap_bounds_fit.hpp"

namespace limber {

namespace {

GapBounds bounds_for(const TrainingData& data, const CompensationModel* start) {
  std::vector<Episode> episodes = data.training;
  episodes.insert(episodes.end(), data.replay.begin(), data.replay.end());
  const GapBounds recorded = gap_bounds_of(episodes);
  return start != nullptr && start->bounds ? joined(*start->bounds, recorded) : recorded;
}

}  // namespace

std::string hash_of(const std::vector<Episode>& episodes) {
  std::string hashes;
  for (const Episode& episode : episodes) {
    for (const FrameMatrix* numbers :
         {&episode.pressure_kpa, &episode.setpoint_kpa, &episode.backbone}) {
      hashes += content_hash(number_bytes(*numbers));
    }
    hashes += content_hash(std::string(episode.tracked.begin(), episode.tracked.end()));
  }
  return content_hash(hashes);
}

DataSurvey survey_of(
    const ArmDescription& arm, const TrainingData& data, std::uint64_t seed,
    const CompensationModel* start,
    const std::function<void(const std::vector<int>&, const std::vector<Episode>&)>& on_slice) {
  if (data.slices.frame_counts.empty()) {
    return {bounds_for(data, start), learns_from_setpoints(data), ""};
  }
  refuse_if(
      !data.training.empty() || !data.replay.empty() || data.slices.slice_frames < 1,
      "slices of {} frames, {} other training episodes and {} to replay; expected slices of a "
      "frame or more, and no other episodes",
      data.slices.slice_frames, data.training.size(), data.replay.size());
  DataSurvey survey;
  TrainingData part;
  part.validation = data.validation;
  for (const std::vector<int>& slice : slices_of(data.slices, seed, 0)) {
    part.training = data.slices.read(slice);
    require_data_of(part, arm);
    survey.from_setpoints = learns_from_setpoints(part);
    part.validation = {part.training.front()};  // the next slice is of its kind
    const GapBounds recorded = gap_bounds_of(part.training);
    survey.bounds = survey.content.empty() ? recorded : joined(survey.bounds, recorded);
    survey.content += hash_of(part.training);
    on_slice(slice, part.training);
  }
  if (start != nullptr && start->bounds) {
    survey.bounds = joined(*start->bounds, survey.bounds);
  }
  return survey;
}

}  // namespace limber
