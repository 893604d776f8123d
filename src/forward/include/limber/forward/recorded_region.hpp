#pragma once
// For those who plan.

#include <optional>
#include <string>
#include <vector>

#include "limber/network/learnt_region.hpp"
#include "limber/world/plan.hpp"
#include "limber/world/pressure_box.hpp"

namespace limber {

/// Checks frames of motions: whether they stay within what the model's recordings held, in
/// pressures, their rates, pressures and shape together, and how both change. Threads: constant
/// after construction; each thread brings its own Workspace.
class RecordedRegion {
 public:
  using Workspace = NoveltyMeasure::Workspace;

  /// Borrows `learnt`. @param frame_rate_hz  of the arm, > 0
  RecordedRegion(const LearntRegion& learnt, double frame_rate_hz);

  const LearntRegion& learnt() const { return learnt_; }
  Workspace make_workspace() const { return measure_.make_workspace(); }
  /// A frame that begins at `before_kpa` and `backbone_before`, and ends at `now_kpa` and
  /// `backbone`. @pre all finite
  bool holds(const Eigen::Ref<const Pressures>& before_kpa,
             const Eigen::Ref<const Pressures>& now_kpa,
             const Eigen::Ref<const Backbone>& backbone_before,
             const Eigen::Ref<const Backbone>& backbone, Workspace& workspace) const;

  /// A rate at which each segment that was moved may fall and rise [the command's unit per second].
  double rate_limit_kpa_per_s() const;

  /// Set points inside the recorded range. @param arm  whose limits hold too
  PressureBox setpoints_of(const ArmDescription& arm) const;

 private:
  const LearntRegion& learnt_;
  NoveltyMeasure measure_;
  Pressures fall_kpa_;  // of a frame, with a little slack
  Pressures rise_kpa_;
};

/// Where a plan leaves what the recordings held, in sentences with numbers: "segment 1 down to
/// −6.0 kPa; recorded −2.5 … 10.7". Empty: nowhere.
std::vector<std::string> excursions_beyond(const LearntRegion& learnt, const Plan& plan,
                                           const Command& command);

}  // namespace limber
