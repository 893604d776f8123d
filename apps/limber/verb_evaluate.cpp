#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>

#include "episode_choice.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/report/evaluation_plots.hpp"
#include "limber/report/training_report.hpp"
#include "limber/training/ensemble_evaluation.hpp"
#include "limber/training/evaluation.hpp"
#include "limber/training/unseen_error.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

class EvaluateVerb final : public Verb {
 public:
  EvaluateVerb()
      : Verb("evaluate", "Errors of the no-load and the network model on a recording",
             "limber collect --schedule random --count 100 --seed 7 --out test.h5\n"
             "  limber evaluate --model model.safetensors --data test.h5 --plots plots") {}

  void add_flags(CLI::App& app) override {
    add_arm_flag(app, arm_);
    CLI::Option* model =
        app.add_option("--model", model_, "Network model; without it, the no-load model alone");
    app.add_option("--data", data_, "Recording that the model was not trained on")->required();
    app.add_option("--out", out_,
                   "Write the model here, with its error on this recording: plans then keep "
                   "this distance from obstacles")
        ->needs(model);
    app.add_flag("--keep-broken", keep_broken_,
                 "Count also episodes in which the arm does not do what it does in the others");
    app.add_option("--plots", plots_,
                   "Folder for error_over_time.svg and other pictures; of an arm in space "
                   "shapes.html, too, in which it can be turned");
    app.add_option("--fit", fit_,
                   "Recordings to fit the yardsticks to, best those that the model learnt from; "
                   "without them, to --data itself, part by part, what is predicted left out")
        ->allow_extra_args(false);
    app.add_option("--predictions", predictions_,
                   "Folder for tables of what was recorded and predicted, frame by frame: "
                   "one_step.csv, window_32.csv, per_motion.csv, open_loop.csv");
  }

  int run(const CommonFlags& flags) override {
    const ArmDescription arm = load_any_arm(arm_);
    require_free_paths(flags, arm.dimension);
    const ForwardModel no_load(arm);
    std::optional<ForwardModel> network;
    if (!model_.empty()) {
      network.emplace(arm, read_model_of_one_arm(model_, arm));
    }
    const std::string data_hash = file_hash(data_);  // names why it can't be read
    const Recording recording = asked_with(read_recording_of(arm, data_), network, data_);
    tell_if_trained_on(flags, network, data_hash);
    const ForwardModel* compared = network ? &*network : nullptr;
    NamedEpisodes counted;
    counted.add(data_, recording.episodes);
    const std::vector<std::string> broken = leave_out(flags, arm, counted);
    const Evaluation evaluation = compare(no_load, compared, counted.episodes, flags.jobs);
    YardstickReport yardsticks = measure(flags, arm, no_load, compared, counted.episodes,
                                         episodes_to_fit(arm, network, recording.setpoints_only()));
    if (counted.episodes.size() < recording.episodes.size()) {
      yardsticks.episode_names = counted.names;  // by their numbers in the file
    }
    write_pictures(flags, arm, no_load, compared, counted.episodes, yardsticks);
    write_tables(flags, no_load, compared, recording);
    Json json = to_json(evaluation);
    json["commands_are"] = commands_are(recording.setpoints_only());
    json["broken_episodes"] = broken;
    json.update(to_json(yardsticks, counted.episodes), true);
    std::string text = to_text(evaluation) + to_text(yardsticks);
    if (recording.setpoints_only()) {
      text += "all models were asked with set points\n";
    }
    if (network) {
      add_ensemble(*network, arm, counted.episodes, flags.jobs, json, text);
      add_unseen_error(*network, arm, counted.episodes, flags.jobs, json, text);
    }
    json["warnings"] = flags.warnings;
    print_result(flags, json, text);
    return kExitDone;
  }

 private:
  /// @throws InputError where a file is in the way.
  void require_free_paths(const CommonFlags& flags, Dimension dimension) const {
    if (!plots_.empty()) {
      for (const auto& path : evaluation_plot_paths(plots_, dimension)) {
        refuse_to_overwrite(path, flags.force);
      }
      refuse_to_overwrite(horizon_plot_path(), flags.force);
    }
    if (!predictions_.empty()) {
      for (const auto& path : prediction_paths(predictions_)) {
        refuse_to_overwrite(path, flags.force);
      }
    }
    refuse_to_overwrite_given({out_}, flags);
  }

  /// Errors on what a model was trained on are shown with a warning, and never stored.
  void tell_if_trained_on(const CommonFlags& flags, const std::optional<ForwardModel>& network,
                          const std::string& data_hash) const {
    if (!network || !learnt_from(network->compensation(), data_hash)) {
      return;
    }
    const std::string fault =
        fmt::format("the model was trained on {}; its errors there say nothing", data_);
    refuse_if(!out_.empty(), "--out: {}", fault);
    warn(flags, "{}", fault);
  }

  /// Takes out what `train` leaves out of --unseen, and says so. @return what is broken
  std::vector<std::string> leave_out(const CommonFlags& flags, const ArmDescription& arm,
                                     NamedEpisodes& episodes) const {
    leave_out_twins(flags, episodes);
    std::vector<std::string> broken;
    if (!keep_broken_) {
      broken = leave_out_broken(arm, {&episodes});
    }
    for (const std::string& one : broken) {
      warn(flags, "left out as broken: {}; --keep-broken counts it too", one);
    }
    return broken;
  }

  /// What takes longest.
  static YardstickReport measure(const CommonFlags& flags, const ArmDescription& arm,
                                 const ForwardModel& no_load, const ForwardModel* network,
                                 const std::vector<Episode>& episodes,
                                 const std::vector<Episode>& fit_to) {
    Progress progress("evaluating", "%", 100, flags.progress());
    return measure_yardsticks(
        arm, no_load, network, episodes, fit_to, flags.jobs,
        [&](double share) { progress.update(std::uint64_t(std::lround(100.0 * share))); });
  }

  /// --plots.
  void write_pictures(const CommonFlags& flags, const ArmDescription& arm,
                      const ForwardModel& no_load, const ForwardModel* network,
                      const std::vector<Episode>& episodes,
                      const YardstickReport& yardsticks) const {
    if (!plots_.empty()) {
      const EvaluationPlots plots = plot_evaluation(arm, no_load, network, episodes, flags.jobs);
      for (const auto& path : write_evaluation_plots(plots_, plots)) {
        say(flags, "wrote {}", path.string());
      }
      write_file_atomically(horizon_plot_path(), error_over_horizon_svg(yardsticks));
      say(flags, "wrote {}", horizon_plot_path().string());
    }
  }

  /// --predictions: of all episodes, so that their numbers are the file's.
  void write_tables(const CommonFlags& flags, const ForwardModel& no_load,
                    const ForwardModel* network, const Recording& recording) const {
    if (!predictions_.empty()) {
      for (const auto& path :
           write_predictions(predictions_, no_load, network, recording.episodes, flags.jobs)) {
        say(flags, "wrote {}", path.string());
      }
    }
  }

  /// Errors of an ensemble's networks and of their mean; nothing of a single network.
  void add_ensemble(const ForwardModel& network, const ArmDescription& arm,
                    const std::vector<Episode>& episodes, int jobs, Json& json,
                    std::string& text) const {
    if (network.compensation().member_count() <= 1) {
      return;
    }
    const EnsembleForward ensemble(arm, network.compensation());
    const EnsembleEvaluation errors = evaluate_ensemble(ensemble, episodes, jobs);
    json["ensemble"] = to_json(errors);
    text += "network: the member that validated best, as used for planning\n" + to_text(errors);
  }

  /// The model's error on this recording, which is stored with --out.
  void add_unseen_error(const ForwardModel& network, const ArmDescription& arm,
                        const std::vector<Episode>& episodes, int jobs, Json& json,
                        std::string& text) const {
    CompensationModel model = network.compensation();
    note_unseen(arm, model, episodes, jobs);
    const std::optional<PredictionError>& error = model.prediction_error;
    json["prediction_error"] = nullptr;
    if (error) {
      json["prediction_error"] = to_json(*error);
      text += to_text(*error) + "\n";
    }
    refuse_if(!out_.empty() && !error,
              "--out: in {} nothing moves that the error could be measured on", data_);
    if (!out_.empty()) {
      write_model(out_, model);
    }
  }

  fs::path horizon_plot_path() const { return fs::path(plots_) / "error_over_horizon.svg"; }

  Recording asked_with(Recording recording, const std::optional<ForwardModel>& network,
                       const std::string& path) const {
    return network ? as_learnt_from(network->compensation(), model_, std::move(recording), path)
                   : std::move(recording);
  }

  /// Of the kind of what is predicted.
  std::vector<Episode> episodes_to_fit(const ArmDescription& arm,
                                       const std::optional<ForwardModel>& network,
                                       bool setpoints_only) const {
    std::vector<Episode> episodes;
    for (const std::string& path : fit_) {
      Recording recording = asked_with(read_recording_of(arm, path), network, path);
      if (setpoints_only && !recording.setpoints_only()) {
        recording.episodes = with_setpoints_only(std::move(recording.episodes));
      } else if (recording.setpoints_only() != setpoints_only) {
        throw InputError(
            fmt::format("--fit {}: holds set points only, --data {} "
                        "what was measured; give recordings of one kind",
                        path, data_));
      }
      std::ranges::move(recording.episodes, std::back_inserter(episodes));
    }
    return episodes;
  }

  /// @throws InputError that names both files if the prediction diverges to infinity.
  Evaluation compare(const ForwardModel& no_load, const ForwardModel* network,
                     const std::vector<Episode>& episodes, int jobs) const {
    try {
      return evaluate(no_load, network, episodes, jobs);
    } catch (const InputError& error) {
      throw InputError(
          fmt::format("{}{}{}: {}", data_, model_.empty() ? "" : " with ", model_, error.what()));
    }
  }

  std::string arm_ = "three_segment";
  std::string model_;
  std::string data_;
  std::string out_;
  std::string plots_;
  std::vector<std::string> fit_;
  std::string predictions_;
  bool keep_broken_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_evaluate_verb() {
  return std::make_unique<EvaluateVerb>();
}

}  // namespace limber
