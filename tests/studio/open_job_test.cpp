#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "src/studio/jobs.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
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
