#include "limber/arm/space_pose.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "limber/arm/backbone.hpp"
#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

constexpr double kRounding = 1e-12;

Eigen::Vector3d random_vector(RandomStream& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

/// The same element by many small straight steps: no formula of it is shared.
SpacePose integrated(double length_m, const Eigen::Vector3d& omega) {
  constexpr int kSteps = 20'000;
  SpacePose pose;
  const Eigen::AngleAxisd half(
      omega.norm() / kSteps / 2.0,
      omega.norm() > 0.0 ? Eigen::Vector3d(omega.normalized()) : Eigen::Vector3d::UnitX());
  for (int i = 0; i < kSteps; ++i) {
    pose.rotation = pose.rotation * half;
    pose.position_m += pose.rotation * Eigen::Vector3d(length_m / kSteps, 0.0, 0.0);
    pose.rotation = (pose.rotation * half).normalized();
  }
  return pose;
}

TEST(SpacePose, AnElementIsWhatManySmallStepsMake) {
  RandomStream random(1, 1);
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector3d omega = random_vector(random, 1.5);
    const SpacePose end = element(0.2, omega);
    const SpacePose expected = integrated(0.2, omega);
    EXPECT_LT((end.position_m - expected.position_m).norm(), 1e-9);
    EXPECT_LT(end.rotation.angularDistance(expected.rotation), 1e-6);
  }
}

TEST(SpacePose, InThePlaneItIsThePlanarArc) {
  for (const double angle : {-2.0, -0.3, -1e-9, 0.0, 1e-5, 0.09, 0.11, 1.0, 3.0}) {
    const SpacePose end = element(0.3, Eigen::Vector3d(0.0, 0.0, angle));
    const Pose planar = arc(0.3, angle);
    EXPECT_NEAR(end.position_m.x(), planar.x_m, kRounding);
    EXPECT_NEAR(end.position_m.y(), planar.y_m, kRounding);
    EXPECT_EQ(end.position_m.z(), 0.0);
    EXPECT_NEAR(rotation_vector(end.rotation).z(), angle, kRounding);
  }
}

TEST(SpacePose, RotationVectorsGoThereAndBackAndDoNotMindSigns) {
  RandomStream random(1, 2);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d omega = random_vector(random, 1.7);
    const Eigen::Quaterniond rotation = rotation_of_vector(omega);
    EXPECT_LT((rotation_vector(rotation) - omega).norm(), 1e-10);
    const Eigen::Quaterniond flipped(-rotation.w(), -rotation.x(), -rotation.y(), -rotation.z());
    EXPECT_LT((rotation_vector(flipped) - omega).norm(), 1e-10);
  }
}

TEST(SpacePose, ComposeUndoesBetween) {
  RandomStream random(1, 3);
  for (int i = 0; i < 20; ++i) {
    const SpacePose a{random_vector(random, 1.0), rotation_of_vector(random_vector(random, 1.7))};
    const SpacePose b{random_vector(random, 1.0), rotation_of_vector(random_vector(random, 1.7))};
    const SpacePose again = compose(a, between(a, b));
    EXPECT_LT((again.position_m - b.position_m).norm(), kRounding);
    EXPECT_LT(again.rotation.angularDistance(b.rotation), 1e-7);
    const SpacePose through = step_of_gap(gap_numbers_of(between(a, b)));
    EXPECT_LT((compose(a, through).position_m - b.position_m).norm(), kRounding);
  }
}

TEST(SpacePose, SignsAreMadeContinuousAndRotationsStay) {
  RandomStream random(1, 5);
  constexpr int kPlates = 4;
  Eigen::MatrixXd frames(50, kSpacePoseSize * kPlates);
  for (Eigen::Index t = 0; t < frames.rows(); ++t) {
    SpacePose pose;
    for (int plate = 0; plate < kPlates; ++plate) {
      // Turns by up to 6 rad in all: w changes its sign on the way.
      frames.row(t).segment<kSpacePoseSize>(kSpacePoseSize * plate) = numbers_of(pose).transpose();
      const Eigen::Vector3d turn(0.0, 2.0 * std::sin(0.1 * double(t)), 0.3);
      pose = compose(pose, element(0.1, turn));
    }
  }
  Eigen::MatrixXd flipped = frames;
  for (Eigen::Index t = 0; t < frames.rows(); ++t) {
    for (int plate = 0; plate < kPlates; ++plate) {
      flipped.row(t).segment<4>(kSpacePoseSize * plate + 3) *= random.uniform(-1, 1) < 0 ? -1 : 1;
    }
  }
  EXPECT_NE(flipped, frames);
  make_signs_continuous(flipped);
  EXPECT_EQ(flipped, frames);
  make_signs_continuous(frames);
  EXPECT_EQ(flipped, frames);
}

}  // namespace
}  // namespace limber
