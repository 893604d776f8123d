#include <fmt/format.h>

#include "limber/run/executor.hpp"

namespace limber {

Recording recording_of(const ArmDescription& arm, const std::string& source, const Plan& plan,
                       const ExecutionResult& result, std::optional<std::uint64_t> motion_queries) {
  Recording recording = make_recording(arm, source, plan.seed);
  recording.settings =
      fmt::format("executed plan, environment '{}', model {}, planner {}, {}",
                  plan.environment_name, plan.model, plan.planner, to_string(result.status));
  if (motion_queries) {
    recording.settings += fmt::format(", closed loop, {} queries in motion", *motion_queries);
  }
  recording.episodes = {result.episode};
  return recording;
}

}  // namespace limber
