// Laws of the world for arms and environments drawn by a number.
#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/error.hpp"
#include "limber/world/collision.hpp"
#include "limber/world/inverse_kinematics.hpp"
#include "planning/dense_oracle.hpp"
#include "support/drawn_environment.hpp"
#include "support/property.hpp"

namespace limber {
namespace {

constexpr double kRoundingM = 1e-9;  // of geometry in double precision
constexpr double kMovedM = 2e-4;     // two bounds, each so near the true clearance where it is < 0
constexpr double kFloatM = 1e-5;     // float32 shapes of arms of 2 m
constexpr double kReachedM = 1e-6;   // Newton's 1e-10 m through the command's inverse

struct Drawn {
  RandomStream random;
  ArmDescription arm;
  Environment environment;

  explicit Drawn(std::uint64_t number)
      : random(number, 0),
        arm(drawn::arm(number, random)),
        environment(drawn::environment(number, arm, random)) {}

  BackboneD shape(const Pressures& kpa) const {
    BackboneD shape(arm.point_count(), kPoseSize);
    NoLoadModel(arm).backbone(Eigen::VectorXd(kpa.cast<double>()), shape);
    return shape;
  }
};

/// The obstacle turned about the base, then shifted, then mirrored if asked for.
Obstacle moved(const Obstacle& obstacle, double turn_rad, const Eigen::Vector2d& shift,
               bool mirror) {
  const double side = mirror ? -1.0 : 1.0;
  const auto point = [&](double x, double y) {
    const Eigen::Vector2d p = Eigen::Rotation2Dd(turn_rad) * Eigen::Vector2d(x, y) + shift;
    return Eigen::Vector2d(p.x(), side * p.y());
  };
  if (const auto* circle = std::get_if<Circle>(&obstacle)) {
    const Eigen::Vector2d centre = point(circle->x_m, circle->y_m);
    return Circle{centre.x(), centre.y(), circle->radius_m};
  }
  if (const auto* r = std::get_if<Rectangle>(&obstacle)) {
    const Eigen::Vector2d centre = point(r->x_m, r->y_m);
    return Rectangle{centre.x(), centre.y(), r->width_m, r->height_m,
                     side * (r->angle_rad + turn_rad)};
  }
  Polygon polygon = std::get<Polygon>(obstacle);
  for (Eigen::Vector2d& corner : polygon.points_m) {
    corner = point(corner.x(), corner.y());
  }
  return polygon;
}

TEST(DrawnEnvironments, FilesComeBackExactly) {
  expect_law("an environment that is written and read is the environment", [] {
    const Drawn drawn(drawn_number());
    const std::string text = environment_to_yaml(drawn.environment);
    const Environment again =
        read_environment(YamlReader::from_text(text, "again.yaml"), drawn.arm);
    RC_ASSERT(environment_to_yaml(again) == text);
    RC_ASSERT(environment_hash(again) == environment_hash(drawn.environment));
  });
}

// Nothing about the world's axes is special: not left or right, not where the base lies.
TEST(DrawnEnvironments, ClearanceDoesNotChangeWhereArmAndObstaclesMoveTogether) {
  expect_law("clearance is that of the arm beside the obstacles", [] {
    Drawn drawn(drawn_number());
    const double turn_rad = drawn.random.uniform(-3.0, 3.0);
    const Eigen::Vector2d shift(drawn.random.uniform(-1.0, 1.0), drawn.random.uniform(-1.0, 1.0));
    const bool mirror = *rc::gen::arbitrary<bool>();
    const BackboneD shape = drawn.shape(drawn::pressures(drawn.arm, drawn.random));
    BackboneD there = shape;
    for (Eigen::Index i = 0; i < shape.rows(); ++i) {
      const Eigen::Vector2d p =
          Eigen::Rotation2Dd(turn_rad) * Eigen::Vector2d(shape(i, 0), shape(i, 1)) + shift;
      there.row(i) << p.x(), p.y(), shape(i, 2) + turn_rad;
    }
    if (mirror) {
      there.rightCols<2>() *= -1.0;
    }
    std::vector<Obstacle> obstacles;
    for (const Obstacle& obstacle : drawn.environment.obstacles) {
      obstacles.push_back(moved(obstacle, turn_rad, shift, mirror));
    }
    const double here_m =
        CollisionChecker(drawn.arm, drawn.environment.obstacles).clearance(shape).value_m;
    const double there_m = CollisionChecker(drawn.arm, obstacles).clearance(there).value_m;
    RC_ASSERT(here_m == there_m ||
              std::abs(here_m - there_m) <= (here_m > 0.0 ? kRoundingM : kMovedM));
  });
}

// What planners go by is never more than what brute force finds at any moment.
TEST(DrawnEnvironments, ClearanceOfAMotionIsNoMoreThanThatOfAnyInstant) {
  constexpr int kSamplesPerGap = 4;
  constexpr int kSlower = 5;
  expect_law(
      "a motion's clearance is a bound from below",
      [] {
        Drawn drawn(drawn_number());
        const std::vector<Obstacle>& obstacles = drawn.environment.obstacles;
        RC_PRE(!obstacles.empty());
        const Pressures kpa = drawn::pressures(drawn.arm, drawn.random);
        const Backbone from = drawn.shape(kpa).cast<float>();
        const Backbone to =
            drawn.shape(kpa + 0.1F * (drawn::pressures(drawn.arm, drawn.random) - kpa))
                .cast<float>();
        double sampled_m = std::numeric_limits<double>::infinity();
        for (const float t : {0.0F, float(drawn.random.uniform()), 1.0F}) {
          const Backbone now = (1.0F - t) * from + t * to;
          sampled_m =
              std::min(sampled_m, oracle::clearance(drawn.arm, now, obstacles, kSamplesPerGap));
        }
        const CollisionChecker checker(drawn.arm, obstacles);
        RC_ASSERT(checker.motion_clearance(from, to).value_m <= std::max(sampled_m, 0.0) + kFloatM);
        RC_ASSERT(!checker.is_motion_free(from, to) || sampled_m >= -kFloatM);
      },
      kSlower);
}

TEST(DrawnEnvironments, OfArmsInSpaceAreRefusedByName) {
  expect_law("an environment is of an arm in the plane", [] {
    const std::uint64_t number = drawn_number();
    RandomStream random(number, 0);
    const std::string text = environment_to_yaml(Drawn(number).environment);
    const ArmDescription arm = drawn::space_arm(number, random);
    std::string said = "accepted";
    try {
      (void)read_environment(YamlReader::from_text(text, "e.yaml"), arm);
    } catch (const InputError& error) {
      said = error.what();
    }
    RC_ASSERT(said.find("an environment can't use an arm in space yet, and '" + arm.name) !=
              std::string::npos);
  });
}

TEST(DrawnEnvironments, InverseKinematicsGoesBackToTheTip) {
  expect_law("some configuration is found for a tip that is reached, and it reaches it", [] {
    Drawn drawn(drawn_number());
    const Pose tip = tip_pose(drawn.shape(drawn::pressures(drawn.arm, drawn.random)));
    const PoseGoal goal{tip.x_m, tip.y_m, std::nullopt, kReachedM, 1.0};
    InverseKinematicsSettings settings;
    settings.starts = 100;
    settings.max_solutions = 2;
    const NoLoadModel model(drawn.arm);
    const auto found = solve_inverse_kinematics(model, goal, settings, drawn.random);
    RC_ASSERT(found.reachable());
    for (const Eigen::VectorXd& kpa : found.pressures_kpa) {
      RC_ASSERT(pose_error(goal, tip_pose(drawn.shape(kpa.cast<float>()))).position_m <= 1e-5);
      for (int i = 0; i < drawn.arm.segment_count(); ++i) {
        RC_ASSERT(drawn.arm.limits_of_channel(i).contains(kpa[i]));
      }
    }
  });
}

}  // namespace
}  // namespace limber
