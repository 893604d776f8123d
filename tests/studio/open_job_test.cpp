#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/common/error.hpp"
#include "limber/planning/planner_factory.hpp"
#include "src/studio/jobs.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const fs::path kData = fs::path(LIMBER_SOURCE_DIR) / "tests/data/closed_loop";

/// A project with a saved plan, its network and its environment; its arm is limber's own.
class OpenPlan : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(root_);
    for (const char* folder : {"plans", "environments", "models"}) {
      fs::create_directories(root_ / folder);
    }
    fs::copy_file(kData / "arm_019.plan.json", plan_);
    fs::copy_file(kData / "arm_019.yaml", environment_);
    fs::copy_file(kData / "ten_hours.safetensors", model_);
  }
  void TearDown() override { fs::remove_all(root_); }

  FoundPlan open(const std::string& name = "plans/saved.json", const SceneNames& in_use = {}) {
    const ProjectFolder project(root_);
    std::optional<FoundPlan> found;
    run_open_job(
        {{7, in_use}, name}, project,
        [&](const SceneNames& names) -> const StudioScene& {
          return scene_.emplace(project, names);
        },
        events_, [&](FoundPlan one) { found = std::move(one); });
    return *std::move(found);
  }
  std::string event() { return events_.pop(std::chrono::milliseconds(0)); }

  /// Writes it again with a seal of its own after it was changed.
  template <class Change>
  void reseal(const Change& change) const {
    Plan plan = read_plan(plan_);
    change(plan);
    write_plan(plan_, plan);
  }

  /// Of the same problem. @param network  null: by the no-load model
  void plan_with(const CompensationModel* network, const ValveParameters& valves) const {
    const ArmDescription arm = load_arm(data_folder() / "arms/three_segment.yaml");
    const ForwardModel forward =
        network == nullptr ? ForwardModel(arm) : ForwardModel(arm, *network);
    PlannerLimits limits;
    limits.iterations = 500;
    PlanSettings settings;
    settings.room.margin_m = 0.001;
    PlanResult result = limber::plan(arm, MotionModel(forward, ValveModel(arm, valves)),
                                     load_environment(environment_, arm), limits, 1, settings);
    ASSERT_TRUE(result.plan) << result.reason;
    result.plan->model_hash = network == nullptr ? "" : file_hash(model_);
    write_plan(plan_, *result.plan);
  }

  fs::path root_ =
      fs::canonical(fs::temp_directory_path()) / ("limber_open_" + std::to_string(::getpid()));
  fs::path plan_ = root_ / "plans/saved.json";
  fs::path environment_ = root_ / "environments/arm_019.yaml";
  fs::path model_ = root_ / "models/a.safetensors";
  std::optional<StudioScene> scene_;
  EventQueue events_;
};

TEST_F(OpenPlan, FindsTheFilesThatItWasMadeFor) {
  const FoundPlan found = open();
  EXPECT_EQ(found.request, 7U);
  EXPECT_EQ(found.scene.arm, "limber:three_segment");
  EXPECT_EQ(found.scene.model, "models/a.safetensors");
  EXPECT_EQ(found.environment.name, "arm 19");
  EXPECT_EQ(found.plan.seed, 5019U);
  const std::string opened = event();
  EXPECT_THAT(opened, HasSubstr(R"("environment":"environments/arm_019.yaml")"));
  EXPECT_THAT(opened, HasSubstr(R"("warnings":[])"));
}

TEST_F(OpenPlan, StaysWithTheModelInUseIfThatIsItsOwn) {
  fs::copy_file(model_, root_ / "models/b.safetensors");
  EXPECT_EQ(open("plans/saved.json", {"", "models/b.safetensors"}).scene.model,
            "models/b.safetensors");
}

TEST_F(OpenPlan, OfARunHasItsEnvironmentBesideIt) {
  fs::create_directories(root_ / "runs/first.plans");
  fs::rename(plan_, root_ / "runs/first.plans/00.json");
  fs::rename(environment_, root_ / "runs/first.plans/00.yaml");
  (void)open("runs/first.plans/00.json");
  EXPECT_THAT(event(), HasSubstr(R"("environment":"runs/first.plans/00.yaml")"));
}

// As `limber experiment --model` makes them.
TEST_F(OpenPlan, OfTheNoLoadModelMayHaveANetworksValves) {
  plan_with(nullptr, read_model(model_).valves.value());
  for (const char* in_use : {"", "models/a.safetensors"}) {
    const FoundPlan found = open("plans/saved.json", {"", in_use});
    EXPECT_EQ(found.scene.model, "");
    EXPECT_FALSE(found.plan.valves_hash.empty());
    EXPECT_THAT(event(), HasSubstr("event: opened"));
  }
  fs::remove(model_);
  EXPECT_THAT([&] { (void)open(); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("plans/saved.json: made for a network with valves (hash "),
                        HasSubstr("which is not in the project folder"))));
}

// As limber plan --no-valves.
TEST_F(OpenPlan, OfANetworkMayBeWithoutItsValves) {
  const CompensationModel network = read_model(model_);
  ASSERT_TRUE(network.valves);
  plan_with(&network, {});
  EXPECT_EQ(open().scene.model, "models/a.safetensors");
}

TEST_F(OpenPlan, NamesWhatIsMissing) {
  const auto refused = [&](const std::string& why) {
    EXPECT_THAT([&] { (void)open(); }, ThrowsMessage<InputError>(HasSubstr(why)));
  };
  write_file_atomically(environment_, read_file(kData / "hard_051.yaml"));
  refused("plans/saved.json: made for environment 'arm 19' (hash a3f1310fb63c");
  fs::remove(model_);
  refused("plans/saved.json: made for a network (hash ");
  reseal([](Plan& plan) {
    plan.arm_name = "another";
    plan.arm_hash = "0";
    plan.arm_description.clear();
  });
  refused("plans/saved.json: made for arm 'another' (hash 0), which is not in the project");
}

TEST_F(OpenPlan, WithoutACertificateThatHoldsIsRefused) {
  const std::string saved = read_file(plan_);
  const auto refused = [&](const std::string& why) {
    EXPECT_THAT([&] { (void)open(); }, ThrowsMessage<InputError>(HasSubstr(why)));
    write_file_atomically(plan_, saved);
  };
  std::string text = saved;
  text.replace(text.find("\"seed\": 5019"), 12, "\"seed\": 5018");
  write_file_atomically(plan_, text);
  refused("was changed since");
  reseal([](Plan& plan) { plan.certified.reset(); });
  refused("the plan has no certificate");
  reseal([](Plan& plan) { plan.clearance_m += 0.01; });
  refused("plans/saved.json: its certificate fails: clearance_m = ");
  EXPECT_EQ(event(), "") << "nothing was opened";
}

TEST_F(OpenPlan, SaysWhereItKeepsLessRoomThanItsModelAsksFor) {
  reseal([](Plan& plan) { plan.margin_m = 0.001; });
  (void)open();
  EXPECT_THAT(event(), HasSubstr("it keeps 0.10 cm from obstacles; the model's error asks for "
                                 "0.87 cm"));
}

}  // namespace
}  // namespace limber
