#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/sim/disturbance.hpp"
#include "limber/sim/driver_server.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

class VirtualArmVerb final : public Verb {
 public:
  VirtualArmVerb()
      : Verb("virtual-arm", "Serve the virtual arm behind the driver protocol",
             "limber collect --schedule random --count 2 --out served.h5 "
             "--driver \"exec:limber virtual-arm --serve\"\n"
             "  limber virtual-arm --serve < /dev/null") {}

  void add_flags(CLI::App& app) override {
    app.add_flag("--serve", serve_,
                 "Speak the protocol (docs/driver.md) on standard input and output");
    add_arm_flag(app, arm_);
    app.add_flag("--fast", settings_.fast,
                 "Answer as fast as possible, instead of keeping frames of wall time");
    app.add_flag("--at-once", settings_.at_once,
                 "Answer with the sample of the moment, as hardware does, and not with the end of "
                 "the frame that begins");
    app.add_option("--sampled", settings_.sampled_s,
                   "At once, with the newest sample of a tracker that takes one every so many "
                   "seconds: a request that overtakes it gets the last one again")
        ->check(more_than_zero());
    app.add_option("--fault", fault_,
                   "Go wrong from a frame on, as in die@12; an unknown kind lists all of them");
    app.add_option("--misassembled", misassembled_,
                   "Seed: be put together wrongly (channels, signs, zeros, tracker), for trying "
                   "limber driver calibrate");
    app.add_flag("--bodies", bodies_,
                 "With --misassembled: the tracker sees in 3D and sends bodies, each with axes of "
                 "its own, in place of backbones");
    app.add_option("--truth", truth_,
                   "File for what a calibration has to find, with --misassembled");
    app.add_option("--device-log", settings_.device_log,
                   "What the simulated device was told, with times of the monotonic clock");
    app.add_option("--noise-m", settings_.arm.noise_m,
                   "Noise of measured positions, std deviation");
    app.add_option("--noise-kpa", settings_.arm.noise_kpa, "Noise of measured pressures");
    app.add_option("--drop-rate", settings_.arm.drop_rate,
                   "Probability that a frame has no backbone");
    app.add_option("--latency-s", settings_.arm.latency_s, "Delay of everything measured");
    app.add_option("--disturbance", disturbance_,
                   "Be another arm than --arm says, as with limber execute --disturbance; without "
                   "obstacles. Sampled from --seed");
    app.add_option("--plan", plan_,
                   "Plan during whose motion lost_tracking, picked_up or leak happens");
  }

  int run(const CommonFlags& flags) override {
    refuse_if(!serve_,
              "expected --serve: 'limber virtual-arm --serve' speaks "
              "the driver protocol on standard input and output");
    refuse_if(settings_.fast && settings_.sampled_s > 0.0,
              "--sampled: is in real time, which --fast is not");
    if (!fault_.empty()) {
      settings_.fault = parse_server_fault(fault_);
    }
    refuse_to_overwrite_given({settings_.device_log}, flags);
    const ArmDescription arm = load_any_arm(find_arm_file(arm_), PolynomialsOf::characterisation);
    const DisturbedArm served = disturb(arm, flags.seed);
    settings_.arm = served.options;
    misassemble(served.arm, flags);
    serve_virtual_arm(served.arm, settings_);
    return kExitDone;
  }

 private:
  DisturbedArm disturb(const ArmDescription& arm, std::uint64_t seed) const {
    const std::vector<Disturbance> disturbances = parse_disturbances(disturbance_);
    refuse_if(
        has_kind(disturbances, DisturbanceKind::obstacle),
        "--disturbance obstacle: the arm does not know obstacles; limber execute has the flag");
    // There are no plans in space yet: there they begin with the arm.
    const bool begins_late =
        !arm.is_spatial() && (has_kind(disturbances, DisturbanceKind::picked_up) ||
                              has_kind(disturbances, DisturbanceKind::leak));
    const bool needs_plan = has_kind(disturbances, DisturbanceKind::lost_tracking) || begins_late;
    if (needs_plan == plan_.empty()) {
      throw InputError(needs_plan ? fmt::format("--disturbance {}: in which plan's motion? "
                                                "(--plan FILE)",
                                                disturbance_)
                                  : "--plan: goes with --disturbance lost_tracking, picked_up or "
                                    "leak");
    }
    Plan plan;
    if (needs_plan) {
      plan = read_plan(plan_);
      require_plan_of(plan, arm, plan_);
    }
    return disturbed(arm, plan, disturbances, seed, settings_.arm);
  }

  void misassemble(const ArmDescription& arm, const CommonFlags& flags) {
    if (!misassembled_) {
      refuse_if(!truth_.empty(), "--truth: goes with --misassembled SEED, whose truth it is");
      refuse_if(bodies_, "--bodies: goes with --misassembled SEED, which says how they are turned");
      return;
    }
    require_planar(arm, "--misassembled");
    settings_.misassembly = bodies_ ? draw_misassembly_in_3d(arm, *misassembled_)
                                    : draw_misassembly(arm, *misassembled_);
    if (!truth_.empty()) {
      refuse_to_overwrite(truth_, flags.force);
      write_file_atomically(truth_, to_yaml(settings_.misassembly->truth));
    }
  }

  std::string arm_ = "three_segment";
  std::string disturbance_;
  std::string plan_;
  std::string fault_;
  std::optional<std::uint64_t> misassembled_;
  std::string truth_;
  bool serve_ = false;
  bool bodies_ = false;
  ServerSettings settings_;
};

}  // namespace

std::unique_ptr<Verb> make_virtual_arm_verb() {
  return std::make_unique<VirtualArmVerb>();
}

}  // namespace limber
