#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>

#include <fmt/ranges.h>

#include "data_flags.hpp"
#include "episode_choice.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/recording_inspection.hpp"
#include "limber/lab/family_traits.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/report/training_report.hpp"
#include "limber/training/fine_tuning.hpp"
#include "limber/training/learnt_region_fit.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/unseen_error.hpp"
#include "train_report.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

class TrainVerb final : public Verb {
 public:
  TrainVerb()
      : Verb("train", "Train a compensation network on recordings",
             "limber collect --schedule random --count 60 --episodes 10 --out train.h5\n"
             "  limber train --data train.h5 --out model.safetensors") {}

  void add_flags(CLI::App& app) override {
    command_ = &app;
    add_arm_flag(app, arm_);
    files_.add_to(app);
    app.add_option("--preset", preset_, "paper: as published; best: the default")
        ->check(CLI::IsMember({"paper", "best"}))
        ->capture_default_str();
    auto* from = app.add_option("--from", from_, "Model to go on from (fine-tuning)");
    files_.add_old_data_to(app, from);
    app.add_option("--replay", replay_share_,
                   fmt::format("Share of each epoch's windows that come "
                               "from --old-data, 0 to 0.95; else {}",
                               TrainingSettings().replay_share))
        ->check(CLI::Range(0.0, 0.95))
        ->needs("--old-data");
    app.add_option("--epochs", epochs_,
                   "Epochs in all; 0 with --from only adds bounds to an old model")
        ->check(CLI::Range(0, kMaxEpochs));
    app.add_option("--time-limit-s", time_limit_s_,
                   "Fix the number of epochs, at the start, to what fits in this time")
        ->check(more_than_zero())
        ->excludes("--epochs");
    app.add_option("--windows", windows_,
                   "Frames per window of each stage, instead of the preset's 32")
        ->check(CLI::Range(1, 1000));
    app.add_option("--learning-rate", learning_rate_, "Learning rate, instead of the preset's")
        ->check(more_than_zero());
    app.add_option("--hidden", hidden_, "Units of each hidden layer, such as --hidden 100 100 100")
        ->check(CLI::Range(1, 4096));
    app.add_flag_function(
        "--velocity,!--no-velocity", [this](std::int64_t sign) { velocity_ = sign > 0; },
        "Whether the network reads how the arm moved in the frame before; else as the preset");
    app.add_option("--ensemble", ensemble_,
                   "Networks to train together; their spread says how certain they are")
        ->check(CLI::Range(1, 64));
    app.add_flag(
           "--family", family_,
           "One network for all arms that the recordings are of, which limber adapt makes one "
           "arm's: every recording is an arm, of collect --vary-physics every episode")
        ->excludes(from);
    app.add_option("--family-size", family_size_, "Numbers that say which arm of a family it is")
        ->check(CLI::Range(0, ArmFamily::kMaxSize))
        ->needs("--family")
        ->capture_default_str();
    app.add_option("--slice-frames", slice_frames_,
                   "Frames of a family in memory at a time, 3 kB each; of more, every epoch reads "
                   "one slice after the other")
        ->check(CLI::Range(1, 100'000'000))
        ->needs("--family")
        ->capture_default_str();
    app.add_option("--checkpoint-interval-s", checkpoint_interval_s_,
                   "Seconds between checkpoints: the most that a killed run loses, but for folds")
        ->check(at_least_zero())
        ->capture_default_str();
    app.add_flag("--resume", resume_,
                 "Go on from the checkpoint that a stopped run left beside --out");
    app.add_option("--out", out_, "Model to write; the learning curve is written beside it")
        ->capture_default_str();
  }

  int run(const CommonFlags& flags) override {
    if (epochs_ == 0) {
      return only_add_bounds(flags);
    }
    require_free_paths(flags);
    const ArmDescription arm = load_any_arm(arm_);
    if (preset_ == "paper") {
      require_planar(arm, "train --preset paper");
    }
    EpisodeReader reader(flags, arm, files_.setpoints());
    const std::optional<CompensationModel> start = read_start(arm, reader);
    TrainingSettings settings = make_settings(flags, start.has_value());
    IdentifiedValves valves;
    // First: --validation and --unseen are compared with all that is learnt from.
    const EpisodeChoice old = files_.load_old(flags, arm, reader);
    EpisodeChoice choice =
        family_
            ? files_.load_arms(flags, arm, reader, slice_frames_, valves)
            : files_.load(flags, arm, reader, takes_usual() && ensemble_.value_or(1) == 1, valves);
    if (choice.is_little) {
      return train_on_little(flags, arm, choice, reader.sources(), valves);
    }
    TrainingData& data = choice.data;
    data.replay = old.data.training;
    std::ranges::copy(old.broken, std::back_inserter(choice.broken));
    say_episodes(flags, choice);
    say_training(flags, data, settings);
    keep_known_valves(flags, arm, start, valves);
    TrainingResult result =
        start ? fine_tune(arm, data, settings, *start) : train(arm, data, settings);
    if (!has_network(flags, result)) {
      return kExitNoSolution;
    }
    result.model.set_valves(valves);
    if (!arm.is_spatial()) {
      result.model.learnt =
          learnt_region_of(data, start && start->learnt ? &*start->learnt : nullptr);
    }
    if (result.model.family) {  // --family-size 0 tells no arms apart
      result.model.family->traits = fit_traits(arm, data.physics, *result.model.family);
    }
    record_origin(result.model, reader.all_sources(), settings, choice);
    note_unseen(arm, result.model, data.unseen, flags.jobs);
    write(result);
    std::optional<FineTuningReport> changes;
    if (start && result.status != TrainingStatus::interrupted) {
      changes = compare_models(arm, *start, result.model, data.validation, old.data.validation,
                               flags.jobs);
    }
    return finish(flags, arm, result, changes, choice, std::nullopt);
  }

 private:
  /// Whether there is one to write; says why where there is none.
  bool has_network(const CommonFlags& flags, const TrainingResult& result) const {
    if (result.status == TrainingStatus::diverged) {
      print_error(result.message);
      remove_checkpoint();  // --resume would only end here again
    }
    if (result.best_epoch == 0) {
      print_no_model(flags, result);
    }
    return result.best_epoch > 0;
  }

  int finish(const CommonFlags& flags, const ArmDescription& arm, const TrainingResult& result,
             const std::optional<FineTuningReport>& changes, const EpisodeChoice& choice,
             const std::optional<CrossValidation>& folds) const {
    if (result.status == TrainingStatus::finished) {
      remove_checkpoint();
    }
    print_training_result(flags, arm, {out_, curve_path(".curve.csv")}, result, changes, choice,
                          folds);
    if (result.status == TrainingStatus::interrupted) {
      say(flags, "the best model so far is in {}; the same command with --resume goes on", out_);
    }
    return result.status == TrainingStatus::finished ? kExitDone : kExitNoSolution;
  }

  /// --epochs 0.
  int only_add_bounds(const CommonFlags& flags) const {
    refuse_if(
        files_.names_unseen(),
        "--epochs 0 only adds bounds, and does not use --unseen: limber evaluate --model MODEL "
        "--data UNSEEN --out OTHER measures a model's error again");
    for (const char* flag : {"--validation", "--keep-broken", "--setpoints", "--preset", "--replay",
                             "--windows", "--learning-rate", "--hidden", "--velocity", "--ensemble",
                             "--checkpoint-interval-s", "--resume"}) {
      if (!from_.empty() && command_->count(flag) > 0) {  // else --from is what is missing
        throw InputError(
            fmt::format("--epochs 0 only adds bounds, and does not use {}; leave it out", flag));
      }
    }
    return add_bounds_to_model({arm_, from_, files_.data(), files_.old_data(), out_}, flags);
  }

  /// @throws InputError where a file is in the way, or --resume has nothing to go on with.
  void require_free_paths(const CommonFlags& flags) const {
    for (const fs::path& path :
         {fs::path(out_), curve_path(".curve.csv"), curve_path(".curve.svg"), checkpoint_path()}) {
      refuse_to_overwrite(path, flags.force || resume_ || path == checkpoint_path());
    }
    const bool was_stopped = fs::exists(checkpoint_path()) ||
                             (takes_usual() && fs::exists(folds_path_of(checkpoint_path())));
    if (resume_ && !was_stopped) {
      throw InputError(fmt::format("--resume: there is no checkpoint {}; leave --resume out",
                                   checkpoint_path().string()));
    }
    if (!resume_ && !flags.force && was_stopped) {
      throw InputError(fmt::format(
          "{}: of a run that was stopped; --resume goes on with it, --force starts over",
          (fs::exists(checkpoint_path()) ? checkpoint_path() : folds_path_of(checkpoint_path()))
              .string()));
    }
  }

  /// The model of --from; none without that flag.
  std::optional<CompensationModel> read_start(const ArmDescription& arm,
                                              EpisodeReader& reader) const {
    if (from_.empty()) {
      return std::nullopt;
    }
    CompensationModel start = read_model(from_);
    require_model_of(start, arm, from_);
    require_one_arm(start, from_);
    require_no_contradiction(start);
    reader.note_kind(from_, start.learnt_from_setpoints);
    if (const auto found = start.training.find("data"); found != start.training.end()) {
      reader.note_learnt_before(found->second);
    }
    return start;
  }

  /// Nothing says how to train: of little data, folds may choose.
  bool takes_usual() const {
    return preset_ == "best" && from_.empty() && windows_.empty() && !epochs_ && !time_limit_s_ &&
           !learning_rate_;
  }

  int train_on_little(const CommonFlags& flags, const ArmDescription& arm,
                      const EpisodeChoice& choice, const std::string& sources,
                      IdentifiedValves valves) {
    const std::vector<Episode>& episodes = choice.data.training;
    TrainingSettings settings = with_flags(flags, preset_for_little());
    say_broken(flags, choice);
    say_little(flags, arm, episodes);
    keep_known_valves(flags, arm, std::nullopt, valves);
    CrossValidation found = choose_by_folds(flags, arm, episodes, settings, valves);
    settings.resume = resume_ && fs::exists(checkpoint_path());
    TrainingResult result = train_as_found(flags, arm, episodes, settings, valves, found);
    if (!has_network(flags, result)) {
      return kExitNoSolution;
    }
    record_origin(result.model, sources, settings, choice);
    if (!choice.data.unseen.empty()) {
      note_unseen(arm, result.model, choice.data.unseen, flags.jobs);
    }
    result.model.training["cross_validation"] = to_text(found);
    if (!found.widest_where.empty()) {
      result.model.training["widest_where"] = found.widest_where;
      say(flags, "{}", found.widest_where);
    }
    write(result);
    return finish(flags, arm, result, std::nullopt, choice, found);
  }

  /// A model keeps its shape; flags that ask for another shape are a mistake.
  void require_no_contradiction(const CompensationModel& start) const {
    std::vector<int> units;
    for (std::size_t layer = 0; layer + 1 < start.layers.size(); ++layer) {
      units.push_back(int(start.layers[layer].bias.size()));
    }
    if (!hidden_.empty() && hidden_ != units) {
      throw InputError(
          fmt::format("--hidden {}: {} has hidden layers of {} units, which it keeps; "
                      "leave --hidden out, or --from",
                      fmt::join(hidden_, " "), from_, fmt::join(units, " ")));
    }
    if (velocity_ && *velocity_ != start.reads_velocity) {
      throw InputError(fmt::format(
          "--{}velocity: {} {} velocities, and keeps to that; leave --{}velocity out, or --from",
          *velocity_ ? "" : "no-", from_, start.reads_velocity ? "reads" : "does not read",
          *velocity_ ? "" : "no-"));
    }
    if (ensemble_ && *ensemble_ != start.member_count()) {
      throw InputError(
          fmt::format("--ensemble {}: {} holds {} networks, which are all tuned; leave "
                      "--ensemble out, or --from",
                      *ensemble_, from_, start.member_count()));
    }
  }

  TrainingSettings make_settings(const CommonFlags& flags, bool tuning) const {
    TrainingSettings settings = training_preset(preset_);
    if (tuning) {
      settings = fine_tuning_of(std::move(settings));
    }
    if (family_) {
      set_family_size(settings, family_size_);
    }
    if (!windows_.empty()) {
      set_window_frames(settings, windows_);
    }
    if (epochs_) {
      set_epoch_count(settings, *epochs_);
    }
    return with_flags(flags, std::move(settings));
  }

  TrainingSettings with_flags(const CommonFlags& flags, TrainingSettings settings) const {
    settings.time_limit_s = time_limit_s_.value_or(0.0);
    settings.learning_rate = learning_rate_.value_or(settings.learning_rate);
    if (!hidden_.empty()) {
      settings.hidden_units = hidden_;
    }
    settings.reads_velocity = velocity_.value_or(settings.reads_velocity);
    settings.ensemble = ensemble_.value_or(settings.ensemble);
    settings.replay_share = replay_share_.value_or(settings.replay_share);
    settings.checkpoint = checkpoint_path();
    settings.checkpoint_interval_s = checkpoint_interval_s_;
    settings.resume = resume_;
    take_common(flags, settings);
    return settings;
  }

  /// What the model's file says of its training, beside what the training itself wrote.
  void record_origin(CompensationModel& model, const std::string& sources,
                     const TrainingSettings& settings, const EpisodeChoice& choice) const {
    model.training["data"] = sources;
    const auto windows = mapped<int>(
        settings.stages, [&](const TrainingStage& stage) { return stage.window_frames; });
    model.training["windows"] = fmt::format("{}", fmt::join(windows, " "));
    model.training["validation"] = fmt::format("{}", fmt::join(choice.validation, "; "));
    if (!from_.empty()) {
      model.training["from"] = file_hash(from_);
    }
  }

  void remove_checkpoint() const {
    std::error_code ignored;  // a checkpoint that stays behind does no harm
    fs::remove(checkpoint_path(), ignored);
    fs::remove(folds_path_of(checkpoint_path()), ignored);
  }

  /// The valves that the new data show; if they show none, the model to go on from keeps its own.
  static void keep_known_valves(const CommonFlags& flags, const ArmDescription& arm,
                                const std::optional<CompensationModel>& start,
                                IdentifiedValves& valves) {
    if (valves.parameters.is_ideal() && start && start->valves) {
      say(flags, "{}; the model's own are kept", to_text(valves, arm.command.unit, arm.dimension));
      valves = start->identified_valves();
    }
    say(flags, "{}", to_text(valves, arm.command.unit, arm.dimension));
    for (const std::string& warning : valves.findings.warnings) {
      warn(flags, "{}", warning);
    }
  }

  fs::path checkpoint_path() const { return out_ + ".checkpoint"; }
  fs::path curve_path(const char* extension) const {
    return fs::path(out_).replace_extension(extension);
  }

  void write(const TrainingResult& result) const {
    write_model(out_, result.model);
    write_learning_curve_csv(curve_path(".curve.csv"), result.curve);
    write_file_atomically(curve_path(".curve.svg"), learning_curve_svg(result.curve));
  }

  static constexpr int kFamilySize = 8;

  const CLI::App* command_ = nullptr;
  std::string arm_ = "three_segment";
  DataFlags files_;
  std::string preset_ = "best";
  std::string from_;
  std::optional<double> replay_share_;
  std::optional<int> epochs_;
  std::optional<double> time_limit_s_;
  std::optional<double> learning_rate_;
  std::vector<int> windows_;
  std::vector<int> hidden_;
  std::optional<bool> velocity_;
  std::optional<int> ensemble_;
  bool family_ = false;
  int family_size_ = kFamilySize;
  int slice_frames_ = kSliceFrames;
  double checkpoint_interval_s_ = 20.0;
  bool resume_ = false;
  std::string out_ = "model.safetensors";
};

}  // namespace

std::unique_ptr<Verb> make_train_verb() {
  return std::make_unique<TrainVerb>();
}

}  // namespace limber
