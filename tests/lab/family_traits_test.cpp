#include "limber/lab/family_traits.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <Eigen/Core>

#include "limber/network/physical_traits.hpp"
#include "limber/sim/related_arms.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::uint64_t kSeed = 7;
constexpr int kArms = 200;

/// A family whose e is what its arms weigh at the tip, how rough their table is, and a number that
/// has to do with nothing.
struct PlainFamily {
  ArmDescription arm = sample_arm(1);
  VirtualArmParameters of_file = virtual_arm_parameters(arm);
  ArmFamily family = {
      Eigen::MatrixXf::Zero(4, 3), Eigen::MatrixXf::Zero(4, 4), Eigen::MatrixXf(3, kArms), {}};
  std::vector<std::string> physics;

  VirtualArmParameters physics_of(int number) const {
    return related_physics(of_file, WidePhysics{}, kSeed, static_cast<std::uint64_t>(number));
  }
  Eigen::Vector3f e_of(int number) const {
    const VirtualArmParameters own = physics_of(number);
    return {static_cast<float>(50.0 * own.tip_load_kg - 2.0),
            static_cast<float>(20.0 * own.friction_coefficient - 5.0 + 0.3 * ((number % 3) - 1)),
            static_cast<float>((number * 37) % 100) / 50.0F - 1.0F};
  }
  PlainFamily() {
    for (int i = 0; i < kArms; ++i) {
      family.arms.col(i) = e_of(i);
      physics.push_back(physics_differences(of_file, physics_of(i)));
    }
  }
};

std::vector<std::string> names(const std::vector<PhysicalTrait>& traits) {
  std::vector<std::string> names;
  std::ranges::transform(traits, std::back_inserter(names), &PhysicalTrait::name);
  return names;
}

TEST(FamilyTraits, AreWhatEOfVirtualArmsTells) {
  PlainFamily plain;
  plain.family.traits = fit_traits(plain.arm, plain.physics, plain.family);
  ASSERT_THAT(names(plain.family.traits), ElementsAre("friction_coefficient", "tip_load_kg"));
  EXPECT_FLOAT_EQ(plain.family.traits[0].of_file,
                  static_cast<float>(plain.of_file.friction_coefficient));
  int outside = 0;
  for (int i = kArms; i < 2 * kArms; ++i) {
    const FamilyMember other{"", plain.e_of(i), Eigen::Matrix3f::Zero()};
    const std::vector<TraitEstimate> told = physical_traits(plain.family, other);
    EXPECT_NEAR(told[1].value, plain.physics_of(i).tip_load_kg, 1e-5);
    const double off = told[0].value - plain.physics_of(i).friction_coefficient;
    outside += std::abs(off) > 2.0 * told[0].deviation ? 1 : 0;
  }
  EXPECT_LE(outside, kArms / 10);
}

TEST(FamilyTraits, ArmsOfWhichNothingIsNotedSayNothing) {
  PlainFamily plain;
  const std::vector<PhysicalTrait> all = fit_traits(plain.arm, plain.physics, plain.family);
  // Mirror images, a real arm, and a recording that says something else.
  plain.family.arms.conservativeResize(Eigen::NoChange, kArms + 3);
  plain.family.arms.rightCols(3).setConstant(100.0F);
  plain.physics.insert(plain.physics.end(), {"", "soft, blue", "{\"colour\": 3}"});
  const std::vector<PhysicalTrait> fewer = fit_traits(plain.arm, plain.physics, plain.family);
  ASSERT_EQ(names(fewer), names(all));
  EXPECT_EQ(fewer[0].slope, all[0].slope);
  plain.physics.resize(20);
  EXPECT_THAT(fit_traits(plain.arm, plain.physics, plain.family), IsEmpty());
}

}  // namespace
}  // namespace limber
