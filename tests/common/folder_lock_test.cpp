#include "limber/common/folder_lock.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(FolderLock, IsOneRunsUntilItEnds) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a/out";
  {
    const FolderLock lock(path, "limber demo");
    EXPECT_THAT([&] { FolderLock(path, "limber demo"); },
                ThrowsMessage<InputError>(AllOf(HasSubstr(path.string() + ": another limber demo"),
                                                HasSubstr("choose another --out"))));
  }
  EXPECT_NO_THROW(FolderLock(path, "limber demo"));
  EXPECT_TRUE(fs::is_empty(path)) << "it leaves nothing";
}

TEST(FolderLock, EndsWithTheProcessHoweverThatEnds) {
  const TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    const FolderLock lock(folder.path(), "limber demo");
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_NO_THROW(FolderLock(folder.path(), "limber demo"));
}

TEST(FolderLock, OfAFolderThatWasRemovedAndMadeAgainIsTheNewOnes) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "out";
  const FolderLock old(path, "limber demo");
  fs::remove(path);
  const FolderLock fresh(path, "limber demo");
  EXPECT_THROW(FolderLock(path, "limber demo"), InputError);
}

}  // namespace
}  // namespace limber
