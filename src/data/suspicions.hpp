#pragma once

#include <string>
#include <utility>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording_inspection.hpp"

namespace limber {

/// Collects what is odd, by kind, in the order of first appearance.
class Suspicions {
 public:
  void add(const std::string& what, std::size_t episode, int frame, const std::string& numbers,
           int count = 1) {
    for (Suspicion& known : list_) {
      if (known.what == what) {
        known.count += count;
        return;
      }
    }
    list_.push_back({what, count, int(episode), {}, frame, numbers});
  }

  std::vector<Suspicion> take() { return std::move(list_); }

 private:
  std::vector<Suspicion> list_;
};

/// What shows only in a recording as a whole, or in an episode: another arm, commands that never
/// change, episodes too short or never tracked, frames at another rate, a base away from the
/// origin, distances between plates that are not the arm's.
/// @param arm  null if none was given
/// @param limits_kpa  of its commands, or the largest set points
void look_at_whole(const Recording& recording, const ArmDescription* arm,
                   const std::vector<PressureLimits>& limits_kpa, Suspicions& suspicions);

}  // namespace limber
