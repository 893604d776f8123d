#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "limber/common/json.hpp"
#include "limber/run/executor.hpp"
#include "limber/world/collision.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// A motion frame by frame, the first one the start, and what is said about it.
class MotionTrack {
 public:
  /// @param key        "simple", "network", "virtual_arm" or "arm"
  /// @param obstacles  that its clearance is measured from
  MotionTrack(const char* key, const ArmDescription& arm, const std::vector<Obstacle>& obstacles)
      : key_(key), arm_(arm), obstacles_(obstacles), checker_(arm, obstacles) {}

  /// @param is_seen  else nobody saw the arm in that frame: it is drawn where it was seen, but has
  ///                 no clearance
  void add(const Eigen::Ref<const Pressures>& kpa, const Eigen::Ref<const Backbone>& shape,
           bool is_seen = true);
  /// From the next frame on there is one more.
  void add_obstacle(const Obstacle& obstacle);
  void set_outcome(std::string words) { outcome_ = std::move(words); }
  Json json() const;

 private:
  const char* key_;
  const ArmDescription& arm_;
  std::vector<Obstacle> obstacles_;
  CollisionChecker checker_;
  std::string outcome_;
  Json shapes_ = Json::array();
  Json pressures_kpa_ = Json::array();
  Json clearances_m_ = Json::array();
};

/// A run as it was recorded. @param key  "virtual_arm" or "arm"
MotionTrack executed_track(const char* key, const ArmDescription& arm,
                           const Environment& environment, const ExecutionResult& result);
/// A plan as its model predicts it.
MotionTrack predicted_track(const ArmDescription& arm, const Environment& environment,
                            const Plan& plan);

/// "ends 0.41 cm from the goal's centre"
std::string miss_text(const PoseGoal& goal, const Backbone& shape);
/// The same of a run, or why there is nothing to say of its end.
std::string outcome_text(const PoseGoal& goal, const ExecutionResult& result);
/// When and where; null if none appeared.
Json appeared_to_json(const std::optional<AppearedObstacle>& appeared);

}  // namespace limber
