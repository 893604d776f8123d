#include <algorithm>
#include <memory>

#include "driver_flags.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/driver/vented_rest.hpp"
#include "limber/lab/improve.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/run/model_arm.hpp"
#include "limber/training/fine_tuning.hpp"
#include "room_flags.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

/// Of improve's training: what learns from ten minutes of an arm that was recorded for two hours
/// without forgetting those (docs/improving.md has the figures).
constexpr double kReplayShare = 0.75;
/// Of --from-start and --prior: windows of 32 predict long motions best (docs/training.md, What it
/// reaches).
constexpr int kWindowFrames = 32;

class ImproveVerb final : public Verb {
 public:
  const char* name() const override { return "improve"; }
  const char* summary() const override {
    return "Rounds of planning, executing and learning from what the arm then did";
  }
  const char* example() const override {
    return "limber collect --schedule random --count 40 --episodes 20 --out train.h5\n"
           "  limber train --data train.h5 --out model.safetensors\n"
           "  limber improve --model model.safetensors --data train.h5 --rounds 2 --out improved";
  }

  void add_flags(CLI::App& app) override {
    app.add_option("--arm", arm_, "Arm file, or the name of one of limber's own")
        ->capture_default_str();
    app.add_option("--model", model_, "Network model to improve")->required();
    app.add_option("--data", data_,
                   "Recording that it has learnt from, which is replayed; repeat for more")
        ->required();
    driver_.add_to(app, true);
    app.add_option("--rounds", settings_.rounds, "Rounds at most")->capture_default_str();
    app.add_option("--round-min", settings_.round_min,
                   "Minutes of arm time that each round learns from")
        ->capture_default_str();
    app.add_option("--plan-share", settings_.plan_share,
                   "Share of them for executed plans, 0 to 1; the rest are random motions")
        ->capture_default_str();
    app.add_option(
           "--chain", settings_.chain,
           "Environments between two ventings: each plan to learn from begins where the one "
           "before ended; 1: all from the vented arm")
        ->capture_default_str();
    app.add_option("--selection", settings_.selection,
                   "Environments whose executed plans choose the round, the same in every round")
        ->capture_default_str();
    app.add_option("--reported", settings_.reported,
                   "Fresh environments, and random motions, for each round's figures")
        ->capture_default_str();
    app.add_option("--max-queries", settings_.queries, "Model queries of each plan")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    room_.add_to(app);
    auto* from_start = app.add_flag(
        "--from-start", settings_.from_start,
        "Each round trains a new network on --data and all rounds, instead of going on from the "
        "last round's: takes longer, and is better where there are hours of plans");
    auto* prior = app.add_option(
        "--prior", settings_.prior_file,
        "Each round goes on from this network, on --data and all rounds: one that learnt from "
        "virtual arms (collect --vary-physics), or from an arm much like this one");
    prior->excludes(from_start);
    app.add_option("--epochs", epochs_,
                   "Epochs of each round's training; by default train's with --from-start or "
                   "--prior, else half of them")
        ->check(CLI::Range(1, 10'000'000));
    app.add_option("--learning-rate", learning_rate_,
                   "Of each round's training; by default train's with --from-start or --prior, "
                   "else a tenth")
        ->check(CLI::PositiveNumber);
    app.add_option("--replay", replay_share_,
                   "Share of each epoch's windows that come from --data, 0 to 0.95")
        ->check(CLI::Range(0.0, 0.95))
        ->excludes(from_start)
        ->excludes(prior)
        ->capture_default_str();
    app.add_option("--out", out_, "Folder for models, recordings, figures and the report")
        ->capture_default_str();
    app.add_flag("--resume", settings_.resume,
                 "Go on with the run in --out; you may ask for more --rounds");
  }

  int run(const CommonFlags& flags) override {
    driver_.check();
    const std::string arm_file = find_arm_file(arm_);
    fill_in_settings(flags, arm_file);
    require_startable(settings_);
    require_writable_folder(out_);
    if (driver_.is_dry_run()) {
      throw InputError(
          "--dry-run: plans depend on what the arm did before, so nothing can be shown; limber "
          "collect --schedule random --dry-run shows what random motions send");
    }
    if (driver_.is_program()) {
      return run_on_driver(arm_file, flags);
    }
    require_full_limits();
    const ImproveArm on = driver_.is_model() ? model_arm() : virtual_improve_arm(settings_.arm);
    report(run_improve(settings_, on), flags);
    return kExitDone;
  }

 private:
  void fill_in_settings(const CommonFlags& flags, const std::string& arm_file) {
    settings_.arm = load_asked_arm(arm_file);
    settings_.model_file = model_;
    settings_.data_files.assign(data_.begin(), data_.end());
    settings_.folder = out_;
    settings_.room = room_.asked();
    settings_.training = training_preset("best");
    if (settings_.from_start || !settings_.prior_file.empty()) {
      set_window_frames(settings_.training, {kWindowFrames});
    } else {
      settings_.training = fine_tuning_of(settings_.training);
    }
    if (epochs_) {
      set_epoch_count(settings_.training, *epochs_);
    }
    settings_.training.learning_rate = learning_rate_.value_or(settings_.training.learning_rate);
    settings_.training.replay_share = replay_share_;
    settings_.seed = flags.seed;
    settings_.jobs = flags.jobs;
    settings_.force = flags.force;
    settings_.progress = flags.progress();
    settings_.say = [&flags](const std::string& line) { say(flags, "{}", line); };
  }

  void require_full_limits() const {
    if (driver_.limit_scale() != 1.0) {
      throw InputError("--limit-scale: is for arms behind --driver exec:COMMAND");
    }
  }

  /// A fresh arm that is what another network says, for every run.
  ImproveArm model_arm() const {
    const auto make = [arm = settings_.arm, network = read_model_of_one_arm(driver_.model_file())] {
      return std::make_unique<ModelArm>(arm, network, network.valves.value_or(ValveParameters{}));
    };
    ImproveArm on;
    on.source = "model:" + driver_.model_file();
    on.about = "network " + content_hash(read_file(driver_.model_file()));
    on.drivers = [make](int /*index*/) { return make(); };
    on.execute = [arm = settings_.arm, make](const Environment& environment, const Plan& plan,
                                             Controller* then) {
      ExecutionSettings execution;
      execution.controller = then;
      return execute(arm, environment, plan, *make(), execution);
    };
    on.side_by_side = true;
    return on;
  }

  int run_on_driver(const std::string& arm_file, const CommonFlags& flags) {
    const bool jumps = true;  // of random motions' set points; the valves ramp by themselves
    const std::unique_ptr<ProcessDriver> driver =
        driver_.start(settings_.arm, arm_file, out_, !jumps, flags);
    require_reach(settings_.arm, driver_.limit_scale(), *driver);
    if (!driver->look().backbone) {
      throw SystemFault(
          "the driver's state has no backbone: nothing tracks the arm, so nothing can be learnt");
    }
    ImproveArm on;
    on.source = describe(*driver);
    on.about = "on an arm, by its driver";
    on.limits = driver->limits_kpa();
    on.limit_scale = driver_.limit_scale();
    on.drivers = on_one_driver(*driver);
    on.start = [&driver = *driver, this] { return vented_rest(settings_.arm, driver); };
    on.execute = [&driver = *driver, this](const Environment& environment, const Plan& plan,
                                           Controller* then) {
      constexpr double kMeasured_m = 0.01;  // what trackers and a base's frame are off by
      ExecutionSettings execution;
      execution.controller = then;
      execution.max_start_error_m = std::max(plan.margin_m, kMeasured_m);
      driver.look();
      return execute(settings_.arm, environment, plan, driver, execution);
    };
    nlohmann::ordered_json summary = run_improve(settings_, on);
    summary["driver"] = to_json(*driver);
    report(summary, flags);
    return driver->last_vent().confirmed ? kExitDone : kExitFault;
  }

  static std::string distance(const nlohmann::ordered_json& round) {
    const nlohmann::ordered_json& mean = round.at("reported").at("distance_to_goal_cm").at("mean");
    return mean.is_null() ? "none executed" : fmt::format("{:.2f} cm", mean.get<double>());
  }

  void report(const nlohmann::ordered_json& summary, const CommonFlags& flags) const {
    const auto best = summary.at("best_round").get<std::size_t>();
    const nlohmann::ordered_json& rounds = summary.at("rounds");
    print_result(
        flags, summary,
        fmt::format("{}/model.safetensors: round {} of {}{}; executed plans end off by {}, before "
                    "{}\n{}/report.html, summary.json",
                    out_, best, rounds.size() - 1,
                    best == 0 ? ", the model to start from: no round was better" : "",
                    distance(rounds[best]), distance(rounds[0]), out_));
  }

  std::string arm_ = "three_segment";
  std::string model_;
  std::vector<std::string> data_;
  DriverFlags driver_;
  RoomFlags room_;
  std::optional<int> epochs_;
  std::optional<double> learning_rate_;
  double replay_share_ = kReplayShare;
  std::string out_ = "improved";
  ImproveSettings settings_;
};

}  // namespace

std::unique_ptr<Verb> make_improve_verb() {
  return std::make_unique<ImproveVerb>();
}

}  // namespace limber
