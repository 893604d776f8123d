#include "limber/lab/demo.hpp"

#include <chrono>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "demo_stages.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/seconds_since.hpp"
#include "limber/lab/output_folder.hpp"

namespace limber {

namespace {

struct Stage {
  const char* name;
  const char* what;
  void (*run)(DemoResults&);
};

constexpr Stage kStages[] = {
    {"characterise", "bench test of each segment, strain polynomials", characterise_stage},
    {"collect", "the virtual arm moves and is recorded", collect_stage},
    {"train", "the network learns what the simple model misses", train_stage},
    {"evaluate", "both models against a recording never trained on", evaluate_stage},
    {"bench", "forward-model queries per second", bench_stage},
    {"plan", "motions through obstacles with both models", plan_stage},
    {"execute", "the plans on the virtual arm", execute_stage},
    {"arrive", "plans and executions over planning time", arrival_stage},
    {"adapt", "another arm in a minute: limber's family of arms", another_arm_stage},
};

// Written for every arm, so an existing file of this name is found before the work begins.
constexpr const char* kFiles[] = {"arm.yaml",
                                  "characterisation.svg",
                                  "train_part.h5",
                                  "train.h5",
                                  "validation.h5",
                                  "unseen.h5",
                                  "test.h5",
                                  "model.safetensors",
                                  "learning_curve.csv",
                                  "bench.json",
                                  "learning_curve.svg",
                                  "evaluation.json",
                                  "plots/inflate_deflate.svg",
                                  "plots/valves.svg",
                                  "report.html",
                                  "plots/bench.svg",
                                  "summary.json"};

}  // namespace

Json run_demo(const DemoSettings& settings) {
  OutputFolder output(settings.folder, "demo", OutputFolder::start(false, settings.force));
  if (!output.left().empty()) {
    settings.say(output.about_left());
  }
  output.require_free({std::begin(kFiles), std::end(kFiles)});
  DemoResults results;
  results.settings = &settings;
  results.output = &output;
  results.recipe = settings.quick ? quick_recipe(settings.arm) : full_recipe(settings.arm);
  const auto timed = [&](const char* stage, const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    results.times.push_back({stage, seconds_since(begin)});
  };
  int number = 0;
  for (const Stage& stage : kStages) {
    throw_if_interrupted();
    settings.say(
        fmt::format("[{}/{}] {}: {}", ++number, std::size(kStages) + 1, stage.name, stage.what));
    timed(stage.name, [&] { stage.run(results); });
  }
  settings.say(fmt::format("[{0}/{0}] report", number + 1));
  timed("report", [&] { output.write("report.html", demo_report(results)); });
  const Json summary = demo_summary(results);
  output.write("summary.json", summary.dump(2) + "\n");
  return summary;
}

}  // namespace limber
