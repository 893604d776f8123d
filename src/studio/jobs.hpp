#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <variant>

#include "event_queue.hpp"
#include "limber/world/plan.hpp"
#include "studio_scene.hpp"

namespace limber {

/// What a tab asks its worker for (docs/studio_api.md). `request` comes back with every event.
struct PlanJob {
  std::uint64_t request = 0;
  SceneNames scene;
  nlohmann::json environment;
  double time_limit_s = 5.0;
  std::uint64_t seed = 1;
  bool with_tree = false;
  double limit_scale = 1.0;  ///< of the arm's pressure limits, in (0, 1]
};
/// The plan that stands, by every model.
struct RunJob {
  std::uint64_t request = 0;
  bool replan = false;         ///< the virtual arm, closed loop
  bool drop_obstacle = false;  ///< into its way while it moves
};
/// Models moved by hand, side by side, from rest.
struct DriveJob {
  std::uint64_t request = 0;
  SceneNames scene;
};
using Job = std::variant<PlanJob, RunJob, DriveJob>;

/// A plan that was found, with what it was made for.
struct FoundPlan {
  SceneNames scene;
  Environment environment;
  Plan plan;
};

/// Set points that a hand moves while arms follow. Threads: any.
class DriveTarget {
 public:
  void set(Pressures kpa) {
    const std::lock_guard lock(mutex_);
    kpa_ = std::move(kpa);
  }
  Pressures get() const {
    const std::lock_guard lock(mutex_);
    return kpa_;
  }

 private:
  mutable std::mutex mutex_;
  Pressures kpa_;
};

// Each runs until it is done or `stop` is set, and reports through `events`.

/// @param found  called with every plan that is certified, the last one the best
void run_plan_job(const PlanJob& job, const StudioScene& scene, const std::atomic<bool>& stop,
                  EventQueue& events, const std::function<void(FoundPlan)>& found);
void run_run_job(const RunJob& job, const StudioScene& scene, const FoundPlan& found,
                 const std::atomic<bool>& stop, EventQueue& events);
void run_drive_job(const DriveJob& job, const StudioScene& scene, const DriveTarget& target,
                   const std::atomic<bool>& stop, EventQueue& events);

}  // namespace limber
