#include "arm_station.hpp"

#include <mutex>
#include <thread>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/data_folder.hpp"
#include "support/bending_plan.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using std::chrono::milliseconds;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int kPatience = 400;  // looks of 50 ms: on a busy machine

class ArmStationTest : public ::testing::Test {
 protected:
  std::unique_ptr<ArmStation> station(const std::string& command) {
    ProcessDriverSettings driver;
    driver.command = command;
    return std::make_unique<ArmStation>(project_, name_, driver,
                                        [this](const std::string& kind, const std::string& json) {
                                          const std::lock_guard lock(mutex_);
                                          if (kind == "arm") {
                                            states_.push_back(nlohmann::json::parse(json)["state"]);
                                          }
                                        });
  }
  /// Renews the lease meanwhile, if one is given. @return the message that went with it
  static std::string wait_for(ArmStation& station, const std::string& state,
                              const std::string& lease = "") {
    nlohmann::json now;
    for (int look = 0; look < kPatience && now["state"] != state; ++look) {
      std::this_thread::sleep_for(milliseconds(50));
      if (!lease.empty()) {
        (void)station.renew(lease);
      }
      now = nlohmann::json::parse(station.status());
    }
    EXPECT_EQ(now["state"], state);
    return now["message"];
  }
  ArmRunJob job() const {
    const ArmDescription arm = load_arm(data_folder() / "arms/two_segment.yaml");
    ArmRunJob job;
    job.limit_scale = 1.0;
    job.found.scene = {name_, ""};
    job.found.plan = bending_plan(arm, job.found.environment);
    return job;
  }

  TemporaryFolder folder_;
  ProjectFolder project_{folder_.path()};
  std::string name_ = "limber:two_segment";
  std::mutex mutex_;
  std::vector<std::string> states_;
};

TEST_F(ArmStationTest, OnePageAtATimeHoldsTheLease) {
  const auto arm = station("false");
  const std::string lease = arm->arm();
  EXPECT_EQ(lease.size(), 32U);
  EXPECT_THAT(arm->arm(), IsEmpty());
  EXPECT_TRUE(arm->renew(lease));
  EXPECT_FALSE(arm->renew(std::string(32, '0')));
  EXPECT_FALSE(arm->renew(""));
  EXPECT_FALSE(arm->stop("") || arm->pause("", true) || arm->disarm(""));
  EXPECT_THAT(arm->run("", job()), HasSubstr("arm the arm first"));
  EXPECT_TRUE(arm->disarm(lease));
  EXPECT_FALSE(arm->renew(lease));
  EXPECT_EQ(arm->arm().size(), 32U);
}

TEST_F(ArmStationTest, APageThatIsNotHeardForThreeSecondsLosesIt) {
  const auto arm = station("false");
  const std::string lease = arm->arm();
  std::this_thread::sleep_for(milliseconds(1500));
  EXPECT_TRUE(arm->renew(lease)) << "until then it may come back";
  EXPECT_THAT(wait_for(*arm, "off"), HasSubstr("not heard for 3 s"));
  EXPECT_FALSE(arm->renew(lease));
  EXPECT_EQ(arm->arm().size(), 32U);
}

TEST_F(ArmStationTest, AVentEndsEveryLease) {
  const auto arm = station("false");
  const std::string lease = arm->arm();
  arm->vent();
  EXPECT_FALSE(arm->renew(lease)) << "at once";
  EXPECT_THAT(arm->run(lease, job()), HasSubstr("arm the arm first"));
  EXPECT_THAT(wait_for(*arm, "off"), HasSubstr("VENT was pressed"));
}

// It may have been that the arm is under pressure still.
TEST_F(ArmStationTest, AVentDoesNotHideWhatBecameOfTheLastRun) {
  const auto arm = station("false");
  const std::string lease = arm->arm();
  EXPECT_THAT(arm->run(lease, job()), IsEmpty());
  wait_for(*arm, "armed", lease);
  arm->vent();
  EXPECT_THAT(wait_for(*arm, "off"),
              AllOf(HasSubstr("VENT was pressed"), HasSubstr("ended with exit code 1")));
}

TEST_F(ArmStationTest, SaysWhyTheDriverDoesNotServe) {
  const auto arm = station("false");
  const std::string lease = arm->arm();
  EXPECT_THAT(arm->run(lease, job()), IsEmpty());
  EXPECT_THAT(wait_for(*arm, "armed", lease), HasSubstr("ended with exit code 1"));
  const std::lock_guard lock(mutex_);
  EXPECT_THAT(states_, ::testing::ElementsAre("armed", "running", "armed"));
}

TEST_F(ArmStationTest, ObeysTheArmFilesSafetyAsItIsNow) {
  const std::string text = read_file(data_folder() / "arms/two_segment.yaml");
  name_ = "mine.yaml";
  write_file_atomically(folder_.path() / name_, text);
  const auto arm = station("false");
  write_file_atomically(folder_.path() / name_, text + "\nsafety:\n  jump_m: -1\n");
  const std::string lease = arm->arm();
  EXPECT_THAT(arm->run(lease, job()), IsEmpty());
  EXPECT_THAT(wait_for(*arm, "armed", lease), HasSubstr("jump_m"));
}

TEST_F(ArmStationTest, MovesNothingBeyondTheLimitScaleAndNoOtherArm) {
  const auto arm = station("false");
  const std::string lease = arm->arm();
  ArmRunJob small = job();
  small.limit_scale = 0.01;
  EXPECT_THAT(arm->run(lease, small), IsEmpty());
  EXPECT_THAT(wait_for(*arm, "armed", lease), HasSubstr("a limit scale of 0.01 allows"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "runs/run.h5.driver.jsonl"));
  ArmRunJob other = job();
  other.found.scene.arm = "limber:three_segment";
  EXPECT_THAT(arm->run(lease, other), HasSubstr("another arm"));
}

}  // namespace
}  // namespace limber
