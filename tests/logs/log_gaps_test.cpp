// What is missing between the rows of a log: for how long it is bridged, and what is said of it.
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "logs/csv_import.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class LogGaps : public CsvImport {
 protected:
  /// Of an arm of that many frames per second.
  void make_arm(double frame_rate_hz) {
    ArmDescription arm = truth_.arm();
    arm.frame_rate_hz = frame_rate_hz;
    truth_ = LogTruth(arm);
  }

  static constexpr std::size_t kFirstPressure = 1;  // columns
  static constexpr std::size_t kPlate9 = 4 + 3 * 9;
};

TEST_F(LogGaps, OneLostRowOrCellOfASlowLogIsBridged) {
  make_arm(5.0);
  rate_hz_ = 5.0;
  rows_ = 150;
  struct Case {
    const char* what;
    std::string log;
    int untracked;
  };
  for (const Case& one : {Case{"row", without_line(log(), "10.000000,"), 1},
                          Case{"point", hidden(log(), kPlate9, 50, 51), 1},
                          Case{"command", hidden(log(), kFirstPressure, 50, 51), 0}}) {
    const Recording bridged = import(one.log, mapping()).recording;
    EXPECT_THAT(bridged.episodes, SizeIs(1)) << one.what;
    EXPECT_EQ(bridged.frame_count(), rows_) << one.what;
    EXPECT_EQ(bridged.untracked_count(), one.untracked) << one.what;
    EXPECT_THAT(bridged.settings, HasSubstr("gaps up to 2.5 usual steps or 0.25 s bridged"));
    // What was asked for holds, however slow the log is.
    const Recording cut = import(one.log, mapping() + "longest_gap_s: 0.25\n").recording;
    EXPECT_THAT(cut.episodes, SizeIs(2)) << one.what;
    EXPECT_EQ(cut.frame_count(), rows_ - 1) << one.what;
    EXPECT_THAT(cut.settings, HasSubstr("gaps up to 0.25 s bridged"));
  }
  EXPECT_THAT(import(hidden(log(), kPlate9, 50, 52), mapping()).recording.episodes, SizeIs(2))
      << "two rows are lost";
}

// An arm of 8 frames per second asks for no more than a row of a log of 16 Hz every 0.125 s.
TEST_F(LogGaps, AStepNoLongerThanAFrameHasLostNoRow) {
  make_arm(8.0);
  rate_hz_ = 16.0;
  const auto log_with = [&](const std::vector<int>& lost, double late_s) {
    std::string text = header() + "\n";
    for (int k = 0; k < rows_; ++k) {
      const double t = k / rate_hz_ + (k == 50 ? late_s : 0.0);
      if (std::ranges::find(lost, k) == lost.end()) {
        text += fmt::format("{:.6f}{}{}\n", t, truth_.pressure_cells(t), pose_cells(t));
      }
    }
    return text;
  };
  const auto untracked = [&](const std::vector<int>& lost, double late_s) {
    return import(log_with(lost, late_s), mapping()).recording.untracked_count();
  };
  EXPECT_EQ(untracked({}, 0.04), 0) << "0.1025 s";
  EXPECT_EQ(untracked({51}, 0.0), 0) << "0.125 s, from frame to frame";
  EXPECT_EQ(untracked({50}, 0.0), 0) << "a frame's own row, 0.125 s";
  EXPECT_EQ(untracked({50, 51}, 0.0), 1) << "0.1875 s";
}

/// Logs of an arm that is seen at one moment of its motion while commands are those of another.
class HungTracker : public LogGaps {
 protected:
  HungTracker() { rows_ = 1000; }  // 10 s

  ImportResult import_of(const std::function<double(double)>& seen_s,
                         const std::function<double(double)>& commanded_s) const {
    return import(LogTruth::table(header(), rows_, rate_hz_,
                                  [&](double t) {
                                    return truth_.pressure_cells(commanded_s(t)) +
                                           pose_cells(seen_s(t));
                                  }),
                  mapping());
  }

  static constexpr const char* kNote = "the tracker hangs";
};

TEST_F(HungTracker, IsNotLearntFrom) {
  rows_ = 3000;
  const auto holds = [](double t) { return t >= 2.0 && t < 5.0 ? 2.0 : t; };
  const ImportResult result = import_of(holds, [](double t) { return t; });
  const ImportNote* found = note(result, kNote);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->count, 299) << "the pose at 2 s is one";
  EXPECT_EQ(found->first, "at 2.010 s");
  ASSERT_THAT(result.recording.episodes, SizeIs(2));
  EXPECT_NEAR(result.recording.episodes[0].time_s.tail<1>()[0], 2.0, 1e-9);
  EXPECT_NEAR(result.recording.episodes[1].time_s[0], 5.0, 1e-9);
  for (const Episode& episode : result.recording.episodes) {
    EXPECT_LT(errors(episode).first, 1e-5);
  }
}

// Logs without noise: of an arm that rests, that waits for its valves, and that hardly moves.
TEST_F(HungTracker, IsNotAnArmWithoutNoiseThatRests) {
  const auto rests = [](double t) { return t < 5.0 ? 0.0 : t - 5.0; };
  const auto is_quiet = [&](const ImportResult& result) {
    return note(result, kNote) == nullptr && result.recording.episodes.size() == 1;
  };
  EXPECT_TRUE(is_quiet(import_of(rests, rests)));
  const auto jumps = [](double t) { return t < 4.2 ? 0.25 : 2.5; };  // by 150 kPa, of 200
  EXPECT_TRUE(is_quiet(import_of([&](double t) { return jumps(t - 0.8); }, jumps)));
  EXPECT_TRUE(is_quiet(import_of(rests, [&](double t) { return t < 5.0 ? 0.05 * t : t - 5.0; })));
}

}  // namespace
}  // namespace limber
