#include <algorithm>
#include <filesystem>
#include <optional>

#include <fmt/ranges.h>

#include "campaign_units.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/progress.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/lab/campaign_report.hpp"
#include "limber/lab/rank_work.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

constexpr std::size_t kShown = 20;  // units that --dry-run and --status name

/// What is known of all units: counts, and the seconds that a unit of cost takes.
struct CampaignStatus {
  std::size_t done = 0, failed = 0, started = 0, waiting = 0;
  std::vector<std::size_t> failures;
  double done_s = 0.0;
  double done_cost = 0.0;
  double left_cost = 0.0;

  std::optional<double> left_s() const {
    return done_cost > 0.0 ? std::optional(left_cost * done_s / done_cost) : std::nullopt;
  }
};

class CampaignVerb final : public Verb {
 public:
  CampaignVerb()
      : Verb("campaign",
             "Many runs of collect, train, evaluate, experiment or calibrate, also on a cluster",
             "limber campaign sweep.yaml --dry-run\n"
             "  limber campaign sweep.yaml --shard 3/16\n"
             "  mpirun -n 16 limber campaign sweep.yaml\n"
             "  limber campaign sweep.yaml --collect") {}

  void add_flags(CLI::App& app) override {
    seed_flag_ = app.get_option("--seed");
    app.add_option("campaign", file_, "Campaign file (docs/cluster.md)")->required();
    app.add_option("--out", out_, "Folder of the units; else the file's name without extension");
    auto* shard = app.add_option("--shard", shard_,
                                 "I/N: every N-th unit from the I-th on, I from 0 to N - 1");
    auto* collect = app.add_flag("--collect", collect_,
                                 "Run nothing: join what finished units left to one recording, set "
                                 "of models or table, with a report")
                        ->excludes(shard);
    auto* status = app.add_flag("--status", status_,
                                "Run nothing: how many units are done, running, failed, and the "
                                "time that is left")
                       ->excludes(collect, shard);
    app.add_flag("--dry-run", dry_run_, "Run nothing: list the units and what they cost")
        ->excludes(shard, collect, status);
  }

  int run(const CommonFlags& flags) override {
    refuse_if(seed_flag_->count() > 0,
              "--seed: is a key of the campaign's file, of which the units' seeds come");
    const Campaign campaign = read_campaign(file_);
    const std::size_t count = unit_count(campaign);
    require_known_flags(campaign, campaign_unit(campaign, 0));
    require_known_flags(campaign, campaign_unit(campaign, count - 1));
    const auto [first, step] = shard(count);
    CampaignFolder folder(out_.empty() ? fs::path(file_).stem() : fs::path(out_), campaign);
    if (!status_ && !collect_) {
      require_forests(campaign);
      require_known_parameters(campaign_unit(campaign, 0));
      require_known_parameters(campaign_unit(campaign, count - 1));
    }
    if (dry_run_) {
      return print_units(campaign, folder, flags);
    }
    if (status_) {
      return print_status(campaign, folder, flags);
    }
    use_cpu_level(campaign);
    if (collect_) {
      return join(campaign, folder, flags);
    }
    return run_units(campaign, folder, flags, first, step);
  }

 private:
  /// The first unit and the step to the next one.
  std::pair<std::size_t, std::size_t> shard(std::size_t count) const {
    if (shard_.empty()) {
      return {0, 1};
    }
    const std::size_t slash = std::min(shard_.find('/'), shard_.size());
    const auto number = number_in<std::size_t>(shard_.substr(0, slash));
    const auto of =
        slash < shard_.size() ? number_in<std::size_t>(shard_.substr(slash + 1)) : std::nullopt;
    if (!number || !of || *number >= *of) {
      throw InputError(fmt::format("--shard {}: expected I/N, I from 0 to N - 1, such as 0/{}",
                                   shard_, std::min<std::size_t>(count, 16)));
    }
    return {*number, *of};
  }

  int run_units(const Campaign& campaign, CampaignFolder& folder, const CommonFlags& flags,
                std::size_t first, std::size_t step) const {
    const bool shares = shard_.empty() && is_rank();
    const int jobs = shares && flags.jobs == 0 ? 1 : flags.jobs;  // of a rank: one core
    std::vector<std::size_t> failures;
    std::optional<Progress> progress;  // ranks do not know of each other's units
    RankWork work;
    work.list = [&] {
      folder.prepare(flags.force);
      std::vector<std::size_t> units = missing_units(campaign, folder);
      std::erase_if(units, [&](std::size_t unit) { return unit % step != first; });
      if (!flags.force) {
        folder.require_none_finished_otherwise(units);
      }
      say(flags, "{} units to do", units.size());
      if (!shares && !units.empty()) {
        progress.emplace("campaign", "units", units.size(), flags.progress());
      }
      return units;
    };
    work.run = [&](std::size_t index) {
      if (const std::string why = failure_of(campaign, index, folder, jobs); !why.empty()) {
        print_error(fmt::format("unit {} failed: {}", index, why));
        failures.push_back(index);
      }
      if (progress && !interrupt_requested()) {
        progress->advance();
      }
    };
    work.should_stop = [] { return interrupt_requested(); };
    const RankFigures figures = shares ? run_over_ranks(work) : run_alone(work);
    progress.reset();
    if (interrupt_requested()) {
      throw Interrupted("stopped on request; the same command makes the units that are missing");
    }
    if (figures.rank > 0) {
      return kExitDone;
    }
    const CampaignStatus status = look(campaign, folder);
    report(folder, status, figures, flags);
    // What failed on other ranks, they alone know; what is left undone, the folder.
    const bool is_done = shares ? status.done == unit_count(campaign) : failures.empty();
    return is_done ? kExitDone : kExitNoSolution;
  }

  /// Runs the unit. @return why it failed; empty where it did not
  static std::string failure_of(const Campaign& campaign, std::size_t index, CampaignFolder& folder,
                                int jobs) {
    try {
      return run_unit(campaign, campaign_unit(campaign, index), folder, jobs)
                 ? ""
                 : (folder.unit_folder(index) / "log.txt").string();
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  static void report(const CampaignFolder& folder, const CampaignStatus& status,
                     const RankFigures& figures, const CommonFlags& flags) {
    Json json = to_json(status);
    json["units_run"] = figures.units;
    json["ranks"] = figures.ranks;
    json["hand_out_mean_s"] = figures.hand_out_mean_s;
    json["hand_out_max_s"] = figures.hand_out_max_s;
    json["busy_share"] = figures.busy_share;
    std::string text = fmt::format("{}: {} units run", folder.path().string(), figures.units);
    if (figures.ranks > 1) {
      text += fmt::format(
          " by {} ranks, busy {:.1f} % of the time; a unit was handed out in {:.2f} ms, {:.2f} ms "
          "at most",
          figures.ranks, 100.0 * figures.busy_share, 1e3 * figures.hand_out_mean_s,
          1e3 * figures.hand_out_max_s);
    }
    print_result(flags, json, text);
  }

  static CampaignStatus look(const Campaign& campaign, CampaignFolder& folder) {
    CampaignStatus status;
    for (std::size_t i = 0; i < unit_count(campaign); ++i) {
      const CampaignUnit unit = campaign_unit(campaign, i);
      const UnitState state = folder.state(unit);
      if (state == UnitState::done) {
        ++status.done;
        status.done_s += folder.result(unit).at("run").at("wall_time_s").get<double>();
        status.done_cost += unit.cost;
        continue;
      }
      status.left_cost += unit.cost;
      status.waiting += state == UnitState::waiting ? 1 : 0;
      status.started += state == UnitState::started ? 1 : 0;
      if (state == UnitState::failed) {
        ++status.failed;
        status.failures.push_back(i);
      }
    }
    return status;
  }

  static Json to_json(const CampaignStatus& status) {
    Json json;
    json["done"] = status.done;
    json["running"] = status.started;
    json["failed"] = status.failed;
    json["waiting"] = status.waiting;
    json["failures"] = status.failures;
    json["left_s"] = optional_json(status.left_s());
    return json;
  }

  static int print_status(const Campaign& campaign, CampaignFolder& folder,
                          const CommonFlags& flags) {
    const CampaignStatus status = look(campaign, folder);
    std::string text = fmt::format(
        "{} units: {} done, {} running or cut short, {} failed, {} waiting", unit_count(campaign),
        status.done, status.started, status.failed, status.waiting);
    if (const std::optional<double> left_s = status.left_s(); left_s && *left_s > 0.0) {
      text += fmt::format("; {} of one process's time are left", format_duration(*left_s));
      if (status.started > 1) {
        text += fmt::format(", {} for {}", format_duration(*left_s / double(status.started)),
                            status.started);
      }
    }
    for (std::size_t i = 0; i < std::min(status.failures.size(), kShown); ++i) {
      text += fmt::format("\nunit {} failed: {}", status.failures[i],
                          (folder.unit_folder(status.failures[i]) / "log.txt").string());
    }
    print_result(flags, to_json(status), text);
    return status.failed == 0 ? kExitDone : kExitNoSolution;
  }

  static int print_units(const Campaign& campaign, CampaignFolder& folder,
                         const CommonFlags& flags) {
    const CampaignStatus status = look(campaign, folder);
    const std::size_t count = unit_count(campaign);
    Json json = to_json(status);
    json["cost_unit"] = cost_unit(campaign.verb);
    json["units"] = Json::array();
    std::string text =
        fmt::format("{} units of limber {}, of which {} are done; {:.4g} {}", count, campaign.verb,
                    status.done, status.left_cost + status.done_cost, cost_unit(campaign.verb));
    if (const std::optional<double> left_s = status.left_s()) {
      text += fmt::format("; {} of one process's time are left", format_duration(*left_s));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const CampaignUnit unit = campaign_unit(campaign, i);
      const std::string line =
          fmt::format("{}", fmt::join(unit_command(campaign, unit, folder.unit_folder(i), 1), " "));
      json["units"].push_back({{"unit", i}, {"cost", unit.cost}, {"command", line}});
      if (i < kShown) {
        text += fmt::format("\n{}: {:.4g}: limber {}", i, unit.cost, line);
      }
    }
    if (count > kShown) {
      text += fmt::format("\n… and {} more; --json has all", count - kShown);
    }
    print_result(flags, json, text);
    return kExitDone;
  }

  static int join(const Campaign& campaign, CampaignFolder& folder, const CommonFlags& flags) {
    const CampaignStatus status = look(campaign, folder);
    const std::size_t missing = unit_count(campaign) - status.done;
    refuse_if(status.done == 0, "{}: no unit is finished, so nothing can be joined",
              folder.path().string());
    Json json = to_json(status);
    json["files"] = {(folder.path() / "table.csv").string(),
                     (folder.path() / "report.html").string()};
    write_campaign_table(campaign, folder);
    if (campaign.verb == "collect") {
      for (const fs::path& file : join_campaign_recordings(campaign, folder)) {
        json["files"].push_back(file.string());
      }
    }
    int code = missing == 0 ? kExitDone : kExitNoSolution;
    if (campaign.verb == "experiment" && !can_join_experiments(campaign)) {
      say(flags,
          "no experiment/: units differ in more than one environment each (docs/cluster.md)");
    } else if (campaign.verb == "experiment" && missing == 0) {
      code = join_experiments(campaign, folder);
      if (code != kExitDone) {
        return code;  // it has said why
      }
      json["files"].push_back((folder.path() / "experiment" / "table.json").string());
    }
    std::string text = fmt::format("{} units joined", status.done);
    for (const auto& file : json["files"]) {
      text += "\n" + file.get<std::string>();
    }
    if (missing > 0) {
      say(flags, "{} units are missing: the same command without --collect makes them", missing);
    }
    print_result(flags, json, text);
    return code;
  }

  const CLI::Option* seed_flag_ = nullptr;
  std::string file_;
  std::string out_;
  std::string shard_;
  bool collect_ = false;
  bool status_ = false;
  bool dry_run_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_campaign_verb() {
  return std::make_unique<CampaignVerb>();
}

}  // namespace limber
