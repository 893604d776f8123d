#include "limber/lab/tube_score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Core>

#include "limber/common/mapped.hpp"
#include "limber/run/state_lag.hpp"

namespace limber {

namespace {

using Eigen::Vector2d;

Vector2d at(const Eigen::Ref<const Backbone>& backbone, Eigen::Index plate) {
  return {double(backbone(plate, 0)), double(backbone(plate, 1))};
}

/// Middle of the arc through two plates that turns by the difference of their headings.
Vector2d middle(const Eigen::Ref<const Backbone>& backbone, Eigen::Index gap) {
  const Vector2d from = at(backbone, gap);
  const Vector2d chord = at(backbone, gap + 1) - from;
  const double turn = double(backbone(gap + 1, 2)) - double(backbone(gap, 2));
  const double bulge = 0.5 * std::tan(0.25 * std::clamp(turn, -std::numbers::pi, std::numbers::pi));
  return from + 0.5 * chord - bulge * Vector2d(-chord.y(), chord.x());
}

double turned(double a, double b) {
  return std::abs(std::remainder(a - b, 2.0 * std::numbers::pi));
}

/// Calls visit(predicted, true shape) where the arm was tracked.
template <class Visit>
void visit_frames(const Plan& plan, const Episode& run, Visit&& visit) {
  const std::vector<int> shown = shown_frames(plan, run);
  for (int t = 0; t < run.frame_count(); ++t) {
    if (run.was_tracked(t)) {
      const auto k = std::size_t(shown[t]);
      visit(plan.frames[k].backbone, backbone_at(run.backbone, t));
    }
  }
}

/// How far each plate of a shape that the plan predicts is from where it started.
auto moved_in(const Plan& plan) {
  return [&start = plan.frames.front().backbone](const Backbone& predicted, Eigen::Index plate) {
    return (at(predicted, plate) - at(start, plate)).norm();
  };
}

/// Of its room that the tip has, on average over the plan's frames.
double mean_tip_share(const Plan& plan, const RoomGrowth& growth) {
  const auto moved = moved_in(plan);
  const auto sum = sum_of<double>(plan.frames, [&](const PlanFrame& frame) {
    return growth.share_after(moved(frame.backbone, frame.backbone.rows() - 1));
  });
  return sum / plan.frame_count();
}

}  // namespace

std::vector<int> shown_frames(const Plan& plan, const Episode& run) {
  const int last = plan.frame_count() - 1;
  StateLag lag;
  ArmState state;
  std::vector<int> shown;
  for (int t = 0; t < run.frame_count(); ++t) {
    const Pressures& sent_kpa = plan.frames[std::min(t, last)].setpoint_kpa;
    state.setpoint_kpa = run.setpoint_kpa.row(t).transpose();
    shown.push_back(std::clamp(t - lag.note(sent_kpa, state), 0, last));
  }
  return shown;
}

MotionErrors motion_errors(const Plan& plan, const Episode& run, const RoomGrowth& growth) {
  MotionErrors errors;
  errors.plate_m.assign(std::size_t(plan.frames.front().backbone.rows()), 0.0);
  const auto moved = moved_in(plan);
  visit_frames(plan, run, [&](const Backbone& predicted, const Backbone& seen) {
    const Eigen::Index tip = predicted.rows() - 1;
    for (Eigen::Index plate = 0; plate <= tip; ++plate) {
      double& largest = errors.plate_m[plate];
      largest = std::max(largest, (at(predicted, plate) - at(seen, plate)).norm() /
                                      growth.share_after(moved(predicted, plate)));
    }
    errors.end_m = (at(predicted, tip) - at(seen, tip)).norm();
    errors.end_heading_rad = turned(double(predicted(tip, 2)), double(seen(tip, 2)));
  });
  return errors;
}

double tube_score(const Plan& plan, const Episode& run, const Tube& shape) {
  double score = 0.0;
  double end_score = 0.0;
  const auto moved = moved_in(plan);
  const auto scale = [&](const Backbone& predicted, Eigen::Index plate) {
    return shape.plate_scale_m[plate] * shape.growth.share_after(moved(predicted, plate));
  };
  visit_frames(plan, run, [&](const Backbone& predicted, const Backbone& seen) {
    const Eigen::Index tip = predicted.rows() - 1;
    double before = 0.0;
    for (Eigen::Index plate = 0; plate <= tip; ++plate) {
      const double here = scale(predicted, plate);
      score = std::max(score, (at(predicted, plate) - at(seen, plate)).norm() / here);
      if (plate > 0) {
        score = std::max(score, (middle(predicted, plate - 1) - middle(seen, plate - 1)).norm() /
                                    std::max(before, here));
      }
      before = here;
    }
    end_score = std::max(
        (at(predicted, tip) - at(seen, tip)).norm() / shape.end_scale_m,
        turned(double(predicted(tip, 2)), double(seen(tip, 2))) / shape.end_heading_scale_rad);
  });
  return std::max(score, end_score);
}

GrowingErrors growing_errors(const Plan& plan, const Episode& run, double arm_length_m) {
  GrowingErrors errors;
  for (std::size_t g = 0; g < kStartShares.size(); ++g) {
    const RoomGrowth growth = growth_of(g, arm_length_m);
    errors.of[g] = motion_errors(plan, run, growth);
    errors.tip_share[g] = mean_tip_share(plan, growth);
  }
  return errors;
}

double mean_tip_radius_m(const Plan& plan, const Tube& tube, const TubeLevel& level) {
  return level.factor * tube.plate_scale_m.back() * mean_tip_share(plan, tube.growth);
}

}  // namespace limber
