#include "estimate/live_arm_fit.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/plate_distance.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/network/arm_family.hpp"

namespace limber {
namespace {

constexpr int kFrames = 300;

/// An arm that moves as the small family's network has one of its arms do, seen by a fit that
/// begins with another one.
class LiveFit : public testing::Test {
 protected:
  CompensationModel arm_at(Eigen::Index number) const {
    const int size = family.family->size();
    return model_of_arm(family, {"", family.family->arms.col(number),
                                 0.01F * Eigen::MatrixXf::Identity(size, size)});
  }

  Pressures pressures(int frame) const {
    const float t = static_cast<float>(frame) * 0.05F;
    return Pressures{{60.0F * std::sin(2.0F * t), 50.0F * std::sin(2.7F * t + 1.0F),
                      40.0F * std::sin(3.1F * t + 2.0F)}};
  }

  /// Of the plates, at most, over a window, of the model beside the true arm.
  double error_m(const CompensationModel& model, const CompensationModel& truth) const {
    const ForwardModel ours(arm, model);
    const ForwardModel theirs(arm, truth);
    ForwardModel::Workspace workspace;
    Backbone a = shape_at_no_load(ours, 1000);
    Backbone b = a;
    Backbone a_before = a;
    Backbone b_before = b;
    for (int t = 1001; t < 1024; ++t) {
      step(ours, t, a_before, a, workspace);
      step(theirs, t, b_before, b, workspace);
    }
    return largest_plate_distance_m(a, b);
  }

  Backbone shape_at_no_load(const ForwardModel& model, int t) const {
    Backbone shape(arm.point_count(), kPoseSize);
    model.no_load().backbone(pressures(t), shape);
    return shape;
  }

  void step(const ForwardModel& model, int t, Backbone& before, Backbone& now,
            ForwardModel::Workspace& workspace) const {
    Backbone next = now;
    model.step(pressures(t - 1), pressures(t), before, now, next, workspace);
    before = now;
    now = next;
  }

  /// @return times that e changed
  /// @param sign  of the pressures that the fit is told, beside those that the arm has
  int watch(LiveArmFit& fit, const CompensationModel& truth, bool is_tracked = true,
            float sign = 1.0F) const {
    const ForwardModel model(arm, truth);
    ForwardModel::Workspace workspace;
    Backbone now = shape_at_no_load(model, 0);
    Backbone before = now;
    int changes = 0;
    for (int t = 1; t < kFrames; ++t) {
      step(model, t, before, now, workspace);
      const std::optional<Backbone> seen = is_tracked ? std::optional(now) : std::nullopt;
      changes += fit.observe(sign * pressures(t), seen) ? 1 : 0;
    }
    return changes;
  }

  ArmDescription arm = load_arm(data_folder() / "arms" / "three_segment.yaml");
  CompensationModel family =
      read_model(data_folder() / "families" / "three_segment_small.safetensors");
};

TEST_F(LiveFit, FindsAnArmOfTheFamilyFromAnother) {
  const CompensationModel truth = arm_at(7);
  LiveArmFit fit(arm, arm_at(0));
  const double before_m = error_m(arm_at(0), truth);
  ASSERT_GT(before_m, 0.01);
  EXPECT_GT(watch(fit, truth), 3);
  EXPECT_LT(error_m(model_of_arm(family, fit.member()), truth), 0.2 * before_m);
  EXPECT_LT(fit.last_error_m(), 0.2 * fit.largest_error_m());
  EXPECT_EQ(fit.times_off(), 1.0);
  EXPECT_FALSE(fit.has_left_family());
}

TEST_F(LiveFit, AnArmThatBendsTheOtherWayHasLeftTheFamily) {
  LiveArmFit fit(arm, arm_at(7));
  watch(fit, arm_at(7), true, -1.0F);
  EXPECT_GT(fit.times_off(), 4.0);
  EXPECT_TRUE(fit.has_left_family());
}

TEST_F(LiveFit, OfAnArmThatDoesAsPredictedStaysAndBecomesSurer) {
  const CompensationModel truth = arm_at(7);
  LiveArmFit fit(arm, truth);
  const float unsure = fit.member().covariance.trace();
  watch(fit, truth);
  EXPECT_LT((fit.member().e - truth.member_of_family->e).norm(), 1e-3F);
  EXPECT_LT(fit.member().covariance.trace(), unsure);
  EXPECT_FALSE(fit.is_surprised());
  EXPECT_TRUE(fit.explained_changes().empty());
}

TEST_F(LiveFit, SaysWhichOneQuantityHasChanged) {
  const CompensationModel before = arm_at(7);
  const PhysicalTrait& friction = family.family->traits.at(0);
  FamilyMember now = *before.member_of_family;
  now.e += 0.2F * friction.along;
  LiveArmFit fit(arm, before);
  watch(fit, model_of_arm(family, now));
  EXPECT_TRUE(fit.is_surprised());
  const std::vector<ArmChange> changes = fit.explained_changes();
  ASSERT_FALSE(changes.empty());
  ASSERT_EQ(changes.front().size(), 1U);
  EXPECT_EQ(changes.front().front().name, "friction_coefficient");
  EXPECT_NEAR(changes.front().front().value - changes.front().front().reference, 0.2, 0.03);
}

// A round of rollouts then takes longer than a window does.
TEST_F(LiveFit, OfTheLargestFamilyFindsItsArmToo) {
  const Eigen::Index own = family.family->size();
  family.family->traits.clear();  // of fewer numbers
  for (Eigen::MatrixXf* columns : {&family.family->shifts, &family.family->log_gains}) {
    columns->conservativeResize(Eigen::NoChange, columns->cols() + ArmFamily::kMaxSize - own);
    columns->rightCols(ArmFamily::kMaxSize - own).setZero();
  }
  family.family->arms.conservativeResize(ArmFamily::kMaxSize, Eigen::NoChange);
  family.family->arms.bottomRows(ArmFamily::kMaxSize - own).setZero();
  const CompensationModel truth = arm_at(7);
  LiveArmFit fit(arm, arm_at(0));
  const double before_m = error_m(arm_at(0), truth);
  EXPECT_GT(watch(fit, truth), 3);
  EXPECT_LT(error_m(model_of_arm(family, fit.member()), truth), 0.3 * before_m);
}

TEST_F(LiveFit, OfAnArmThatNobodySeesSaysNothing) {
  LiveArmFit fit(arm, arm_at(0));
  EXPECT_EQ(watch(fit, arm_at(7), false), 0);
  EXPECT_EQ(fit.largest_error_m(), 0.0);
}

TEST_F(LiveFit, OfAnArmThatIsLostAfterOneLongFrameSaysNothing) {
  LiveArmFit fit(arm, arm_at(0));
  Backbone shape = shape_at_no_load(ForwardModel(arm, arm_at(7)), 0);
  for (int t = 0; t < kFrames; ++t) {
    EXPECT_FALSE(fit.observe(pressures(t), t < 2 ? std::optional(shape) : std::nullopt));
    shape.col(0).array() += 0.1F;  // [m]
  }
  EXPECT_EQ(fit.largest_error_m(), 0.0);
}

}  // namespace
}  // namespace limber
