#include "model_flags.hpp"

#include "limber/arm/valve_parameters.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/gap_bounds.hpp"

namespace limber {

void ModelFlags::add_to(CLI::App& app, const std::string& of_plan) {
  CLI::Option* model = app.add_option("--model", model_, "Network model" + of_plan);
  app.add_flag("--no-load", no_load_, "The no-load model alone" + of_plan)->excludes(model);
  add_valves_to(app);
}

void ModelFlags::add_valves_to(CLI::App& app) {
  CLI::Option* valves = app.add_option(
      "--valves", valves_,
      "Valve model between set points and pressures (limber characterize --valves); by default "
      "the one that the network was trained with");
  app.add_flag("--no-valves", no_valves_, "Take the set points for the pressures")
      ->excludes(valves);
}

ForwardModel ModelFlags::planning_model(const ArmDescription& arm) const {
  refuse_if(model_.empty() && !no_load_,
            "nothing to predict with: give --model MODEL.safetensors, or --no-load");
  if (model_.empty()) {
    return ForwardModel(arm);
  }
  CompensationModel network = read_model_of_one_arm(model_, arm);
  require_bounded(network, model_);
  return ForwardModel(arm, std::move(network));
}

ValveParameters ModelFlags::valves(const ArmDescription& arm,
                                   const CompensationModel* network) const {
  if (no_valves_) {
    return {};
  }
  if (network != nullptr && network->learnt_from_setpoints) {
    if (!valves_.empty()) {
      throw InputError(fmt::format(
          "--valves {}: {} learnt from set points, so that it knows the valves along with the arm; "
          "before it their lag would count twice. Leave --valves out, or give a network that "
          "learnt from what was measured",
          valves_, model_.empty() ? "the network" : model_));
    }
    return {};
  }
  if (valves_.empty()) {
    return network != nullptr && network->valves ? *network->valves : ValveParameters{};
  }
  ValveParameters valves = read_valves(fs::path(valves_)).parameters;
  const std::string fault = why_unusable(valves, arm);
  refuse_if(!fault.empty(), "{}: {}", valves_, fault);
  return valves;
}

MotionModel ModelFlags::motion_model(const ArmDescription& arm, const ForwardModel& forward) const {
  const CompensationModel* network = forward.has_network() ? &forward.compensation() : nullptr;
  return {forward, ValveModel(arm, valves(arm, network))};
}

void ModelFlags::warn_without_valves(const MotionModel& model, const CommonFlags& flags) const {
  const std::string missing = why_valves_are_missing(model);
  if (!no_valves_ && !missing.empty()) {
    say(flags,
        "warning: {}. --valves FILE names a valve model (limber characterize --valves RECORDING); "
        "--no-valves says that none is wanted",
        missing);
  }
}

}  // namespace limber
