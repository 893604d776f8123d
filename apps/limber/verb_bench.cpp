#include <optional>

#include "limber/arm/arm_description.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/experiment/speed_benchmark.hpp"
#include "limber/network/compensation_model.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

constexpr std::int64_t kQuickQueries = 50'000;

class BenchVerb final : public Verb {
 public:
  const char* name() const override { return "bench"; }
  const char* summary() const override {
    return "Forward model queries per second, beside peers and the machine's limit";
  }
  const char* example() const override {
    return "limber bench --arm three_segment --quick --plot speed.svg";
  }

  void add_flags(CLI::App& app) override {
    app.add_option("--arm", arm_, "Arm file, or the name of one of limber's own")
        ->capture_default_str();
    app.add_option("--model", model_, "Network to measure beside the paper's shape");
    auto* queries = app.add_option("--queries", queries_, "Queries of each measurement")
                        ->check(CLI::Range(std::int64_t{1'000}, std::int64_t{1'000'000'000}))
                        ->capture_default_str();
    app.add_flag("--quick", quick_, fmt::format("{} queries a measurement", kQuickQueries))
        ->excludes(queries);
    app.add_option("--plot", plot_, "Bar chart to write, SVG");
  }

  int run(const CommonFlags& flags) override {
    if (!plot_.empty()) {
      refuse_to_overwrite(plot_, flags.force);
    }
    const ArmDescription arm = load_arm(find_arm_file(arm_));
    std::optional<CompensationModel> model;
    if (!model_.empty()) {
      model = read_model(model_);
      require_model_of(*model, arm, model_);
    }
    SpeedSettings settings;
    settings.queries = quick_ ? kQuickQueries : queries_;
    settings.jobs = flags.jobs;
    settings.seed = flags.seed;
    settings.progress = flags.progress();
    const SpeedReport report = measure_speed(arm, model ? &*model : nullptr, settings);
    if (!plot_.empty()) {
      write_file_atomically(plot_, speed_chart(report).svg());
    }
    print_result(flags, to_json(report), to_text(report));
    return kExitDone;
  }

 private:
  std::string arm_ = "three_segment";
  std::string model_;
  std::int64_t queries_ = 1'000'000;
  bool quick_ = false;
  std::string plot_;
};

}  // namespace

std::unique_ptr<Verb> make_bench_verb() {
  return std::make_unique<BenchVerb>();
}

}  // namespace limber
