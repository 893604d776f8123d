#include "limber/training/window_stages.hpp"

#include <algorithm>

#include "limber/data/episode_slice.hpp"

namespace limber {

namespace {

// Between these, three networks were measured to arrive more often than one (docs/training.md).
constexpr double kMinHoursToShare = 1.0;
constexpr double kMaxHoursToShare = 4.0;
constexpr int kNetworksThatShare = 3;

}  // namespace

std::vector<int> windows_of(const TrainingSettings& settings) {
  std::vector<int> frames;
  for (const TrainingStage& stage : settings.stages) {
    frames.push_back(stage.window_frames);
  }
  return frames;
}

int network_count_for(const ArmDescription& arm, const TrainingData& data) {
  const double hours = double(frame_count(data.training)) * arm.frame_period_s() / 3600.0;
  return hours >= kMinHoursToShare && hours <= kMaxHoursToShare ? kNetworksThatShare : 1;
}

void share_epochs(TrainingSettings& settings, int networks) {
  settings.ensemble = networks;
  const int stages = static_cast<int>(settings.stages.size());
  set_epoch_count(settings, std::max(settings.epoch_count() / networks, stages));
}

}  // namespace limber
