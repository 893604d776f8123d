#include "limber/lab/speed_benchmark.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limber/lab/speed_peers.hpp"
#include "limber/network/untrained_model.hpp"
#include "limber/report/speed_report.hpp"
#include "support/exit_interrupted.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

SpeedSettings brief() {
  SpeedSettings settings;
  settings.queries = 1000;
  settings.jobs = 2;
  return settings;
}

std::vector<int> sizes_of(const nlohmann::ordered_json& batches) {
  std::vector<int> sizes;
  for (const auto& batch : batches) {
    sizes.push_back(batch["size"]);
  }
  return sizes;
}

std::vector<std::string> names_of(const nlohmann::ordered_json& peers) {
  std::vector<std::string> names;
  for (const auto& peer : peers) {
    names.push_back(peer["name"]);
  }
  return names;
}

std::vector<std::string> expected_peers() {
  std::vector<std::string> names{"eigen"};
  for (const OptionalPeer& peer : optional_peers()) {
    if (peer.present) {
      names.push_back(peer.name);
    }
  }
  return names;
}

TEST(SpeedBenchmark, StopsOnCtrlC) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(exit_interrupted([] { measure_speed(sample_arm(3), nullptr, brief()); }),
              testing::ExitedWithCode(0), "stopped on request");
}

// measure_speed itself refuses a peer whose answers differ, so this also checks those that are
// here.
TEST(SpeedBenchmark, ReportsThePapersShapeAndAModelThatDiffers) {
  const ArmDescription arm = sample_arm(3);
  const CompensationModel model = untrained_model(arm, BackboneLayout::gap_poses, {32, 32}, 1);
  const SpeedReport report = measure_speed(arm, &model, brief());
  const nlohmann::ordered_json json = to_json(report);
  EXPECT_EQ(json["network"]["layout"], "102-100-100-100-48");
  EXPECT_EQ(json["model"]["layout"], "60-32-32-45");
  EXPECT_EQ(json["model"]["backbone_layout"], "gap_poses");
  EXPECT_EQ(json["threads"], 2);
  EXPECT_GT(json["fma_peak_gmac_per_s"], 0.0);
  EXPECT_GT(json["clock_ghz"], 0.1);
  EXPECT_LT(json["clock_ghz"], 10.0);
  EXPECT_GT(json["no_load"]["single"]["queries_per_s"], 0.0);
  EXPECT_GT(json["no_load"]["batch"]["queries_per_s"], 0.0);
  EXPECT_GT(json["network"]["single"]["queries_per_s"], 0.0);
  EXPECT_GT(json["network"]["batch"]["fraction_of_fma_peak"], 0.0);
  EXPECT_LE(json["network"]["batch"]["fraction_of_fma_peak"], 1.1);
  EXPECT_EQ(names_of(json["peers"]), expected_peers());
  for (const auto& peer : json["peers"]) {
    EXPECT_THAT(sizes_of(peer["batches"]),
                ElementsAre(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024));
  }
  EXPECT_THAT(sizes_of(json["network"]["batches"]),
              ElementsAre(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 16384, 16384));
  EXPECT_EQ(json["network"]["batches"].back()["threads"], 2);

  EXPECT_THAT(to_text(report), AllOf(HasSubstr("network 102-100-100-100-48"),
                                     HasSubstr("model 60-32-32-45"), HasSubstr("peer: eigen")));
  EXPECT_THAT(speed_chart(report).svg(),
              AllOf(HasSubstr("network: the paper"), HasSubstr("limber, 60-32-32-45")));
}

TEST(SpeedBenchmark, ModelOfThePapersShapeIsMeasuredOnce) {
  const ArmDescription arm = sample_arm(2);
  const CompensationModel model =
      untrained_model(arm, BackboneLayout::base_poses, {100, 100, 100}, 9);
  SpeedSettings settings = brief();
  settings.optional_peers = false;
  const nlohmann::ordered_json json = to_json(measure_speed(arm, &model, settings));
  EXPECT_THAT(names_of(json["peers"]), ElementsAre("eigen"));
  EXPECT_FALSE(json.contains("model"));
  EXPECT_EQ(json["network"]["layout"], model.shape());
}

TEST(SpeedBenchmark, FastestBatchIsTakenOnOneThread) {
  const std::vector<QueryRate> rates = {{1, 1, 5.0}, {8, 1, 9.0}, {16, 1, 7.0}, {64, 2, 20.0}};
  EXPECT_EQ(fastest_batch(rates).batch_size, 8);
}

}  // namespace
}  // namespace limber
