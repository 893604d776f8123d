#pragma once

#include <functional>

#include "limber/world/plan.hpp"

namespace limber {

/// Decides whether a plan that a search has found holds. Searches ask while they go on, so that
/// they end with a plan that holds. Threads: one caller at a time.
class PlanJudge {
 public:
  enum class Verdict {
    holds,
    refused,
    unfinished,  ///< `give_up` came first
  };

  virtual ~PlanJudge() = default;
  /// @param plan     built from its waypoints; a judge may add its findings to it
  /// @param give_up  called now and then; once it is true the answer is `unfinished`, within
  ///                 milliseconds
  virtual Verdict judge(Plan& plan, const std::function<bool()>& give_up) = 0;
};

}  // namespace limber
