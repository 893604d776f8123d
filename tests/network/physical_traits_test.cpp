#include "limber/network/physical_traits.hpp"

#include <cmath>

#include <gmock/gmock.h>

namespace limber {
namespace {

/// e's first number is the load at the tip in grams, its second how much stronger the left side of
/// segment 1 is, in per cent.
ArmFamily family_of_two_traits() {
  ArmFamily family{
      Eigen::MatrixXf::Zero(4, 2), Eigen::MatrixXf::Zero(4, 3), Eigen::MatrixXf::Zero(2, 1), {}};
  family.traits = {{"tip_load_kg", 0.0F, 0.02F, 0.003F, Eigen::Vector2f(0.001F, 0.0F),
                    Eigen::Vector2f(1000.0F, 0.0F)},
                   {sides_trait(1), 0.0F, 0.0F, 0.04F, Eigen::Vector2f(0.0F, 0.01F),
                    Eigen::Vector2f(0.0F, 100.0F)}};
  return family;
}

FamilyMember member(float grams, float percent, float deviation) {
  return {"", Eigen::Vector2f(grams, percent), deviation * deviation * Eigen::Matrix2f::Identity()};
}

TEST(PhysicalTraits, AreKnownNoBetterThanEAndThanETellsThem) {
  const std::vector<TraitEstimate> told =
      physical_traits(family_of_two_traits(), member(30.0F, -20.0F, 4.0F));
  ASSERT_EQ(told.size(), 2U);
  EXPECT_NEAR(told[0].value, 0.05, 1e-6);
  EXPECT_NEAR(told[0].deviation, std::hypot(0.003, 0.004), 1e-6);
  EXPECT_TRUE(told[0].differs());
  EXPECT_NEAR(told[1].value, -0.2, 1e-6);
  EXPECT_TRUE(told[1].differs());
  EXPECT_EQ(differences_text(told),
            "load at the tip 50.0 ± 5.0 g (0.0), segment 1: left side's strength over the "
            "right's -20.0 ± 5.7 % (0.0)");
}

/// By motion alone: this is what e has become, known with this deviation in every number.
std::string told_by_motion(const ArmFamily& family, const FamilyMember& before, Eigen::Vector2d e,
                           double deviation) {
  const Eigen::Matrix2d precision = Eigen::Matrix2d::Identity() / (deviation * deviation);
  return changes_text(
      explained_changes(family, before, {precision, precision * (e - before.e.cast<double>())}));
}

TEST(PhysicalTraits, AChangeIsExplainedByOneIfOneIsEnough) {
  ArmFamily family = family_of_two_traits();
  const FamilyMember before = member(-18.0F, 0.0F, 4.0F);
  EXPECT_EQ(told_by_motion(family, before, {32.0, 1.0}, 4.0), "load at the tip 52.0 ± 4.0 g (2.0)");
  EXPECT_EQ(told_by_motion(family, before, {32.0, -40.0}, 4.0),
            "load at the tip 52.0 ± 4.0 g (2.0) and segment 1: left side's strength over the "
            "right's -40.0 ± 4.0 % (0.0)");
  EXPECT_EQ(told_by_motion(family, before, {-3.0, 4.0}, 4.0), "") << "which may be chance";
  // Another quantity that moves e nearly as load does.
  family.traits.push_back(family.traits[0]);
  family.traits[2].name = "friction_coefficient";
  family.traits[2].along.y() = 100.0F;
  EXPECT_THAT(told_by_motion(family, before, {32.0, 0.0}, 4.0),
              ::testing::MatchesRegex("load at the tip .*, or friction on the table .*"));
}

}  // namespace
}  // namespace limber
