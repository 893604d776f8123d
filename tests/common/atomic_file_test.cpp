#include "limber/common/atomic_file.hpp"

#include <fstream>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

int count_entries(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(AtomicFile, WritesMakesFoldersAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a/b/c.txt";
  write_file_atomically(path, "hello");
  EXPECT_EQ(read_file(path), "hello");
  EXPECT_EQ(count_entries(path.parent_path()), 1);
}

TEST(AtomicFile, KeepsTheOldFileWhenTheWriterThrows) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "c.txt";
  write_file_atomically(path, "old");
  EXPECT_THROW(write_atomically(path,
                                [](const fs::path& temporary) {
                                  std::ofstream(temporary) << "half";
                                  throw InputError("no");
                                }),
               InputError);
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(count_entries(folder.path()), 1);
}

TEST(AtomicFile, RefusesToOverwriteUnlessForced) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "c.txt";
  EXPECT_NO_THROW(refuse_to_overwrite(path, false));
  write_file_atomically(path, "x");
  EXPECT_THAT([&] { refuse_to_overwrite(path, false); },
              ThrowsMessage<InputError>(HasSubstr("--force")));
  EXPECT_NO_THROW(refuse_to_overwrite(path, true));
}

TEST(AtomicFile, NeverReplacesFoldersDevicesOrLinks) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "c.txt";
  write_file_atomically(file, "x");
  fs::create_symlink(file, folder.path() / "link");
  for (const fs::path& path : {folder.path(), fs::path("/dev/null"), folder.path() / "link"}) {
    EXPECT_THAT([&] { refuse_to_overwrite(path, true); },
                ThrowsMessage<InputError>(HasSubstr("no plain file")));
  }
  EXPECT_THAT([&] { refuse_to_overwrite(file / "x", true); },
              ThrowsMessage<InputError>(HasSubstr("is no folder")));
}

TEST(AtomicFile, NamesAMissingFile) {
  EXPECT_THAT([] { read_file("/nowhere/x.yaml"); },
              ThrowsMessage<InputError>(HasSubstr("/nowhere/x.yaml")));
}

}  // namespace
}  // namespace limber
