#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/ranges.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/folder_lock.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/lab/family_traits.hpp"
#include "limber/lab/tube_calibration.hpp"
#include "limber/sim/related_arms.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/unseen_error.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

/// Virtual arms that move in one way, and what share of all hours is theirs.
struct Share {
  const char* name;
  double share;
  Approach approach;
  int count;  // motions of each arm
  double hold_min_s;
  double hold_s;
  double arm_s;  // about what they last
};

constexpr double kSecondsPerHour = 3600.0;
constexpr Share kShares[] = {{"steps", 0.7, Approach::step, 30, 0.2, 2.0, 34.0},
                             {"straight", 0.3, Approach::straight, 18, 0.05, 1.0, 29.0}};

class FamilyVerb final : public Verb {
 public:
  FamilyVerb()
      : Verb("family", "Make a family for an arm file, from virtual arms: for limber adapt",
             "limber family --arm mine.yaml --out mine_family.safetensors\n"
             "  limber collect --arm mine.yaml --schedule identify --driver \"exec:./driver\" "
             "--out minute.h5\n"
             "  limber adapt --arm mine.yaml --model mine_family.safetensors --recording minute.h5 "
             "--out mine.safetensors") {}

  void add_flags(CLI::App& app) override {
    add_arm_flag(app, arm_);
    app.add_option("--out", out_, "Family to write")->required();
    app.add_option("--hours", hours_, "Of arms' motion to learn from; a new arm every half minute")
        ->check(CLI::Range(0.01, 1000.0))
        ->capture_default_str();
    app.add_option("--family-size", size_, "Numbers that say which of its arms it is")
        ->check(CLI::Range(1, ArmFamily::kMaxSize))
        ->capture_default_str();
    app.add_option("--hidden", hidden_,
                   "Units of each hidden layer; more tell more arms apart, and predict slower")
        ->check(CLI::Range(1, 4096))
        ->capture_default_str();
    app.add_option("--epochs", epochs_, "Epochs of training in all")
        ->check(CLI::Range(1, kMaxEpochs))
        ->capture_default_str();
    app.add_option("--vary-physics", variation_,
                   "How arms differ, as of limber collect: wide, or a factor")
        ->capture_default_str();
    app.add_option(
           "--noise-m", noise_m_,
           "Noise of the recorded positions, std deviation, as trackers have it; of the "
           "headings 10 rad/m times as much. Without any, real trackers mislead limber adapt")
        ->capture_default_str();
    app.add_option(
        "--tube-runs", tube_runs_,
        "Runs that test its tube, each on an arm of its own, else 400; 0: no tube, limber "
        "calibrate measures one later. In space there is none yet");
    app.add_flag("--resume", resume_, "Go on with a run that was stopped");
  }

  int run(const CommonFlags& flags) override {
    const bool goes_on = resume_ && fs::exists(folder());
    refuse_to_overwrite(out_, flags.force || goes_on);
    refuse_if(!resume_ && !flags.force && fs::exists(folder()),
              "{}: of a run that was stopped; --resume goes on with it, --force starts over",
              folder().string());
    const ArmDescription arm = load_any_arm(arm_);
    if (arm.is_spatial() && tube_runs_.value_or(0) != 0) {
      require_planar(arm, "limber family --tube-runs");
    }
    const int tube_runs = calibration().test_runs;
    if (const int needed = min_test_runs(calibration()); wants_tube(arm) && tube_runs < needed) {
      throw InputError(
          fmt::format("--tube-runs {}: so few can't show a level of {}; expected 0, or at least {}",
                      tube_runs, Tube::kDefaultLevel, needed));
    }
    const PhysicsVariation variation = parse_physics_variation(variation_);
    (void)VirtualArm(arm, noisy());  // refuses arm and noise before anything is left
    const FolderLock lock(folder(), "limber family");
    std::vector<Episode> episodes;
    std::vector<int> arms;
    std::string sources;
    for (const Share& share : kShares) {
      Recording recording = record(arm, variation, share, flags);
      add_arms_of(recording, arms);
      std::ranges::move(recording.episodes, std::back_inserter(episodes));
      add_source(sources, share.name, file_hash(recording_path(share)));
    }
    TrainingData data = hold_back_arms(std::move(episodes), arms, kHeldBackShare, flags.seed);
    add_mirrored_arms(arm, data);
    TrainingResult result = train(arm, data, settings(flags));
    if (result.status != TrainingStatus::finished) {
      print_error(result.status == TrainingStatus::diverged
                      ? result.message
                      : result.message + "; the same command with --resume goes on");
      return kExitNoSolution;
    }
    if (!arm.is_spatial()) {
      result.model.learnt = learnt_region_of(data);
    }
    result.model.family->traits = fit_traits(arm, data.physics, *result.model.family);
    result.model.training["data"] = sources;
    result.model.training["physics"] = variation_;
    if (wants_tube(arm)) {
      result.model = with_tube(arm, std::move(result.model), flags);
    }
    write_model(out_, result.model);
    remove_parts();
    report(flags, data, result);
    return kExitDone;
  }

 private:
  bool wants_tube(const ArmDescription& arm) const {
    return !arm.is_spatial() && tube_runs_.value_or(kTubeRuns) != 0;
  }
  fs::path folder() const { return out_ + ".parts"; }
  fs::path recording_path(const Share& share) const {
    return folder() / fmt::format("{}.h5", share.name);
  }

  fs::path checkpoint() const { return folder() / "training.checkpoint"; }

  /// Those that this command wrote. What else lies there stays, and the folder with it.
  void remove_parts() const {
    std::error_code ignored;  // what stays behind does no harm
    for (const Share& share : kShares) {
      fs::remove(recording_path(share), ignored);
    }
    fs::remove(checkpoint(), ignored);
    fs::remove(calibration().model_file, ignored);
    fs::remove_all(calibration().folder, ignored);
    fs::remove(folder(), ignored);
  }

  Recording record(const ArmDescription& arm, const PhysicsVariation& variation, const Share& share,
                   const CommonFlags& flags) const {
    ScheduleSettings schedule;
    schedule.kind = ScheduleKind::random;
    schedule.approach = share.approach;
    schedule.count = share.count;
    schedule.hold_min_s = share.hold_min_s;
    schedule.hold_s = share.hold_s;
    schedule.episodes =
        std::max(1, int(std::lround(hours_ * kSecondsPerHour * share.share / share.arm_s)));
    VirtualArmOptions options = noisy();
    options.seed = flags.seed + std::uint64_t(&share - kShares);
    CollectionSettings settings = related_collection(arm, schedule, options, variation);
    take_common(flags, settings);
    settings.seed = options.seed;
    settings.resume = resume_;
    return collect(arm, settings, related_arm_factory(arm, options, variation),
                   recording_path(share))
        .recording;
  }

  VirtualArmOptions noisy() const {
    VirtualArmOptions options;
    options.noise_m = noise_m_;
    options.noise_rad = kNoiseRadPerM * noise_m_;
    return options;
  }

  TrainingSettings settings(const CommonFlags& flags) const {
    TrainingSettings settings = best_preset();
    set_family_size(settings, size_);
    set_epoch_count(settings, epochs_);
    settings.hidden_units = hidden_;
    take_common(flags, settings);
    settings.checkpoint = checkpoint();
    settings.resume = resume_ && fs::exists(settings.checkpoint);
    return settings;
  }

  CalibrationSettings calibration() const {
    CalibrationSettings settings;
    settings.levels = {Tube::kDefaultLevel};
    settings.scale_runs = settings.screen_runs = kRunsBeforeTest;
    settings.test_runs = tube_runs_.value_or(kTubeRuns);
    settings.audit_runs = 0;
    settings.folder = folder() / "tube";
    settings.model_file = folder() / "family.safetensors";
    return settings;
  }

  /// Without one where none holds: a family is worth something without a tube too.
  CompensationModel with_tube(const ArmDescription& arm, CompensationModel family,
                              const CommonFlags& flags) const {
    CalibrationSettings settings = calibration();
    write_model(settings.model_file, family);
    settings.resume = resume_;
    take_common(flags, settings);
    settings.runs.arm = settings.runs.executed_arm = arm;
    settings.runs.unseen = UnseenArms{parse_physics_variation(variation_)};
    settings.runs.model = family;
    settings.runs.limits.queries = kCalibrationQueries;
    take_common(flags, settings.runs);
    try {
      CalibrationResult result = calibrate_tube(settings);
      for (const std::string& failure : result.failures) {
        say(flags, "no tube: {}", failure);
      }
      return std::move(result.model);
    } catch (const TooFewPlans& error) {
      say(flags, "no tube: {}", error.what());
      return family;
    }
  }

  void report(const CommonFlags& flags, const TrainingData& data,
              const TrainingResult& result) const {
    const auto arms = result.model.family->arms.cols();
    Json json;
    json["file"] = out_;
    json["arms"] = arms;
    json["arms_held_back"] = data.validation.size();
    json["seed"] = flags.seed;
    json["hours"] = hours_;
    json["family_size"] = size_;
    json["epochs"] = epochs_;
    json["error_of_other_arms_cm"] = result.best_validation_position_error_cm;
    json["tube"] = result.model.tube ? to_json(*result.model.tube) : nullptr;
    json["wall_time_s"] = result.wall_time_s;
    const std::string on_others =
        data.validation.empty()
            ? ""
            : fmt::format(
                  "; on {} others, fitted to 20 s at most, the tip's error is {:.2f} cm, open loop",
                  data.validation.size(), result.best_validation_position_error_cm);
    print_result(flags, json,
                 fmt::format("{}: a family of {} arms{}. Next: limber adapt --model {} "
                             "--recording MINUTE.h5 --out MINE.safetensors",
                             out_, arms, on_others, out_));
  }

  static constexpr double kHeldBackShare = 0.03;
  static constexpr double kNoiseRadPerM = 10.0;  // of markers 14 cm apart
  static constexpr int kTubeRuns = 400;
  static constexpr int kRunsBeforeTest = 200;  // that shape the tube; that say what to test

  std::string arm_ = "three_segment";
  std::string out_;
  double hours_ = 18.0;
  int size_ = 24;
  std::vector<int> hidden_ = {200, 200};  // an arm that varies in 20 ways takes more than one
  int epochs_ = 250;
  std::string variation_ = "wide";
  double noise_m_ = 0.0002;
  std::optional<int> tube_runs_;
  bool resume_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_family_verb() {
  return std::make_unique<FamilyVerb>();
}

}  // namespace limber
