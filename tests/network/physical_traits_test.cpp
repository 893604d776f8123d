#include "limber/network/physical_traits.hpp"

#include <cmath>

#include <gmock/gmock.h>

namespace limber {
namespace {

/// e's first number is the load at the tip in grams, its second how much stronger the left side of
/// the second segment is, in per cent.
ArmFamily family_of_two_traits() {
  ArmFamily family{Eigen::MatrixXf::Zero(4, 2), Eigen::MatrixXf::Zero(2, 1), {}};
  family.traits = {{"tip_load_kg", 0.0F, 0.02F, 0.003F, Eigen::Vector2f(0.001F, 0.0F)},
                   {sides_trait(1), 0.0F, 0.0F, 0.04F, Eigen::Vector2f(0.0F, 0.01F)}};
  return family;
}

FamilyMember member(float grams, float percent, float deviation) {
  return {"", Eigen::Vector2f(grams, percent),
          deviation * deviation * Eigen::Matrix2f::Identity()};
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
            "load at the tip 50.0 ± 5.0 g (0.0), strength of segment 2's left side over its right "
            "-20.0 ± 5.7 % (0.0)");
}

TEST(PhysicalTraits, OfTheArmNowStandBesideWhatWasBelievedBefore) {
  const ArmFamily family = family_of_two_traits();
  const std::vector<TraitEstimate> since = physical_traits_since(
      family, member(-18.0F, 0.0F, 4.0F), member(32.0F, 1.0F, 4.0F));
  EXPECT_NEAR(since[0].value - since[0].reference, 0.05, 1e-6);
  EXPECT_NEAR(since[0].deviation, std::sqrt(0.003 * 0.003 + 2.0 * 0.004 * 0.004), 1e-6);
  EXPECT_FALSE(since[1].differs());
  EXPECT_EQ(differences_text(since), "load at the tip 52.0 ± 6.4 g (2.0)");
  EXPECT_EQ(differences_text(physical_traits_since(family, member(1.0F, 2.0F, 1.0F),
                                                   member(1.0F, 2.0F, 1.0F))),
            "");
}

TEST(PhysicalTraits, OneIsChangedAloneAlongItsDirection) {
  ArmFamily family = family_of_two_traits();
  family.traits[1].slope.x() = 0.02F;  // what makes the load larger, makes the sides differ
  const Eigen::MatrixXf directions = trait_directions(family);
  ASSERT_EQ(directions.cols(), 2);
  const FamilyMember before = member(10.0F, 5.0F, 1.0F);
  FamilyMember after = before;
  after.e += 0.03F * directions.col(0);
  EXPECT_NEAR(physical_traits(family, after)[0].value,
              physical_traits(family, before)[0].value + 0.03, 1e-5);
  EXPECT_NEAR(physical_traits(family, after)[1].value, physical_traits(family, before)[1].value,
              1e-5);
}

}  // namespace
}  // namespace limber
