#pragma once

#include <deque>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// Which arm of its family this is, while it moves: e of the model that the arm was adapted to,
/// fitted again and again to the last windows of frames in which the arm moved, one rollout after
/// another. What older windows said is kept as what was known before them. It counts less, the
/// more predictions are off by than is usual: a load that is picked up makes the fit forget.
///
/// Work per frame is bounded: four rollouts of a window, some 100 queries, and the models that they
/// are made with, at most one each.
/// Threads: one fit, one thread. Borrows the arm.
class LiveArmFit {
 public:
  /// @pre `adapted` is an arm's of a family (CompensationModel::member_of_family)
  LiveArmFit(const ArmDescription& arm, const CompensationModel& adapted);

  /// Takes in a frame: pressures, and the shape if the arm was tracked.
  /// @return whether e is another one now
  bool observe(const Pressures& pressure_kpa, const std::optional<Backbone>& shape);

  /// What was seen so far is not followed by what is seen next.
  void lose_track();

  /// As far as it is known now.
  const FamilyMember& member() const { return member_; }
  /// What of the arm's physics may have changed since the start, as far as its motion tells.
  std::vector<ArmChange> explained_changes() const;
  /// Whether the arm is far from where it was predicted within a window: at once, not at its end.
  bool is_surprised() const { return is_surprised_; }
  /// How many times the usual error the plates were off by: over the last window, by the e before
  /// it, or within the one that the arm is in, where that surprised. 1 at least. An arm that stands
  /// tells nothing new.
  double times_off() const { return times_off_; }
  /// Whether no arm of the family moves like this one: window after window was predicted wrong,
  /// whatever e came to be.
  bool has_left_family() const;
  /// Of the plates' places, by the e of its time, over the window that was fitted last, and the
  /// largest of all; 0 before the first. [m]
  double last_error_m() const { return last_error_m_; }
  double largest_error_m() const { return largest_error_m_; }

 private:
  struct Frame {
    Pressures pressure_kpa;
    std::optional<Backbone> shape;
  };
  /// Frames that are predicted without correction, and how the plates' offsets depend on e.
  struct Window {
    std::vector<Frame> frames;
    Eigen::VectorXf at;      ///< the e about which
    Eigen::VectorXf left_m;  ///< offsets there
    Eigen::MatrixXf slope;
    bool is_fitted = false;
  };
  /// Of e: |e − mean|² in the metric of `precision` / 2, up to a constant.
  struct Knowledge {
    Eigen::MatrixXd precision;
    Eigen::VectorXd pull;  ///< precision · mean
  };

  /// A prediction without correction, as far as it has come.
  struct Ahead {
    Backbone before;
    Backbone now;
    int frames = 0;
  };

  void look_ahead();
  bool has_moved() const;
  void take_window();
  bool roll_out();
  const ForwardModel& todays_model();
  Eigen::VectorXf offsets(const Window& window, const ForwardModel& model);
  void add(const Window& window, Knowledge& known) const;
  Knowledge with_windows(Knowledge known) const;
  void forget(double wrong);
  void solve();

  const ArmDescription& arm_;
  CompensationModel family_;  // its network alone
  FamilyMember at_start_;
  FamilyMember member_;
  Knowledge before_;   // the windows
  Knowledge retired_;  // windows, by themselves
  std::deque<Frame> recent_;
  std::deque<Window> windows_;
  std::size_t turn_ = 0;               // the window that is rolled out
  int rolled_out_ = 0;                 // of its rollouts: that of e, then one for each number of e
  Window next_;                        // it, about today's e
  std::optional<ForwardModel> model_;  // of member_; none since e has changed
  std::optional<Ahead> ahead_;
  bool is_surprised_ = false;
  double times_off_ = 1.0;
  int strange_ = 0;  // windows in a row
  double last_error_m_ = 0.0;
  double largest_error_m_ = 0.0;
  ForwardModel::Workspace workspace_;
};

}  // namespace limber
