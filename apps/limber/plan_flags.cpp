#include "plan_flags.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/utf8.hpp"
#include "limber/planning/problem_check.hpp"

namespace limber {

namespace {

/// A value of the flag.
struct Narrowing {
  std::string text;
  std::optional<std::size_t> segment;  // none: all of them
  PressureLimits limits;
};

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw InputError(fmt::format("--limit {}: {}", shortened(text), why));
}

PressureLimits limits_in(const std::string& text, const std::string& range) {
  const std::size_t comma = range.find(',');
  const std::optional<double> first = number_in(range.substr(0, comma));
  const std::optional<double> second =
      comma == std::string::npos ? first : number_in(range.substr(comma + 1));
  const PressureLimits limits = comma == std::string::npos
                                    ? PressureLimits(first.value_or(0.0))
                                    : PressureLimits(first.value_or(0.0), second.value_or(0.0));
  const bool finite = first && second && std::isfinite(*first) && std::isfinite(*second);
  if (!finite || !(limits.lower_kpa < limits.upper_kpa)) {
    refuse(text,
           "expected LOWER,UPPER, as in -8,10, or SEGMENT:LOWER,UPPER "
           "for one segment, with LOWER less than UPPER");
  }
  return limits;
}

Narrowing narrowing_in(const std::string& text, const ArmDescription& arm) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    return {text, std::nullopt, limits_in(text, text)};
  }
  const auto segment = number_in<std::size_t>(text.substr(0, colon));
  if (!segment || *segment >= arm.segments.size()) {
    refuse(text, fmt::format("'{}' is no segment; arm '{}' has segments 0 to {}",
                             text.substr(0, colon), arm.name, arm.segment_count() - 1));
  }
  return {text, segment, limits_in(text, text.substr(colon + 1))};
}

}  // namespace

void RoomFlags::add_to(CLI::App& app) {
  auto* margin =
      app.add_option("--margin-m", asked_.margin_m,
                     "Clearance kept from every obstacle; by default the model's tube, or its "
                     "largest error in 95 % of its unseen runs (limber inspect MODEL)")
          ->check(CLI::Range(0.0, kMaxMarginM));
  app.add_option("--tube", asked_.tube_level,
                 "Keep the tube free that held this share of runs, of those that limber calibrate "
                 "put into the model; by default 0.95, where the model carries one")
      ->check(CLI::Range(0.0, 1.0))
      ->excludes(margin);
  app.add_option("--goal-margin-m", asked_.goal_margin_m,
                 "How far inside the goal's rim plans end; by default the model's error at the "
                 "end of 95 % of those runs")
      ->check(CLI::Range(0.0, kMaxMarginM));
  app.add_option("--goal-margin-rad", asked_.goal_margin_rad,
                 "The same for the goal's heading, if it asks for one")
      ->check(CLI::Range(0.0, kMaxMarginM));
}

void RoomFlags::require_use(const Environment& environment) const {
  if (asked_.goal_margin_rad.value_or(0.0) > 0.0 && !environment.goal.theta_rad) {
    throw InputError(fmt::format("--goal-margin-rad {}: the goal of '{}' asks for no heading",
                                 *asked_.goal_margin_rad, environment.name));
  }
}

ErrorRoom RoomFlags::room(const ForwardModel& model, const CommonFlags& flags) const {
  ErrorRoom room = error_room(model, asked_);
  if (!room.note.empty()) {
    say(flags, "{}: {}", model.has_network() ? "note" : "warning", room.note);
  }
  return room;
}

void LimitFlags::add_to(CLI::App& app) {
  app.add_option("--limit", values_,
                 "LOWER,UPPER: plan with set points from LOWER to UPPER, within the arm's limits, "
                 "in the unit of its command; SEGMENT:LOWER,UPPER for one segment. Can be repeated")
      ->allow_extra_args(false);
  app.add_option(
      "--rate-limit", rate_limit_,
      "Change set points by at most so much per second, less than the arm allows, in the "
      "unit of its command. What runs the plan keeps it too");
}

std::vector<PressureLimits> LimitFlags::limits(const ArmDescription& arm) const {
  if (values_.empty()) {
    return {};
  }
  std::vector<PressureLimits> limits = limits_of(arm);
  std::vector<Narrowing> all;
  for (const std::string& value : values_) {
    const Narrowing asked = narrowing_in(value, arm);
    if (std::ranges::count(all, asked.segment, &Narrowing::segment) > 0) {
      refuse(value, asked.segment ? "the segment has a range already"
                                  : "another range for all segments is there already");
    }
    all.push_back(asked);
  }
  std::ranges::stable_partition(all, [](const Narrowing& asked) { return !asked.segment; });
  for (const Narrowing& asked : all) {  // those of one segment last
    const std::size_t first = asked.segment.value_or(0);
    const std::size_t end = asked.segment ? first + 1 : limits.size();
    for (std::size_t s = first; s < end; ++s) {
      const PressureLimits& own = arm.segments[s].pressure_limit_kpa;
      if (!own.contains(asked.limits)) {
        refuse(asked.text,
               fmt::format("beyond the limits of {}, {} {}", segment_name(Eigen::Index(s)),
                           to_string(own), arm.command.unit));
      }
      limits[s] = asked.limits;
    }
  }
  return limits;
}

void ForestFlags::add_to(CLI::App& app) {
  app.add_option("--forest", file_,
                 "Stored motions of model and start, tried before searching; grown and written "
                 "here if there are none");
  app.add_flag("--build-forest", build_,
               "Grow the stored motions again. If --forest names no file, they are written to "
               "MODEL.forest, which --forest can name from then on");
  nodes_flag_ = app.add_option("--forest-nodes", nodes_, "How many motions to grow")
                    ->check(CLI::Range(1, 1 << 24))
                    ->capture_default_str();
}

void ForestFlags::require_use() const {
  refuse_if(nodes_flag_->count() > 0 && !is_asked_for(),
            "--forest-nodes {}: nothing would be grown; give --forest FILE or --build-forest too",
            nodes_);
}

std::string ForestFlags::path_beside(const std::string& model_file) const {
  if (!file_.empty()) {
    return file_;
  }
  refuse_if(model_file.empty(),
            "--build-forest with --no-load: --forest has to name the file to write");
  return fs::path(model_file).replace_extension(".forest").string();
}

std::optional<Forest> ForestFlags::forest(const ArmDescription& arm, const MotionModel& model,
                                          const std::string& model_file, const ArmStart& start,
                                          const CommonFlags& flags) const {
  const std::string path = path_beside(model_file);
  const ForestKey key = forest_key(arm, model_file.empty() ? "" : file_hash(model_file),
                                   model.valves().parameters(), start);
  std::error_code error;
  if (fs::exists(path, error) && build_) {
    if (kind_of(path) != FileKind::forest) {
      throw InputError(path + ": no forest; only a forest can be replaced by a forest");
    }
    say(flags, "{}: growing it again, as asked for", path);
  } else if (fs::exists(path, error)) {
    Forest stored = read_forest(path);
    if (is_grown_for(stored, arm, key)) {
      try {
        require_forest_of(stored, arm, model.valves().parameters(), start);
      } catch (const InputError& refusal) {
        throw InputError(fmt::format("{}: {}", path, refusal.what()));
      }
      if (nodes_flag_->count() > 0 && stored.size() != nodes_) {
        say(flags, "{}: has {} motions, and is used as it is; --build-forest grows {}", path,
            stored.size(), nodes_);
      }
      return stored;
    }
    throw InputError(fmt::format(
        "{}: grown for another arm, model, valves or start; --build-forest replaces it", path));
  }
  refuse_to_overwrite(path, true);
  ForestSettings settings;
  settings.nodes = nodes_;
  take_common(flags, settings);
  Progress progress("forest", "nodes", std::uint64_t(nodes_), flags.progress());
  std::optional<Forest> grown = grow_forest(arm, model, key, start, settings, [&](int nodes) {
    progress.update(std::uint64_t(nodes));
    return !interrupt_requested();
  });
  progress.finish();
  if (grown) {
    write_forest(path, *grown);
    say(flags, "{}: {} motions from the start", path, grown->size());
  }
  return grown;
}

void ReplanFlags::add_settings_to(CLI::App& app) {
  app.add_option(
         "--motion-queries", motion_queries_,
         fmt::format("With --replan: model queries of a search while the arm moves; 0: none "
                     "then. By default what {:.0f} ms take on this machine, and the results "
                     "say how many that were: pass it on to repeat a run",
                     1e3 * kMotionSearchS))
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1'000'000}));
  adapt_flag_ = app.add_flag(
      "--adapt,!--no-adapt", settings_.adapts,
      "With --replan and a model that limber adapt made: which arm this is, is fitted again "
      "while it moves (by default) or left as it is");
}

void ReplanFlags::add_to(CLI::App& app) {
  CLI::Option* replan = app.add_flag(
      "--replan", replan_,
      "Closed loop: plan again, with --model, from where the arm is measured, while it "
      "moves and after, until it is near the goal's centre or comes no nearer");
  add_settings_to(app);
  app.add_option("--max-replans", settings_.corrections.max_replans,
                 "With --replan: plans from rest, after the first")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option(
         "--replan-queries", settings_.corrections.queries,
         "Model queries of each search while the arm stands still (25 times as many as a last "
         "resort)")
      ->check(CLI::Range(std::uint64_t{100}, std::uint64_t{1'000'000'000}))
      ->capture_default_str();
  app.add_option("--blind-s", settings_.blind_s,
                 "With --replan: a moving arm that is not tracked for longer than that is stopped")
      ->check(CLI::Range(0.0, 60.0))
      ->capture_default_str();
  for (const char* name :
       {"--motion-queries", "--adapt", "--max-replans", "--replan-queries", "--blind-s"}) {
    app.get_option(name)->needs(replan);
  }
}

void ReplanFlags::choose_motion_queries(const ArmDescription& arm, const MotionModel& model,
                                        std::optional<std::uint64_t> known,
                                        const CommonFlags& flags) {
  if (motion_queries_ || known) {
    settings_.motion_queries = motion_queries_ ? *motion_queries_ : *known;
    return;
  }
  settings_.motion_queries = queries_within(kMotionSearchS, arm, model);
  say(flags, "{:.0f} ms take {} queries here (--motion-queries)", 1e3 * kMotionSearchS,
      settings_.motion_queries);
}

void TrackFlags::add_to(CLI::App& app) {
  CLI::Option* track = app.add_option(
      "--track", path_,
      "In place of --plan: path of the tip over time to follow with --model, a CSV file "
      "with the columns time_s, x_m and y_m");
  app.add_option("--laps", laps_, "With --track: how often a path that ends at its start is run")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str()
      ->needs(track);
  app.add_option("--track-queries", settings_.queries, "With --track: model queries in each frame")
      ->check(CLI::Range(300, 10'000'000))
      ->capture_default_str()
      ->needs(track);
}

void TrackFlags::prepare(const ArmDescription& arm, const ModelFlags& model,
                         const CommonFlags& flags) {
  tip_path_ = read_tip_path(path_);
  tip_path_.require_within(arm.length_m(), path_);
  if (laps_ > 1 && !tip_path_.closes()) {
    throw InputError(
        tip_path_.source_of(path_, tip_path_.point_m.size() - 1) +
        fmt::format(": ends {:.1f} mm from where the path starts; "
                    "--laps {} needs one that ends at its start, to 1 mm",
                    1000.0 * (tip_path_.point_m.back() - tip_path_.point_m.front()).norm(), laps_));
  }
  tip_path_.laps = laps_;
  forward_ = std::make_unique<ForwardModel>(model.planning_model(arm));
  motion_ = std::make_unique<MotionModel>(model.motion_model(arm, *forward_));
  model.warn_without_valves(*motion_, flags);
}

}  // namespace limber
