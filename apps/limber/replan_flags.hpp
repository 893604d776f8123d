#pragma once

#include <optional>

#include <CLI/CLI.hpp>

#include "limber/run/closed_loop.hpp"
#include "verb.hpp"

namespace limber {

/// --replan, and how a plan is then replaced while it is executed.
class ReplanFlags {
 public:
  void add_to(CLI::App& app);
  /// Of these flags --motion-queries and --no-adapt alone, for verbs that are told in other ways to
  /// replan.
  void add_settings_to(CLI::App& app);

  bool is_asked_for() const { return replan_; }
  ClosedLoopSettings& settings() { return settings_; }
  const ClosedLoopSettings& settings() const { return settings_; }

  /// Sets the queries of a search in mid-motion, where no flag says how many: as many as fit into
  /// part of a frame on this machine. Says so.
  /// @param known  of earlier runs that these continue
  void choose_motion_queries(const ArmDescription& arm, const MotionModel& model,
                             std::optional<std::uint64_t> known, const CommonFlags& flags);

 private:
  bool replan_ = false;
  std::optional<std::uint64_t> motion_queries_;
  ClosedLoopSettings settings_;
};

}  // namespace limber
