#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/report/execution_report.hpp"
#include "limber/report/motion_track.hpp"
#include "limber/report/plan_picture.hpp"
#include "planning/random_shapes.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

nlohmann::json data_of(const std::string& page) {
  const std::string open = "<script type=\"application/json\" id=\"data\">";
  const std::size_t from = page.find(open) + open.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

/// web/src/packing.ts, once more. @param columns  numbers in a frame
std::vector<std::vector<double>> unpacked(const std::string& text, std::size_t columns,
                                          const std::vector<double>& units) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::vector<double>> frames;
  std::vector<double> last(columns, 0.0);
  std::size_t column = 0;
  long value = 0;
  long scale = 1;
  for (const char digit : text) {
    const long bits = static_cast<long>(digits.find(digit));
    value += bits % 32 * scale;
    scale *= 32;
    if (bits >= 32) {
      continue;
    }
    last[column] +=
        double(value % 2 != 0 ? -(value - 1) / 2 : value / 2) * units[column % units.size()];
    value = 0;
    scale = 1;
    if (++column == columns) {
      frames.push_back(last);
      column = 0;
    }
  }
  return frames;
}

Plan random_plan(const ArmDescription& arm, const std::string& model) {
  const NoLoadModel no_load(arm);
  RandomStream random(1, 0);
  Plan plan;
  plan.model = model;
  plan.frame_rate_hz = arm.frame_rate_hz;
  for (int k = 0; k < 4; ++k) {
    PlanFrame frame;
    frame.setpoint_kpa = random_pressures(arm, random);
    frame.pressure_kpa = 0.5F * frame.setpoint_kpa;
    frame.backbone = no_load_backbone(no_load, frame.setpoint_kpa);
    plan.frames.push_back(std::move(frame));
  }
  return plan;
}

TEST(MotionTrack, HasNoClearanceWhereNobodySawTheArm) {
  const ArmDescription arm = three_segment_arm();
  const PlanFrame frame = random_plan(arm, "network").frames.front();
  MotionTrack track("arm", arm, {Circle{0.4, 0.2, 0.03}});
  track.add(frame.pressure_kpa, frame.backbone, false);
  track.add(frame.pressure_kpa, frame.backbone);
  const nlohmann::ordered_json json = track.json();
  ASSERT_EQ(json["shapes"].size(), 2U);
  ASSERT_EQ(json["pressures_kpa"].size(), 2U);
  ASSERT_EQ(json["clearances_m"].size(), 2U);
  EXPECT_TRUE(json["clearances_m"][0].is_null());
  EXPECT_TRUE(json["clearances_m"][1].is_number());
}

TEST(MotionTrack, SaysWhatARunBelievesOfTheArmToo) {
  ExecutionResult result;
  result.final_backbone = Backbone::Zero(3, 3);
  result.hint = "; segment 1 lost 20 % of its pressure";
  const PoseGoal goal{0.3, 0.4, std::nullopt, 0.02, 0.3};
  EXPECT_EQ(outcome_text(goal, result),
            "ends 50.00 cm from the goal's centre, misses it; segment 1 lost 20 % of its pressure");
  result.goal_reached = true;
  EXPECT_EQ(outcome_text(goal, result),
            "ends 50.00 cm from the goal's centre, arrives; segment 1 lost 20 % of its pressure");
}

TEST(Animation, HoldsEveryFrameWithObstaclesAndGoal) {
  const ArmDescription arm = three_segment_arm();
  Environment environment;
  environment.obstacles = {Circle{0.4, 0.2, 0.03}, Rectangle{0.5, -0.2, 0.1, 0.2, 0.3}};
  environment.goal = {0.3, 0.4, 1.2, 0.02, 0.3};
  const Plan plan = random_plan(arm, "network");
  const nlohmann::json data = data_of(plan_animation(arm, environment, plan));
  ASSERT_EQ(data["tracks"].size(), 1U);
  const auto& track = data["tracks"][0];
  EXPECT_EQ(track["key"], "network");
  const std::size_t numbers = 3 * static_cast<std::size_t>(arm.point_count());
  const auto shapes = unpacked(track["shapes"].get<std::string>(), numbers, {1e-4, 1e-4, 1e-3});
  const auto set = unpacked(data["setpoints_kpa"].get<std::string>(), 3, {0.01});
  const auto pressures = unpacked(track["pressures_kpa"].get<std::string>(), 3, {0.01});
  ASSERT_EQ(shapes.size(), plan.frames.size());
  ASSERT_EQ(set.size(), plan.frames.size());
  ASSERT_EQ(pressures.size(), plan.frames.size());
  for (std::size_t k = 0; k < plan.frames.size(); ++k) {
    const PlanFrame& frame = plan.frames[k];
    for (std::size_t i = 0; i < numbers; ++i) {
      const auto row = static_cast<Eigen::Index>(i / 3);
      const auto column = static_cast<Eigen::Index>(i % 3);
      EXPECT_NEAR(shapes[k][i], frame.backbone(row, column), column == 2 ? 6e-4 : 6e-5);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(set[k][i], frame.setpoint_kpa[static_cast<Eigen::Index>(i)], 0.006);
      EXPECT_NEAR(pressures[k][i], frame.pressure_kpa[static_cast<Eigen::Index>(i)], 0.006);
    }
  }
  EXPECT_EQ(track["clearances_m"].size(), plan.frames.size());
  EXPECT_EQ(data["environment"]["obstacles"][0]["circle"]["radius_m"], 0.03);
  EXPECT_EQ(data["environment"]["goal"]["theta_rad"], 1.2);
  EXPECT_EQ(data["arm"]["segments"].size(), 3U);
}

TEST(Animation, NamesCannotEndTheScriptAndNothingIsLoadedFromElsewhere) {
  const ArmDescription arm = three_segment_arm();
  Environment environment;
  environment.name = "</script><i>&@DATA@";
  const std::string page = plan_animation(arm, environment, random_plan(arm, "no_load"));
  EXPECT_THAT(page, Not(HasSubstr("</script><i>")));
  EXPECT_THAT(page, HasSubstr("<title>&lt;/script&gt;&lt;i&gt;&amp;@DATA@"));
  EXPECT_EQ(data_of(page)["environment"]["name"], environment.name);
  EXPECT_EQ(data_of(page)["tracks"][0]["key"], "simple");
  EXPECT_THAT(page, Not(HasSubstr("src=")));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST(Animation, ARunHasWhatWasMeasuredBesideWhatWasPredicted) {
  const ArmDescription arm = three_segment_arm();
  const Environment environment;
  const Plan plan = random_plan(arm, "network");
  ExecutionResult result;
  result.episode.time_s = Eigen::VectorXd::LinSpaced(2, 0.0, 0.05);
  result.episode.pressure_kpa = FrameMatrix::Constant(2, 3, 7.0F);
  result.episode.setpoint_kpa = FrameMatrix::Constant(2, 3, 9.0F);
  result.episode.backbone = FrameMatrix::Zero(2, 3 * arm.point_count());
  const nlohmann::json data = data_of(execution_animation(arm, environment, plan, result));
  ASSERT_EQ(data["tracks"].size(), 2U);
  EXPECT_EQ(data["tracks"][1]["key"], "arm");
  const auto set = unpacked(data["setpoints_kpa"].get<std::string>(), 3, {0.01});
  ASSERT_EQ(set.size(), 2U);
  EXPECT_NEAR(set[1][2], 9.0, 1e-9);
}

}  // namespace
}  // namespace limber
