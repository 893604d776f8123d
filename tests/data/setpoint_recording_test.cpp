// Recordings in which nothing was measured: set points alone, and never passed off as measured.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"
#include "limber/data/recording_inspection.hpp"
#include "limber/data/valve_identification.hpp"
#include "recording_file.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

Recording setpoints_of(Recording recording) {
  recording.episodes = with_setpoints_only(std::move(recording.episodes));
  return recording;
}

TEST_F(RecordingFile, OfSetPointsAloneHoldsNothingThatIsCalledMeasured) {
  const Recording measured = test_recording();
  write_recording(path_, setpoints_of(measured));
  {
    const H5::H5File file(path_.string(), H5F_ACC_RDONLY);
    EXPECT_FALSE(file.nameExists("episodes/000000/pressure_kpa"));
    EXPECT_TRUE(file.nameExists("episodes/000000/setpoint_kpa"));
  }
  const Recording read = read_recording(path_);
  EXPECT_TRUE(read.setpoints_only());
  for (std::size_t i = 0; i < read.episodes.size(); ++i) {
    EXPECT_EQ(read.episodes[i].setpoint_kpa, measured.episodes[i].setpoint_kpa);
    EXPECT_EQ(read.episodes[i].pressure_kpa, measured.episodes[i].setpoint_kpa);
    EXPECT_EQ(read.episodes[i].backbone, measured.episodes[i].backbone);
  }
}

// Files of before there were two kinds don't say, and so do those that are written today.
TEST_F(RecordingFile, WithoutTheAttributeIsMeasured) {
  {
    const H5::H5File file(path_.string(), H5F_ACC_RDONLY);
    EXPECT_FALSE(file.attrExists("commands_are"));
  }
  EXPECT_FALSE(read_recording(path_).setpoints_only());
  {
    H5::H5File file(path_.string(), H5F_ACC_RDWR);
    set_attribute(file, "commands_are", "measured");
  }
  EXPECT_FALSE(read_recording(path_).setpoints_only());
}

TEST_F(RecordingFile, RefusesKindsThatContradictTheData) {
  expect_refusal([](H5::H5File& f) { set_attribute(f, "commands_are", "guessed"); },
                 {"attribute 'commands_are': 'guessed' found; expected 'measured' or 'setpoints'"});
  write_recording(path_, test_recording());
  expect_refusal([](H5::H5File& f) { set_attribute(f, "commands_are", "setpoints"); },
                 {"episodes/000000/pressure_kpa: found, though the attribute 'commands_are'"});
  write_recording(path_, setpoints_of(test_recording()));
  expect_refusal([](H5::H5File& f) { f.removeAttr("commands_are"); },
                 {"episodes/000000/pressure_kpa: data set missing",
                  "the attribute 'commands_are' of the file says 'setpoints'"});
}

TEST_F(RecordingFile, RefusesEpisodesOfBothKinds) {
  Recording mixed = test_recording();
  mixed.episodes[1].pressure_kpa = mixed.episodes[1].setpoint_kpa;
  mixed.episodes[1].setpoints_only = true;
  EXPECT_THAT([&] { write_recording(path_, mixed); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("episodes/000001/pressure_kpa"),
                                              HasSubstr("expected one kind in a recording"))));
  Recording contradicting = setpoints_of(test_recording());
  contradicting.episodes[0].pressure_kpa(2, 1) += 1.0F;
  EXPECT_THAT([&] { validate(contradicting, "a.h5"); },
              ThrowsMessage<InputError>(HasSubstr("differs from setpoint_kpa")));
}

TEST(SetpointRecording, WithoutWhatWasMeasuredHasTheSameMotions) {
  const std::vector<Episode> before = test_recording().episodes;
  const std::vector<Episode> after = with_setpoints_only(before);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].time_s, before[i].time_s);
    EXPECT_EQ(after[i].setpoint_kpa, before[i].setpoint_kpa);
    EXPECT_EQ(after[i].backbone, before[i].backbone);
    EXPECT_EQ(after[i].motion_index, before[i].motion_index);
    EXPECT_EQ(after[i].tracked, before[i].tracked);
  }
}

TEST(SetpointRecording, IsInspectedAsSuch) {
  const Recording recording = setpoints_of(test_recording());
  const RecordingInspection inspection = inspect(recording, nullptr, "a.h5");
  const std::string text = to_text(recording, inspection);
  EXPECT_THAT(text, AllOf(HasSubstr("set points only: no pressure was measured"),
                          HasSubstr("segment 0: set "), Not(HasSubstr(": measured"))));
  const nlohmann::ordered_json json = to_json(recording, inspection);
  EXPECT_EQ(json["commands_are"], "setpoints");
  EXPECT_TRUE(json["pressure_kpa"].is_null());
  EXPECT_EQ(json["setpoint_kpa"].size(), 2U);
  EXPECT_TRUE(json["transitions"]["covered"].is_null()) << "no end is known to be reached";
  const Recording measured = test_recording();
  const nlohmann::ordered_json other = to_json(measured, inspect(measured, nullptr, "a.h5"));
  EXPECT_EQ(other["commands_are"], "measured");
  EXPECT_EQ(other["pressure_kpa"].size(), 2U);
}

TEST(SetpointRecording, TellsNothingOfValves) {
  const IdentifiedValves valves = identify_valves(setpoints_of(test_recording(5, 60)));
  EXPECT_TRUE(valves.parameters.is_ideal());
  EXPECT_THAT(valves.findings.reason, HasSubstr("set points only: no pressure was measured"));
}

}  // namespace
}  // namespace limber
