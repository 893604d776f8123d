#include "limber/world/environment.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/common/yaml_reader.hpp"
#include "planning/random_shapes.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const char* const kGood =
    "schema: limber/environment/1\n"
    "name: gap in a wall\n"
    "obstacles:\n"
    "  - circle: {x_m: 0.45, y_m: 0.22, radius_m: 0.06}\n"
    "  - rectangle: {x_m: 0.5, y_m: -0.3, width_m: 0.04, height_m: 0.3, angle_rad: 0.5}\n"
    "  - polygon: [[0.1, 0.3], [0.2, 0.3], [0.15, 0.4]]\n"
    "start: rest\n"
    "goal: {x_m: 0.5, y_m: 0.3, theta_rad: 1.2, position_tolerance_m: 0.02, "
    "orientation_tolerance_rad: 0.25}\n";

Environment read(const std::string& text) {
  return read_environment(YamlReader::from_text(text, "e.yaml"));
}

std::string with(const std::string& from, const std::string& to) {
  std::string text = kGood;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void expect_refused(const std::string& text, const std::string& place, const std::string& what) {
  EXPECT_THAT([&] { read(text); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(place), HasSubstr(what))))
      << text;
}

TEST(Environment, ReadsEveryKindOfObstacle) {
  const Environment e = read(kGood);
  EXPECT_EQ(e.name, "gap in a wall");
  ASSERT_EQ(e.obstacles.size(), 3U);
  EXPECT_EQ(std::get<Circle>(e.obstacles[0]).radius_m, 0.06);
  EXPECT_EQ(std::get<Rectangle>(e.obstacles[1]).angle_rad, 0.5);
  EXPECT_EQ(std::get<Polygon>(e.obstacles[2]).points_m[2], Eigen::Vector2d(0.15, 0.4));
  EXPECT_FALSE(e.start);
  EXPECT_EQ(e.goal.theta_rad, 1.2);
  EXPECT_EQ(e.goal.orientation_tolerance_rad, 0.25);
}

TEST(Environment, OrientationIsOptionalAndItsToleranceHasADefault) {
  EXPECT_FALSE(read(with("theta_rad: 1.2, position_tolerance_m: "
                         "0.02, orientation_tolerance_rad: 0.25",
                         "position_tolerance_m: 0.02"))
                   .goal.theta_rad);
  EXPECT_EQ(read(with(", orientation_tolerance_rad: 0.25", "")).goal.orientation_tolerance_rad,
            0.3);
  EXPECT_EQ(PoseGoal().orientation_tolerance_rad, 0.3) << "as in files";
}

TEST(Environment, SurvivesWritingAndReadingExactly) {
  const ArmDescription arm = three_segment_arm();
  RandomStream random(3, 0);
  for (int trial = 0; trial < 20; ++trial) {
    Environment e;
    e.name = "odd \"name\": [" + std::to_string(trial) + "]";
    for (int k = 0; k < trial % 5; ++k) {
      e.obstacles.push_back(random_obstacle(random));
    }
    if (trial % 2 == 1) {
      const Pressures q = random_pressures(arm, random);
      e.start = ArmStart{q, no_load_backbone(NoLoadModel(arm), q)};
      for (int k = 0; k < trial % 4; ++k) {  // in motion
        e.start->setpoints_kpa.push_back(random_pressures(arm, random));
        e.start->before = no_load_backbone(NoLoadModel(arm), random_pressures(arm, random));
      }
    }
    e.goal = {random.uniform(), random.uniform(), std::nullopt, random.uniform(0.001, 0.1), 0.3};
    if (trial % 3 == 0) {
      e.goal.theta_rad = random.uniform(-3.0, 3.0);
      e.goal.orientation_tolerance_rad = random.uniform(0.1, 1.0);
    }
    const std::string text = environment_to_yaml(e);
    const Environment again = read_environment(YamlReader::from_text(text, "e.yaml"), arm);
    EXPECT_EQ(again.name, e.name);
    EXPECT_EQ(environment_to_yaml(again), text);
    EXPECT_EQ(environment_hash(again), environment_hash(e));
    EXPECT_EQ(again.goal.x_m, e.goal.x_m);
    ASSERT_EQ(again.start.has_value(), e.start.has_value());
    if (e.start) {
      EXPECT_EQ(again.start->backbone, e.start->backbone);
      EXPECT_EQ(again.start->before, e.start->before);
      EXPECT_EQ(again.start->pressures_kpa, e.start->pressures_kpa);
      EXPECT_EQ(again.start->setpoints_kpa, e.start->setpoints_kpa);
    }
  }
}

TEST(Environment, HashTellsContentAndIgnoresTheName) {
  const std::string hash = environment_hash(read(kGood));
  EXPECT_EQ(environment_hash(read(with("gap in a wall", "other"))), hash);
  EXPECT_NE(environment_hash(read(with("radius_m: 0.06", "radius_m: 0.0600001"))), hash);
  EXPECT_NE(environment_hash(read(with("x_m: 0.5, y_m: 0.3,", "x_m: 0.5, y_m: 0.31,"))), hash);
}

TEST(Environment, NamesPlaceFoundAndAllowedOfEveryBrokenNumber) {
  expect_refused(with("radius_m: 0.06", "radius_m: -0.06"),
                 "e.yaml:4: obstacles[0].circle.radius_m: ", "-0.06 found; expected a radius");
  expect_refused(with("radius_m: 0.06", "radius_m: 0"), "obstacles[0].circle.radius_m", "> 0");
  expect_refused(with("radius_m: 0.06", "radius_m: .nan"), "obstacles[0].circle.radius_m",
                 "finite");
  expect_refused(with("radius_m: 0.06", "radius_m: 6 cm"), "obstacles[0].circle.radius_m", "6 cm");
  expect_refused(with(", radius_m: 0.06", ""), "e.yaml:4: obstacles[0].circle",
                 "'radius_m' is missing");
  expect_refused(with("radius_m: 0.06", "radius: 0.06"), "obstacles[0].circle.radius",
                 "unknown key");
  expect_refused(with("width_m: 0.04", "width_m: 1e999"), "e.yaml:5: obstacles[1].rectangle",
                 "finite");
  expect_refused(with("x_m: 0.45", "x_m: 4500"), "obstacles[0].circle.x_m", "-1000 to 1000");
  expect_refused(with("position_tolerance_m: 0.02", "position_tolerance_m: 0"),
                 "e.yaml:8: goal.position_tolerance_m", "> 0");
  expect_refused(with("theta_rad: 1.2, ", ""), "goal.orientation_tolerance_rad",
                 "without theta_rad");
}

TEST(Environment, RefusesPolygonsThatAreNotSimple) {
  const auto polygon = [](const std::string& points) {
    return with("[[0.1, 0.3], [0.2, 0.3], [0.15, 0.4]]", points);
  };
  const std::string place = "e.yaml:6: obstacles[2].polygon";
  expect_refused(polygon("[[0, 0], [1, 0]]"), place, "2 points found; expected 3");
  expect_refused(polygon("[[0, 0], [1, 1], [1, 0], [0, 1]]"), place,
                 "edges 0–1 and 2–3 cross or touch");
  expect_refused(polygon("[[0, 0], [1, 0], [2, 0]]"), place, "runs back over");
  expect_refused(polygon("[[0, 0], [1, 0], [1, 0], [0, 1]]"), place, "points 1 and 2 are the same");
  expect_refused(polygon("[[0, 0], [2, 0], [2, 1], [1, 0], [0, 1]]"), place, "cross or touch");
  expect_refused(polygon("[[0, 0], [1, 0], [0.5]]"), place + "[2]", "1 numbers found");
  EXPECT_NO_THROW(read(polygon("[[0, 0], [1, 0], [1, 1], [0.5, 0.2], [0, 1]]")));
  EXPECT_NO_THROW(read(polygon("[[0, 0], [0.5, 0], [1, 0], [1, 1]]"))) << "a corner of 180°";
}

TEST(Environment, RefusesMoreCornersThanItLooksAtInSeconds) {
  // One polygon of 1000 corners, named 101 times over.
  std::string corners;
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 1000.0;
    corners += fmt::format("[{:.6f}, {:.6f}], ", 5.0 + std::cos(angle), std::sin(angle));
  }
  std::string obstacles = "obstacles:\n  - polygon: &p [" + corners + "]\n";
  for (int i = 0; i < 100; ++i) {
    obstacles += "  - polygon: *p\n";
  }
  expect_refused(with("obstacles:\n", obstacles), "obstacles[100]", "more than 100000 corners");
}

TEST(Environment, RefusesBrokenStructure) {
  expect_refused(with("limber/environment/1", "limber/environment/9"), "e.yaml:1: schema",
                 "this program reads");
  expect_refused(with("- circle:", "- sphere:"), "obstacles[0].sphere", "unknown key");
  expect_refused(with("start: rest", "start: sleep"), "e.yaml:7: start", "'sleep' found");
  expect_refused(with("start: rest\n", ""), "e.yaml", "'start' is missing");
  expect_refused(with("goal: {", "target: {"), "target", "unknown key");
  expect_refused(with("obstacles:\n", "obstacles: 3\nmore:\n"), "e.yaml:5: more", "unknown key");
  expect_refused("", "e.yaml:1", "an empty file");
}

TEST(Environment, RefusesAStartThatDoesNotFitTheArm) {
  const ArmDescription arm = three_segment_arm();
  Environment e = read(kGood);
  const Pressures q = Pressures::Constant(3, 20.0F);
  const Backbone b = no_load_backbone(NoLoadModel(arm), q);
  const auto refusal = [&](const Pressures& pressures, const Backbone& backbone) {
    e.start = ArmStart{pressures, backbone};
    try {
      read_environment(YamlReader::from_text(environment_to_yaml(e), "e.yaml"), arm);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing refused");
  };
  EXPECT_EQ(refusal(q, b), "nothing refused");
  EXPECT_THAT(refusal(Pressures::Zero(2), b),
              AllOf(HasSubstr("start.pressures_kpa"), HasSubstr("2 pressures found; expected 3")));
  EXPECT_THAT(refusal(q * 6.0F, b), AllOf(HasSubstr("start.pressures_kpa[0]"),
                                          HasSubstr("120 kPa found; expected ± 100")));
  EXPECT_THAT(refusal(q, b.topRows(12)), AllOf(HasSubstr("e.yaml:9: start.backbone"),
                                               HasSubstr("12 poses found; expected 16")));
  EXPECT_THAT(refusal(q, b * 100.0F), HasSubstr("poses are in metres"));
  EXPECT_THAT(refusal(q, Backbone::Zero(16, 3)),
              AllOf(HasSubstr("e.yaml:9: start.backbone[1]"),
                    HasSubstr("plate 1 is 0 m from plate 0; expected 0.0235 to 0.0705 m")));
}

TEST(Environment, SetPointsOfAStartInMotionFitTheArmAndCountInTheHash) {
  const ArmDescription arm = three_segment_arm();
  Environment e = read(kGood);
  const Pressures q = Pressures::Constant(3, 20.0F);
  e.start = ArmStart{q, no_load_backbone(NoLoadModel(arm), q)};
  const std::string at_rest = environment_hash(e);
  EXPECT_EQ(e.start->setpoint_kpa(), q);
  e.start->setpoints_kpa = {q * 1.5F};
  EXPECT_NE(environment_hash(e), at_rest);
  EXPECT_EQ(e.start->setpoint_kpa(), q * 1.5F);
  e.start->setpoints_kpa = {q, q * 6.0F};
  const auto reading = [&] {
    (void)read_environment(YamlReader::from_text(environment_to_yaml(e), "e.yaml"), arm);
  };
  EXPECT_THAT(reading,
              ThrowsMessage<InputError>(AllOf(HasSubstr("start.setpoints_kpa[1][0]"),
                                              HasSubstr("120 kPa found; expected ± 100"))));
  e.start->setpoints_kpa = {Pressures::Zero(2)};
  EXPECT_THAT(reading, ThrowsMessage<InputError>(AllOf(HasSubstr("start.setpoints_kpa[0]"),
                                                       HasSubstr("2 pressures found"))));
}

// Valves overshoot: what is measured in motion may lie 5 % of a segment's range beyond its limits.
TEST(Environment, AStartInMotionAsMeasuredIsReadAsItWasWritten) {
  const ArmDescription arm = three_segment_arm();
  Environment e = read(kGood);
  const auto again = [&] {
    return read_environment(YamlReader::from_text(environment_to_yaml(e), "e.yaml"), arm);
  };
  const Pressures at_limit = Pressures::Constant(3, 100.0F);
  e.start = ArmStart{at_limit * 1.095F, no_load_backbone(NoLoadModel(arm), at_limit), {at_limit}};
  EXPECT_EQ(again().start->pressures_kpa, e.start->pressures_kpa);
  EXPECT_EQ(environment_hash(again()), environment_hash(e));
  e.start->pressures_kpa = at_limit * 1.105F;
  EXPECT_THAT(again, ThrowsMessage<InputError>(AllOf(
                         HasSubstr("start.pressures_kpa[0]"),
                         HasSubstr("found; expected ± 110 kPa, the limits of that segment and 5 % "
                                   "of their range for overshoot"))));
  e.start->pressures_kpa = at_limit * 1.095F;
  e.start->setpoints_kpa.clear();
  EXPECT_THAT(again,
              ThrowsMessage<InputError>(AllOf(HasSubstr("start.pressures_kpa[0]"),
                                              HasSubstr("expected ± 100 kPa, the limits of"))));
}

TEST(Environment, ShapeBeforeAStartInMotionFitsTheArmAndCountsInTheHash) {
  const ArmDescription arm = three_segment_arm();
  Environment e = read(kGood);
  const Pressures q = Pressures::Constant(3, 20.0F);
  e.start = ArmStart{q, no_load_backbone(NoLoadModel(arm), q)};
  const std::string at_rest = environment_hash(e);
  e.start->before = e.start->backbone;
  e.start->before(15, 0) += 0.01F;
  EXPECT_NE(environment_hash(e), at_rest);
  e.start->before = Backbone::Zero(15, 3);
  EXPECT_THAT(
      [&] { (void)read_environment(YamlReader::from_text(environment_to_yaml(e), "e.yaml"), arm); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("start.backbone_before"),
                                      HasSubstr("15 poses found; expected 16, one per plate"))));
}

TEST(Environment, AShapeBeforeThatNoArmHasIsRefused) {
  const ArmDescription arm = three_segment_arm();
  Environment e = read(kGood);
  const Pressures q = Pressures::Constant(3, 20.0F);
  e.start = ArmStart{q, no_load_backbone(NoLoadModel(arm), q)};
  e.start->before = Backbone::Constant(16, 3, 0.9F);
  EXPECT_THAT(
      [&] { (void)read_environment(YamlReader::from_text(environment_to_yaml(e), "e.yaml"), arm); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("start.backbone_before["), HasSubstr("plate"))));
}

TEST(Environment, AStartOfAnotherArmIsRefused) {
  const ArmDescription arm = three_segment_arm();
  Environment e = read(kGood);
  e.start = ArmStart{Pressures::Zero(3), Backbone::Zero(2, 3)};
  EXPECT_THAT([&] { (void)start_state(e, arm); },
              ThrowsMessage<InputError>(HasSubstr("start.backbone: 2 found; expected 16")));
  e.start = ArmStart{Pressures::Zero(2), Backbone::Zero(16, 3)};
  EXPECT_THAT([&] { (void)start_state(e, arm); },
              ThrowsMessage<InputError>(HasSubstr("start.pressures_kpa: 2 found; expected 3")));
}

// Of an arm that is driven by angles, nothing has to be called kPa. Old files are still read.
TEST(Environment, AStartMayNameItsCommandsWithoutAUnit) {
  const ArmDescription arm = three_segment_arm();
  Environment e = read(kGood);
  const Pressures q = Pressures::Constant(3, 20.0F);
  e.start = ArmStart{q, no_load_backbone(NoLoadModel(arm), q), {q * 1.5F}};
  std::string text = environment_to_yaml(e);
  const auto rename = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  rename("pressures_kpa", "commands");
  rename("setpoints_kpa", "setpoints");
  const Environment again = read_environment(YamlReader::from_text(text, "e.yaml"), arm);
  EXPECT_EQ(again.start->pressures_kpa, q);
  EXPECT_EQ(again.start->setpoint_kpa(), q * 1.5F);
  EXPECT_EQ(environment_hash(again), environment_hash(e));
  rename("  commands:", "  pressures_kpa: [0, 0, 0]\n  commands:");
  EXPECT_THAT([&] { (void)read_environment(YamlReader::from_text(text, "e.yaml"), arm); },
              ThrowsMessage<InputError>(
                  HasSubstr("start.commands: given beside pressures_kpa; expected one of both")));
}

TEST(Environment, RefusesABrokenNumberInAnyPlaceOfAStartingPose) {
  for (const char* pose : {"[x, 0, 0]", "[0, .nan, 0]", "[0, 0, 1e9]", "[5000, 0, 0]"}) {
    expect_refused(with("start: rest", std::string("start: {pressures_kpa: [0, "
                                                   "0, 0], backbone: [[0, 0, 0], ") +
                                           pose + "]}"),
                   "e.yaml:7: start.backbone[1]", "found; expected");
  }
}

TEST(Environment, RestIsTheStraightUnpressurisedArm) {
  const ArmDescription arm = three_segment_arm();
  const ArmStart start = start_state(read(kGood), arm);
  const Backbone straight = no_load_backbone(NoLoadModel(arm), Pressures::Zero(3));
  constexpr float kFloatM = 1e-6F;
  EXPECT_LT((start.backbone - straight).cwiseAbs().maxCoeff(), kFloatM);
  EXPECT_TRUE(start.pressures_kpa.isZero());
}

}  // namespace
}  // namespace limber
