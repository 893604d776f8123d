#include "limber/common/atomic_file.hpp"

#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "src/common/temporary_file.hpp"
#include "support/file_size_limit.hpp"
#include "support/temporary_folder.hpp"

namespace {

/// What this program has had put on disk, where anybody asks: its path and its size then.
std::vector<std::pair<std::filesystem::path, std::int64_t>>* synced = nullptr;

}  // namespace

/// In place of the C library's, which tells nobody that it was called.
extern "C" int fsync(int descriptor) {
  if (synced != nullptr) {
    struct stat found {};
    ::fstat(descriptor, &found);
    synced->emplace_back(
        std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor)),
        S_ISDIR(found.st_mode) ? -1 : std::int64_t{found.st_size});
  }
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

std::string repeat(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) {
    result += text;
  }
  return result;
}

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

// Else a power cut after the rename leaves an empty file, and one before the folder is on disk the
// old one, though the new one was reported.
TEST(AtomicFile, IsOnDiskBeforeItHasItsNameAndItsNameIsOnDiskAtTheEnd) {
  const TemporaryFolder temporary;
  const fs::path folder = fs::canonical(temporary.path());
  const fs::path path = folder / "c.txt";
  std::vector<std::pair<fs::path, std::int64_t>> calls;
  synced = &calls;
  write_file_atomically(path, "hello");
  synced = nullptr;
  ASSERT_EQ(calls.size(), 2U);
  EXPECT_EQ(calls[0].first.parent_path(), folder);
  EXPECT_NE(calls[0].first, path);
  EXPECT_EQ(calls[0].second, 5) << "all of it";
  EXPECT_EQ(calls[1], std::pair(folder, std::int64_t{-1}));
}

TEST(AtomicFile, KeepsTheOldFileWhereTheDiskIsFull) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "c.txt";
  write_file_atomically(path, "old");
  {
    const FileSizeLimit limit(1000);
    EXPECT_THAT([&] { write_file_atomically(path, std::string(2000, 'x')); },
                ThrowsMessage<SystemFault>(AllOf(HasSubstr(path.string()),
                                                 HasSubstr("can't be written: File too large"))));
  }
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(count_entries(folder.path()), 1);
}

TEST(AtomicFile, TakesNamesAsLongAsTheFileSystemDoes) {
  const TemporaryFolder folder;
  for (const std::string& name : {std::string(255, 'n'), std::string("m") + repeat("é", 127)}) {
    refuse_to_overwrite(folder.path() / name, false);
    write_file_atomically(folder.path() / name, name);
    EXPECT_EQ(read_file(folder.path() / name), name);
  }
  EXPECT_EQ(count_entries(folder.path()), 2);
}

TEST(AtomicFile, RemovesWhatKilledProcessesLeftAndNothingElse) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "c.txt";
  // A child starts to write, and is killed; another one still writes.
  const auto write_until_killed = [&](const char* name) {
    const pid_t child = ::fork();
    if (child == 0) {
      std::ofstream(folder.path() / temporary_name(name)) << "half";
      while (true) {
        ::pause();
      }
    }
    return child;
  };
  const pid_t dead = write_until_killed("c.txt");
  const pid_t alive = write_until_killed("alive.txt");
  while (count_entries(folder.path()) < 2) {
    ::usleep(1000);
  }
  ::kill(dead, SIGKILL);
  ::waitpid(dead, nullptr, 0);
  // What only looks alike: another host's, one of another program, one of the user's.
  const std::vector<std::string> kept = {".c.txt.other_host-4026531836.1-1-0.tmp",
                                         ".c.txt.999999.tmp",
                                         ".tmp",
                                         "..tmp",
                                         "notes.tmp",
                                         ".a.b-c.d-e-f.tmp"};
  for (const std::string& name : kept) {
    std::ofstream(folder.path() / name) << "kept";
  }
  write_file_atomically(path, "whole");
  EXPECT_EQ(read_file(path), "whole");
  for (const std::string& name : kept) {
    EXPECT_TRUE(fs::exists(folder.path() / name)) << name;
  }
  EXPECT_EQ(count_entries(folder.path()), static_cast<int>(kept.size()) + 2);
  ::kill(alive, SIGKILL);
  ::waitpid(alive, nullptr, 0);
  remove_abandoned_files(folder.path());
  EXPECT_EQ(count_entries(folder.path()), static_cast<int>(kept.size()) + 1);
}

TEST(AtomicFile, TellsAProcessFromALaterOneOfTheSameNumber) {
  const TemporaryFolder folder;
  std::string name = temporary_name("c.txt");  // of this process, which runs, …
  std::ofstream(folder.path() / name) << "mine";
  const std::size_t start = name.rfind('-', name.rfind('-') - 1) + 1;
  name.replace(start, name.rfind('-') - start, "1");  // … and as if it had started at boot
  std::ofstream(folder.path() / name) << "of the one before";
  remove_abandoned_files(folder.path());
  EXPECT_EQ(count_entries(folder.path()), 1);
  EXPECT_FALSE(fs::exists(folder.path() / name));
}

/// It has not been waited for.
pid_t child_that_leaves_half(const fs::path& folder) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::ofstream(folder / temporary_name("c.txt")) << "half";
    ::_exit(0);
  }
  return child;
}

// Of a process that has ended, as in a container whose first process waits for nobody.
TEST(AtomicFile, WhoseParentHasNotHeardOfItsEndLeavesNothing) {
  const TemporaryFolder folder;
  const pid_t child = child_that_leaves_half(folder.path());
  siginfo_t ended;
  ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT), 0);
  EXPECT_EQ(count_entries(folder.path()), 1);
  remove_abandoned_files(folder.path());
  EXPECT_EQ(count_entries(folder.path()), 0);
  ::waitpid(child, nullptr, 0);
}

TEST(AtomicFile, LooksForWhatWasLeftWhereItTriesAName) {
  const TemporaryFolder folder;
  const pid_t child = child_that_leaves_half(folder.path());
  ::waitpid(child, nullptr, 0);
  refuse_to_overwrite(folder.path() / "csv" / "x", false);
  EXPECT_EQ(count_entries(folder.path()), 0);
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
                ThrowsMessage<InputError>(HasSubstr("not a plain file")));
  }
  EXPECT_THAT([&] { refuse_to_overwrite(file / "x", true); },
              ThrowsMessage<InputError>(HasSubstr("is no folder")));
  // Nor does a writer that nobody asked before; of devices, that would be for all of the machine.
  ASSERT_EQ(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  for (const char* name : {"pipe", "link"}) {
    const fs::path path = folder.path() / name;
    const fs::file_type type = fs::symlink_status(path).type();
    EXPECT_THAT([&] { write_file_atomically(path, "y"); },
                ThrowsMessage<InputError>(HasSubstr("not a plain file")));
    EXPECT_EQ(fs::symlink_status(path).type(), type);
  }
  EXPECT_EQ(read_file(file), "x");
}

TEST(AtomicFile, RefusesWhatCannotBeWrittenBeforeTheWork) {
  const TemporaryFolder folder;
  const auto refused = [](const fs::path& path, const std::string& reason) {
    EXPECT_THAT([&] { refuse_to_overwrite(path, true); },
                ThrowsMessage<InputError>(AllOf(HasSubstr(path.string()), HasSubstr(reason))));
  };
  refused("", "names no file");
  refused(folder.path() / "results" / "", "names no file");
  refused(folder.path() / std::string(256, 'n'), "256 bytes is too long");
  refused(folder.path() / std::string(256, 'n') / "c.txt", "too long");
  refused(folder.path() / "new" / std::string(256, 'n') / "c.txt", "too long");
  refused("/proc/nowhere/c.txt", "no file can be made in /proc");
  refused("/sys/c.txt", "no file can be made in /sys");
  EXPECT_THAT([] { require_writable_folder("/proc/nowhere"); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("no file can be made in /proc"), Not(HasSubstr("nowhere/x")))));
  EXPECT_THAT([] { require_writable_folder(""); },
              ThrowsMessage<InputError>(HasSubstr("names no folder")));
  write_file_atomically(folder.path() / "file", "x");
  EXPECT_THAT([&] { require_writable_folder(folder.path() / "file"); },
              ThrowsMessage<InputError>(HasSubstr("is a file; expected a folder")));
  EXPECT_NO_THROW(refuse_to_overwrite(folder.path() / "a/b/c.txt", false));
  EXPECT_NO_THROW(require_writable_folder(folder.path() / "a/b"));
  EXPECT_EQ(count_entries(folder.path()), 1) << "nothing is left of the attempts";
}

TEST(AtomicFile, RefusesFoldersWithoutPermission) {
  if (::geteuid() == 0) {
    GTEST_SKIP() << "everything is permitted to root";
  }
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT([&] { refuse_to_overwrite(folder.path() / "c.txt", true); },
              ThrowsMessage<InputError>(HasSubstr("Permission denied")));
  fs::permissions(folder.path(), fs::perms::none);
  EXPECT_THAT([&] { refuse_to_overwrite(folder.path() / "c.txt", true); },
              ThrowsMessage<InputError>(HasSubstr("Permission denied")));
  EXPECT_THAT([&] { read_file(folder.path() / "c.txt"); },
              ThrowsMessage<InputError>(HasSubstr("Permission denied")));
  fs::permissions(folder.path(), fs::perms::owner_all);
}

TEST(ReadFile, ReturnsEveryByte) {
  const TemporaryFolder folder;
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{65536}, std::size_t{3000003}}) {
    std::string content(size, '\0');
    for (std::size_t i = 0; i < size; ++i) {
      content[i] = static_cast<char>(i * 7 + i / 251);
    }
    write_file_atomically(folder.path() / "c.bin", content);
    EXPECT_EQ(read_file(folder.path() / "c.bin"), content);
    EXPECT_EQ(file_hash(folder.path() / "c.bin"), content_hash(content)) << "a block at a time";
  }
}

TEST(ReadFile, ReadsTheKernelsFilesThatSayTheyAreEmpty) {
  EXPECT_THAT(read_file("/proc/self/status"), HasSubstr("Name:"));
}

// The memory of a process below its first page can't be read: a plain file with a read error.
TEST(ReadFile, TakesAReadErrorForAFaultOfTheMachine) {
  EXPECT_THAT([] { read_file("/proc/self/mem"); },
              ThrowsMessage<SystemFault>(HasSubstr("/proc/self/mem: can't be read: Input/output")));
  EXPECT_THROW(file_hash("/proc/self/mem"), SystemFault);
}

TEST(ReadFile, RefusesPipesAndDevicesAtOnce) {
  const TemporaryFolder folder;
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const fs::path& path : {pipe, fs::path("/dev/zero"), fs::path("/dev/null")}) {
    EXPECT_THAT([&] { read_file(path); },
                ThrowsMessage<InputError>(
                    AllOf(HasSubstr(path.string()), HasSubstr("is a pipe or a device"))));
  }
  EXPECT_THAT([&] { read_file(folder.path()); },
              ThrowsMessage<InputError>(HasSubstr("is a folder")));
}

TEST(ReadFile, RefusesFilesBeyondItsLimitBeforeReadingThem) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "huge";
  std::ofstream(path) << "x";
  fs::resize_file(path, kMaxFile + 1);  // takes no room on disk
  EXPECT_THAT([&] { read_file(path); },
              ThrowsMessage<InputError>(HasSubstr("files of up to 4294967296 bytes are read")));
}

TEST(ReadFile, NamesAMissingFile) {
  EXPECT_THAT([] { read_file("/nowhere/x.yaml"); },
              ThrowsMessage<InputError>(HasSubstr("/nowhere/x.yaml")));
}

// A run looks for its output at its start; what somebody writes while it works is not lost.
TEST(AtomicFile, KeepsBothFilesWhereSomebodyWroteItsOwnMeanwhile) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "c.txt";
  refuse_to_overwrite(path, false);
  std::ofstream(path) << "theirs";
  EXPECT_THAT([&] { write_file_atomically(path, "ours"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(path.string() + ": exists already"),
                                              HasSubstr("c.txt.2; --force"))));
  EXPECT_EQ(read_file(path), "theirs");
  EXPECT_EQ(read_file(path.string() + ".2"), "ours");
  EXPECT_EQ(count_entries(folder.path()), 2);
  refuse_to_overwrite(path, true);
  write_file_atomically(path, "forced");
  EXPECT_EQ(read_file(path), "forced");
}

TEST(AtomicFile, ReplacesWhatThisRunWroteItself) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "c.txt";
  refuse_to_overwrite(path, false);
  write_file_atomically(path, "one");
  write_file_atomically(path, "two");
  EXPECT_EQ(read_file(path), "two");
  EXPECT_EQ(count_entries(folder.path()), 1);
}

}  // namespace
}  // namespace limber
