#pragma once

#include <functional>

#include "limber/world/plan.hpp"

namespace limber {

/// Says of a plan that a search has found whether it holds; searches ask while they go on, so that
/// they end with a plan that does. Threads: one caller at a time.
class PlanJudge {
 public:
  enum class Verdict {
    holds,
    refused,
    unfinished,  ///< `give_up` came first
  };

  virtual ~PlanJudge() = default;
  /// @param plan     built from its waypoints; a judge may add to it what it has found
  /// @param give_up  asked now and then; once it says so the answer is `unfinished`, within
  ///                 milliseconds
  virtual Verdict judge(Plan& plan, const std::function<bool()>& give_up) = 0;
};

}  // namespace limber
