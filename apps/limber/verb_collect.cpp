#include "driver_flags.hpp"
#include "limber/arm/arm_description.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/lab/plan_schedule.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/sim/related_arms.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

constexpr const char* kPlans = "plans";

class CollectVerb final : public Verb {
 public:
  CollectVerb()
      : Verb("collect", "Record an arm while it follows a schedule",
             "limber collect --arm three_segment --schedule random --count 20 --out random.h5") {}

  void add_flags(CLI::App& app) override {
    command_ = &app;
    add_arm_flag(app, arm_);
    app.add_option(
           "--schedule", schedule_name_,
           "transitions: every ordered pair of fully left, off, fully right per segment, in space "
           "of off, half and full per chamber; "
           "random: uniform set points within the limits; identify: the minute that tells "
           "most about an arm (limber adapt), with its own --count, --approach and holds; plans: "
           "what --model plans in random environments, one plan after another")
        ->check(CLI::IsMember({"transitions", "random", "identify", kPlans}))
        ->capture_default_str();
    app.add_option("--count", schedule_.count,
                   "Motions per random episode; plans per episode, else 10; or how many "
                   "transitions, all by default");
    app.add_option("--episodes", schedule_.episodes, "Unbroken runs: 16 for transitions, else 1");
    app.add_option("--approach", approach_,
                   "step: set points jump; straight: they move together along a straight line at "
                   "the arm's rate limit, as those of a plan do")
        ->check(CLI::IsMember({"step", "straight"}))
        ->capture_default_str();
    app.add_option(
           "--hold-s", schedule_.hold_s,
           "Seconds that a motion's final set point is commanded, or longer until it is reached")
        ->capture_default_str();
    app.add_option("--hold-min-s", schedule_.hold_min_s,
                   "Draw each hold between this and --hold-s, reached or not");
    app.add_option("--model", model_file_, "Of --schedule plans: the network that plans them");
    app.add_option("--max-queries", plans_.queries, "Of --schedule plans: model queries of each")
        ->check(more_than_zero())
        ->capture_default_str()
        ->needs(app.get_option("--model"));
    driver_.add_to(app);
    app.add_option("--noise-m", options_.noise_m, "Noise of measured positions, std deviation");
    app.add_option("--noise-rad", options_.noise_rad, "Noise of measured headings");
    app.add_option("--noise-kpa", options_.noise_kpa, "Noise of measured pressures");
    app.add_option("--drop-rate", options_.drop_rate, "Probability that a frame has no backbone")
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("--latency-s", options_.latency_s, "Delay of everything measured");
    app.add_option("--vary-physics", vary_physics_,
                   "Each episode on a virtual arm whose friction, load, stiffness, valves and "
                   "strength are others, by up to this factor, 1 to 10: for a network that is then "
                   "trained further on the arm itself (train --from). wide: drawn "
                   "from all that arms, tables and valves are like (docs/virtual-arm.md)");
    app.add_option("--out", out_, "Recording to write")->required();
    app.add_flag("--resume", resume_, "Go on from the finished episodes of a stopped run");
  }

  int run(const CommonFlags& flags) override {
    driver_.check({"--noise-m", "--noise-rad", "--noise-kpa", "--drop-rate", "--latency-s",
                   "--vary-physics"});
    const std::string arm_file = find_arm_file(arm_);
    const ArmDescription arm = load_any_arm(arm_file, PolynomialsOf::characterisation);
    if (schedule_name_ == kPlans) {
      require_planar(arm, "--schedule plans");
    }
    options_.seed = flags.seed;
    set_schedule(arm.dimension);
    schedule_.limit_scale = driver_.limit_scale();
    const std::optional<PhysicsVariation> variation =
        vary_physics_ ? std::optional(parse_physics_variation(*vary_physics_)) : std::nullopt;
    CollectionSettings settings = variation
                                      ? related_collection(arm, schedule_, options_, *variation)
                                      : virtual_collection(arm, schedule_, options_);
    take_common(flags, settings);
    settings.resume = resume_;
    if (schedule_name_ == kPlans) {
      if (!resume_ && !driver_.is_dry_run()) {
        refuse_to_overwrite(out_, flags.force);  // planning takes long
      }
      add_plans(arm, settings, flags);
    }
    if (driver_.is_dry_run()) {
      return print_dry_run(arm, settings, flags);
    }
    if (!driver_.is_virtual()) {
      return run_on_driver(arm, arm_file, settings, flags);
    }
    const DriverFactory drivers = variation ? related_arm_factory(arm, options_, *variation)
                                            : virtual_arm_factory(arm, options_);
    const CollectionResult result = collect(arm, settings, drivers, out_);
    report(flags, arm, result, nullptr);
    return kExitDone;
  }

 private:
  /// What flags leave out of `identify` is its own.
  void set_schedule(Dimension dimension) {
    refuse_if((schedule_name_ == kPlans) == model_file_.empty(),
              "--schedule plans and --model: expected both or neither; the model makes the plans");
    if (schedule_name_ == "random" || schedule_name_ == "transitions") {
      schedule_.kind =
          schedule_name_ == "random" ? ScheduleKind::random : ScheduleKind::transitions;
      schedule_.approach = approach_ == "step" ? Approach::step : Approach::straight;
      return;
    }
    refuse_if(command_->count("--hold-s") + command_->count("--hold-min-s") +
                      command_->count("--approach") >
                  0,
              "--schedule {} has its own holds, and goes straight: leave --hold-s, "
              "--hold-min-s and --approach out, or take --schedule random",
              schedule_name_);
    if (schedule_name_ == kPlans) {
      schedule_.approach = Approach::straight;
      return;
    }
    const ScheduleSettings asked = schedule_;
    schedule_ = identifying_schedule(dimension);
    schedule_.count = asked.count != 0 ? asked.count : schedule_.count;
    schedule_.episodes = asked.episodes;
  }

  void add_plans(const ArmDescription& arm, CollectionSettings& settings,
                 const CommonFlags& flags) {
    const CompensationModel network = read_model_of_one_arm(model_file_, arm);
    const ForwardModel forward(arm, network);
    const MotionModel model(forward, ValveModel(arm, network.identified_valves().parameters));
    plans_.count = schedule_.count != 0 ? schedule_.count : plans_.count;
    plans_.episodes = schedule_.episodes != 0 ? schedule_.episodes : plans_.episodes;
    plans_.limit_scale = schedule_.limit_scale;
    take_common(flags, plans_);
    settings.episodes = plan_schedule(arm, model, plans_);
    settings.episodes_are = describe(plans_, file_hash(model_file_));
  }

  int print_dry_run(const ArmDescription& arm, const CollectionSettings& settings,
                    const CommonFlags& flags) const {
    return driver_.print_dry_run(arm, flags, [&](ArmDriver& driver) {
      for (const EpisodeSchedule& schedule :
           settings.episodes.empty() ? make_schedule(arm, settings.schedule, settings.seed)
                                     : settings.episodes) {
        (void)record_episode(arm, driver, schedule, settings);
      }
    });
  }

  /// @throws InputError where the schedule goes beyond what the driver allows, on either side.
  /// One process for all episodes, one after the other.
  int run_on_driver(const ArmDescription& arm, const std::string& arm_file,
                    CollectionSettings settings, const CommonFlags& flags) {
    refuse_if(vary_physics_ || describe(arm, options_) != describe(arm, VirtualArmOptions{}),
              "--noise-m, --vary-physics and the like are the virtual arm's; drop them with exec:");
    if (!resume_) {
      refuse_to_overwrite(out_, flags.force);
    }
    const bool straight = schedule_.approach == Approach::straight;
    const std::unique_ptr<ProcessDriver> driver =
        driver_.start(arm, arm_file, out_, straight, flags);
    require_reach(arm, schedule_.limit_scale, *driver);
    settings.source = describe(*driver);
    settings.driver = how_it_is_moved(*driver);
    settings.jobs = 1;
    settings.partial = fs::path(out_).replace_extension(".partial.h5");
    const CollectionResult result = collect(arm, settings, on_one_driver(*driver), out_);
    report(flags, arm, result, driver.get());
    return driver->last_vent().confirmed ? kExitDone : kExitFault;
  }

  /// @param driver  that moved the arm; null: the virtual one
  void report(const CommonFlags& flags, const ArmDescription& arm, const CollectionResult& result,
              const ProcessDriver* driver) const {
    if (result.foreign_files > 0) {
      say(flags, "{}.parts: {} files were not written by collect and stay", out_,
          result.foreign_files);
    }
    const Recording& recording = result.recording;
    const IdentifiedValves valves =
        identify_valves(recording.episodes, arm, fs::path(out_).filename().string());
    const auto motions = sum_of<std::size_t>(recording.episodes, [&](const Episode& episode) {
      return std::size_t(episode.motion_index.back() + 1);
    });
    Json json;
    json["file"] = out_;
    json["arm"] = recording.arm_name;
    json["seed"] = recording.seed;
    json["settings"] = recording.settings;
    json["episodes"] = recording.episodes.size();
    json["episodes_kept_from_before"] = result.kept_episodes;
    json["motions"] = motions;
    json["frames"] = recording.frame_count();
    json["frames_dropped"] = recording.untracked_count();
    json["arm_time_s"] = recording.duration_s();
    json["wall_time_s"] = result.wall_time_s;
    json["valves"] = to_json(valves);
    if (driver != nullptr) {
      json["driver"] = to_json(*driver);
    }
    print_result(flags, json,
                 fmt::format("{}: {} motions in {} episodes, {} frames ({} of arm time), seed {}, "
                             "recorded in {:.1f} s\n{}",
                             out_, motions, recording.episodes.size(), recording.frame_count(),
                             format_duration(recording.duration_s()), recording.seed,
                             result.wall_time_s, to_text(valves, arm.command.unit, arm.dimension)));
  }

  const CLI::App* command_ = nullptr;
  std::string arm_ = "three_segment";
  DriverFlags driver_;
  std::string out_;
  std::string schedule_name_ = "transitions";
  std::string approach_ = "step";
  ScheduleSettings schedule_;
  PlanScheduleSettings plans_;
  std::string model_file_;
  VirtualArmOptions options_;
  std::optional<std::string> vary_physics_;
  bool resume_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_collect_verb() {
  return std::make_unique<CollectVerb>();
}

}  // namespace limber
