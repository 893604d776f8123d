#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <variant>

#include "event_queue.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/run/appearing_obstacle.hpp"
#include "limber/run/tip_path.hpp"
#include "limber/sim/disturbance.hpp"
#include "limber/world/plan.hpp"
#include "studio_scene.hpp"

namespace limber {

/// Of the jobs that compute for seconds: the other cores are for other tabs, and VENT.
inline constexpr int kJobThreads = 1;
inline constexpr double kMinLimitScale = 0.01;

/// What a tab asks its worker for (docs/studio_api.md). `request` comes back with every event.
struct SceneJob {
  std::uint64_t request = 0;
  SceneNames scene;
};
struct PlanJob : SceneJob {
  nlohmann::json environment;
  double time_limit_s = 5.0;
  std::uint64_t seed = 1;
  bool with_tree = false;
  double limit_scale = 1.0;        ///< of the arm's pressure limits, kMinLimitScale to 1
  std::optional<double> margin_m;  ///< from obstacles; none: what the model's error asks for
};
/// The plan that stands, by every model.
struct RunJob {
  std::uint64_t request = 0;
  bool replan = false;         ///< the virtual arm, closed loop
  bool drop_obstacle = false;  ///< into its way while it moves
};
/// The virtual arm's tip, led along a path that was drawn.
struct FollowJob : SceneJob {
  nlohmann::json environment;
  TipPath path;
};
/// Models moved by hand, side by side, from rest.
struct DriveJob : SceneJob {};
/// A plan that was saved, run or made by `limber experiment`. The scene is the one in use: where
/// the plan was made for its arm and its model, it stays in use.
struct OpenJob : SceneJob {
  std::string plan;  ///< as the project folder has it
};
/// The model's errors on a recording, and what the recording covers.
struct MeasureJob : SceneJob {
  std::string recording;
};
/// The scene's family, fitted to a minute of the virtual arm; saved among the project's models.
struct FitJob : SceneJob {};
using Job = std::variant<PlanJob, RunJob, FollowJob, DriveJob, OpenJob, MeasureJob, FitJob>;

/// A plan that was found, with what it was made for.
struct FoundPlan {
  std::uint64_t request = 0;  ///< of the work that found it
  SceneNames scene;
  Environment environment;
  Plan plan;
};

/// Where a hand moves what follows it.
struct DriveTo {
  Pressures kpa;
  Eigen::VectorXf e;  ///< which arm of the model's family; empty: as the model stands
};

/// The same, as it changes. Threads: any.
class DriveTarget {
 public:
  void set(DriveTo to) {
    const std::lock_guard lock(mutex_);
    to_ = std::move(to);
  }
  DriveTo get() const {
    const std::lock_guard lock(mutex_);
    return to_;
  }

 private:
  mutable std::mutex mutex_;
  DriveTo to_;
};

/// The one of `limber execute --disturbance obstacle`; none where none is wanted, or fits the plan.
inline std::optional<AppearingObstacle> dropped_obstacle(bool wanted, const ArmDescription& arm,
                                                         const Plan& plan) {
  return wanted ? disturbed(arm, plan, parse_disturbances("obstacle"), plan.seed).obstacle
                : std::nullopt;
}

/// The path of a request: time_s, x_m and y_m of each point, flat, times from 0 on.
/// @throws InputError naming the point.
TipPath tip_path_in(const JsonReader& body);

// Each runs until it is done or `stop` is set, and reports through `events`.

/// @param found  called with every plan that is certified, the last one the best
void run_plan_job(const PlanJob& job, const StudioScene& scene, const std::atomic<bool>& stop,
                  EventQueue& events, const std::function<void(FoundPlan)>& found);
void run_run_job(const RunJob& job, const StudioScene& scene, const FoundPlan& found,
                 const std::atomic<bool>& stop, EventQueue& events);
void run_follow_job(const FollowJob& job, const StudioScene& scene, const std::atomic<bool>& stop,
                    EventQueue& events);
void run_drive_job(const DriveJob& job, const StudioScene& scene, const DriveTarget& target,
                   const std::atomic<bool>& stop, EventQueue& events);
/// Finds the arm, the model and the environment that the plan was made for, and certifies it again.
/// @param scene_of  loads these
/// @param found     called with the plan
/// @throws InputError if one of them is not there, or the certificate fails.
void run_open_job(const OpenJob& job, const ProjectFolder& project,
                  const std::function<const StudioScene&(const SceneNames&)>& scene_of,
                  EventQueue& events, const std::function<void(FoundPlan)>& found);
void run_measure_job(const MeasureJob& job, const ProjectFolder& project, const StudioScene& scene,
                     const std::atomic<bool>& stop, EventQueue& events);
void run_fit_job(const FitJob& job, const ProjectFolder& project, const StudioScene& scene,
                 const std::atomic<bool>& stop, EventQueue& events);

}  // namespace limber
