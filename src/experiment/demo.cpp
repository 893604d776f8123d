#include "limber/experiment/demo.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "demo_stages.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/experiment/output_folder.hpp"

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
    {"bench", "forward-model queries a second", bench_stage},
    {"plan", "motions through obstacles with both models", plan_stage},
    {"execute", "the plans on the virtual arm", execute_stage},
};

}  // namespace

nlohmann::ordered_json run_demo(const DemoSettings& settings) {
  prepare_output_folder(settings.folder, settings.force);
  DemoResults results;
  results.settings = &settings;
  results.recipe = settings.quick ? quick_recipe(settings.arm) : full_recipe(settings.arm);
  int number = 0;
  for (const Stage& stage : kStages) {
    throw_if_interrupted();
    settings.say(
        fmt::format("[{}/{}] {}: {}", ++number, std::size(kStages) + 1, stage.name, stage.what));
    results.clock.start(stage.name);
    stage.run(results);
  }
  settings.say(fmt::format("[{0}/{0}] report", number + 1));
  results.clock.start("report");
  write_file_atomically(results.file("report.html"), demo_report(results));
  results.clock.stop();
  const nlohmann::ordered_json summary = demo_summary(results);
  write_file_atomically(results.file("summary.json"), summary.dump(2) + "\n");
  return summary;
}

}  // namespace limber
