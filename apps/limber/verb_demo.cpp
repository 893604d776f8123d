#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/json.hpp"
#include "limber/lab/demo.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

/// If no plan was found, or none executed, there is no distance.
std::string distance(const Json& plans) {
  const Json& mean_cm = plans.at("mean_distance_to_goal_cm");
  return mean_cm.is_null() ? "none executed" : fmt::format("{:.1f} cm", mean_cm.get<double>());
}

std::string to_text(const Json& summary, const std::string& folder) {
  const Json& evaluation = summary.at("evaluation");
  const Json& plans = summary.at("comparison");
  return fmt::format(
      "open-loop tip error: no load {:.2f} cm, network {:.2f} cm: {:.0f} % less\n"
      "executed plans end off by: no load {}, network {}\n"
      "report in {}/report.html, figures in {}/summary.json",
      evaluation.at("no_load").at("open_loop").at("position_error_cm").at("mean").get<double>(),
      evaluation.at("network").at("open_loop").at("position_error_cm").at("mean").get<double>(),
      evaluation.at("reduction_percent").at("position").get<double>(),
      distance(plans.at("no_load")), distance(plans.at("network")), folder, folder);
}

class DemoVerb final : public Verb {
 public:
  DemoVerb()
      : Verb("demo",
             "The whole chain on the virtual arm, from bench test to executed plans and a report",
             "limber demo --quick --out out") {}

  void add_flags(CLI::App& app) override {
    app.add_option("--out", out_,
                   "Folder for all results; a folder that limber demo made itself is replaced")
        ->capture_default_str();
    add_arm_flag(app, arm_);
    app.add_flag("--quick", quick_,
                 "Little data and a short training: under a minute, with worse figures");
  }

  int run(const CommonFlags& flags) override {
    DemoSettings settings;
    settings.folder = out_;
    settings.arm = load_asked_arm(arm_, "limber demo");
    settings.quick = quick_;
    take_common(flags, settings);
    require_writable_folder(out_);
    Json summary;
    try {
      summary = run_demo(settings);
    } catch (const Interrupted&) {
      // The stages may say how to resume them; the demo itself starts from the first one again.
      throw Interrupted("stopped on request; the next limber demo starts from the beginning");
    }
    print_result(flags, summary, to_text(summary, out_));
    return kExitDone;
  }

 private:
  std::string out_ = "out";
  std::string arm_ = "three_segment";
  bool quick_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_demo_verb() {
  return std::make_unique<DemoVerb>();
}

}  // namespace limber
