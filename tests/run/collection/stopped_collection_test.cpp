#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "run/collection/collection_fixture.hpp"
#include "support/file_size_limit.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// What a run leaves that was killed after its first episodes.
class StoppedCollection : public Collection {
 protected:
  void SetUp() override {
    settings_.jobs = 1;
    FakeFaults faults;
    faults.fails_at_s = 0.3;
    const DriverFactory flaky = [&](int i) {
      return std::make_unique<FakeArm>(arm_, kLag_s, i == 3 ? faults : FakeFaults{});
    };
    EXPECT_THROW(collect(arm_, settings_, flaky, path_), SystemFault);
    ASSERT_TRUE(fs::exists(parts_ / "000000.h5"));
    settings_.resume = true;
  }

  CollectionSettings settings_ = quick_settings();
};

TEST_F(StoppedCollection, RemovesPartsThatAFinishedFileHolds) {
  const fs::path kept = folder_.path() / "kept";
  fs::copy(parts_, kept);
  collect(arm_, settings_, factory(), path_);
  const std::string whole = read_file(path_);
  fs::rename(kept, parts_);  // as if the run had been killed just before it removed them
  drivers_ = 0;
  const CollectionResult result = collect(arm_, settings_, factory(), path_);
  EXPECT_EQ(result.kept_episodes, 5);
  EXPECT_EQ(drivers_, 0);
  EXPECT_EQ(read_file(path_), whole);
  EXPECT_FALSE(fs::exists(parts_));
  fs::create_directory(parts_);  // killed between the last part and their folder
  EXPECT_EQ(collect(arm_, settings_, factory(), path_).kept_episodes, 5);
  EXPECT_FALSE(fs::exists(parts_));
}

TEST_F(StoppedCollection, KeepsPartsThatAFinishedFileDoesNotHold) {
  CollectionSettings once = quick_settings();
  const fs::path other = folder_.path() / "other.h5";
  const DriverFactory slower = [this](int) {
    return std::make_unique<FakeArm>(arm_, 1.5 * kLag_s);
  };
  collect(arm_, once, slower, other);  // the same schedule and settings, on an arm that has aged
  fs::rename(other, path_);
  const std::string before = read_file(path_);
  EXPECT_THAT([&] { collect(arm_, settings_, factory(), path_); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("run.h5: exists already"), HasSubstr("--resume --force"))));
  EXPECT_TRUE(fs::exists(parts_ / "000000.h5"));
  EXPECT_EQ(read_file(path_), before);
  settings_.force = true;
  EXPECT_EQ(collect(arm_, settings_, factory(), path_).kept_episodes, 3);
  EXPECT_NE(read_file(path_), before);
  EXPECT_FALSE(fs::exists(parts_));
}

TEST_F(StoppedCollection, ReplacesWhatWasThereWhereItIsForced) {
  fs::remove_all(parts_);  // stopped before its first episode was finished
  write_file_atomically(path_, "what was there before");
  EXPECT_THROW(collect(arm_, settings_, factory(), path_), InputError);
  settings_.force = true;
  EXPECT_EQ(collect(arm_, settings_, factory(), path_).kept_episodes, 0);
  EXPECT_EQ(read_recording(path_).episodes.size(), 5U);
}

TEST_F(StoppedCollection, StopsWhereItsCallerAsksToAndGoesOn) {
  int asked = 0;
  settings_.should_stop = [&] { return ++asked > 3; };
  EXPECT_THAT([&] { collect(arm_, settings_, factory(), path_); },
              ThrowsMessage<Interrupted>(HasSubstr("3 of 5 episodes are kept")));
  EXPECT_FALSE(fs::exists(path_));
  settings_.should_stop = {};
  EXPECT_EQ(collect(arm_, settings_, factory(), path_).kept_episodes, 3);
}

TEST_F(StoppedCollection, NeverRemovesFilesThatAreNotItsOwn) {
  const std::vector<std::string> foreign = {"my_notes.txt", "000000.h5.bak", "12.h5", "a.h5"};
  for (const std::string& name : foreign) {
    write_file_atomically(parts_ / name, "mine");
  }
  settings_.resume = false;
  settings_.force = true;
  const CollectionResult result = collect(arm_, settings_, factory(), path_);
  EXPECT_EQ(result.kept_episodes, 0);
  EXPECT_EQ(result.foreign_files, foreign.size());
  for (const std::string& name : foreign) {
    EXPECT_EQ(read_file(parts_ / name), "mine");
  }
  EXPECT_FALSE(fs::exists(parts_ / "000000.h5"));
  EXPECT_FALSE(fs::exists(parts_ / "000004.h5"));
}

TEST_F(StoppedCollection, KeepsAllPartsAndTheOldFileWhereTheDiskIsFull) {
  const std::string old = "what was there before";
  write_file_atomically(path_, old);
  settings_.force = true;
  const auto part = fs::file_size(parts_ / "000000.h5");
  {
    const FileSizeLimit limit(part + part / 2);  // room for every part, not for all of them joined
    EXPECT_THAT([&] { collect(arm_, settings_, factory(), path_); },
                ThrowsMessage<SystemFault>(
                    AllOf(HasSubstr("run.h5: can't be written: File too large"),
                          HasSubstr("All episodes are kept in"), HasSubstr("--resume"))));
  }
  EXPECT_EQ(read_file(path_), old);
  drivers_ = 0;
  const CollectionResult resumed = collect(arm_, settings_, factory(), path_);
  EXPECT_EQ(resumed.kept_episodes, 5);
  EXPECT_EQ(drivers_, 0);
  const fs::path undisturbed = folder_.path() / "undisturbed.h5";
  collect(arm_, quick_settings(), factory(), undisturbed);
  EXPECT_EQ(read_file(path_), read_file(undisturbed));
}

}  // namespace
}  // namespace limber
