#include "limber/lab/output_folder.hpp"

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;
using Start = OutputFolder::Start;

class OutputFolders : public ::testing::Test {
 protected:
  OutputFolder open(Start start = Start::fresh, const std::vector<fs::path>& inputs = {}) const {
    return OutputFolder(out(), "demo", start, inputs);
  }
  void put(const std::string& name, const std::string& content = "mine") const {
    write_file_atomically(out() / name, content);
  }
  bool holds(const std::string& name) const { return fs::exists(fs::symlink_status(out() / name)); }
  fs::path out() const { return folder_.path() / "out"; }

  /// A finished run's folder.
  void finished_run() const {
    OutputFolder folder = open();
    folder.write("report.html", "a");
    folder.write("plots/a.svg", "b");
    folder.write_with({"train.h5"}, [&] { put("train.h5", "c"); });
  }

  TemporaryFolder folder_;
};

TEST_F(OutputFolders, TheNextRunRemovesWhatTheLastOneWroteAndEmptyFolders) {
  finished_run();
  const OutputFolder again = open();
  EXPECT_FALSE(holds("report.html"));
  EXPECT_FALSE(holds("plots"));
  EXPECT_FALSE(holds("train.h5"));
  EXPECT_THAT(again.left(), IsEmpty());
  EXPECT_EQ(again.about_left(), "");
}

TEST_F(OutputFolders, WhatSomebodyElsePutThereIsNeverRemoved) {
  for (const Start start : {Start::fresh, Start::forced}) {
    finished_run();
    put("my_model.safetensors");
    put("plots/my.svg");
    put("notes/deep/a.txt");
    const OutputFolder again = open(start);
    EXPECT_TRUE(holds("my_model.safetensors"));
    EXPECT_TRUE(holds("plots/my.svg"));
    EXPECT_FALSE(holds("plots/a.svg"));
    EXPECT_THAT(again.left(),
                ElementsAre("my_model.safetensors", "notes/deep/a.txt", "plots/my.svg"));
    EXPECT_THAT(again.about_left(),
                AllOf(HasSubstr("left as they are, because limber demo did not"),
                      HasSubstr("my_model.safetensors")));
  }
}

TEST_F(OutputFolders, AResultThatWasChangedSinceIsSomebodyElses) {
  finished_run();
  put("train.h5", "my ten hours");
  OutputFolder again = open();
  EXPECT_EQ(read_file(out() / "train.h5"), "my ten hours");
  EXPECT_THAT(
      [&] {
        again.require_free({"report.html", "train.h5"});
      },
      ThrowsMessage<InputError>(
          AllOf(HasSubstr("out/train.h5"), HasSubstr("changed since"), HasSubstr("move it away"))));
  EXPECT_THROW(again.write("train.h5", "x"), InputError);
  EXPECT_THROW(again.write_with({"train.h5"}, [&] { put("train.h5", "x"); }), InputError);
  EXPECT_EQ(read_file(out() / "train.h5"), "my ten hours");
}

TEST_F(OutputFolders, AKilledRunsFilesAreRemovedToo) {
  {
    OutputFolder folder = open();
    folder.write("report.html", "a");
    // Killed between the file and its hash, and amid a collection.
    EXPECT_THROW(folder.write_with({"train.h5"},
                                   [&] {
                                     put("train.h5", "half");
                                     put("train.h5.parts/000003.h5", "an episode");
                                     put("train.h5.parts/my_notes.txt");
                                     throw SystemFault("killed");
                                   }),
                 SystemFault);
  }
  const OutputFolder again = open();
  EXPECT_FALSE(holds("report.html"));
  EXPECT_FALSE(holds("train.h5"));
  EXPECT_FALSE(holds("train.h5.parts/000003.h5"));
  EXPECT_THAT(again.left(), ElementsAre("train.h5.parts/my_notes.txt"));
}

TEST_F(OutputFolders, WithoutAManifestForceIsNeededAndRemovesNothing) {
  for (const char* manifest :
       {"", "Results of limber demo; the next run replaces them.\n",
        "{\"schema\":\"limber/output/1\",\"files\":{\"../thesis.tex\":\"\"}}",
        "{\"schema\":\"limber/output/1\",\"files\":{\"/etc/passwd\":\"\"}}",
        "{\"schema\":\"limber/output/1\",\"files\":[]}"}) {
    fs::remove_all(out());
    put("thesis.tex");
    if (*manifest != '\0') {
      put(".limber-demo", manifest);
    }
    EXPECT_THAT([&] { (void)open(); }, ThrowsMessage<InputError>(AllOf(
                                           HasSubstr("out: holds files"), HasSubstr("--force"))))
        << manifest;
    EXPECT_THROW((void)open(Start::resumed), InputError);
    {
      OutputFolder forced = open(Start::forced);
      EXPECT_THAT(forced.left(), ElementsAre("thesis.tex"));
      EXPECT_THROW(forced.write("thesis.tex", "x"), InputError);
      forced.write("report.html", "a");
    }
    const OutputFolder again = open();
    EXPECT_EQ(read_file(out() / "thesis.tex"), "mine");
    EXPECT_FALSE(holds("report.html"));
  }
}

TEST_F(OutputFolders, NothingIsRemovedNorWrittenThroughALink) {
  finished_run();
  const fs::path elsewhere = folder_.path() / "elsewhere";
  write_file_atomically(elsewhere / "a.svg", "b");  // of the very content that was listed
  fs::remove_all(out() / "plots");
  fs::create_directory_symlink(elsewhere, out() / "plots");
  fs::remove(out() / "report.html");
  fs::create_symlink(elsewhere / "a.svg", out() / "report.html");
  OutputFolder again = open();
  EXPECT_TRUE(fs::exists(elsewhere / "a.svg"));
  EXPECT_TRUE(holds("report.html"));
  EXPECT_THROW(again.write("report.html", "x"), InputError);
  EXPECT_THROW(again.write("plots/a.svg", "x"), InputError);
  EXPECT_EQ(read_file(elsewhere / "a.svg"), "b");
}

TEST_F(OutputFolders, ResumingKeepsEverythingAndGoesOnWithTheList) {
  finished_run();
  {
    OutputFolder resumed = open(Start::resumed);
    EXPECT_TRUE(holds("report.html"));
    resumed.write("report.html", "newer");
    resumed.write("table.md", "t");
    resumed.remove("plots/a.svg");
    EXPECT_FALSE(holds("plots/a.svg"));
  }
  (void)open();
  EXPECT_FALSE(holds("report.html"));
  EXPECT_FALSE(holds("table.md"));
}

TEST_F(OutputFolders, AFileThatWasEditedSinceIsRefusedByName) {
  OutputFolder folder = open();
  folder.write("trials/a.json", "1");
  EXPECT_NO_THROW(folder.require_unchanged({"trials/a.json", "trials/of_another.json"}));
  put("trials/a.json", "2");
  EXPECT_THAT([&] { folder.require_unchanged({"trials/a.json"}); },
              ThrowsMessage<InputError>(HasSubstr("trials/a.json: has changed since limber")));
}

TEST_F(OutputFolders, InputsInTheFolderAreRefusedHoweverTheyAreNamed) {
  finished_run();
  put("envs/a.yaml");
  fs::create_symlink(out() / "envs", folder_.path() / "link");
  fs::create_symlink(folder_.path() / "else.yaml", out() / "link.yaml");
  for (const fs::path& input :
       {out(), out() / "envs", out() / "envs/a.yaml", out() / "../out/./envs", out() / "",
        folder_.path() / "link", folder_.path() / "link/a.yaml", out() / "link.yaml"}) {
    EXPECT_THAT([&] { (void)open(Start::forced, {input}); },
                ThrowsMessage<InputError>(HasSubstr("lies in")))
        << input;
  }
  EXPECT_TRUE(holds("report.html"));
  EXPECT_FALSE(lies_in(folder_.path() / "outer/a.yaml", out()));
  EXPECT_FALSE(lies_in(folder_.path(), out()));
}

TEST_F(OutputFolders, TheCurrentFolderIsNeverFilled) {
  EXPECT_THAT([] { OutputFolder(fs::current_path(), "demo", Start::forced); },
              ThrowsMessage<InputError>(HasSubstr("current folder")));
}

TEST_F(OutputFolders, AFileInItsPlaceIsRefused) {
  write_file_atomically(out(), "x");
  EXPECT_THAT([&] { (void)open(Start::forced); },
              ThrowsMessage<InputError>(HasSubstr("is a file")));
}

}  // namespace
}  // namespace limber
