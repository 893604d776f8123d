#include "limber/world/plan.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "support/temporary_folder.hpp"
#include "world/small_plan.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;
using Json = nlohmann::ordered_json;

TEST(PlanFile, OfAnotherCommandSaysNothingOfPressures) {
  const TemporaryFolder folder;
  Plan plan = small_plan(three_segment_arm());
  plan.command = {"curvature", "1/m"};
  write_plan(folder.path() / "p.json", plan);
  const std::string text = read_file(folder.path() / "p.json");
  EXPECT_THAT(text, Not(HasSubstr("kpa")));
  EXPECT_THAT(text, HasSubstr(R"("command": {"name":"curvature","unit":"1/m"})"));
  const Plan again = read_plan(folder.path() / "p.json");
  EXPECT_EQ(again.command.name, "curvature");
  EXPECT_EQ(again.command.unit, "1/m");
  EXPECT_EQ(again.cost_kpa, plan.cost_kpa);
  EXPECT_EQ(again.waypoints_kpa, plan.waypoints_kpa);
  for (std::size_t k = 0; k < plan.frames.size(); ++k) {
    EXPECT_EQ(again.frames[k].setpoint_kpa, plan.frames[k].setpoint_kpa);
    EXPECT_EQ(again.frames[k].pressure_kpa, plan.frames[k].pressure_kpa);
  }
  write_setpoints_csv(folder.path() / "p.csv", plan);
  EXPECT_THAT(
      read_file(folder.path() / "p.csv"),
      StartsWith("time_s,setpoint_0,setpoint_1,setpoint_2,command_0,command_1,command_2\n"));
}

TEST(PlanFile, SurvivesTheRoundTripExactly) {
  const TemporaryFolder folder;
  const ArmDescription arm = three_segment_arm();
  const Plan plan = small_plan(arm);
  write_plan(folder.path() / "p.json", plan);
  const Plan again = read_plan(folder.path() / "p.json");
  EXPECT_EQ(again.seed, plan.seed);
  EXPECT_EQ(again.valves_hash, plan.valves_hash);
  EXPECT_EQ(again.cost_kpa, plan.cost_kpa);
  EXPECT_EQ(again.clearance_m, plan.clearance_m);
  EXPECT_EQ(again.goal_distance_m, plan.goal_distance_m);
  EXPECT_EQ(again.model_hash, "abc");
  EXPECT_EQ(again.waypoints_kpa, plan.waypoints_kpa);
  EXPECT_EQ(again.hold_frame_count, 2);
  ASSERT_EQ(again.frame_count(), plan.frame_count());
  for (std::size_t k = 0; k < plan.frames.size(); ++k) {
    EXPECT_EQ(again.frames[k].setpoint_kpa, plan.frames[k].setpoint_kpa);
    EXPECT_EQ(again.frames[k].pressure_kpa, plan.frames[k].pressure_kpa);
    EXPECT_EQ(again.frames[k].backbone, plan.frames[k].backbone);
  }
  write_plan(folder.path() / "q.json", again);
  EXPECT_EQ(read_file(folder.path() / "p.json"), read_file(folder.path() / "q.json"));
  EXPECT_NO_THROW(require_plan_of(again, arm, "p.json"));
}

TEST(PlanFile, KeepsTheLimitsThatThePlanWasMadeWithin) {
  const TemporaryFolder folder;
  const ArmDescription arm = three_segment_arm();
  Plan plan = small_plan(arm);
  write_plan(folder.path() / "p.json", plan);
  EXPECT_THAT(read_file(folder.path() / "p.json"), Not(HasSubstr("limits")));
  plan.limits = {PressureLimits(-30.0, 99.5), PressureLimits(40.0), PressureLimits(0.0, 50.1)};
  for (PlanFrame& frame : plan.frames) {
    frame.setpoint_kpa[2] = 0.0F;
  }
  plan.waypoints_kpa = {plan.frames.front().setpoint_kpa, plan.frames.back().setpoint_kpa};
  plan.cost_kpa = path_cost_kpa(plan.frames, &PlanFrame::setpoint_kpa);
  write_plan(folder.path() / "p.json", plan);
  EXPECT_EQ(read_plan(folder.path() / "p.json").limits, plan.limits);
  EXPECT_NO_THROW(require_plan_of(plan, arm, "p.json"));
  plan.frames.back().setpoint_kpa[2] = -0.1F;
  EXPECT_THAT(
      [&] { require_plan_of(plan, arm, "p.json"); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("frames[6].setpoint_kpa[2]: -0.1"),
                                      HasSubstr("expected 0 to 50.1 kPa, the plan's limits"))));
  plan.limits[1] = PressureLimits(-40.0, 101.0);
  EXPECT_THAT([&] { require_plan_of(plan, arm, "p.json"); },
              ThrowsMessage<InputError>(
                  HasSubstr("limits_kpa[1]: -40 to 101 kPa found; the limits of arm")));
  plan.limits.pop_back();
  EXPECT_THAT([&] { require_plan_of(plan, arm, "p.json"); },
              ThrowsMessage<InputError>(HasSubstr("limits_kpa: 2 pairs found")));
}

TEST(PlanFile, InfiniteClearanceIsNull) {
  const TemporaryFolder folder;
  Plan plan = small_plan(three_segment_arm());
  plan.clearance_m = std::numeric_limits<double>::infinity();
  write_plan(folder.path() / "p.json", plan);
  EXPECT_EQ(read_plan(folder.path() / "p.json").clearance_m, plan.clearance_m);
}

/// One way of a file being broken, and what the message must hold.
struct Broken {
  const char* what;
  std::function<void(Json&)> damage;
  std::vector<std::string> message;
};

/// Each damage is done to a good file, alone.
void expect_refused(const std::vector<Broken>& cases) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "p.json";
  write_plan(path, small_plan(three_segment_arm()));
  const Json good = Json::parse(read_file(path));
  for (const Broken& broken : cases) {
    Json json = good;
    broken.damage(json);
    std::ofstream(path) << json.dump();
    std::string message = "accepted";
    try {
      read_plan(path);
    } catch (const InputError& error) {
      message = error.what();
    }
    EXPECT_THAT(message, HasSubstr(path.string())) << broken.what;
    for (const std::string& part : broken.message) {
      EXPECT_THAT(message, HasSubstr(part)) << broken.what;
    }
  }
}

TEST(PlanFile, NamesFileAndFieldOfBrokenKeys) {
  expect_refused({
      {"other schema",
       [](Json& j) { j["schema"] = "limber/arm/1"; },
       {"schema", "'limber/arm/1' found", "limber/plan/2"}},
      {"no schema", [](Json& j) { j.erase("schema"); }, {"schema: missing"}},
      {"no hash", [](Json& j) { j["arm"].erase("hash"); }, {"arm.hash: missing"}},
      {"arm is a text", [](Json& j) { j["arm"] = "mine"; }, {"arm.name: missing"}},
      {"unknown model",
       [](Json& j) { j["model"]["kind"] = "magic"; },
       {"model.kind", "'magic' found", "no_load or network"}},
      {"negative seed", [](Json& j) { j["seed"] = -1; }, {"seed", "-1 found"}},
      {"text as number",
       [](Json& j) { j["cost_kpa"] = "12"; },
       {"cost_kpa", "'12' found", "finite number"}},
      {"limits of another name",
       [](Json& j) {
         j["limit"] = {{-1, 1}};
       },
       {"limit: unknown key", "limits_kpa"}},
      {"a frame with more", [](Json& j) { j["frames"][1]["twist"] = 0; }, {"frames[1].twist"}},
      {"rate", [](Json& j) { j["frame_rate_hz"] = 0; }, {"frame_rate_hz", "from 1 to 1000"}},
  });
}

TEST(PlanFile, ATubeHasARadiusForEveryPlateAndAStart) {
  const auto with_tube = [](std::vector<double> radii_m, double start_share) {
    return [=](Json& j) {
      j["tube"] = {{"level", 0.95},       {"plate_radius_m", radii_m}, {"start_share", start_share},
                   {"full_after_m", 0.1}, {"end_radius_m", 0.01},      {"end_heading_rad", 0.1},
                   {"goal_inside", true}};
    };
  };
  const std::vector<double> radii_m(16, 0.01);
  const auto level = [&](double share) {
    return [=](Json& j) {
      with_tube(radii_m, 0.4)(j);
      j["tube"]["level"] = share;
    };
  };
  expect_refused({
      {"no run inside", level(0.0), {"tube.level", "0", "between 0 and 1"}},
      {"every run inside", level(1.0), {"tube.level", "1", "between 0 and 1"}},
      {"no radius", with_tube({}, 0.4), {"tube.plate_radius_m", "0 numbers found; expected 16"}},
      {"no width at the start", with_tube(radii_m, 0.0), {"tube.start_share", "0", "more than 0"}},
      {"wider at the start", with_tube(radii_m, 1.5), {"tube.start_share", "from 0 to 1"}},
  });
}

// In pascals the cost of an ordinary plan is a million.
TEST(PlanFile, NumbersInSmallUnitsAreReadBack) {
  const TemporaryFolder folder;
  Plan plan = small_plan(three_segment_arm());
  for (PlanFrame& frame : plan.frames) {
    frame.setpoint_kpa *= 1e5F;
  }
  for (Pressures& waypoint : plan.waypoints_kpa) {
    waypoint *= 1e5F;
  }
  plan.cost_kpa = path_cost_kpa(plan.frames, &PlanFrame::setpoint_kpa);
  ASSERT_GT(plan.cost_kpa, 1e6);
  write_plan(folder.path() / "p.json", plan);
  EXPECT_EQ(read_plan(folder.path() / "p.json").cost_kpa, plan.cost_kpa);
}

TEST(PlanFile, NamesFrameAndFieldOfBrokenFrames) {
  expect_refused({
      {"null as number",
       [](Json& j) { j["frames"][2]["setpoint_kpa"][1] = nullptr; },
       {"frames[2].setpoint_kpa[1]", "null found"}},
      {"no frames", [](Json& j) { j["frames"] = Json::array(); }, {"frames", "no frame found"}},
      {"frames no list", [](Json& j) { j["frames"] = 3; }, {"frames", "a list of frames"}},
      {"short pressures",
       [](Json& j) { j["frames"][3]["setpoint_kpa"].erase(0); },
       {"frames[3].setpoint_kpa", "2 numbers found; expected 3"}},
      {"short backbone",
       [](Json& j) { j["frames"][3]["backbone"].erase(0); },
       {"frames[3].backbone", "15 poses found; expected 16"}},
      {"short pose",
       [](Json& j) { j["frames"][0]["backbone"][5].erase(0); },
       {"frames[0].backbone[5]", "2 numbers found; expected 3"}},
      {"huge",
       [](Json& j) { j["frames"][0]["backbone"][5][0] = 1e30; },
       {"frames[0].backbone[5][0]", "1e+30 found"}},
  });
}

TEST(PlanFile, RefusesFramesThatContradictTheRest) {
  expect_refused({
      {"wrong cost", [](Json& j) { j["cost_kpa"] = 1.0; }, {"cost_kpa", "its frames add up to"}},
      {"hold too long",
       [](Json& j) { j["hold_frame_count"] = 9; },
       {"hold_frame_count", "9 found; expected less than the 7 frames"}},
      {"hold moves", [](Json& j) { j["hold_frame_count"] = 4; }, {"frames", "should hold still"}},
      {"waypoints elsewhere",
       [](Json& j) { j["waypoints_kpa"][0][0] = 5.0; },
       {"waypoints_kpa", "at its ends"}},
  });
}

TEST(PlanFile, ASealThatIsBrokenStaysBroken) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "p.json";
  Plan plan = small_plan(three_segment_arm());
  plan.certified = CertifiedFigures{};
  write_plan(path, plan);
  ASSERT_TRUE(read_plan(path).certified->seal_is_intact);
  auto json = nlohmann::ordered_json::parse(read_file(path));
  json["certificate"]["seal"] = "0";
  write_file_atomically(path, json.dump());
  for (int copy = 0; copy < 2; ++copy) {
    const Plan changed = read_plan_unchecked(path);
    EXPECT_FALSE(changed.certified->seal_is_intact);
    write_plan(path, changed);
  }
  EXPECT_THAT([&] { read_plan(path); }, ThrowsMessage<InputError>(HasSubstr("was changed since")));
}

// The seal is a hash over everything, so an extra key counts, however deep it goes.
TEST(PlanFile, RefusesNestingThatWouldEndTheStack) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "p.json";
  write_plan(path, small_plan(three_segment_arm()));
  const std::string nested = std::string(200'000, '[') + std::string(200'000, ']');
  const std::string whole = read_file(path);
  for (const std::string& text :
       {"{\"schema\":" + nested + "}", "{\"extra\":" + nested + "," + whole.substr(1)}) {
    write_file_atomically(path, text);
    for (const auto& read : {read_plan, read_plan_unchecked}) {
      EXPECT_THAT([&] { read(path); },
                  ThrowsMessage<InputError>(AllOf(HasSubstr("p.json: "), HasSubstr("32 deep"))));
    }
  }
}

TEST(PlanFile, RefusesWhatIsNoJson) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "p.json";
  write_plan(path, small_plan(three_segment_arm()));
  const std::string whole = read_file(path);
  for (const std::string& text :
       {std::string(), whole.substr(0, whole.size() / 2), std::string("schema: limber/plan/1"),
        std::string("{\"cost_kpa\": 1e999}")}) {
    std::ofstream(path) << text;
    EXPECT_THAT([&] { read_plan(path); },
                ThrowsMessage<InputError>(AllOf(HasSubstr("p.json"), HasSubstr("not valid JSON"))));
  }
  EXPECT_THAT([&] { read_plan(folder.path() / "none.json"); },
              ThrowsMessage<InputError>(HasSubstr("none.json")));
}

TEST(Plan, OfAnotherMachinesFitOfTheSameArmIsItsOwn) {
  const TemporaryFolder folder;
  const ArmDescription arm = three_segment_arm();
  Plan plan = small_plan(arm);
  plan.arm_description = arm_keys_to_yaml(arm);
  write_plan(folder.path() / "p.json", plan);
  const Plan back = read_plan(folder.path() / "p.json");
  EXPECT_EQ(back.arm_description, plan.arm_description);
  ArmDescription elsewhere = arm;
  elsewhere.segments[1].strain_polynomial[0] += 1e-9;  // 1e-7 of strain
  ASSERT_NE(elsewhere.hash(), arm.hash());
  EXPECT_NO_THROW(require_plan_of(back, elsewhere, "p.json"));
  elsewhere.segments[1].width_m = 0.031;
  EXPECT_THAT([&] { require_plan_of(back, elsewhere, "p.json"); },
              ThrowsMessage<InputError>(HasSubstr("segments[1].width_m: 0.03 there, 0.031 here")));
}

TEST(Plan, OfBeforeTheDescriptionIsOfTheArmWithItsHash) {
  const ArmDescription arm = three_segment_arm();
  const Plan plan = small_plan(arm);
  ASSERT_EQ(plan.arm_description, "");
  EXPECT_NO_THROW(require_plan_of(plan, arm, "p.json"));
  ArmDescription elsewhere = arm;
  elsewhere.segments[1].strain_polynomial[0] += 1e-9;
  EXPECT_THAT([&] { require_plan_of(plan, elsewhere, "p.json"); },
              ThrowsMessage<InputError>(HasSubstr("what differs is not known")));
}

TEST(Plan, IsRefusedForAnotherArmAndBeyondItsLimits) {
  const ArmDescription arm = three_segment_arm();
  ArmDescription other = arm;
  other.name = "other";
  other.segments[0].length_m = 0.3;
  const Plan plan = small_plan(arm);
  EXPECT_THAT([&] { require_plan_of(plan, other, "p.json"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("p.json: arm_hash"),
                                              HasSubstr("'three_segment'"), HasSubstr("'other'"))));
  Plan fast = plan;
  fast.frames[2].setpoint_kpa[1] += 11.0F;
  EXPECT_THAT([&] { require_plan_of(fast, arm, "p.json"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("frames[2].setpoint_kpa[1]"),
                                              HasSubstr("expected at most 5 kPa"))));
  Plan strong = plan;
  strong.frames[0].setpoint_kpa[2] = -100.5F;
  EXPECT_THAT([&] { require_plan_of(strong, arm, "p.json"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("frames[0].setpoint_kpa[2]"),
                                              HasSubstr("-100.5 kPa found"),
                                              HasSubstr("expected ± 100 kPa"))));
  Plan thin = plan;
  thin.frames[1].setpoint_kpa = Pressures::Zero(2);
  EXPECT_THAT([&] { require_plan_of(thin, arm, "p.json"); },
              ThrowsMessage<InputError>(HasSubstr("frames[1]: 2 set points")));
}

}  // namespace
}  // namespace limber
