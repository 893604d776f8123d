#include "limber/experiment/output_folder.hpp"

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(OutputFolder, ReplacesWhatItMadeItself) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  prepare_output_folder(out, false);
  write_file_atomically(out / "plots/old.svg", "x");
  prepare_output_folder(out, false);
  EXPECT_FALSE(fs::exists(out / "plots"));
}

TEST(OutputFolder, SparesTheUsersFilesUnlessForced) {
  const TemporaryFolder folder;
  const fs::path thesis = folder.path() / "out/thesis.tex";
  write_file_atomically(thesis, "x");
  EXPECT_THAT([&] { prepare_output_folder(thesis.parent_path(), false); },
              ThrowsMessage<InputError>(HasSubstr("--force")));
  EXPECT_TRUE(fs::exists(thesis));
  prepare_output_folder(thesis.parent_path(), true);
  EXPECT_FALSE(fs::exists(thesis));
}

TEST(OutputFolder, NeverWipesTheCurrentFolder) {
  EXPECT_THAT([] { prepare_output_folder(fs::current_path(), true); },
              ThrowsMessage<InputError>(HasSubstr("current folder")));
}

TEST(OutputFolder, RefusesAFileInItsPlace) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "out", "x");
  EXPECT_THAT([&] { prepare_output_folder(folder.path() / "out", true); },
              ThrowsMessage<InputError>(HasSubstr("is a file")));
}

}  // namespace
}  // namespace limber
