#include "limber/run/tip_path.hpp"

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/run/track_run.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class TipPathTest : public ::testing::Test {
 protected:
  TipPath read(const std::string& text) const {
    const auto file = folder_.path() / "path.csv";
    write_file_atomically(file, text);
    return read_tip_path(file);
  }
  void refuses(const std::string& text, const std::string& message) const {
    EXPECT_THAT([&] { (void)read(text); }, ThrowsMessage<InputError>(HasSubstr(message))) << text;
  }

  const TemporaryFolder folder_;
};

TEST_F(TipPathTest, IsStraightBetweenItsPointsAndStandsStillOutside) {
  const TipPath path = read("time_s,x_m,y_m\n2,0.1,0.2\n3,0.3,0.2\n5,0.3,0.6\n");
  EXPECT_EQ(path.lap_s(), 3.0) << "times count from the first";
  EXPECT_NEAR(path.length_m(), 0.6, 1e-12);
  EXPECT_TRUE(path.at(-1.0).isApprox(Eigen::Vector2d(0.1, 0.2)));
  EXPECT_TRUE(path.at(0.25).isApprox(Eigen::Vector2d(0.15, 0.2)));
  EXPECT_TRUE(path.at(1.0).isApprox(Eigen::Vector2d(0.3, 0.2)));
  EXPECT_TRUE(path.at(2.5).isApprox(Eigen::Vector2d(0.3, 0.5)));
  EXPECT_TRUE(path.at(9.0).isApprox(Eigen::Vector2d(0.3, 0.6)));
  EXPECT_FALSE(path.closes());
}

TEST_F(TipPathTest, LapsRepeatIt) {
  TipPath path = read("y_m,time_s,x_m\n0,0,0.4\n0.1,1,0.4\n0,2,0.4\n");
  ASSERT_TRUE(path.closes());
  path.laps = 3;
  EXPECT_EQ(path.duration_s(), 6.0);
  for (const double time_s : {0.3, 1.0, 1.7}) {
    EXPECT_TRUE(path.at(time_s + 4.0).isApprox(path.at(time_s), 1e-9)) << time_s;
  }
}

TEST_F(TipPathTest, WhatIsWrongIsNamedByFileAndLine) {
  refuses("", "path.csv:1:1: empty; expected the columns time_s, x_m and y_m");
  refuses("time_s,x_m\n0,1\n", "path.csv:1:1: no column y_m");
  refuses("time_s,x_m,y_m,z_m\n", "4 columns; expected time_s, x_m and y_m alone");
  refuses("time_s,x_m,y_m\n0,0.1,0.2\n1,nan,0.2\n", "path.csv:3:3");
  refuses("time_s,x_m,y_m\n0,0.1,0.2\n1,0.2\n", "path.csv:3:1: 2 cells; the header has 3");
  refuses("time_s,x_m,y_m\n0,0.1,0.2\n\n0,0.2,0.2\n",
          "path.csv:4:1: time_s = 0 is not later than 0 before it");
  refuses("time_s,x_m,y_m\n0,0.1,0.2\n", "1 points; expected at least 2");
  refuses(
      "time_s,x_m,y_m\n-2147483648,0.1,0.2\n1,0.2,0.2\n",
      "path.csv:3:1: time_s = 1 is 2.14748e+09 s after the first; expected seconds, at most 3600");
  refuses("time_s,x_m,y_m\n0,450,200\n", "x_m = 450; expected metres");
}

TEST_F(TipPathTest, APointThatTheArmIsTooShortForIsNamed) {
  const TipPath path = read("time_s,x_m,y_m\n0,0.1,0.2\n1,0.6,0.6\n");
  EXPECT_NO_THROW(path.require_within(0.9, "p.csv"));
  EXPECT_THAT([&] { path.require_within(0.7, "p.csv"); },
              ThrowsMessage<InputError>(HasSubstr(
                  "p.csv:3: (0.600, 0.600) m is 0.849 m from the base; the arm is 0.700")));
}

TEST_F(TipPathTest, ErrorsAreTakenAtEqualTimesAndTheFirstLapApart) {
  TipPath path = read("time_s,x_m,y_m\n0,0.4,0\n1,0.5,0\n2,0.4,0\n");
  path.laps = 2;
  // 2 frames before the path, then 5 a lap: 1 cm beside it in the first, 3 cm in the second.
  Episode episode;
  const int frames = 11;
  episode.time_s = Eigen::VectorXd::LinSpaced(frames, 7.0, 12.0);
  episode.backbone = FrameMatrix::Zero(frames, 6);
  episode.tracked.assign(frames, 1);
  for (int t = 2; t < frames; ++t) {
    const double since_s = 0.5 * (t - 2);
    const Eigen::Vector2d there = path.at(since_s);
    episode.backbone(t, 3) = float(there.x());
    episode.backbone(t, 4) = float(there.y() + (since_s <= 2.0 ? 0.01 : 0.03));
  }
  episode.tracked[4] = 0;
  episode.backbone(4, 4) = 9.0F;
  constexpr double kRounding_m = 1e-6;
  const TrackErrors errors = track_errors(path, episode, 2);
  ASSERT_TRUE(errors.first_lap && errors.later_laps);
  EXPECT_NEAR(errors.first_lap->rms_m, 0.01, kRounding_m);
  EXPECT_EQ(errors.first_lap->frames, 4) << "one was not tracked";
  EXPECT_NEAR(errors.later_laps->rms_m, 0.03, kRounding_m);
  EXPECT_NEAR(errors.later_laps->max_m, 0.03, kRounding_m);
  EXPECT_FALSE(track_errors(path, episode, frames).first_lap);
}

TEST_F(TipPathTest, ASingleLapHasNoLaterOnes) {
  const TipPath path = read("time_s,x_m,y_m\n0,0.4,0\n1,0.5,0\n");
  Episode episode;
  const int frames = 200;
  episode.time_s = Eigen::VectorXd::LinSpaced(frames, 0.0, frames - 1) * 0.05;
  episode.backbone = FrameMatrix::Zero(frames, 6);
  for (int start = 0; start + 20 < frames; ++start) {  // sums of 0.05 are rounded up or down
    Episode run = episode;
    run.time_s.conservativeResize(start + 21);
    EXPECT_FALSE(track_errors(path, run, start).later_laps) << start;
  }
}

}  // namespace
}  // namespace limber
