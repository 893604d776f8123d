#include "limber/planning/certificate.hpp"

#include <chrono>
#include <cmath>
#include <complex>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <regex>
#include <thread>

#include <gmock/gmock.h>
#include <rapidcheck.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/cpu_level.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/network/untrained_model.hpp"
#include "limber/planning/certified_planner.hpp"
#include "limber/planning/obstacle_shape.hpp"
#include "limber/planning/planner.hpp"
#include "limber/planning/pressure_rrt_star.hpp"
#include "planning/dense_oracle.hpp"
#include "planning/play_model.hpp"
#include "src/planning/certificate/covered_obstacle.hpp"
#include "src/planning/certificate/exact_arm.hpp"
#include "src/planning/certificate/exact_network.hpp"
#include "src/planning/certificate/swept_clearance.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pointwise;
using ::testing::ThrowsMessage;

constexpr double kFloatModelM = 2e-6;  // float32 forward model over a 0.7 m arm, one step
constexpr double kFloatModelRad = 2e-5;

ExactArm::Shape shape_of(const Backbone& b) {
  ExactArm::Shape shape;
  for (Eigen::Index i = 0; i < b.rows(); ++i) {
    shape.push_back({double(b(i, 0)), double(b(i, 1)), double(b(i, 2))});
  }
  return shape;
}

std::vector<double> doubles(const Pressures& q) {
  return {q.begin(), q.end()};
}

/// A solved problem with a heading asked for, so that every check has work.
struct Solved {
  ArmDescription arm = three_segment_arm();
  ForwardModel model{arm, play_network(arm, 0.01F)};
  Environment environment;
  Plan plan;

  Solved() {
    environment.name = "pillars";
    environment.obstacles = {Circle{0.45, 0.22, 0.025}, Rectangle{0.6, -0.1, 0.04, 0.1, 0.3},
                             Polygon{{{0.1, 0.3}, {0.2, 0.3}, {0.15, 0.4}}}};
    environment.goal = {0.30, 0.40, 2.4, 0.02, 0.8};
    PlannerLimits limits;
    limits.iterations = 1500;
    PlanResult result = make_planner("default")->plan({arm, model, environment}, limits, 3);
    if (result.plan) {
      plan = *result.plan;
    }
  }

  Certificate certificate(const Plan& p) const {
    return certify(p, arm, &model.compensation(), {}, environment);
  }
};

const Solved& solved() {
  static const Solved s;
  return s;
}

std::vector<std::string> failed_checks(const Certificate& certificate) {
  std::vector<std::string> checks;
  for (const CertificateFailure& failure : certificate.failures) {
    checks.push_back(failure.check);
  }
  return checks;
}

TEST(ExactArm, AgreesWithTheForwardModelInEveryLayoutAndForm) {
  const ArmDescription arm = three_segment_arm();
  RandomStream random(1, 0);
  for (const auto& [layout, form] :
       {std::pair{BackboneLayout::base_poses, OutputForm::compensation},
        {BackboneLayout::base_poses, OutputForm::gated_change},
        {BackboneLayout::gap_poses, OutputForm::compensation},
        {BackboneLayout::gap_poses, OutputForm::gated_change}}) {
    const ForwardModel fast(arm, untrained_model(arm, layout, {100, 100, 100}, 5, form));
    const ExactArm exact(arm, &fast.compensation());
    const NoLoadModel no_load(arm);
    ForwardModel::Workspace workspace;
    for (int trial = 0; trial < 200; ++trial) {
      const Pressures before = random_pressures(arm, random);
      const Pressures now = random_pressures(arm, random);
      const Backbone from = no_load_backbone(no_load, random_pressures(arm, random));
      Backbone to(arm.point_count(), 3);
      fast.step(before, now, from, to, workspace);
      const ExactArm::Shape shape = exact.next(doubles(before), doubles(now), shape_of(from));
      ASSERT_EQ(shape.size(), 16U);
      for (std::size_t i = 0; i < shape.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        EXPECT_NEAR(shape[i].x_m, to(row, 0), kFloatModelM) << trial << ' ' << i;
        EXPECT_NEAR(shape[i].y_m, to(row, 1), kFloatModelM) << trial << ' ' << i;
        EXPECT_NEAR(shape[i].theta_rad, to(row, 2), kFloatModelRad) << trial << ' ' << i;
      }
    }
  }
}

// Row by row and number by number, as docs/model.md has it.
TEST(ExactNetwork, AgreesWithPlainLoopsAndToTheBitOnEveryCpu) {
  constexpr double kRounding = 1e-13;
  const ArmDescription arm = three_segment_arm();
  RandomStream random(6, 0);
  for (const int width : {1, 7, 33, 100}) {
    const CompensationModel model = untrained_model(arm, BackboneLayout::gap_poses, {width, width},
                                                    9, OutputForm::gated_change);
    ExactNetwork::Workspace workspace;
    for (std::vector<double>& input : workspace.input) {
      for (Eigen::Index k = 0; k < model.input.scale.size(); ++k) {
        input.push_back(random.uniform(-1.0, 1.0));
      }
    }
    ExactNetwork(model, CpuLevel::baseline).run(workspace);
    const auto output = workspace.output;
    for (const CpuLevel level : available_cpu_levels()) {
      ExactNetwork(model, level).run(workspace);
      EXPECT_EQ(workspace.output, output) << to_string(level);
    }
    for (std::size_t c = 0; c < 2; ++c) {
      std::vector<double> values;
      for (Eigen::Index k = 0; k < model.input.scale.size(); ++k) {
        values.push_back(
            (workspace.input[c][static_cast<std::size_t>(k)] - double(model.input.offset[k])) *
            double(model.input.scale[k]));
      }
      for (const Layer& layer : model.layers) {
        std::vector<double> next;
        for (Eigen::Index row = 0; row < layer.weight.rows(); ++row) {
          double sum = double(layer.bias[row]);
          for (Eigen::Index k = 0; k < layer.weight.cols(); ++k) {
            sum += double(layer.weight(row, k)) * values[static_cast<std::size_t>(k)];
          }
          next.push_back(&layer == &model.layers.back() ? sum : std::max(sum, 0.0));
        }
        values = next;
      }
      for (Eigen::Index k = 0; k < model.output.scale.size(); ++k) {
        double& value = values[static_cast<std::size_t>(k)];
        value = value / double(model.output.scale[k]) + double(model.output.offset[k]);
      }
      EXPECT_THAT(output[c], Pointwise(DoubleNear(kRounding), values)) << width;
    }
  }
}

TEST(SweptClearance, AgreesWithDenseSamplingInSpaceAndTime) {
  constexpr double kToleranceM = 1e-4;
  constexpr int kSamplesPerGap = 13;
  constexpr int kInstants = 12;
  const ArmDescription arm = three_segment_arm();
  const NoLoadModel model(arm);
  RandomStream random(2, 0);
  int touching = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Pressures q = random_pressures(arm, random);
    Pressures next = q;
    for (int i = 0; i < 3; ++i) {
      next[i] += static_cast<float>(random.uniform(-10.0, 10.0));
    }
    const Backbone from = no_load_backbone(model, q);
    const Backbone to = no_load_backbone(model, next);
    const std::vector<Obstacle> obstacles{random_obstacle(random), random_obstacle(random)};
    double sampled = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= kInstants; ++k) {
      const float t = float(k) / kInstants;
      sampled = std::min(
          sampled, oracle::clearance(arm, (1.0F - t) * from + t * to, obstacles, kSamplesPerGap));
    }
    const SweptClearance::Result found =
        SweptClearance(arm, obstacles, kToleranceM).over({shape_of(from), shape_of(to)});
    const double way = (to - from).leftCols<2>().cast<double>().rowwise().norm().maxCoeff();
    const double spacing = 0.047 / (kSamplesPerGap - 1) + way / kInstants;
    constexpr double kFloatM = 1e-6;
    EXPECT_LE(found.value_m, sampled + kFloatM) << trial;
    EXPECT_GE(found.value_m, sampled - spacing / 2 - kToleranceM - kFloatM) << trial;
    touching += sampled < 0.0 ? 1 : 0;
  }
  EXPECT_GT(touching, 3);
  EXPECT_LT(touching, 17);
}

/// A star about the origin, whose outline the ray from a point meets many times.
Polygon star(int corners, double inner_m, double outer_m) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    const double radius = i % 2 == 0 ? outer_m : inner_m;
    polygon.points_m.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

// Boxes over edges only say where not to look: the distance is that over all edges.
TEST(SweptClearance, DistanceToAnOutlineIsThatOverAllItsEdges) {
  constexpr double kRoundingM = 1e-12;
  RandomStream random(3, 0);
  for (const int corners : {4, 16, 18, 34, 1000}) {
    const Polygon polygon = star(corners, 0.05, 0.15);
    const PolygonOutline outline(polygon);
    const ObstacleShape slow = make_obstacle_shape(polygon, 0);
    int inside = 0;
    for (int trial = 0; trial < 300; ++trial) {
      const Eigen::Vector2d p(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
      const double expected = signed_distance(slow, p);
      EXPECT_NEAR(outline.distance_m({p.x(), p.y()}), expected, kRoundingM) << corners;
      inside += expected < 0.0 ? 1 : 0;
    }
    EXPECT_GT(inside, 10);
    EXPECT_LT(inside, 200);
  }
}

/// Simple, not convex, and as ragged as its corners are many.
Polygon ragged_polygon(int corners, RandomStream& random) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + random.uniform(0.0, 0.9)) / corners;
    const double radius = 0.1 + 0.04 * std::sin(3.0 * angle) + random.uniform(0.0, 0.03);
    polygon.points_m.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

/// All edges, one by one: distance to the outline, negative where a ray meets it an odd number of
/// times.
double brute_force_distance(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d ab = corners[(i + 1) % corners.size()] - a;
    const double along = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - along * ab).norm());
    const double height = p.y() - a.y();
    if ((height < 0.0) != (height < ab.y()) && p.x() < a.x() + ab.x() * height / ab.y()) {
      inside = !inside;
    }
  }
  return inside ? -nearest : nearest;
}

TEST(PolygonOutline, AThousandRandomCornersAreReadAsByBruteForce) {
  constexpr double kRoundingM = 1e-12;
  RandomStream random(4, 0);
  int inside = 0;
  for (int trial = 0; trial < 20; ++trial) {
    Polygon polygon = ragged_polygon(1000, random);
    if (trial % 2 == 0) {
      std::reverse(polygon.points_m.begin(), polygon.points_m.end());
    }
    const PolygonOutline outline(polygon);
    EXPECT_FALSE(outline.is_convex());
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector2d p(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
      const double expected = brute_force_distance(polygon.points_m, p);
      EXPECT_NEAR(outline.distance_m({p.x(), p.y()}), expected, kRoundingM) << trial << ' ' << i;
      inside += expected < 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 500);
  EXPECT_LT(inside, 3500);
}

// The bound that convex obstacles are skipped by: from any point to any other, inside or outside.
TEST(CoveredObstacle, AConvexOneLiesBehindAStraightLine) {
  constexpr double kRoundingM = 1e-12;
  RandomStream random(5, 0);
  Polygon round;
  for (int i = 0; i < 50; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 50;
    round.points_m.emplace_back(0.1 * std::cos(angle), 0.07 * std::sin(angle));
  }
  Polygon reversed = round;
  std::reverse(reversed.points_m.begin(), reversed.points_m.end());
  EXPECT_TRUE(PolygonOutline(round).is_convex());
  EXPECT_TRUE(PolygonOutline(reversed).is_convex());
  // A pentagram turns to one side only, but twice.
  Polygon pentagram;
  for (int i = 0; i < 5; ++i) {
    const double angle = 4.0 * std::numbers::pi * i / 5;
    pentagram.points_m.emplace_back(0.1 * std::cos(angle), 0.1 * std::sin(angle));
  }
  EXPECT_FALSE(PolygonOutline(pentagram).is_convex());
  for (const Obstacle& obstacle :
       {Obstacle(Circle{0.01, 0.02, 0.08}), Obstacle(Rectangle{0.02, -0.01, 0.15, 0.06, 0.7}),
        Obstacle(round), Obstacle(reversed)}) {
    const CoveredObstacle covered(obstacle);
    for (int i = 0; i < 2000; ++i) {
      const std::complex<double> p(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
      const std::complex<double> q(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
      const Reading reading = covered.read(p);
      ASSERT_NEAR(std::abs(reading.away), 1.0, kRoundingM);
      const double bound = reading.distance_m + ((q - p) * std::conj(reading.away)).real();
      EXPECT_GE(covered.read(q).distance_m, bound - kRoundingM) << obstacle_kind(obstacle);
    }
  }
}

/// Sweeps for a second or more, and is sent a signal soon after it began.
[[noreturn]] void sweep_with_signal() {
  constexpr auto kSoon = std::chrono::milliseconds(50);
  const ArmDescription arm = three_segment_arm();
  const ExactArm::Shape shape =
      shape_of(no_load_backbone(NoLoadModel(arm), Pressures::Constant(3, 20.0F)));
  const std::vector<Obstacle> obstacles(300, star(1000, 0.05, 0.15));
  const SweptClearance sweep(arm, obstacles, Certificate::kClearanceToleranceM);
  const std::vector<ExactArm::Shape> shapes(20'000, shape);
  install_interrupt_handler();
  std::thread([kSoon] {
    std::this_thread::sleep_for(kSoon);
    (void)std::raise(SIGINT);
  }).detach();
  try {
    (void)sweep.over(shapes);
  } catch (const Interrupted&) {
    // Asked again by one who knows of the signal: done to its end.
    std::_Exit(std::isfinite(sweep.over({shape}).value_m) ? 0 : 2);
  }
  std::_Exit(3);
}

// In a process of its own, for the signal's flag stays set.
TEST(SweptClearanceDeathTest, StopsOnASignalThatComesMeanwhileAndOnlyThen) {
  EXPECT_EXIT(sweep_with_signal(), ::testing::ExitedWithCode(0), "");
}

TEST(Certificate, APlannersPlanIsCertifiedWithRoomToSpare) {
  const Solved& s = solved();
  ASSERT_FALSE(s.plan.frames.empty()) << "not solved";
  const Certificate certificate = s.certificate(s.plan);
  EXPECT_THAT(failed_checks(certificate), IsEmpty());
  EXPECT_LT(certificate.largest_deviation_m, Certificate::kDeviationM / 5);
  EXPECT_GE(certificate.clearance_m, Certificate::kLeastClearanceM);
  EXPECT_NEAR(certificate.goal_distance_m, s.plan.goal_distance_m, Certificate::kDeviationM);
  EXPECT_NEAR(certificate.cost_kpa, s.plan.cost_kpa, 1e-9 * s.plan.cost_kpa);
  ASSERT_TRUE(s.plan.certified);
  EXPECT_EQ(s.plan.certified->clearance_m, certificate.clearance_m);
}

TEST(Certificate, ANoLoadPlanIsCertifiedToo) {
  const Solved& s = solved();
  const ForwardModel model(s.arm);
  PlannerLimits limits;
  limits.iterations = 1500;
  Environment environment = s.environment;
  environment.goal.theta_rad.reset();
  const PlanResult result = make_planner("paper")->plan({s.arm, model, environment}, limits, 3);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(certify(*result.plan, s.arm, nullptr, {}, environment).certified());
}

// Each way of changing a plan by hand, and the check that must notice it.
TEST(Certificate, RefusesAPlanChangedByHandInAnyField) {
  const Solved& s = solved();
  ASSERT_FALSE(s.plan.frames.empty());
  const struct {
    const char* check;
    std::function<void(Plan&)> change;
  } cases[] = {
      {"waypoints", [](Plan& p) { p.frames[5].setpoint_kpa[1] += 0.01F; }},
      {"start", [](Plan& p) { p.frames[0].setpoint_kpa[0] += 0.01F; }},
      {"rate", [](Plan& p) { p.frames[5].setpoint_kpa[1] += 20.0F; }},
      {"limits", [](Plan& p) { p.frames.back().setpoint_kpa[0] = 101.0F; }},
      {"hold", [](Plan& p) { p.frames.back().setpoint_kpa[2] += 1e-4F; }},
      {"hold", [](Plan& p) { p.hold_frame_count = 5; }},
      {"model", [](Plan& p) { p.frames[7].backbone(9, 0) += 2e-4F; }},
      {"model", [](Plan& p) { p.frames[0].backbone(15, 1) -= 2e-4F; }},
      {"model", [](Plan& p) { p.frames.back().backbone(3, 2) += 2e-3F; }},
      {"cost", [](Plan& p) { p.cost_kpa -= 0.01; }},
      {"waypoints", [](Plan& p) { p.waypoints_kpa[1][0] += 0.01F; }},
      {"waypoints", [](Plan& p) { p.waypoints_kpa.pop_back(); }},
      {"waypoints", [](Plan& p) { p.waypoints_kpa.push_back(p.waypoints_kpa.back()); }},
      {"waypoints", [](Plan& p) { p.frames.erase(p.frames.begin() + 6); }},
      {"model",
       [](Plan& p) {
         p.frames.pop_back();
         p.frames.back().backbone.setZero();
       }},
      {"valves", [](Plan& p) { p.frames[6].pressure_kpa[1] += 2e-3F; }},
      {"claims", [](Plan& p) { p.clearance_m += 0.01; }},
      {"claims", [](Plan& p) { p.goal_distance_m -= 0.001; }},
      {"claims", [](Plan& p) { p.goal_orientation_rad += 0.01; }},
      {"collision", [](Plan& p) { p.margin_m = p.clearance_m + 0.002; }},
      {"sizes", [](Plan& p) { p.frame_rate_hz = 40.0; }},
      {"sizes", [](Plan& p) { p.frames[4].setpoint_kpa.conservativeResize(2); }},
      {"seal", [](Plan& p) { p.certified->seal_is_intact = false; }},
  };
  for (std::size_t i = 0; i < std::size(cases); ++i) {
    Plan changed = s.plan;
    cases[i].change(changed);
    EXPECT_THAT(failed_checks(s.certificate(changed)), Contains(cases[i].check)) << "case " << i;
  }
}

TEST(Certificate, RandomPerturbationsOfAnyFrameAreRefused) {
  ASSERT_FALSE(solved().plan.frames.empty());
  ::setenv("RC_PARAMS", "seed=20 max_success=150", 1);
  const bool held = rc::check("a perturbed plan is refused", [] {
    const Solved& s = solved();
    Plan changed = s.plan;
    const auto k = *rc::gen::inRange<std::size_t>(0, changed.frames.size());
    const bool of_backbone = *rc::gen::arbitrary<bool>();
    const float sign = *rc::gen::element(-1.0F, 1.0F);
    // Hundredths above what the certificate lets pass, evenly in the logarithm.
    const float size = std::pow(10.0F, 0.01F * float(*rc::gen::inRange(0, 300)));
    if (of_backbone) {
      const auto entry = *rc::gen::inRange<Eigen::Index>(0, changed.frames[k].backbone.size());
      changed.frames[k].backbone.data()[entry] +=
          sign * size * (entry % 3 == 2 ? 1.3e-3F : 1.3e-4F);
    } else {
      const auto i = *rc::gen::inRange<Eigen::Index>(0, 3);
      changed.frames[k].setpoint_kpa[i] += sign * size * 3e-4F;
    }
    RC_ASSERT(!s.certificate(changed).certified());
  });
  EXPECT_TRUE(held);
}

TEST(Certificate, CollisionsAndMissedGoalsAreNamedWithPlateObstacleAndAmount) {
  const Solved& s = solved();
  ASSERT_FALSE(s.plan.frames.empty());
  Environment environment = s.environment;
  const Backbone& last = s.plan.frames.back().backbone;
  environment.obstacles.push_back(Circle{double(last(12, 0)), double(last(12, 1)), 0.001});
  environment.goal.x_m += 0.1;
  Plan plan = s.plan;
  plan.environment_hash = environment_hash(environment);
  const Certificate certificate = certify(plan, s.arm, &s.model.compensation(), {}, environment);
  EXPECT_THAT(failed_checks(certificate), AllOf(Contains("collision"), Contains("goal")));
  for (const CertificateFailure& failure : certificate.failures) {
    if (failure.check == "collision") {
      EXPECT_THAT(failure.message, AllOf(HasSubstr("obstacle 4 (circle)"), HasSubstr("plates 1")));
    }
    if (failure.check == "goal") {
      EXPECT_THAT(failure.message, HasSubstr("cm from the goal; tolerance 2.000 cm"));
      EXPECT_EQ(failure.frame, plan.frame_count() - 1);
    }
  }
}

TEST(Certifier, SaysTheSameOfEveryPlanAsOneMadeForItAlone) {
  const Solved& s = solved();
  const ValveParameters ideal;
  const Certifier certifier(s.arm, &s.model.compensation(), ideal, s.environment);
  EXPECT_EQ(certifier.environment_hash(), environment_hash(s.environment));
  Plan other = s.plan;
  other.frames[7].backbone(9, 0) += 2e-4F;
  for (const Plan& plan : {s.plan, other, s.plan}) {
    const Certificate again = certifier.certify(plan);
    const Certificate alone = s.certificate(plan);
    EXPECT_EQ(certificate_to_json(again, s.environment), certificate_to_json(alone, s.environment));
    EXPECT_FALSE(again.unfinished);
  }
}

// Whenever it gives up, it says so, and is never certified.
TEST(Certifier, GivesUpWhenAskedTo) {
  const Solved& s = solved();
  ASSERT_FALSE(s.plan.frames.empty());
  const ValveParameters ideal;
  const Certifier certifier(s.arm, &s.model.compensation(), ideal, s.environment);
  int asked = 0;
  ASSERT_TRUE(certifier.certify(s.plan, [&] { return ++asked < 0; }).certified());
  ASSERT_GT(asked, 2 * s.plan.frame_count()) << "simulation and collision both ask";
  for (int when = 1; when <= asked; ++when) {
    int left = when;
    const Certificate certificate = certifier.certify(s.plan, [&] { return --left <= 0; });
    EXPECT_TRUE(certificate.unfinished);
    EXPECT_FALSE(certificate.certified());
    ASSERT_THAT(failed_checks(certificate), ElementsAre("unfinished")) << when;
    EXPECT_THAT(certificate.failures.front().message,
                HasSubstr("not finished in the time that was left"));
    EXPECT_EQ(left, 0) << "asked again after it gave up";
  }
}

// Another machine's fit of the same bench test: the same arm, and the plan still holds on it.
TEST(Certificate, HoldsForTheSameArmFittedElsewhere) {
  const Solved& s = solved();
  ArmDescription arm = s.arm;
  for (Segment& segment : arm.segments) {
    segment.strain_polynomial[0] += 0.99 * kSameStrain / segment.pressure_limit_kpa;
  }
  ASSERT_NE(arm.hash(), s.arm.hash());
  CompensationModel model = s.model.compensation();
  model.set_arm(s.arm);
  const Certificate certificate = certify(s.plan, arm, &model, {}, s.environment);
  EXPECT_GT(certificate.largest_deviation_m, 1e-6) << "another arm in its last digits";
  EXPECT_TRUE(certificate.certified());
}

TEST(Certificate, OtherArmsEnvironmentsAndModelsAreBadInput) {
  const Solved& s = solved();
  ArmDescription arm = s.arm;
  arm.segments[0].length_m += 0.001;
  EXPECT_THAT([&] { (void)certify(s.plan, arm, &s.model.compensation(), {}, s.environment); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("made for another arm"),
                                              HasSubstr(s.arm.hash()), HasSubstr(arm.hash()))));
  Environment environment = s.environment;
  environment.goal.x_m += 1e-3;
  EXPECT_THAT([&] { (void)certify(s.plan, s.arm, &s.model.compensation(), {}, environment); },
              ThrowsMessage<InputError>(HasSubstr("made for another environment")));
  EXPECT_THAT([&] { (void)certify(s.plan, s.arm, nullptr, {}, s.environment); },
              ThrowsMessage<InputError>(HasSubstr("another kind of model")));
}

TEST(Certificate, TheSealBreaksWhateverIsChangedInTheFile) {
  const Solved& s = solved();
  ASSERT_FALSE(s.plan.frames.empty());
  const TemporaryFolder folder;
  const auto file = folder.path() / "p.json";
  write_plan(file, s.plan);
  EXPECT_TRUE(read_plan(file).certified->seal_is_intact);
  const std::string text = read_file(file);
  for (const auto& [from, to] : {std::pair{"\"seed\": 3", "\"seed\": 4"},
                                 std::pair{"\"planner\": \"default\"", "\"planner\": \"paper\""}}) {
    std::string changed = text;
    ASSERT_NE(changed.find(from), std::string::npos);
    changed.replace(changed.find(from), std::string(from).size(), to);
    write_file_atomically(file, changed);
    EXPECT_FALSE(read_plan_unjudged(file).certified->seal_is_intact) << from;
    EXPECT_THAT([&] { (void)read_plan(file); },
                ThrowsMessage<InputError>(HasSubstr("changed since it was certified")));
  }
  // Layout and order are nobody's business.
  write_file_atomically(file, nlohmann::json::parse(text).dump());
  EXPECT_TRUE(read_plan(file).certified->seal_is_intact);
}

/// Returns a plan whose last backbone is not what the model says.
class BrokenPlanner final : public Planner {
 public:
  const char* name() const override { return "broken"; }
  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    PlanResult result =
        make_pressure_rrt_star(ParentRule::lazy)->plan(problem, limits, seed, callback);
    if (result.plan) {
      result.plan->frames.back().backbone(15, 0) += 0.001F;
    }
    return result;
  }
};

TEST(CertifiedPlanner, APlanThatIsRefusedIsADefectAndNoSolution) {
  const Solved& s = solved();
  PlannerLimits limits;
  limits.iterations = 1500;
  const PlanResult result = make_certified_planner(std::make_unique<BrokenPlanner>())
                                ->plan({s.arm, s.model, s.environment}, limits, 3);
  ASSERT_EQ(result.status, PlanStatus::not_certified) << result.reason;
  EXPECT_FALSE(result.plan);
  EXPECT_TRUE(result.best_partial);
  EXPECT_THAT(result.reason,
              HasSubstr("planner 'paper' found is refused by its certificate, the cheapest for "
                        "this: model"));
}

// The certificate is worth as much as it is independent: of the planner's module its sources see
// plain values and nothing that computes.
TEST(Certificate, ItsSourcesIncludeNothingThatThePlannerComputesWith) {
  const std::regex include("#include \"(limber/[^\"]+)\"");
  const std::vector<std::string> allowed{
      "limber/arm/arm_description.hpp",  "limber/arm/backbone.hpp",
      "limber/arm/valve_parameters.hpp", "limber/common/cpu_level.hpp",
      "limber/common/error.hpp",         "limber/common/interrupt.hpp",
      "limber/common/units.hpp",         "limber/network/compensation_model.hpp",
      "limber/planning/certificate.hpp", "limber/planning/environment.hpp",
      "limber/planning/plan.hpp"};
  int seen = 0;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(LIMBER_SOURCE_DIR) / "src/planning/certificate")) {
    const std::string text = read_file(entry.path());
    for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it) {
      EXPECT_THAT(allowed, Contains((*it)[1].str())) << entry.path();
      ++seen;
    }
  }
  EXPECT_GE(seen, 10);
}

}  // namespace
}  // namespace limber
