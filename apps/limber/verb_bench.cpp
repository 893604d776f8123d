#include <optional>

#include "episode_choice.hpp"
#include "limber/arm/arm_description.hpp"
#include "limber/common/json.hpp"
#include "limber/lab/speed_benchmark.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/report/speed_report.hpp"
#include "limber/report/training_report.hpp"
#include "limber/training/training_benchmark.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

constexpr std::int64_t kQuickQueries = 50'000;

class BenchVerb final : public Verb {
 public:
  BenchVerb()
      : Verb("bench",
             "Forward model queries per second, compared with peers and the machine's limit",
             "limber bench --arm three_segment --quick --plot speed.svg") {}

  void add_flags(CLI::App& app) override {
    add_arm_flag(app, arm_);
    auto* model =
        app.add_option("--model", model_, "Network to measure in addition to the paper's shape");
    auto* queries = app.add_option("--queries", queries_, "Queries per measurement")
                        ->check(CLI::Range(std::int64_t{1'000}, std::int64_t{1'000'000'000}))
                        ->capture_default_str();
    auto* quick =
        app.add_flag("--quick", quick_, fmt::format("{} queries per measurement", kQuickQueries))
            ->excludes(queries);
    auto* plot = app.add_option("--plot", plot_, "Bar chart to write, SVG");
    auto* training = app.add_option("--training", training_,
                                    "Recording: instead, time the epochs of training on it")
                         ->excludes(model, queries, quick, plot);
    app.add_option("--preset", preset_, "Training preset to time: paper or best; both by default")
        ->check(CLI::IsMember({"paper", "best"}))
        ->needs(training);
    app.add_option("--ensemble", ensemble_, "Networks trained together")
        ->check(CLI::Range(1, 64))
        ->needs(training);
    app.add_option("--epochs", epochs_, "Epochs to time per stage")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str()
        ->needs(training);
    app.add_option(
           "--tables", tables_,
           "File (safetensors) for the weights that the first epoch starts from, for a peer")
        ->needs(training, "--preset");
  }

  int run(const CommonFlags& flags) override {
    refuse_to_overwrite_given({plot_}, flags);
    const ArmDescription arm = load_any_arm(arm_);
    if (!training_.empty()) {
      return run_training(arm, flags);
    }
    const std::optional<CompensationModel> model =
        model_.empty() ? std::nullopt : std::optional(read_model_of_one_arm(model_, arm));
    SpeedSettings settings;
    settings.queries = quick_ ? kQuickQueries : queries_;
    take_common(flags, settings);
    const SpeedReport report = measure_speed(arm, model ? &*model : nullptr, settings);
    write_given(plot_, [&] { return speed_chart(report).svg(); });
    print_result(flags, to_json(report), to_text(report));
    return kExitDone;
  }

 private:
  int run_training(const ArmDescription& arm, const CommonFlags& flags) const {
    refuse_to_overwrite_given({tables_}, flags);
    const TrainingData data{read_recording_of(arm, training_).episodes, {}, {}};
    Json json = Json::array();
    std::string text;
    for (const char* name : {"paper", "best"}) {
      if (!preset_.empty() && preset_ != name) {
        continue;
      }
      TrainingSettings settings = training_preset(name);
      settings.jobs = flags.jobs;
      settings.seed = flags.seed;
      settings.ensemble = ensemble_;
      if (!tables_.empty()) {
        take_adam_for_soap(settings);  // which peers have
        write_training_tables(tables_, arm, data, settings);
      }
      const TrainingSpeed speed = measure_training_speed(arm, data, settings, epochs_);
      json.push_back(to_json(speed));
      text += to_text(speed);
    }
    print_result(flags, {{"training", json}}, text);
    return kExitDone;
  }

  std::string arm_ = "three_segment";
  std::string model_;
  std::int64_t queries_ = 1'000'000;
  bool quick_ = false;
  std::string plot_;
  std::string training_;
  std::string preset_;
  int ensemble_ = 1;
  int epochs_ = 9;
  std::string tables_;
};

}  // namespace

std::unique_ptr<Verb> make_bench_verb() {
  return std::make_unique<BenchVerb>();
}

}  // namespace limber
