#include "limber/report/plan_report.hpp"

#include <limits>

#include <gmock/gmock.h>

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

PlanResult solved(double clearance_m) {
  PlanResult result;
  result.status = PlanStatus::solved;
  result.first_solution.emplace();
  result.statistics.time_s = 1.0;
  result.plan.emplace();
  result.plan->model = "network";
  result.plan->clearance_m = clearance_m;
  result.plan->certified = CertifiedFigures{clearance_m, 0.0, true};
  return result;
}

TEST(PlanReport, SaysHowFarThePlanKeepsFromObstaclesWhereThereAreSome) {
  EXPECT_THAT(to_text(solved(0.0125)),
              AllOf(HasSubstr("clearance 1.25 cm"), HasSubstr("clearance 1.250 cm")));
  EXPECT_THAT(to_text(solved(std::numeric_limits<double>::infinity())),
              AllOf(HasSubstr("from the goal, no obstacles"), HasSubstr("simulation, no obstacles"),
                    Not(HasSubstr("inf"))));
}

TEST(PlanReport, CountsWhatIsWrongWithAPlanAndNotItsFrames) {
  Certificate certificate;
  certificate.frames = 68;
  certificate.failures = {{"claims", -1, "clearance_m = 1; found 2"}};
  EXPECT_THAT(to_text(certificate, ArmDescription(), Environment()),
              AllOf(HasSubstr("refused: claims: clearance_m = 1"),
                    HasSubstr("not certified: 1 failure as above; 68 frames in all")));
}

}  // namespace
}  // namespace limber
