#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
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
  /// "10 s spent", "5000 iterations spent", …; empty where neither a limit nor anybody ended it
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

/// Whose turn it is in a search whose plans are improved while it goes on, by the queries of the
/// model that each has had: the search's alone until there is a plan, then a fifth of them, the
/// rest its improvers'. Queries are counted by whoever simulates, over all turns.
class TurnTaking {
 public:
  enum class Turn { search, improvers };

  static constexpr double kSearchShare = 0.2;
  static constexpr int kMaxIdleTurns = 10'000;

  /// @param queries  so far
  Turn next(bool has_plan, std::uint64_t queries) const {
    const bool search_is_behind =
        double(search_queries_) <= kSearchShare * double(queries - before_plan_);
    return !has_plan || search_is_behind ? Turn::search : Turn::improvers;
  }

  /// The search, or the forest, has had a turn. @param has_plan  after it
  void note_search(bool has_plan, std::uint64_t before, std::uint64_t after) {
    if (has_plan) {
      search_queries_ += after - before;
    } else {
      before_plan_ = after;
    }
  }
  /// Anybody has had one.
  void note_turn(std::uint64_t before, std::uint64_t after) {
    idle_turns_ = after == before ? idle_turns_ + 1 : 0;
  }

  /// Queries since there is a plan; 0 where there is none.
  double since_plan(bool has_plan, std::uint64_t queries) const {
    return has_plan ? double(queries - before_plan_) : 0.0;
  }
  /// Whether nobody has anything to try, for long: a limit of queries alone would never be reached.
  bool is_idle() const { return idle_turns_ > kMaxIdleTurns; }

 private:
  std::uint64_t before_plan_ = 0;     // queries
  std::uint64_t search_queries_ = 0;  // since then
  int idle_turns_ = 0;                // in a row
};

/// When a search that has found nothing starts again. Some searches find a plan soon and others
/// never, though they differ in their random numbers alone: their trees fill the cells that lead to
/// the goal with states from which it can't be reached. Lengths are those of Luby, Sinclair and
/// Zuckerman (1993), 1 1 2 1 1 2 4 …, whose expected time is within a factor of the logarithm of
/// the best schedule's, whatever the search.
class Restarts {
 public:
  /// @param unit_queries  of the model, for the shortest search; > 0
  explicit Restarts(double unit_queries) : unit_queries_(unit_queries) {}

  /// Whether the search that began at `begun_` has had its queries.
  bool is_due(std::uint64_t queries) const {
    return double(queries - begun_) >= unit_queries_ * length(count_ + 1);
  }
  /// The next search begins.
  void begin(std::uint64_t queries) {
    begun_ = queries;
    ++count_;
  }

  /// Term i ≥ 1 of the sequence.
  static double length(std::uint64_t i);

 private:
  double unit_queries_;
  std::uint64_t begun_ = 0;
  std::uint64_t count_ = 0;  // of searches that have ended
};

}  // namespace limber
