#include "improve_settings.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/planning/problem_check.hpp"
#include "optional_json.hpp"

namespace limber {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr double kMaxRoundMin = 1e5;
constexpr int kMaxCount = 100'000;
constexpr int kMaxChain = 100;

void require(bool usable, const char* name, double found, const std::string& allowed) {
  if (!usable) {
    throw InputError(fmt::format("{} {}: expected {}", name, found, allowed));
  }
}

Json to_json(const TrainingSettings& training) {
  return {{"epochs", training.epoch_count()},
          {"learning_rate", training.learning_rate},
          {"replay_share", training.replay_share}};
}

}  // namespace

void require_usable(const ImproveSettings& settings) {
  require(settings.rounds >= 1 && settings.rounds <= kMaxCount, "--rounds", settings.rounds,
          fmt::format("1 to {}", kMaxCount));
  require(std::isfinite(settings.round_min) && settings.round_min > 0.0 &&
              settings.round_min <= kMaxRoundMin,
          "--round-min", settings.round_min, fmt::format("minutes, over 0 to {}", kMaxRoundMin));
  require(settings.plan_share >= 0.0 && settings.plan_share <= 1.0, "--plan-share",
          settings.plan_share, "0 to 1");
  require(settings.chain >= 1 && settings.chain <= kMaxChain, "--chain", settings.chain,
          fmt::format("1 to {} environments", kMaxChain));
  require(settings.selection >= 2 && settings.selection <= kMaxCount, "--selection",
          settings.selection, fmt::format("2 to {} environments", kMaxCount));
  require(settings.reported >= 2 && settings.reported <= kMaxCount, "--reported", settings.reported,
          fmt::format("2 to {} environments", kMaxCount));
  require(settings.queries >= 1, "--max-queries", double(settings.queries), "at least 1");
  require_margin(settings.room.margin_m.value_or(0.0));
  require_goal_margin(
      {settings.room.goal_margin_m.value_or(0.0), settings.room.goal_margin_rad.value_or(0.0)});
  require_usable(settings.training);
  if (settings.from_start && !settings.prior_file.empty()) {
    throw InputError("--prior: excludes --from-start; expected one of them");
  }
  if (settings.data_files.empty()) {
    throw InputError("--data: missing; expected the recordings that the model was trained on");
  }
}

Json to_json(const ImproveSettings& settings, const ImproveArm& on) {
  Json json;
  json["schema"] = "limber/improve/1";
  json["arm"] = {{"name", settings.arm.name}, {"hash", settings.arm.hash()}};
  json["on"] = on.source + "; " + on.about;
  json["model"] = content_hash(read_file(settings.model_file));
  json["prior"] = settings.prior_file.empty() ? Json(nullptr)
                                              : Json(content_hash(read_file(settings.prior_file)));
  json["data"] = Json::array();
  for (const fs::path& file : settings.data_files) {
    json["data"].push_back(content_hash(read_file(file)));
  }
  json["round_min"] = settings.round_min;
  json["plan_share"] = settings.plan_share;
  json["chain"] = settings.chain;
  json["selection"] = settings.selection;
  json["reported"] = settings.reported;
  json["max_queries"] = settings.queries;
  json["margin_m"] = optional_json(settings.room.margin_m);  // null: the model's own
  json["goal_margin_m"] = optional_json(settings.room.goal_margin_m);
  json["goal_margin_rad"] = optional_json(settings.room.goal_margin_rad);
  json["limit_scale"] = on.limit_scale;
  json["training"] = to_json(settings.training);
  json["training"]["from_start"] = settings.from_start;
  json["seed"] = settings.seed;
  return json;
}

void require_same_run(const fs::path& file, const Json& wanted) {
  const nlohmann::json root = read_json_object(file);
  const nlohmann::json unordered = wanted;
  for (const auto& [key, value] : unordered.items()) {
    const nlohmann::json there = root.value(key, nlohmann::json(nullptr));
    if (there != value) {
      throw InputError(fmt::format(
          "{}: {} = {}; this run has {}: --resume goes on with the same run only, with as many or "
          "more --rounds; choose another --out, or drop --resume",
          file.string(), key, in_few_words(there), in_few_words(value)));
    }
  }
}

}  // namespace limber
