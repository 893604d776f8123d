#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "limber/planning/planner.hpp"

namespace limber {

/// Watches a planner's limits and calls its callback now and then.
class PlannerBudget {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param now  the time, for tests that bring their own
  /// @throws InputError where no limit is set or one is not positive.
  PlannerBudget(const PlannerLimits& limits, const PlannerCallback& callback,
                std::function<Clock::time_point()> now = &Clock::now);

  double elapsed_s() const;

  /// True if the time is up, or the callback or the StopScope of the thread that made the budget
  /// has asked to stop; checked inside long steps, on any thread.
  bool out_of_time() const;

  /// True if the time limit has passed by more than an ending may take, or StopScope says stop.
  bool is_overdue() const;

  /// The last plan's certificate takes about this long, so the search ends that much earlier.
  void keep_for_the_end(double seconds);

  /// Checks every limit; true as soon as one is spent.
  /// @param bytes  that the tree takes
  bool spent(const PlannerProgress& progress, double bytes);

  /// Adds to the log if there is something to note; `spent` does so each time.
  void note(const PlannerProgress& progress);
  /// PlanResult::events.
  const std::vector<PlannerProgress>& events() const { return events_; }

  /// The limit that ended the search, if one did.
  std::optional<PlanLimit> limit() const { return limit_; }
  bool was_stopped() const { return stopped_ || is_asked_to_stop(); }
  /// True if the best cost is at or below the threshold asked for.
  bool good_enough(const std::optional<double>& cost_kpa) const {
    return cost_kpa && limits_.cost_threshold_kpa && *cost_kpa <= *limits_.cost_threshold_kpa;
  }
  /// "10 s spent", "5000 iterations spent", …
  std::string reason() const;

 private:
  bool is_asked_to_stop() const { return stop_ != nullptr && stop_->load(); }
  /// Of the limits, that the search may have as it stands.
  double share() const { return has_plan_ ? 1.0 : limits_.patience; }

  PlannerLimits limits_;
  PlannerCallback callback_;
  std::function<Clock::time_point()> now_;
  Clock::time_point start_;
  double next_call_s_ = 0.0;
  double reserve_s_;
  bool has_plan_ = false;
  std::optional<PlanLimit> limit_;
  bool stopped_ = false;
  const std::atomic<bool>* stop_;  // of the thread that made it; null without a StopScope
  std::vector<PlannerProgress> events_;
};

}  // namespace limber
