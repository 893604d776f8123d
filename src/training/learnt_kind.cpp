#include "learnt_kind.hpp"

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"

namespace limber {

namespace {

const char* kind_of(bool setpoints_only) {
  return setpoints_only ? "set points alone" : "what was measured";
}

}  // namespace

bool learns_from_setpoints(const TrainingData& data) {
  const bool first = !data.training.empty() && data.training.front().setpoints_only;
  for (const std::vector<Episode>* episodes :
       {&data.training, &data.validation, &data.replay, &data.unseen}) {
    for (const Episode& episode : *episodes) {
      if (episode.setpoints_only != first) {
        throw InputError(fmt::format(
            "the first training episode holds {}, another one {}; a network learns from one kind, "
            "since it can't know the other",
            kind_of(first), kind_of(!first)));
      }
    }
  }
  return first;
}

void require_data_of(const TrainingData& data, const ArmDescription& arm) {
  require_episodes_of(data.training, arm, "training data");
  require_episodes_of(data.validation, arm, "validation data");
  require_episodes_of(data.replay, arm, "replayed data");
  require_episodes_of(data.unseen, arm, "unseen data");
}

void require_kind_learnt(const CompensationModel& network, const std::vector<Episode>& episodes) {
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    if (episodes[i].setpoints_only != network.learnt_from_setpoints) {
      throw InputError(fmt::format(
          "the network learnt from {}, and {} holds {}. {}", kind_of(network.learnt_from_setpoints),
          episode_name(i, episodes[i].log), kind_of(episodes[i].setpoints_only),
          network.learnt_from_setpoints
              ? "Leave what was measured out (with_setpoints_only)"
              : "It has to be asked with pressures, or the arm's other command, as measured"));
    }
  }
}

}  // namespace limber
