#include <filesystem>
#include <optional>

#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/training/training_settings.hpp"
#include "verbs.hpp"

namespace limber {

namespace {
using Words = std::vector<std::string>;

constexpr int kPlansOfAnEpisode = 10;  // between two ventings
/// What learns from ten minutes of an arm that was recorded for two hours without forgetting those
/// (docs/improving.md has the figures).
constexpr const char* kReplayShare = "0.75";

void append(Words& to, const Words& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// Rounds of two other verbs, in this process: `collect --schedule plans`, then `train --from`.
class ImproveVerb final : public Verb {
 public:
  ImproveVerb()
      : Verb("improve", "Rounds of planning, executing and learning from what the arm then did",
             "limber collect --schedule random --count 40 --episodes 20 --out train.h5\n"
             "  limber train --data train.h5 --out model.safetensors\n"
             "  limber improve --model model.safetensors --data train.h5 --rounds 2 --out "
             "improved") {}

  void add_flags(CLI::App& app) override {
    add_arm_flag(app, arm_);
    app.add_option("--model", model_, "Network model to improve")->required();
    app.add_option("--data", data_,
                   "Recording that it has learnt from, which is replayed; repeat for more")
        ->required();
    app.add_option("--rounds", rounds_, "Rounds")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--plans", plans_, "Plans that each round executes, ten from each venting")
        ->check(CLI::Range(1, 100'000))
        ->capture_default_str();
    app.add_option("--max-queries", queries_, "Model queries of each plan; else those of collect")
        ->check(more_than_zero());
    app.add_option("--epochs", epochs_, "Epochs of each round's training; else those of train")
        ->check(CLI::Range(1, kMaxEpochs));
    app.add_option("--driver", driver_, "What moves: virtual, or exec:COMMAND as of limber collect")
        ->capture_default_str();
    app.add_option("--calibration", calibration_, "Of the driver, as of limber collect");
    app.add_option("--limit-scale", limit_scale_,
                   "Factor on the arm's pressure limits, over 0 and at most 1");
    app.add_flag("--simulated", simulated_, "The driver need not be in real time");
    app.add_option("--out", out_, "Folder for the rounds' recordings and models")
        ->capture_default_str();
    app.add_flag("--resume", resume_, "Go on with the run in --out; you may ask for more --rounds");
  }

  int run(const CommonFlags& flags) override {
    load_asked_arm(arm_, "limber improve");
    const fs::path folder(out_);
    refuse_if(plans_ > kPlansOfAnEpisode && plans_ % kPlansOfAnEpisode != 0,
              "--plans {}: expected at most {}, or a multiple of it", plans_, kPlansOfAnEpisode);
    begin(folder, flags);
    Json rounds = Json::array();
    std::string model = model_;
    Words learnt;
    for (int round = 1; round <= rounds_; ++round) {
      const fs::path here = folder_of(folder, round);
      fs::create_directories(here);
      Json found = {{"round", round}};
      const std::string plans = (here / "plans.h5").string();
      const std::string better = (here / "model.safetensors").string();
      append(learnt, {"--data", plans});
      say(flags, "round {} of {}", round, rounds_);
      const std::string seed = std::to_string(flags.seed + std::uint64_t(round) - 1);
      int code = kExitDone;
      try {
        code = step(*make_collect_verb(), collect_words(model, plans, seed),
                    fs::exists(plans + ".parts") || fs::exists(plans), here, flags, found);
      } catch (const InputError&) {
        forget_if_nothing_was_made(folder);
        throw;
      }
      if (code == kExitDone) {
        code = step(*make_train_verb(), train_words(model, learnt, better, seed),
                    fs::exists(better + ".checkpoint"), here, flags, found);
      }
      rounds.push_back(std::move(found));
      if (code != kExitDone) {
        print_result(flags, {{"model", nullptr}, {"rounds", rounds}}, "");
        return code;
      }
      model = better;
    }
    const std::string result = result_of(folder).string();
    write_file_atomically(result, read_file(model));
    print_result(flags, {{"model", result}, {"rounds", rounds}},
                 fmt::format("{}: learnt from {} rounds of {} plans", result, rounds_, plans_));
    return kExitDone;
  }

 private:
  static fs::path result_of(const fs::path& folder) { return folder / "model.safetensors"; }

  /// What the rounds so far were made of; the number of rounds may grow.
  Json identity(const CommonFlags& flags) const {
    Json json = {{"arm", file_hash(find_arm_file(arm_))},
                 {"model", file_hash(model_)},
                 {"data", Json::array()},
                 {"plans", plans_},
                 {"max_queries", optional_json(queries_)},
                 {"epochs", optional_json(epochs_)},
                 {"limit_scale", optional_json(limit_scale_)},
                 {"driver", driver_},
                 {"seed", flags.seed}};
    for (const std::string& data : data_) {
      json["data"].push_back(file_hash(data));
    }
    if (!calibration_.empty()) {
      json["calibration"] = file_hash(calibration_);
    }
    return json;
  }

  /// Refuses what would mix two runs, or replace what this one does not own.
  void begin(const fs::path& folder, const CommonFlags& flags) {
    const fs::path made_of = folder / "improve.json";
    const fs::path result = result_of(folder);
    if (resume_ && fs::exists(made_of)) {
      refuse_if(read_json_object(made_of) != nlohmann::json(identity(flags)),
                "{}: a run with another model, data or settings began there; give the same, or "
                "--force to make all rounds again",
                made_of.string());
      goes_on_ = true;
      return;
    }
    refuse_if(fs::exists(made_of) && !flags.force,
              "{}: holds rounds already; --resume goes on from them, --force makes them again",
              out_);
    refuse_to_overwrite(result, flags.force);
    for (int round = 1; fs::exists(folder_of(folder, round)); ++round) {
      for (const char* file : {"plans.h5", "model.safetensors"}) {
        refuse_to_overwrite(folder_of(folder, round) / file, flags.force);
      }
    }
    for (int round = 1; fs::exists(folder_of(folder, round)); ++round) {
      const fs::path here = folder_of(folder, round);
      for (const char* verb : {"collect", "train"}) {
        fs::remove(kept(here, verb));
      }
      if (flags.force) {  // else a later --resume would go on with what another run left
        fs::remove_all(here / "plans.h5.parts");
        fs::remove(here / "model.safetensors.checkpoint");
      }
    }
    fs::create_directories(folder);
    write_file_atomically(made_of, identity(flags).dump(1) + "\n");
  }

  /// What was asked for was refused: the same folder serves once that is mended.
  static void forget_if_nothing_was_made(const fs::path& folder) {
    const fs::path first = folder_of(folder, 1) / "plans.h5";
    if (!fs::exists(first) && !fs::exists(first.string() + ".parts")) {
      fs::remove(folder / "improve.json");
    }
  }

  static fs::path folder_of(const fs::path& folder, int round) {
    return folder / fmt::format("round_{}", round);
  }
  static fs::path kept(const fs::path& folder, const std::string& verb) {
    return folder / (verb + ".json");
  }

  Words collect_words(const std::string& model, const std::string& plans,
                      const std::string& seed) const {
    Words words = {"--schedule", "plans",
                   "--model",    model,
                   "--count",    std::to_string(std::min(plans_, kPlansOfAnEpisode)),
                   "--episodes", std::to_string(std::max(1, plans_ / kPlansOfAnEpisode)),
                   "--driver",   driver_,
                   "--seed",     seed,
                   "--out",      plans};
    if (queries_) {
      append(words, {"--max-queries", std::to_string(*queries_)});
    }
    if (limit_scale_) {
      append(words, {"--limit-scale", fmt::format("{}", *limit_scale_)});
    }
    if (!calibration_.empty()) {
      append(words, {"--calibration", calibration_});
    }
    if (simulated_) {
      words.emplace_back("--simulated");
    }
    return words;
  }

  Words train_words(const std::string& model, const Words& learnt, const std::string& better,
                    const std::string& seed) const {
    Words words = {"--from", model, "--replay", kReplayShare, "--seed", seed, "--out", better};
    append(words, learnt);
    for (const std::string& data : data_) {
      append(words, {"--old-data", data});
    }
    if (epochs_) {
      append(words, {"--epochs", std::to_string(*epochs_)});
    }
    return words;
  }

  /// Runs another verb; what it says as JSON is kept beside its files, which says that it is done.
  /// @param has_begun  whether it was stopped before
  int step(Verb& verb, Words words, bool has_begun, const fs::path& folder,
           const CommonFlags& flags, Json& found) const {
    const fs::path done = kept(folder, verb.name());
    if (goes_on_ && fs::exists(done)) {
      found[verb.name()] = read_json_object(done);
      return kExitDone;
    }
    CommonFlags own = flags;
    own.take_result = [&](const Json& result) { found[verb.name()] = result; };
    CLI::App command;
    command.add_option("--seed", own.seed);
    verb.add_flags(command);
    append(words, {"--arm", arm_});
    if (goes_on_ && has_begun) {
      words.emplace_back("--resume");
    }
    own.force = flags.force || goes_on_;  // what a step made that was stopped right before its end
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    try {
      command.parse(words);
    } catch (const CLI::ParseError& error) {
      throw InputError(fmt::format("limber {}: {}", verb.name(), error.what()));
    }
    const int code = verb.run(own);
    if (code == kExitDone) {
      write_file_atomically(done, found[verb.name()].dump(1) + "\n");
    }
    return code;
  }

  std::string arm_ = "three_segment";
  std::string model_;
  Words data_;
  int rounds_ = 2;
  int plans_ = 100;
  std::optional<std::uint64_t> queries_;
  std::optional<int> epochs_;
  std::string driver_ = "virtual";
  std::string calibration_;
  std::optional<double> limit_scale_;
  bool simulated_ = false;
  std::string out_ = "improved";
  bool resume_ = false;
  bool goes_on_ = false;  // with the run that it found
};

}  // namespace

std::unique_ptr<Verb> make_improve_verb() {
  return std::make_unique<ImproveVerb>();
}

}  // namespace limber
