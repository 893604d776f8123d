#include "limber/lab/improve.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "demo/demo_recipe.hpp"
#include "improve_settings.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/version.hpp"
#include "limber/lab/output_folder.hpp"
#include "limber/network/arm_family.hpp"
#include "plan_runs.hpp"
#include "round_figures.hpp"
#include "round_training.hpp"
#include "run_roles.hpp"

namespace limber {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* kImproveFile = "improve.json";
constexpr double kMotionHoldS = 3.0;          // of a random motion, as `collect` has it
constexpr int kRandomMotionsPerEpisode = 10;  // so that some episodes can be held back
constexpr double kSecondsPerMinute = 60.0;

// Parts of a run that sample by chance: each in environments of its own (derived_seed). Those of a
// round follow at multiples of kSeedsPerRound.
enum ImproveSeed : std::uint64_t { kSelection = 256, kExploration, kPlans, kReported, kRandom };
constexpr std::uint64_t kSeedsPerRound = 16;

std::string in_round(int round, const char* name) {
  return fmt::format("round_{}/{}", round, name);
}

struct RoundModel {
  CompensationModel compensation;
  std::string hash;  ///< of its file

  MotionModel motion_model(const ImproveSettings& settings, const ForwardModel& forward) const {
    return {forward, ValveModel(settings.arm, compensation.valves.value_or(ValveParameters{}))};
  }
};

RoundModel read_round_model(const fs::path& file) {
  return {read_model_of_one_arm(file), content_hash(read_file(file))};
}

class Improvement {
 public:
  Improvement(const ImproveSettings& settings, const ImproveArm& on)
      : settings_(settings),
        on_(on),
        start_(read_round_model(settings.model_file)),
        sampling_forward_(settings.arm, start_.compensation),
        sampling_(start_.motion_model(settings, sampling_forward_)) {
    require_model_of(start_.compensation, settings.arm, settings.model_file.string());
    if (!settings.prior_file.empty()) {
      prior_ = read_round_model(settings.prior_file);
      require_model_of(prior_->compensation, settings.arm, settings.prior_file.string());
    }
  }

  Json run() {
    read_old_data();
    open_folder();
    RoundModel model = start_;
    rounds_.push_back(judge(0, model));
    while (static_cast<int>(rounds_.size()) <= settings_.rounds && !is_settled()) {
      const int round = static_cast<int>(rounds_.size());
      collect_round(round, model);
      model = learn(round, model);
      rounds_.push_back(judge(round, model));
    }
    return write_results();
  }

 private:
  fs::path file(const std::string& name) const { return output_->path() / name; }

  std::uint64_t seed_of(ImproveSeed part, int round) const {
    return derived_seed(settings_.seed, part + kSeedsPerRound * std::uint64_t(round));
  }

  RoundChoice choice() const {
    std::vector<EndDistances> distances;
    for (const RoundFigures& round : rounds_) {
      distances.push_back(round.selection_m);
    }
    return choose_round(distances);
  }

  bool is_settled() const { return choice().rounds_without_gain >= kMaxRoundsWithoutGain; }

  void read_old_data() {
    const auto known = start_.compensation.training.find("data");
    for (const fs::path& path : settings_.data_files) {
      Recording recording = read_recording(path);
      require_recording_of(recording, settings_.arm, path.string());
      std::ranges::move(recording.episodes, std::back_inserter(data_.data.replay));
      if (known != start_.compensation.training.end() &&
          known->second.find(content_hash(read_file(path))) == std::string::npos) {
        settings_.say(fmt::format(
            "warning: {}: {} was not trained on it, but on {}; what it has learnt and is not "
            "replayed may be forgotten",
            path.string(), settings_.model_file.string(), known->second));
      }
    }
  }

  void open_folder() {
    const Json wanted = to_json(settings_, on_);
    const bool resumes = settings_.resume && fs::exists(settings_.folder / kImproveFile);
    if (resumes) {
      require_same_run(settings_.folder / kImproveFile, wanted);
    }
    std::vector<fs::path> inputs = settings_.data_files;
    inputs.push_back(settings_.model_file);
    if (!settings_.prior_file.empty()) {
      inputs.push_back(settings_.prior_file);
    }
    output_.emplace(settings_.folder, "improve",
                    resumes           ? OutputFolder::Start::resumed
                    : settings_.force ? OutputFolder::Start::forced
                                      : OutputFolder::Start::fresh,
                    inputs);
    if (!output_->left().empty()) {
      settings_.say(output_->about_left());
    }
    output_->require_free({"model.safetensors", "summary.json", "report.html", "distance.svg"});
    if (resumes) {
      output_->write_with({kImproveFile}, [] {});  // listed, wherever a kill came
    } else {
      Json written = wanted;
      written["program_version"] = version();
      output_->write(kImproveFile, written.dump(1) + "\n");
    }
  }

  /// Random motions as `collect` makes them; read where they are recorded already.
  Recording record_motions(const std::string& name, int motions, int per_episode,
                           std::uint64_t seed) {
    CollectionSettings collection;
    collection.schedule.kind = ScheduleKind::random;
    collection.schedule.hold_s = kMotionHoldS;
    collection.schedule.limit_scale = on_.limit_scale;
    collection.schedule.episodes = std::max(1, motions / per_episode);
    collection.schedule.count = std::max(1, motions / collection.schedule.episodes);
    collection.source = on_.source;
    collection.driver = on_.about;
    collection.seed = seed;
    collection.jobs = on_.side_by_side ? settings_.jobs : 1;
    collection.resume = true;
    collection.progress = settings_.progress;
    if (!on_.side_by_side) {
      collection.partial = file(fs::path(name).replace_extension(".unfinished.h5").string());
    }
    Recording recording;
    output_->write_with({name}, [&] {
      recording = collect(settings_.arm, collection, on_.drivers, file(name)).recording;
    });
    return recording;
  }

  PlanRuns run_plans_of(int round, const char* name, const PlanRunsSettings& asked,
                        const RoundModel& model) {
    const ForwardModel forward(settings_.arm, model.compensation);
    const MotionModel planning = model.motion_model(settings_, forward);
    PlanRunsSettings named = asked;
    named.name = in_round(round, name);
    named.what = fmt::format("round {}: {}", round, name);
    output_->require_free({named.name + ".json", named.name + ".h5"});
    return run_plans(settings_, on_, *output_, {sampling_, planning, model.hash}, named);
  }

  void collect_round(int round, const RoundModel& model) {
    const double round_s = settings_.round_min * kSecondsPerMinute;
    settings_.say(fmt::format("round {} of at most {}: {:.3g} min of arm time to learn from", round,
                              settings_.rounds, settings_.round_min));
    double plans_s = 0.0;
    if (settings_.plan_share > 0.0) {
      PlanRunsSettings asked;
      asked.seed = seed_of(kPlans, round);
      asked.arm_time_s = settings_.plan_share * round_s;
      asked.chain = settings_.chain;
      const PlanRuns plans = run_plans_of(round, "plans", asked, model);
      data_.add_plans(plans.episodes, settings_.arm.frame_period_s());
      plans_s = plans.arm_time_s;
      learning_ventings_ += plans.ventings();
      add_source(in_round(round, "plans.h5"));
    }
    // Plans that took longer than their share leave less for the rest.
    const int motions = static_cast<int>(std::lround((round_s - plans_s) / kMotionHoldS));
    double exploration_s = 0.0;
    if (motions > 0 && settings_.plan_share < 1.0) {
      const Recording exploration =
          record_motions(in_round(round, "exploration.h5"), motions, kRandomMotionsPerEpisode,
                         seed_of(kExploration, round));
      data_.add_exploration(exploration.episodes);
      exploration_s = exploration.duration_s();
      learning_ventings_ += static_cast<int>(exploration.episodes.size());
      add_source(in_round(round, "exploration.h5"));
    }
    learning_s_ += plans_s + exploration_s;
  }

  void add_source(const std::string& name) {
    if (fs::exists(file(name))) {
      sources_ += fmt::format("{}{} {}", sources_.empty() ? "" : ", ", name,
                              content_hash(read_file(file(name))));
    }
  }

  RoundModel learn(int round, const RoundModel& before) {
    const std::string name = in_round(round, "model.safetensors");
    output_->require_free({name});
    output_->write_with({name}, [&] {
      if (!fs::exists(file(name))) {
        settings_.say(
            fmt::format("round {}: training on {} runs", round, data_.data.training.size()));
        const RoundModel& from = prior_ ? *prior_ : before;
        write_model(file(name), learn_round(settings_, before.compensation, from.compensation,
                                            from.hash, data_.data, sources_));
      }
    });
    sources_.clear();  // the model names them now
    return read_round_model(file(name));
  }

  RoundFigures judge(int round, const RoundModel& model) {
    PlanRunsSettings asked;
    asked.environments = settings_.selection;
    asked.seed = seed_of(kSelection, 0);  // the same in all rounds, so that they pair up
    const PlanRuns selection = run_plans_of(round, "selection", asked, model);
    asked.environments = settings_.reported;
    asked.seed = seed_of(kReported, round);
    const PlanRuns reported = run_plans_of(round, "reported", asked, model);
    const Recording motions = record_motions(in_round(round, "random.h5"), settings_.reported,
                                             settings_.reported, seed_of(kRandom, round));
    // From now on they are runs that no model has learnt from, and that chose nothing.
    data_.hold_back(reported.episodes, motions.episodes, settings_.arm.frame_period_s());
    judging_s_ += selection.arm_time_s + reported.arm_time_s + motions.duration_s();

    const ForwardModel forward(settings_.arm, model.compensation);
    const MotionModel motion_model = model.motion_model(settings_, forward);
    RoundFigures figures;
    figures.round = round;
    figures.model_hash = model.hash;
    figures.prediction_error = model.compensation.prediction_error;
    figures.learning_min = learning_s_ / kSecondsPerMinute;
    figures.learning_ventings = learning_ventings_;
    figures.judging_min = judging_s_ / kSecondsPerMinute;
    figures.selection = figures_of(selection.runs);
    figures.selection_m = end_distances(selection.runs);
    figures.reported = figures_of(reported.runs);
    figures.on_plans = error_on_plans(motion_model, reported.episodes);
    figures.on_motions = error_on_motions(motion_model, motions.episodes);
    output_->write(in_round(round, "round.json"), to_json(figures).dump(1) + "\n");
    settings_.say(to_text(figures));
    return figures;
  }

  Json write_results() {
    const RoundChoice chosen = choice();
    const fs::path best =
        chosen.best == 0 ? settings_.model_file : file(in_round(chosen.best, "model.safetensors"));
    output_->write("model.safetensors", read_file(best));
    output_->write("distance.svg", improve_curve(rounds_, chosen));
    output_->write("report.html", improve_report(settings_, rounds_, chosen));
    const Json summary = improve_summary(settings_, rounds_, chosen);
    output_->write("summary.json", summary.dump(1) + "\n");
    return summary;
  }

  const ImproveSettings& settings_;
  const ImproveArm& on_;
  RoundModel start_;
  ForwardModel
      sampling_forward_;  // environments are those of the model to start from, in all rounds
  MotionModel sampling_;
  std::optional<RoundModel> prior_;
  std::optional<OutputFolder> output_;
  RoundData data_;
  std::string sources_;  // learnt from since the last model
  double learning_s_ = 0.0;
  int learning_ventings_ = 0;
  double judging_s_ = 0.0;
  std::vector<RoundFigures> rounds_;
};

}  // namespace

void require_startable(const ImproveSettings& settings) {
  require_usable(settings);
  const fs::path there = settings.folder / kImproveFile;
  if (fs::exists(there) && !settings.resume && !settings.force) {
    throw InputError(fmt::format(
        "{}: a run of limber improve; --resume goes on with it, --force starts over (what its arm "
        "did is then removed), or choose another --out",
        settings.folder.string()));
  }
}

nlohmann::ordered_json run_improve(const ImproveSettings& settings, const ImproveArm& on) {
  require_startable(settings);
  try {
    return Improvement(settings, on).run();
  } catch (const Interrupted& stop) {
    if (std::string_view(stop.what()).find("--resume") != std::string_view::npos) {
      throw;
    }
    throw Interrupted(
        fmt::format("stopped on request; what was finished is in {}: "
                    "the same command with --resume goes on from there",
                    settings.folder.string()));
  }
}

}  // namespace limber
