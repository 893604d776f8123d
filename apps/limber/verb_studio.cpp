#include <chrono>
#include <cstdio>
#include <thread>

#include "driver_flags.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/gap_bounds.hpp"
#include "limber/studio/studio.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

constexpr std::chrono::milliseconds kSignalPoll{100};
constexpr int kMaxPort = 65535;
constexpr double kFirstLimitScale = 0.1;  // web/src/arm_panel.ts

class StudioVerb final : public Verb {
 public:
  StudioVerb()
      : Verb("studio",
             "Serve a page for browsers: see the arm, drag obstacles and goal, plan, play, drive",
             "limber studio\n  limber studio --project my_project --model "
             "my_project/model.safetensors") {}

  void add_flags(CLI::App& app) override {
    app.add_option("--project", settings_.project,
                   "Folder whose arms, models and environments are offered, and where environments "
                   "and plans are saved")
        ->capture_default_str();
    app.add_option("--arm", arm_, "Arm to show first: a file, or the name of one of limber's own")
        ->capture_default_str();
    app.add_option("--model", model_, "Network to plan with first; else the no-load model");
    app.add_option("--driver", driver_,
                   "exec:COMMAND, the driver of --arm (docs/driver.md): pages can arm it and run "
                   "plans on it");
    wire_.add_to(app);
    app.add_option("--limit-scale", limit_scale_,
                   "Largest factor on the driver's arm's pressure limits that a page may set, 0.1 "
                   "to 1")
        ->capture_default_str();
    for (const char* name : {"--calibration", "--simulated", "--limit-scale"}) {
      app.get_option(name)->needs("--driver");
    }
    app.add_option("--port", settings_.port, "Port to listen at; 0: any that is free")
        ->check(CLI::Range(0, kMaxPort))
        ->capture_default_str();
    app.add_option("--listen", settings_.listen,
                   "Address or name of this machine to listen at. Whoever can read what is sent on "
                   "the way can use the studio: prefer an SSH tunnel to the default")
        ->capture_default_str();
  }

  int run(const CommonFlags& flags) override {
    const std::string arm_file = find_arm_file(arm_);
    const ArmDescription arm = load_asked_arm(arm_file, "limber studio");
    settings_.arm = arm_file;
    settings_.model = model_;
    if (!model_.empty()) {
      const CompensationModel model = read_model(model_);
      require_model_of(model, arm, model_);
      require_bounded(model, model_);
    }
    if (!driver_.empty()) {
      require_limit_scale(limit_scale_);
      refuse_if(limit_scale_ < kFirstLimitScale,
                "--limit-scale {}: expected at least {}, with which pages begin", limit_scale_,
                kFirstLimitScale);
      settings_.driver = wire_.settings(driver_, arm, arm_file);
      settings_.driver->limit_scale = limit_scale_;
      settings_.driver->say = tell_of_arm(true);
    }
    Studio studio(settings_);
    CommonFlags spoken = flags;
    spoken.quiet = false;  // nobody guesses it
    print_result(spoken, {{"address", studio.address()}}, studio.address());
    std::fflush(stdout);  // whoever reads it through a pipe waits for it
    say(flags, "open this address in a browser; Ctrl-C ends the studio");
    {
      // Again and again: a server that does not listen yet is not stopped.
      const std::jthread watch([&studio](const std::stop_token& has_ended) {
        while (!has_ended.stop_requested()) {
          std::this_thread::sleep_for(kSignalPoll);
          if (interrupt_requested()) {
            studio.stop();
          }
        }
      });
      studio.serve();
    }
    return kExitDone;
  }

 private:
  StudioSettings settings_;
  std::string driver_;
  WireFlags wire_;
  double limit_scale_ = 1.0;
  std::string arm_ = "three_segment";
  std::string model_;
};

}  // namespace

std::unique_ptr<Verb> make_studio_verb() {
  return std::make_unique<StudioVerb>();
}

}  // namespace limber
