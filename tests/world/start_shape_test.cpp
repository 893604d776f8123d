#include "limber/world/start_shape.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "limber/arm/no_load_model.hpp"
#include "planning/random_shapes.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string fault_of(const Backbone& backbone, const ArmDescription& arm) {
  const std::optional<StartFault> fault = find_start_fault(backbone, arm);
  return fault ? std::to_string(fault->row) + ": " + fault->message : "none";
}

Backbone straight(const ArmDescription& arm) {
  return no_load_backbone(NoLoadModel(arm), Pressures::Zero(arm.segment_count()));
}

TEST(StartShape, EveryShapeOfTheModelIsOne) {
  const ArmDescription arm = three_segment_arm();
  const NoLoadModel model(arm);
  RandomStream random(5, 0);
  for (int trial = 0; trial < 200; ++trial) {
    const Backbone b = no_load_backbone(model, random_pressures(arm, random));
    ASSERT_EQ(fault_of(b, arm), "none");
  }
}

// What a tracker adds: a base a few millimetres off, plates that tilt, gaps that read too long.
TEST(StartShape, MeasuredShapesAreOnes) {
  const ArmDescription arm = three_segment_arm();
  const NoLoadModel model(arm);
  RandomStream random(6, 0);
  for (int trial = 0; trial < 200; ++trial) {
    Backbone b = no_load_backbone(model, random_pressures(arm, random));
    for (Eigen::Index i = 0; i < b.rows(); ++i) {
      b(i, 0) += static_cast<float>(random.uniform(-0.003, 0.003));
      b(i, 1) += static_cast<float>(random.uniform(-0.003, 0.003));
      b(i, 2) += static_cast<float>(random.uniform(-0.1, 0.1));
    }
    ASSERT_EQ(fault_of(b, arm), "none");
  }
}

TEST(StartShape, AllPlatesInOnePlaceAreNoArm) {
  const ArmDescription arm = three_segment_arm();
  EXPECT_THAT(fault_of(Backbone::Zero(arm.point_count(), 3), arm),
              HasSubstr("1: plate 1 is 0 m from plate 0; expected 0.0235 to 0.0705 m"));
}

TEST(StartShape, TheFirstPlateIsTheBase) {
  const ArmDescription arm = three_segment_arm();
  Backbone b = straight(arm);
  b.col(1).array() += 0.03F;
  EXPECT_THAT(fault_of(b, arm), HasSubstr("0: plate 0 is at (0, 0.03) m with heading 0 rad"));
  b = straight(arm);
  b.col(2).array() += 0.5F;
  EXPECT_THAT(fault_of(b, arm), HasSubstr("with heading 0.5 rad; expected the base"));
}

TEST(StartShape, GapsHaveAboutTheirLength) {
  const ArmDescription arm = three_segment_arm();
  Backbone b = straight(arm);
  b.bottomRows(3).col(0).array() += 0.03F;
  EXPECT_THAT(fault_of(b, arm), AllOf(HasSubstr("13: plate 13 is 0.077 m from plate 12"),
                                      HasSubstr("the gap of segment 2 at rest")));
  b = straight(arm);
  b.bottomRows(3).col(0).array() -= 0.03F;
  EXPECT_THAT(fault_of(b, arm), HasSubstr("13: plate 13 is 0.017 m from plate 12"));
}

TEST(StartShape, HeadingsRunOn) {
  const ArmDescription arm = three_segment_arm();
  Backbone b = straight(arm);
  b.bottomRows(4).col(2).array() += 2.0F;
  EXPECT_THAT(fault_of(b, arm), HasSubstr("12: the heading turns by 2 rad from plate "
                                          "11 to plate 12; expected at most 1.571 rad"));
  b = straight(arm);
  b.bottomRows(4).col(2).array() -= 6.2831853F;
  EXPECT_THAT(fault_of(b, arm), HasSubstr("without jumps of a full turn"));
}

TEST(StartShape, PlatesLieWhereHeadingsLead) {
  const ArmDescription arm = three_segment_arm();
  Backbone b = straight(arm);
  b.col(0) *= -1.0F;
  EXPECT_THAT(fault_of(b, arm), HasSubstr("1: plate 1 lies 3.142 rad off where its heading"));
  b = straight(arm);
  b.col(0).swap(b.col(1));
  EXPECT_THAT(fault_of(b, arm), HasSubstr("plate 1 lies 1.571 rad off"));
}

TEST(StartShape, ArmsThatBendFurtherMayStartBentFurther) {
  ArmDescription arm = three_segment_arm();
  for (Segment& segment : arm.segments) {
    segment.gaps = 1;
  }
  const NoLoadModel model(arm);
  const Backbone b = no_load_backbone(model, Pressures::Constant(3, 100.0F));
  ASSERT_GT(std::abs(b(3, 2) - b(2, 2)), 2.0F);
  EXPECT_EQ(fault_of(b, arm), "none");
}

TEST(StartShape, WrongCountsAndWhatIsNoNumberAreFaults) {
  const ArmDescription arm = three_segment_arm();
  EXPECT_THAT(fault_of(Backbone::Zero(3, 3), arm), HasSubstr("3 poses found; expected 16"));
  for (int column = 0; column < 3; ++column) {
    Backbone b = straight(arm);
    b(7, column) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(fault_of(b, arm), "none") << column;
  }
}

}  // namespace
}  // namespace limber
