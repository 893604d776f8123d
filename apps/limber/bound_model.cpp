#include "bound_model.hpp"

#include <filesystem>

#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/network/gap_bounds.hpp"
#include "limber/report/training_report.hpp"
#include "limber/training/gap_bounds_fit.hpp"

namespace limber {

namespace {

/// The episodes of all recordings; `sources` names the files and their hashes.
std::vector<Episode> episodes_of(const BoundModelRequest& request, const ArmDescription& arm,
                                 std::string& sources) {
  std::vector<Episode> episodes;
  for (const std::vector<std::string>* paths : {&request.data, &request.old_data}) {
    for (const std::string& path : *paths) {
      Recording recording = read_recording(path);
      require_recording_of(recording, arm, path);
      std::move(recording.episodes.begin(), recording.episodes.end(), std::back_inserter(episodes));
      add_source(sources, path);
    }
  }
  return episodes;
}

}  // namespace

int add_bounds_to_model(const BoundModelRequest& request, const CommonFlags& flags) {
  if (request.from.empty()) {
    throw InputError(
        "--epochs 0 trains nothing: it only adds bounds to an old model, and needs --from MODEL");
  }
  refuse_to_overwrite(request.out, flags.force);
  const ArmDescription arm = load_any_arm(request.arm);
  CompensationModel model = read_model(request.from);
  require_model_of(model, arm, request.from);
  if (model.arm_description.empty()) {
    model.set_arm(arm);
  }
  std::string sources;
  const std::vector<Episode> episodes = episodes_of(request, arm, sources);
  const GapBounds recorded = gap_bounds_of(episodes);
  model.bounds = model.bounds ? joined(*model.bounds, recorded) : recorded;
  model.training["bounds"] = sources;
  const LongRollout rollout = roll_out_long(ForwardModel(arm, model), episodes);
  write_model(request.out, model);
  if (!rollout.bounded) {
    say(flags,
        "warning: in {:.0f} % of a rollout of {} frames a bound held a gap: this network runs away "
        "without them. Train it again, which picks another epoch",
        100.0 * rollout.held_share, rollout.frames);
  }
  print_result(
      flags,
      {{"status", "bounded"},
       {"model", request.out},
       {"from", request.from},
       {"bounds", to_json(*model.bounds)},
       {"long_rollout", to_json(rollout)}},
      fmt::format("{}: {} as it was, and {}", request.out, request.from, to_text(*model.bounds)));
  return kExitDone;
}

}  // namespace limber
