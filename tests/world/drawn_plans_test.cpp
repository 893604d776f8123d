// Laws of plans drawn by a number: straight motions of any arm, and the files that hold them.
#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/world/plan.hpp"
#include "limber/world/straight_motion.hpp"
#include "support/drawn_environment.hpp"
#include "support/property.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

constexpr double kSumShare = 1e-5;  // of costs: float32 set points
constexpr int kSlower = 2;          // plans are written and read

/// Straight from waypoint to waypoint, some frames each, and holds.
Plan drawn_motion(const ArmDescription& arm, RandomStream& random) {
  const NoLoadModel no_load(arm);
  const auto frame = [&](const Pressures& kpa) {
    return PlanFrame{kpa, float(random.uniform(0.5, 1.0)) * kpa, no_load_backbone(no_load, kpa)};
  };
  Plan plan;
  plan.arm_name = arm.name;
  plan.arm_hash = arm.hash();
  plan.model = "no_load";
  plan.command = arm.command;
  plan.frame_rate_hz = arm.frame_rate_hz;
  plan.waypoints_kpa = {drawn::pressures(arm, random)};
  plan.frames = {frame(plan.waypoints_kpa.front())};
  const double step = arm.pressure_step_limit_kpa();
  for (int left = int(random.index(4)); left > 0; --left) {
    const Pressures from = plan.waypoints_kpa.back();
    const Pressures way = drawn::pressures(arm, random) - from;
    const double most = random.uniform(0.0, 6.0) * step;
    const float share = std::min(1.0F, float(most) / way.cwiseAbs().maxCoeff());
    plan.waypoints_kpa.push_back(from + share * way);
    for (const Pressures& kpa : straight_setpoints(from, plan.waypoints_kpa.back(), step)) {
      plan.frames.push_back(frame(kpa));
    }
  }
  plan.hold_frame_count = int(random.index(4));
  plan.frames.insert(plan.frames.end(), std::size_t(plan.hold_frame_count), plan.frames.back());
  plan.cost_kpa = path_cost_kpa(plan.frames, &PlanFrame::setpoint_kpa);
  return plan;
}

PlanTube drawn_tube(int plates, RandomStream& random) {
  PlanTube tube;
  tube.level = random.uniform(0.5, 0.999);
  for (int p = 0; p < plates; ++p) {
    tube.plate_radius_m.push_back(random.uniform(0.0, 0.1));
  }
  tube.growth = {random.uniform(0.01, 1.0), random.uniform(0.0, 0.5)};
  tube.end_radius_m = random.uniform(0.0, 0.1);
  tube.end_heading_rad = random.uniform(0.0, 1.0);
  tube.goal_inside = drawn::chance(random, 0.5);
  return tube;
}

/// Everything that a plan may hold beside its motion.
Plan drawn_plan(const ArmDescription& arm, RandomStream& random) {
  Plan plan = drawn_motion(arm, random);
  plan.arm_name = drawn_text();
  plan.arm_description = drawn::chance(random, 0.5) ? arm_keys_to_yaml(arm) : "";
  plan.environment_name = drawn_text();
  plan.environment_hash = drawn_text();
  plan.valves_hash = drawn_text();
  plan.planner = drawn_text();
  plan.program_version = "0.0.1";
  plan.seed = (std::uint64_t(random.index(0xFFFFFFFFU)) << 32U) + random.index(0xFFFFFFFFU);
  plan.margin_m = random.uniform(0.0, 0.1);
  plan.clearance_m = drawn::chance(random, 0.3) ? std::numeric_limits<double>::infinity()
                                                : random.uniform(-0.1, 1.0);
  plan.goal_distance_m = random.uniform(0.0, 0.1);
  plan.goal_orientation_rad = random.uniform(0.0, 3.0);
  if (drawn::chance(random, 0.5)) {
    plan.model = "network";
    plan.model_hash = "abc";
    plan.arm_of_family = Eigen::VectorXf::NullaryExpr(
        random.index(4), [&] { return float(random.uniform(-3.0, 3.0)); });
  }
  if (drawn::chance(random, 0.5)) {
    plan.tube = drawn_tube(arm.point_count(), random);
  }
  if (drawn::chance(random, 0.5)) {
    for (int i = 0; i < arm.channel_count(); ++i) {
      plan.limits.push_back(arm.limits_of_channel(i));
      plan.limits.back() *= random.uniform(0.95, 1.0);
    }
  }
  if (drawn::chance(random, 0.5)) {
    plan.certified = CertifiedFigures{plan.clearance_m, random.uniform(0.0, 1e-4)};
  }
  return plan;
}

void check_same_motion(const Plan& a, const Plan& b) {
  RC_ASSERT(a.waypoints_kpa == b.waypoints_kpa);
  RC_ASSERT(a.hold_frame_count == b.hold_frame_count);
  RC_ASSERT(a.cost_kpa == b.cost_kpa);
  RC_ASSERT(a.frame_count() == b.frame_count());
  for (std::size_t k = 0; k < a.frames.size(); ++k) {
    RC_ASSERT(a.frames[k].setpoint_kpa == b.frames[k].setpoint_kpa);
    RC_ASSERT(a.frames[k].pressure_kpa == b.frames[k].pressure_kpa);
    RC_ASSERT(a.frames[k].backbone == b.frames[k].backbone);
  }
}

void check_same_rest(const Plan& a, const Plan& b) {
  RC_ASSERT(a.arm_name == b.arm_name);
  RC_ASSERT(a.arm_hash == b.arm_hash);
  RC_ASSERT(a.arm_description == b.arm_description);
  RC_ASSERT(a.command.name == b.command.name);
  RC_ASSERT(a.command.unit == b.command.unit);
  RC_ASSERT(a.model == b.model);
  RC_ASSERT(a.model_hash == b.model_hash);
  RC_ASSERT(a.arm_of_family.size() == b.arm_of_family.size());
  RC_ASSERT(a.arm_of_family == b.arm_of_family);
  RC_ASSERT(a.valves_hash == b.valves_hash);
  RC_ASSERT(a.environment_name == b.environment_name);
  RC_ASSERT(a.environment_hash == b.environment_hash);
  RC_ASSERT(a.planner == b.planner);
  RC_ASSERT(a.seed == b.seed);
  RC_ASSERT(a.margin_m == b.margin_m);
  RC_ASSERT(a.tube == b.tube);
  RC_ASSERT(a.frame_rate_hz == b.frame_rate_hz);
  RC_ASSERT(a.limits == b.limits);
  RC_ASSERT(a.clearance_m == b.clearance_m);
  RC_ASSERT(a.goal_distance_m == b.goal_distance_m);
  RC_ASSERT(a.goal_orientation_rad == b.goal_orientation_rad);
  RC_ASSERT(a.program_version == b.program_version);
  RC_ASSERT(a.certified.has_value() == b.certified.has_value());
  if (a.certified) {
    RC_ASSERT(b.certified->seal_is_intact);
    RC_ASSERT(a.certified->clearance_m == b.certified->clearance_m);
    RC_ASSERT(a.certified->max_deviation_m == b.certified->max_deviation_m);
  }
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(DrawnPlans, FilesComeBackExactly) {
  expect_law(
      "a plan that is written and read is the plan",
      [] {
        const std::uint64_t number = drawn_number();
        RandomStream random(number, 0);
        const ArmDescription arm = drawn::arm(number, random);
        const Plan plan = drawn_plan(arm, random);
        const TemporaryFolder folder;
        write_plan(folder.path() / "p.json", plan);
        const Plan again = read_plan(folder.path() / "p.json");
        check_same_motion(plan, again);
        check_same_rest(plan, again);
        write_plan(folder.path() / "q.json", again);
        RC_ASSERT(read_file(folder.path() / "p.json") == read_file(folder.path() / "q.json"));
      },
      kSlower);
}

TEST(DrawnPlans, CostAlongFramesIsThatAlongWaypoints) {
  expect_law("frames neither lengthen a motion nor shorten it", [] {
    const std::uint64_t number = drawn_number();
    RandomStream random(number, 0);
    const ArmDescription arm = drawn::arm(number, random);
    const Plan plan = drawn_motion(arm, random);
    double cost_kpa = 0.0;
    double size_kpa = 0.0;
    for (std::size_t w = 1; w < plan.waypoints_kpa.size(); ++w) {
      for (int i = 0; i < arm.channel_count(); ++i) {
        cost_kpa +=
            std::abs(double(plan.waypoints_kpa[w][i]) - double(plan.waypoints_kpa[w - 1][i]));
        size_kpa += double(plan.waypoints_kpa[w].cwiseAbs().maxCoeff());
      }
    }
    RC_ASSERT(std::abs(plan.cost_kpa - cost_kpa) <= kSumShare * (1.0 + cost_kpa + size_kpa));
  });
}

TEST(DrawnPlans, ACostThatFramesDoNotAddUpToIsRefused) {
  expect_law(
      "the stated cost is the frames' cost, or the file is refused",
      [] {
        const std::uint64_t number = drawn_number();
        RandomStream random(number, 0);
        const ArmDescription arm = drawn::arm(number, random);
        Plan plan = drawn_motion(arm, random);
        const double off = std::pow(10.0, random.uniform(-5.0, 0.0)) * (1.0 + plan.cost_kpa);
        plan.cost_kpa += drawn::chance(random, 0.5) && plan.cost_kpa > off ? -off : off;
        const TemporaryFolder folder;
        write_plan(folder.path() / "p.json", plan);
        const std::string said = refusal([&] { (void)read_plan(folder.path() / "p.json"); });
        RC_ASSERT(said.find("its frames add up to") != std::string::npos);
      },
      kSlower);
}

TEST(DrawnPlans, FramesKeepLimitsAndRateOrAreRefused) {
  expect_law("a straight motion within limits is a plan of its arm, and one beyond is none", [] {
    const std::uint64_t number = drawn_number();
    RandomStream random(number, 0);
    const ArmDescription arm = drawn::arm(number, random);
    const Plan plan = drawn_motion(arm, random);
    RC_ASSERT(refusal([&] { require_plan_of(plan, arm, "p.json"); }) == "accepted");
    Plan beyond = plan;
    const auto k = std::size_t(random.index(std::uint32_t(plan.frames.size())));
    const auto i = Eigen::Index(random.index(std::uint32_t(arm.channel_count())));
    const PressureLimits& limits = arm.limits_of_channel(int(i));
    const double over = std::pow(10.0, random.uniform(-3.0, 0.0)) * limits.largest_kpa();
    float& setpoint = beyond.frames[k].setpoint_kpa[i];
    if (k == 0 || drawn::chance(random, 0.5)) {
      setpoint =
          float(drawn::chance(random, 0.5) ? limits.upper_kpa + over : limits.lower_kpa - over);
    } else {
      setpoint =
          beyond.frames[k - 1].setpoint_kpa[i] + 1.01F * float(arm.pressure_step_limit_kpa());
    }
    const std::string said = refusal([&] { require_plan_of(beyond, arm, "p.json"); });
    RC_ASSERT(said.find("p.json: frames[" + std::to_string(k) + "].setpoint") == 0);
  });
}

}  // namespace
}  // namespace limber
