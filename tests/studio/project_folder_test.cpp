#include "src/studio/project_folder.hpp"

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

const char* const kArm = "schema: limber/arm/1\n";
const char* const kEnvironment = "schema: limber/environment/1\n";
const char* const kPlan = R"({"schema": "limber/plan/2"})";

class Project : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(root_);
    write_file_atomically(root_ / "project/arms/mine.yaml", kArm);
    write_file_atomically(root_ / "project/environments/mine.yaml", kEnvironment);
    write_file_atomically(root_ / "project/.hidden/mine.yaml", kEnvironment);
    write_file_atomically(root_ / "project/notes.yaml", "hello: world\n");
    write_file_atomically(root_ / "outside/secret.yaml", kEnvironment);
    write_file_atomically(root_ / "project/runs/first.h5", "\x89HDF\r\n\x1a\n");
    write_file_atomically(root_ / "project/runs/text.h5", "no recording");
    write_file_atomically(root_ / "project/runs/first.plans/00.yaml", kEnvironment);
    write_file_atomically(root_ / "project/runs/first.plans/00.json", kPlan);
    write_file_atomically(root_ / "project/plans/mine.json", kPlan);
    write_file_atomically(root_ / "project/plans/notes.json", "{}");
    write_file_atomically(root_ / "project/table/plans/trial.json", kPlan);
    write_file_atomically(root_ / "project/table/experiment.json", "{}");
    write_file_atomically(root_ / "project/models/family.safetensors", R"({"family.arms":{}})");
    write_file_atomically(root_ / "project/models/member.safetensors",
                          R"({"family.arms":{},"family.e":{}})");
    write_file_atomically(root_ / "project/table/trials/mine.yaml", kEnvironment);
    fs::create_directory_symlink(root_ / "outside", root_ / "project/out");
    fs::create_symlink(root_ / "outside/secret.yaml", root_ / "project/link.yaml");
    write_file_atomically(root_ / "outside/far.safetensors", R"({"family.arms":{}})");
    fs::create_symlink(root_ / "outside/far.safetensors", root_ / "project/models/far.safetensors");
  }
  void TearDown() override { fs::remove_all(root_); }

  fs::path root_ =
      fs::canonical(fs::temp_directory_path()) / ("limber_project_" + std::to_string(::getpid()));
};

TEST_F(Project, OffersWhatFilesSayThatTheyAre) {
  const ProjectFolder project(root_ / "project");
  EXPECT_THAT(project.names(ProjectItem::arm), Contains("arms/mine.yaml"));
  EXPECT_THAT(project.names(ProjectItem::arm), Contains("limber:three_segment"));
  const std::vector<std::string> environments = project.names(ProjectItem::environment);
  EXPECT_THAT(environments, Contains("environments/mine.yaml"));
  EXPECT_THAT(environments, Contains("limber:01_pillar"));
  EXPECT_THAT(environments, Not(Contains(HasSubstr("notes"))));
  EXPECT_THAT(environments, Not(Contains(HasSubstr("hidden"))));
  EXPECT_THAT(environments, Not(Contains(HasSubstr("secret"))));
  EXPECT_THAT(environments, Not(Contains("link.yaml")));
  EXPECT_THAT(environments, Not(Contains(HasSubstr("plans"))));
}

TEST_F(Project, OffersRecordingsFamiliesAndExperiments) {
  const ProjectFolder project(root_ / "project");
  EXPECT_THAT(project.names(ProjectItem::recording), ElementsAre("runs/first.h5"));
  EXPECT_THROW((void)project.find(ProjectItem::recording, "limber:first"), InputError);
  EXPECT_THAT(project.names(ProjectItem::model), Contains("limber:three_segment"));
  EXPECT_THAT(project.families(), Contains("limber:three_segment"));
  EXPECT_THAT(project.families(), Contains("models/family.safetensors"));
  EXPECT_THAT(project.families(), Not(Contains("models/member.safetensors")));
  EXPECT_THAT(project.experiments(), ElementsAre("table"));
  EXPECT_THAT(project.names(ProjectItem::environment), Not(Contains(HasSubstr("trials"))));
}

TEST_F(Project, OffersPlansOfRunsTooAndFindsThoseOfExperiments) {
  const ProjectFolder project(root_ / "project");
  EXPECT_THAT(project.names(ProjectItem::plan),
              ElementsAre("plans/mine.json", "runs/first.plans/00.json"));
  EXPECT_EQ(project.find(ProjectItem::plan, "table/plans/trial.json"),
            root_ / "project/table/plans/trial.json");
  for (const char* name : {"limber:mine", "environments/mine.yaml", "../plans/mine.json"}) {
    EXPECT_THROW((void)project.find(ProjectItem::plan, name), InputError) << name;
  }
}

TEST_F(Project, FindsWhatItOffers) {
  const ProjectFolder project(root_ / "project");
  EXPECT_EQ(project.find(ProjectItem::environment, "environments/mine.yaml"),
            root_ / "project/environments/mine.yaml");
  for (const std::string& name : project.names(ProjectItem::environment)) {
    if (name != "link.yaml") {
      EXPECT_TRUE(fs::exists(project.find(ProjectItem::environment, name))) << name;
    }
  }
}

TEST_F(Project, NoNameLeadsOut) {
  const ProjectFolder project(root_ / "project");
  const std::vector<std::string> tricks = {"../outside/secret.yaml",
                                           "environments/../../outside/secret.yaml",
                                           (root_ / "outside/secret.yaml").string(),
                                           "out/secret.yaml",
                                           "link.yaml",
                                           "limber:../arms/three_segment",
                                           "limber:",
                                           "given:secret.yaml",
                                           "",
                                           ".",
                                           "environments",
                                           "/etc/passwd",
                                           "missing.yaml",
                                           std::string(100000, 'a') + ".yaml"};
  for (const std::string& name : tricks) {
    EXPECT_THAT([&] { (void)project.find(ProjectItem::environment, name); },
                ThrowsMessage<InputError>(HasSubstr("no file of the project folder")))
        << name.substr(0, 100);
  }
  const std::string cut("environments/mine.yaml\0.yaml", 28);
  EXPECT_THROW((void)project.find(ProjectItem::environment, cut), InputError);
}

TEST_F(Project, AFileThatTheCommandLineNamedMayLieAnywhere) {
  ProjectFolder project(root_ / "project");
  const std::string name = project.give(ProjectItem::environment, root_ / "outside/secret.yaml");
  EXPECT_EQ(project.find(ProjectItem::environment, name), root_ / "outside/secret.yaml");
  EXPECT_EQ(project.give(ProjectItem::arm, root_ / "project/arms/mine.yaml"), "arms/mine.yaml");
}

TEST_F(Project, SavesInsideAndNowhereElse) {
  const ProjectFolder project(root_ / "project");
  EXPECT_EQ(project.to_save("environments", "new one", ".yaml"),
            root_ / "project/environments/new one.yaml");
  EXPECT_EQ(project.to_save("environments", "mine.yaml", ".yaml"),
            root_ / "project/environments/mine.yaml");
  for (const std::string name : {"", "..", ".x", "a/b", "../a", "a\\b", "ä", "a\n"}) {
    EXPECT_THAT([&] { (void)project.to_save("environments", name, ".yaml"); },
                ThrowsMessage<InputError>(HasSubstr("letters, digits")))
        << name;
  }
  EXPECT_THAT([&] { (void)project.to_save("out", "a", ".yaml"); },
              ThrowsMessage<InputError>(HasSubstr("leads out")));
}

TEST_F(Project, IsAFolder) {
  EXPECT_THAT([&] { ProjectFolder project(root_ / "missing"); },
              ThrowsMessage<InputError>(HasSubstr("no such folder")));
}

}  // namespace
}  // namespace limber
