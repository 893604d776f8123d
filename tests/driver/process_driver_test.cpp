#include "limber/driver/process_driver.hpp"

#include <atomic>
#include <chrono>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "support/fake_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;
using Clock = std::chrono::steady_clock;

constexpr double kPeriodS = 0.05;  // of small_arm
/// Waiting for the kill takes 0.5 s; the rest is a machine that is busy.
constexpr double kMaxFaultS = 5.0;

class ProcessDriverTest : public ::testing::Test {
 protected:
  ProcessDriverSettings settings(const std::string& fault = "") {
    ProcessDriverSettings settings;
    settings.command = fmt::format("{} {}/tests/driver/fake_driver.py \"{}\" {}", LIMBER_PYTHON,
                                   LIMBER_SOURCE_DIR, log_.string(), fault);
    settings.say = [this](const std::string& message) { said_.push_back(message); };
    return settings;
  }

  static Pressures pressures(float first, float second) {
    Pressures result(2);
    result << first, second;
    return result;
  }

  /// Commands `count` frames of a ramp. @return the message of the fault that ended it, or "".
  std::string ramp(ArmDriver& driver, int count) const {
    try {
      for (int k = 1; k <= count; ++k) {
        const float kpa = 8.0F * static_cast<float>(std::min(k, 10));
        driver.command(pressures(kpa, 0.5F * kpa));
      }
    } catch (const SystemFault& fault) {
      return fault.what();
    }
    return "";
  }

  std::string heard() const { return read_file(log_); }

  /// A driver with `fault` ends in a fault within seconds, having been vented.
  void expect_fault(const std::string& fault, const std::string& message) {
    const auto start = Clock::now();
    {
      ProcessDriver driver(arm_, settings(fault));
      EXPECT_THAT(ramp(driver, 12), HasSubstr(message)) << fault;
      EXPECT_THAT(ramp(driver, 1), HasSubstr(message)) << "a failed driver stays failed";
    }
    EXPECT_LT(std::chrono::duration<double>(Clock::now() - start).count(), kMaxFaultS) << fault;
    ASSERT_FALSE(said_.empty()) << fault;
  }

  void ramp_of(const std::string& fault) {
    ProcessDriver driver(arm_, settings(fault));
    (void)ramp(driver, 12);
  }

  TemporaryFolder folder_;
  std::filesystem::path log_ = folder_.path() / "it's a log";
  ArmDescription arm_ = small_arm();
  std::vector<std::string> said_;
};

TEST_F(ProcessDriverTest, CommandsOnceAFrameAndReturnsWhatTheDriverSays) {
  ProcessDriver driver(arm_, settings());
  EXPECT_EQ(driver.hello().driver, "fake");
  EXPECT_TRUE(driver.state().pressure_kpa.isZero());
  const auto start = Clock::now();
  const double first_s = driver.command(pressures(5, 0)).time_s;
  for (int k = 0; k < 10; ++k) {
    EXPECT_EQ(driver.command(pressures(5, -1)).pressure_kpa, pressures(5, -1));
  }
  EXPECT_GE(std::chrono::duration<double>(Clock::now() - start).count(), 10 * kPeriodS - 0.001);
  EXPECT_NEAR(driver.state().time_s - first_s, 10 * kPeriodS, 1e-9);  // the driver's own clock
  EXPECT_EQ(driver.timing().late_s.size(), 11U);
  EXPECT_EQ(driver.state().backbone->rows(), 5);
}

TEST_F(ProcessDriverTest, RunsInItsOwnGroupWithoutAShell) {
  { const ProcessDriver driver(arm_, settings("$HOME")); }
  EXPECT_THAT(heard(), HasSubstr("group True"));
  EXPECT_THAT(heard(), HasSubstr("words 3"));
}

/// Seconds from then until the driver read its first `vent` after a `set`.
double vent_read_after_s(const std::string& heard, double since_s) {
  std::istringstream lines(heard.substr(heard.find(" set\n")));
  double time_s = 0.0;
  for (std::string what; lines >> time_s >> what;) {
    if (what == "vent") {
      break;
    }
  }
  return time_s - since_s;
}

TEST_F(ProcessDriverTest, AVentThatIsAskedForWaitsForNoFrame) {
  constexpr double kSoonS = 0.04;  // less than a frame: looked at every 5 ms; the rest is for load
  for (const char* fault : {"", "frame"}) {
    std::filesystem::remove(log_);
    std::atomic<bool> asked = false;
    std::atomic<double> asked_s = 0.0;
    ProcessDriverSettings asking = settings(fault);
    asking.vent_asked = [&asked] { return asked.load(); };
    ProcessDriver driver(arm_, asking);
    EXPECT_THAT(ramp(driver, 5), IsEmpty());
    std::thread press([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(8));
      asked_s = std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
      asked = true;
    });
    const auto go_on = [&driver] {
      for (int k = 0; k < 3; ++k) {
        driver.command(pressures(40, 20));
      }
    };
    EXPECT_THROW(go_on(), Interrupted) << fault;
    press.join();
    driver.vent();
    EXPECT_TRUE(driver.last_vent().confirmed) << fault;
    EXPECT_LT(vent_read_after_s(heard(), asked_s), kSoonS) << fault;
    asked = false;
    EXPECT_THAT(ramp(driver, 3), IsEmpty()) << "it goes on where it was stopped on purpose";
  }
}

TEST_F(ProcessDriverTest, VentsUntilPressuresAreDownAndSaysSo) {
  {
    ProcessDriver driver(arm_, settings());
    EXPECT_THAT(ramp(driver, 3), IsEmpty());
    driver.vent();
    driver.vent();
    EXPECT_TRUE(driver.last_vent().confirmed);
    EXPECT_LE(driver.last_vent().pressure_kpa, 2.0);
    EXPECT_GT(driver.last_vent().after_s, 3 * kPeriodS);  // 24 kPa halve four times
    EXPECT_THAT(ramp(driver, 3), IsEmpty());              // and goes on
  }
  EXPECT_THAT(said_, ElementsAre(StartsWith("vented: 1.5 kPa after 0."),
                                 StartsWith("vented: 1.5 kPa after 0.")));
  EXPECT_THAT(heard(), HasSubstr("bye"));
}

TEST_F(ProcessDriverTest, SaysWhichSegmentIsNotVented) {
  ProcessDriverSettings sealed = settings("sealed");
  sealed.safety.vent_time_s = 0.3;
  ProcessDriver driver(arm_, sealed);
  EXPECT_THAT(ramp(driver, 3), IsEmpty());
  driver.vent();
  EXPECT_FALSE(driver.last_vent().confirmed);
  EXPECT_THAT(said_, ElementsAre("VENT NOT CONFIRMED: segment 0 at 24 kPa, shut off the supply"));
  // Whoever shuts it off stands beside an arm that is moved no more.
  EXPECT_THAT(ramp(driver, 1), StartsWith("VENT NOT CONFIRMED"));
  EXPECT_THROW((void)driver.look(), SystemFault);
}

TEST_F(ProcessDriverTest, EveryBrokenAnswerVentsAndEndsTheDriver) {
  for (const auto& [fault, message] : std::vector<std::pair<std::string, std::string>>{
           {"late", "did not answer request"},
           {"repeat", "more than one answer"},
           {"old", "late, repeated or out of order"},
           {"half", "only part of a line"},
           {"huge", "a line of more than 1048576 bytes"},
           {"nan", "answered request"},
           {"size", "3 numbers found; expected 2"},
           {"die", "ended with exit code 7"},
           {"hang", "did not answer request"},
           {"flood", "more than one answer"},
           {"clock", "time has to go on"},
           {"frozen", "time has to go on"},
           {"group", "did not answer request"},
           {"milliseconds", "`t` is in seconds"},
           {"nanosecond", "no device samples so fast"},
           {"twice", "the key 'type' stands twice"},
           {"fault", "valve 3 is hot"}}) {
    said_.clear();
    expect_fault(fault, message);
  }
}

TEST_F(ProcessDriverTest, WhatIsMeasuredWronglyIsAFaultThatIsVentedInFull) {
  expect_fault("released", "vented by itself");
  EXPECT_THAT(said_, ElementsAre(StartsWith("vented:")));
  said_.clear();
  expect_fault("over", "segment 0 is at 106.0 kPa");
  EXPECT_THAT(said_, ElementsAre(StartsWith("vented:")));
}

// Of a tracker that samples more slowly than requests come.
TEST_F(ProcessDriverTest, AVentMayOvertakeTheSamplingAndIsConfirmedByLaterSamples) {
  {
    ProcessDriver driver(arm_, settings("overtaken"));
    EXPECT_EQ(ramp(driver, 3), "");
    driver.vent();
    EXPECT_TRUE(driver.last_vent().confirmed);
    EXPECT_GT(driver.last_vent().after_s, 3 * kPeriodS);  // the first sample, at zero, is of before
    driver.vent();
  }
  EXPECT_THAT(said_, ElementsAre(StartsWith("vented: 0.0 kPa after 0.")));
}

TEST_F(ProcessDriverTest, ABrokenDriverThatStillAnswersIsWatchedUntilItHasVented) {
  for (const char* fault : {"clock", "repeat", "old"}) {
    said_.clear();
    ramp_of(fault);
    EXPECT_THAT(said_, ElementsAre(StartsWith("vented: "))) << fault;
  }
}

// Pressures alone say whether it has vented, whatever is broken beside them.
TEST_F(ProcessDriverTest, AVentIsConfirmedThoughEveryShapeLacksAPlate) {
  expect_fault("unseen", "4 poses found; the arm has 5 plates");
  EXPECT_THAT(said_, ElementsAre(StartsWith("vented: ")));
}

TEST_F(ProcessDriverTest, ADriverWhoseAnswersCantBeReadIsVentedOnAndNotCalledSilent) {
  ProcessDriverSettings babbling = settings("babble");
  babbling.safety.vent_time_s = 0.3;
  {
    ProcessDriver driver(arm_, babbling);
    EXPECT_THAT(ramp(driver, 12), HasSubstr("answered request"));
  }
  EXPECT_THAT(said_, ElementsAre("VENT NOT CONFIRMED: the driver gives no readable answer; it last "
                                 "read segment 0 at 24 kPa, before the vent. Shut off the supply"));
  const std::string after_sets = heard().substr(heard().rfind(" set\n"));
  EXPECT_NE(after_sets.find(" vent\n"), after_sets.rfind(" vent\n")) << "one vent alone";
}

TEST_F(ProcessDriverTest, WhereNothingWasMeasuredItSaysWhatWasMeasuredLast) {
  ramp_of("die");
  EXPECT_THAT(said_, ElementsAre("VENT NOT CONFIRMED: the driver does not answer any more; it last "
                                 "read segment 0 at 24 kPa, before the vent. Shut off the supply"));
}

TEST_F(ProcessDriverTest, ASetpointInForceThatNothingAllowsIsAFault) {
  expect_fault("told", "segment 1 reports a set point in force of 99999.0 kPa; its limit is 100.0");
  EXPECT_THAT(said_, ElementsAre(StartsWith("vented:")));
  said_.clear();
  std::filesystem::remove(log_);
  ProcessDriver driver(arm_, settings("told_vented"));  // the first frame of a recording
  EXPECT_THAT(ramp(driver, 1), HasSubstr("reports a set point in force of -106.0 kPa"));
  EXPECT_THAT(heard(), Not(HasSubstr("set")));
}

TEST_F(ProcessDriverTest, ASetpointInForceThatWasNotSentIsAFault) {
  expect_fault("other", "kPa were sent within the last 0.5 s, and 5.0 kPa are allowed beyond");
}

// 50 µs in a frame of 50 ms, as of a clock in another unit.
TEST_F(ProcessDriverTest, AClockThatHardlyGoesOnIsAFault) {
  ProcessDriver driver(arm_, settings("crawling"));
  EXPECT_THAT(ramp(driver, 40), HasSubstr("went on by 0.001 s in 20 frames, which last 1 s"));
}

TEST_F(ProcessDriverTest, SetpointsBeyondALimitAreNeverSent) {
  ProcessDriverSettings half = settings();
  half.limit_scale = 0.05;
  ProcessDriver driver(arm_, half);
  EXPECT_THAT(ramp(driver, 1), HasSubstr("its limit is 5 kPa"));
  EXPECT_THAT(heard(), Not(HasSubstr("set")));
}

TEST_F(ProcessDriverTest, TheDriversOwnLimitsCount) {
  const ProcessDriver driver(arm_, settings("weak"));
  EXPECT_THAT(driver.limits_kpa(), ElementsAre(100.0, 60.0));
}

TEST_F(ProcessDriverTest, RefusesDriversThatDoNotFit) {
  EXPECT_THAT([&] { ProcessDriver(arm_, settings("hello")); },
              ThrowsMessage<SystemFault>(HasSubstr("arm 'small' has 2 segments")));
  EXPECT_THAT([&] { ProcessDriver(arm_, settings("absolute")); },
              ThrowsMessage<SystemFault>(AllOf(HasSubstr("101.3 kPa"), HasSubstr("absolute"))));
  ProcessDriverSettings missing = settings();
  missing.command = "/no/such/driver --port 3";
  EXPECT_THAT(
      [&] { ProcessDriver(arm_, missing); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("/no/such/driver"), HasSubstr("No such file"))));
}

TEST_F(ProcessDriverTest, ASimulationThatNobodyExpectsMovesNothing) {
  EXPECT_THAT([&] { ProcessDriver(arm_, settings("fast")); },
              ThrowsMessage<InputError>(HasSubstr("say --simulated")));
  EXPECT_THAT(heard(), Not(HasSubstr("set")));
}

TEST_F(ProcessDriverTest, SimulationsRunAsFastAsTheyAreAsked) {
  ProcessDriverSettings expected = settings("fast");
  expected.simulated = true;
  ProcessDriver driver(arm_, expected);
  const auto start = Clock::now();
  EXPECT_THAT(ramp(driver, 40), IsEmpty());
  EXPECT_LT(std::chrono::duration<double>(Clock::now() - start).count(), 40 * kPeriodS);
}

TEST_F(ProcessDriverTest, LogsBothSidesAndWhoStartedIt) {
  ProcessDriverSettings logged = settings();
  logged.log = folder_.path() / "run.jsonl";
  {
    ProcessDriver driver(arm_, logged);
    EXPECT_THAT(ramp(driver, 2), IsEmpty());
  }
  const std::string text = read_file(logged.log);
  for (const char* part : {"limber/driver_log/1", "started_by", "\"to_driver\": {\"type\":\"set\"",
                           "\"from_driver\": {\"type\": \"state\"", "\"note\": \"vented:"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST_F(ProcessDriverTest, LinesOfTheLogAreJsonWhateverTheDriverSent) {
  ProcessDriverSettings logged = settings("bom");
  logged.log = folder_.path() / "run.jsonl";
  {
    ProcessDriver driver(arm_, logged);
    EXPECT_THAT(ramp(driver, 5), IsEmpty());
  }
  EXPECT_THAT(read_file(logged.log), HasSubstr(R"("from_driver": "\ufeff{)"));
}

// What the bodies of a tracker in 3D mean, only a calibration says.
TEST_F(ProcessDriverTest, BodiesWithoutAPlaneAreAFault) {
  expect_fault("bodies", "bodies: only a calibration says where they are");
  ProcessDriverSettings unplaned = settings("bodies");
  unplaned.calibration = identity_calibration(arm_);
  ProcessDriver driver(arm_, unplaned);
  EXPECT_THAT(ramp(driver, 12), HasSubstr("the calibration knows no plane for them"));
}

TEST_F(ProcessDriverTest, BodiesPassWhereADriverIsCalibrated) {
  ProcessDriverSettings calibrating = settings("bodies");
  calibrating.pass_bodies = true;
  ProcessDriver driver(arm_, calibrating);
  EXPECT_EQ(ramp(driver, 3), "");
  EXPECT_FALSE(driver.timing().last.bodies);
  driver.command(pressures(24.0F, 12.0F));
  ASSERT_TRUE(driver.timing().last.bodies);
  EXPECT_EQ((*driver.timing().last.bodies)(4, 0), 0.4);
  EXPECT_FALSE(driver.state().backbone);
}

/// Bodies at rest have no rotation, and the tracker's x and y are the plane.
WireCalibration calibration_with_plane(const ArmDescription& arm) {
  const auto points = static_cast<std::size_t>(arm.point_count());
  WireCalibration calibration = identity_calibration(arm);
  calibration.tracker = TrackerCalibration{};
  calibration.tracker->marker_offsets.resize(points);
  calibration.tracker->plane = TrackerPlane{};
  calibration.tracker->plane->body_rotations.resize(points, Eigen::Quaterniond::Identity());
  return calibration;
}

TEST_F(ProcessDriverTest, ABodyOutOfThePlaneIsNotSeenAndTheLogSaysSo) {
  ProcessDriverSettings planed = settings("tilted");
  planed.calibration = calibration_with_plane(arm_);
  planed.log = folder_.path() / "log.jsonl";
  ProcessDriver driver(arm_, planed);
  EXPECT_EQ(ramp(driver, 3), "");
  ASSERT_TRUE(driver.state().backbone);
  EXPECT_EQ((*driver.state().backbone)(4, 0), 0.4F);
  driver.command(pressures(24.0F, 12.0F));
  EXPECT_FALSE(driver.state().backbone);
  EXPECT_EQ(driver.timing().frames_unseen, 1);
  EXPECT_THAT(read_file(planed.log), HasSubstr("body 2 is turned 3.14 rad out of"));
}

TEST_F(ProcessDriverTest, BackbonesOfADriverThatWasCalibratedWithBodiesAreAFault) {
  ProcessDriverSettings planed = settings();
  planed.calibration = calibration_with_plane(arm_);
  EXPECT_THAT([&] { ProcessDriver(arm_, planed); },
              ThrowsMessage<SystemFault>(HasSubstr("sent bodies when it was calibrated")));
}

}  // namespace
}  // namespace limber
