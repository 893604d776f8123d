#include "planner_budget.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr double kCallPeriodS = 0.1;
constexpr double kReserveS = 0.005;  // for what comes after the search
constexpr double kMaxReserve = 0.5;  // of the time limit
constexpr double kGraceS = 0.02;     // beyond the time limit, to end what has begun
constexpr double kBytesPerMb = 1e6;
constexpr double kNotableCost = 0.995;  // of the cost noted before

template <class Number>
void require_positive(const std::optional<Number>& limit, const char* name) {
  if (limit && !(*limit > Number(0) && std::isfinite(double(*limit)))) {
    throw InputError(fmt::format("{} of {}; expected a number > 0", name, *limit));
  }
}

}  // namespace

PlannerBudget::PlannerBudget(const PlannerLimits& limits, const PlannerCallback& callback,
                             std::function<Clock::time_point()> now)
    : limits_(limits),
      callback_(callback),
      now_(std::move(now)),
      start_(now_()),
      reserve_s_(kReserveS),
      stop_(stop_of_thread()) {
  refuse_if(!limits.time_s && !limits.iterations && !limits.queries,
            "a planner needs a limit of time, iterations or queries; none is set");
  require_positive(limits.time_s, "time limit [s]");
  require_positive(limits.iterations, "limit of iterations");
  require_positive(limits.queries, "limit of queries");
  require_positive(limits.memory_mb, "memory limit [MB]");
  require_positive(limits.cost_threshold_kpa, "cost threshold");
}

double PlannerBudget::elapsed_s() const {
  return std::chrono::duration<double>(now_() - start_).count();
}

bool PlannerBudget::out_of_time() const {
  return was_stopped() || (limits_.time_s && elapsed_s() >= share() * *limits_.time_s - reserve_s_);
}

bool PlannerBudget::is_overdue() const {
  return is_asked_to_stop() || (limits_.time_s && elapsed_s() >= *limits_.time_s + kGraceS);
}

void PlannerBudget::keep_for_the_end(double seconds) {
  if (limits_.time_s) {
    reserve_s_ = std::min(std::max(reserve_s_, kReserveS + seconds), kMaxReserve * *limits_.time_s);
  }
}

void PlannerBudget::note(const PlannerProgress& progress) {
  has_plan_ = progress.best_cost_kpa.has_value();
  if (progress.best_cost_kpa &&
      (events_.empty() || *progress.best_cost_kpa < kNotableCost * *events_.back().best_cost_kpa)) {
    events_.push_back(progress);
    events_.back().tree = {};
  }
}

bool PlannerBudget::spent(const PlannerProgress& progress, double bytes) {
  note(progress);
  if (limit_ || was_stopped()) {
    return true;
  }
  if (limits_.iterations && double(progress.iterations) >= share() * double(*limits_.iterations)) {
    limit_ = PlanLimit::iterations;
  } else if (limits_.queries && double(progress.queries) >= share() * double(*limits_.queries)) {
    limit_ = PlanLimit::queries;
  } else if (limits_.memory_mb && bytes >= *limits_.memory_mb * kBytesPerMb) {
    limit_ = PlanLimit::memory;
  } else if (out_of_time()) {
    limit_ = PlanLimit::time;
  }
  if (callback_ && progress.time_s >= next_call_s_) {
    next_call_s_ = progress.time_s + kCallPeriodS;
    stopped_ = !callback_(progress);
  }
  return limit_ || was_stopped();
}

std::string PlannerBudget::reason() const {
  if (was_stopped()) {
    return "stopped by the user";
  }
  if (!limit_) {
    return "";
  }
  switch (*limit_) {
    case PlanLimit::time:
      return fmt::format("{:.4g} s spent", *limits_.time_s);
    case PlanLimit::iterations:
      return fmt::format("{} iterations spent", *limits_.iterations);
    case PlanLimit::queries:
      return fmt::format("{} model queries spent", *limits_.queries);
    case PlanLimit::memory:
      return fmt::format("{} MB spent", *limits_.memory_mb);
  }
  return "";
}

double Restarts::length(std::uint64_t i) {
  // i = 2^k − 1 has length 2^(k−1); the terms between two of those repeat the sequence.
  while (!std::has_single_bit(i + 1)) {
    i -= std::bit_floor(i) - 1;
  }
  return double((i + 1) / 2);
}

}  // namespace limber
