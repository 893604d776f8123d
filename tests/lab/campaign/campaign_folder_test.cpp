#include "limber/lab/campaign_folder.hpp"

#include <cstdlib>

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/folder_lock.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Units of 1, 3 and 2 episodes.
Campaign unequal_units() {
  Campaign campaign;
  campaign.verb = "collect";
  campaign.flags = {{"count", {"6"}}};
  campaign.factors = {{"episodes", {{"1"}, {"3"}, {"2"}}, std::nullopt}};
  return campaign;
}

class CampaignFolderTest : public ::testing::Test {
 protected:
  CampaignUnit unit(std::size_t index) const { return campaign_unit(campaign_, index); }

  TemporaryFolder temporary_;
  std::filesystem::path path_ = temporary_.path() / "out";
  Campaign campaign_ = unequal_units();
};

TEST_F(CampaignFolderTest, MissingUnitsAreOrderedDearestFirst) {
  CampaignFolder folder(path_, campaign_);
  EXPECT_THAT(missing_units(campaign_, folder), ElementsAre(1, 2, 0));
  folder.begin(unit(1));
  folder.finish(unit(1), {{"frames", 7}}, 0.5);
  EXPECT_THAT(missing_units(campaign_, folder), ElementsAre(2, 0));
  EXPECT_EQ(folder.result(unit(1))["result"]["frames"], 7);
}

TEST_F(CampaignFolderTest, AUnitIsWaitingStartedFailedAndDoneInTurn) {
  CampaignFolder folder(path_, campaign_);
  EXPECT_EQ(folder.state(unit(0)), UnitState::waiting);
  folder.begin(unit(0));
  EXPECT_EQ(folder.state(unit(0)), UnitState::started);
  folder.fail(unit(0), 2);
  EXPECT_EQ(folder.state(unit(0)), UnitState::failed);
  folder.begin(unit(0));
  EXPECT_EQ(folder.state(unit(0)), UnitState::started);
  folder.finish(unit(0), {}, 0.5);
  EXPECT_EQ(folder.state(unit(0)), UnitState::done);
}

// What a process left that was killed is not taken for the unit's own.
TEST_F(CampaignFolderTest, AUnitBeginsInAnEmptyFolder) {
  CampaignFolder folder(path_, campaign_);
  folder.begin(unit(0));
  const std::filesystem::path left = folder.unit_folder(0) / "recording.h5";
  write_file_atomically(left, "half of it");
  const FolderLock lock(folder.unit_folder(0), "limber campaign");
  folder.begin(unit(0));
  EXPECT_FALSE(std::filesystem::exists(left));
  EXPECT_THROW(FolderLock(folder.unit_folder(0), "limber campaign"), InputError);
}

TEST_F(CampaignFolderTest, AnotherCommandOrInputIsAnotherUnit) {
  const std::filesystem::path data = temporary_.path() / "data.h5";
  write_file_atomically(data, "one");
  campaign_.flags.push_back({"data", {data.string()}});
  CampaignFolder folder(path_, campaign_);
  folder.begin(unit(0));
  folder.finish(unit(0), {}, 0.5);
  EXPECT_EQ(folder.state(unit(0)), UnitState::done);
  write_file_atomically(data, "two");
  EXPECT_EQ(CampaignFolder(path_, campaign_).state(unit(0)), UnitState::waiting);
  write_file_atomically(data, "one");
  EXPECT_EQ(CampaignFolder(path_, campaign_).state(unit(0)), UnitState::done);
  campaign_.cpu = CpuLevel::avx2;
  EXPECT_EQ(CampaignFolder(path_, campaign_).state(unit(0)), UnitState::waiting);
}

TEST_F(CampaignFolderTest, OtherEnvironmentsInAFolderAreAnotherUnit) {
  const std::filesystem::path places = temporary_.path() / "places";
  std::filesystem::create_directories(places);
  write_file_atomically(places / "a.yaml", "one");
  campaign_.flags.push_back({"environments", {places.string()}});
  campaign_.flags.push_back({"schedule", {temporary_.path().string()}});  // a folder by chance
  CampaignFolder folder(path_, campaign_);
  folder.begin(unit(0));
  folder.finish(unit(0), {}, 0.5);
  write_file_atomically(places / "notes.txt", "no environment");
  write_file_atomically(temporary_.path() / "other.yaml", "no input");
  EXPECT_EQ(CampaignFolder(path_, campaign_).state(unit(0)), UnitState::done);
  write_file_atomically(places / "a.yaml", "two");
  EXPECT_EQ(CampaignFolder(path_, campaign_).state(unit(0)), UnitState::waiting);
  write_file_atomically(places / "a.yaml", "one");
  write_file_atomically(places / "b.yaml", "one");
  EXPECT_EQ(CampaignFolder(path_, campaign_).state(unit(0)), UnitState::waiting);
}

// limber's own arms are named, not given as files; a changed one is another unit all the same.
TEST_F(CampaignFolderTest, AChangedArmOfLimbersOwnIsAnotherUnit) {
  std::filesystem::create_directories(temporary_.path() / "arms");
  const std::filesystem::path arm =
      temporary_.path() / "arms" / "three_segment.yaml";  // the default
  write_file_atomically(arm, "one");
  ::setenv("LIMBER_DATA_DIR", temporary_.path().c_str(), 1);
  CampaignFolder folder(path_, campaign_);
  folder.begin(unit(0));
  folder.finish(unit(0), {}, 0.5);
  EXPECT_EQ(CampaignFolder(path_, campaign_).state(unit(0)), UnitState::done);
  write_file_atomically(arm, "two");
  EXPECT_EQ(CampaignFolder(path_, campaign_).state(unit(0)), UnitState::waiting);
  ::unsetenv("LIMBER_DATA_DIR");
}

TEST_F(CampaignFolderTest, FindsWhatAnotherRunFinishedBeforeItIsErased) {
  const std::filesystem::path data = temporary_.path() / "data.h5";
  write_file_atomically(data, "one");
  campaign_.flags.push_back({"data", {data.string()}});
  CampaignFolder folder(path_, campaign_);
  folder.begin(unit(1));
  folder.finish(unit(1), {}, 0.5);
  EXPECT_NO_THROW(folder.require_none_finished_otherwise(missing_units(campaign_, folder)));
  std::filesystem::remove(data);
  CampaignFolder changed(path_, campaign_);
  EXPECT_THAT([&] { changed.require_none_finished_otherwise(missing_units(campaign_, changed)); },
              ThrowsMessage<InputError>(HasSubstr("001: was finished with other input files")));
}

TEST_F(CampaignFolderTest, NoFolderHasMoreThanAThousandEntries) {
  const CampaignFolder folder(path_, campaign_);
  EXPECT_EQ(folder.unit_folder(0), path_ / "units/000/000");
  EXPECT_EQ(folder.unit_folder(123'456), path_ / "units/123/456");
  EXPECT_EQ(folder.unit_folder(999'999), path_ / "units/999/999");
}

TEST_F(CampaignFolderTest, RefusesAnotherCampaignsFolderAndOtherPeoplesFiles) {
  CampaignFolder(path_, campaign_).prepare(false);
  CampaignFolder(path_, campaign_).prepare(false);  // its own
  Campaign other = campaign_;
  other.seed = 2;
  EXPECT_THAT([&] { CampaignFolder(path_, other).prepare(false); },
              ThrowsMessage<InputError>(HasSubstr("campaign.json: of another campaign")));
  CampaignFolder(path_, other).prepare(true);
  const std::filesystem::path thesis = temporary_.path() / "thesis";
  std::filesystem::create_directories(thesis);
  write_file_atomically(thesis / "chapter.tex", "");
  EXPECT_THAT([&] { CampaignFolder(thesis, campaign_).prepare(false); },
              ThrowsMessage<InputError>(HasSubstr("thesis: holds something else")));
}

}  // namespace
}  // namespace limber
