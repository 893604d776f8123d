#include "arm_station.hpp"

#include <map>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/run/executor.hpp"
#include "support/bending_plan.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using std::chrono::milliseconds;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr int kPatience = 400;  // looks of 50 ms: on a busy machine

/// A driver that keeps no frames: an arm that stays straight while its pressures follow at once.
constexpr const char* kSimulation = R"(
import json
import sys
import time

now = 0.0
for line in sys.stdin:
    asked = json.loads(line)
    if asked["type"] == "hello":
        said = {"type": "hello", "protocol": 1, "driver": "simulation", "device": "",
                "rate_hz": 20.0, "segments": 2, "tracked": True, "real_time": False}
    elif asked["type"] in ("set", "vent"):
        time.sleep(0.02)
        now += 0.05
        said = {"type": "state", "seq": asked["seq"], "t": now,
                "pressure_kpa": asked.get("pressure_kpa", [0.0, 0.0]),
                "backbone": [[0.047 * i, 0.0, 0.0] for i in range(11)]}
    else:
        break
    print(json.dumps(said), flush=True)
)";

class ArmStationTest : public ::testing::Test {
 protected:
  std::unique_ptr<ArmStation> station(const std::string& command) {
    ProcessDriverSettings driver;
    driver.command = command;
    driver.simulated = true;
    return std::make_unique<ArmStation>(project_, name_, driver,
                                        [this](const std::string& kind, const std::string& json) {
                                          const std::lock_guard lock(mutex_);
                                          events_[kind].push_back(nlohmann::json::parse(json));
                                        });
  }
  std::unique_ptr<ArmStation> simulating_station() {
    const std::filesystem::path script = folder_.path() / "simulation.py";
    write_file_atomically(script, kSimulation);
    return station(fmt::format("{} \"{}\"", LIMBER_PYTHON, script.string()));
  }
  std::vector<nlohmann::json> events(const std::string& kind) {
    const std::lock_guard lock(mutex_);
    return events_[kind];
  }
  void wait_for_a_frame(ArmStation& station, const std::string& lease) {
    for (int look = 0; look < kPatience && events("arm_frame").empty(); ++look) {
      std::this_thread::sleep_for(milliseconds(50));
      (void)station.renew(lease);
    }
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
    job.found.environment.name = "to the right";
    job.found.plan = bending_plan(arm, job.found.environment);
    job.found.plan.model = "no_load";
    return job;
  }

  TemporaryFolder folder_;
  ProjectFolder project_{folder_.path()};
  std::string name_ = "limber:two_segment";
  std::mutex mutex_;
  std::map<std::string, std::vector<nlohmann::json>> events_;  // by their kind
};

TEST_F(ArmStationTest, OnePageAtATimeHoldsTheLease) {
  const auto arm = station("false");
  const std::string lease = arm->arm();
  EXPECT_EQ(lease.size(), 32U);
  EXPECT_THAT(arm->arm(), IsEmpty());
  EXPECT_TRUE(arm->renew(lease));
  EXPECT_FALSE(arm->renew(std::string(32, '0')));
  EXPECT_FALSE(arm->renew(""));
  EXPECT_FALSE(arm->stop("") || arm->disarm(""));
  EXPECT_THAT(arm->pause("", true), HasSubstr("arm the arm first"));
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
  std::vector<std::string> states;
  for (const nlohmann::json& status : events("arm")) {
    states.push_back(status["state"]);
  }
  EXPECT_THAT(states, ::testing::ElementsAre("armed", "running", "armed"));
}

TEST_F(ArmStationTest, AnArmThatNothingHoldsIsNotPaused) {
  const auto arm = simulating_station();
  const std::string lease = arm->arm();
  EXPECT_THAT(arm->run(lease, job()), IsEmpty());
  wait_for_a_frame(*arm, lease);
  EXPECT_THAT(arm->pause(lease, true), HasSubstr("a simulated arm keeps no frames"));
  EXPECT_THAT(wait_for(*arm, "armed", lease), Not(HasSubstr("paused")));
  ASSERT_FALSE(events("arm_frame").empty());
  for (const nlohmann::json& frame : events("arm_frame")) {
    EXPECT_EQ(frame["holds"], "");
    EXPECT_EQ(frame["noticed"], "");
  }
}

// As tracks of models do: a page puts index k of each at the time of frame k.
TEST_F(ArmStationTest, TheTrackOfARunBeginsAtItsStart) {
  const auto arm = simulating_station();
  const std::string lease = arm->arm();
  EXPECT_THAT(arm->run(lease, job()), IsEmpty());
  wait_for(*arm, "armed", lease);
  ASSERT_EQ(events("arm_run").size(), 1U);
  const nlohmann::json run = events("arm_run").front();
  const nlohmann::json& track = run["tracks"][0];
  for (const nlohmann::json& rows : {run["setpoints_kpa"], track["pressures_kpa"]}) {
    EXPECT_EQ(rows.size(), events("arm_frame").size());
    EXPECT_EQ(rows[0][0], 0.0);
    EXPECT_EQ(rows[1][0], 5.0);  // a frame at the arm's rate
  }
  EXPECT_EQ(track["shapes"].size(), run["setpoints_kpa"].size());
}

TEST_F(ArmStationTest, WhatVerifyTakesLiesBesideARunsRecording) {
  const auto arm = simulating_station();
  const std::string lease = arm->arm();
  const ArmRunJob run = job();
  EXPECT_THAT(arm->run(lease, run), IsEmpty());
  wait_for(*arm, "armed", lease);
  const std::filesystem::path recording =
      folder_.path() / nlohmann::json::parse(arm->status())["recording"].get<std::string>();
  ASSERT_EQ(recording.extension(), ".h5");
  const std::filesystem::path plans = std::filesystem::path(recording).replace_extension(".plans");
  const Plan plan = read_plan(plans / "00.json");
  EXPECT_EQ(plan.frames.size(), run.found.plan.frames.size());
  EXPECT_NO_THROW(require_plan_in(plan, load_environment(plans / "00.yaml"), "00.json"));
  EXPECT_FALSE(std::filesystem::exists(plans / "01.json")) << "open loop";
}

TEST_F(ArmStationTest, MovesNothingWhereTheModelIsAnotherThanThePlans) {
  const auto arm = station("false");
  const std::string lease = arm->arm();
  ArmRunJob changed = job();
  changed.found.plan.model_hash = "0";
  EXPECT_THAT(arm->run(lease, changed), IsEmpty());
  EXPECT_THAT(wait_for(*arm, "armed", lease), HasSubstr("made with another model"));
}

TEST(KeptArm, IsAModelThatTheNextPlanMayBeMadeWith) {
  const TemporaryFolder folder;
  const CompensationModel family =
      read_model(data_folder() / "families/three_segment_small.safetensors");
  const int size = family.family->size();
  const FamilyMember member{"", family.family->arms.col(7),
                            0.01F * Eigen::MatrixXf::Identity(size, size)};
  CompensationModel mine = model_of_arm(family, member);
  mine.prediction_error = PredictionError{20, 8.0, 0.02, 0.01, 0.01, 0.1};
  write_model(folder.path() / "mine.safetensors", mine);
  const ProjectFolder project(folder.path());
  const StudioScene scene(project, {"limber:three_segment", "mine.safetensors"});
  const std::filesystem::path recording = folder.path() / "runs/run.h5";
  ExecutionResult result;
  EXPECT_EQ(keep_arm(recording, scene, result), "") << "open loop";
  result.arm = member;
  EXPECT_EQ(keep_arm(recording, scene, result), "") << "nothing has changed";
  result.arm->e[0] += 0.5F;
  result.arm_changed_s = 2.0;
  EXPECT_THAT(keep_arm(recording, scene, result), HasSubstr("plan with runs/run.safetensors"));
  const StudioScene next(project, {"limber:three_segment", "runs/run.safetensors"});
  EXPECT_EQ(next.network()->member_of_family->e, result.arm->e);
  EXPECT_EQ(next.network()->prediction_error, mine.prediction_error);
  EXPECT_FALSE(next.network()->tube);
  result.status = ExecutionStatus::fault;
  EXPECT_EQ(keep_arm(recording, scene, result), "") << "nobody knows what it was worth";
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
