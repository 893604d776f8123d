// What trackers write of a body in space that they don't see.
#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "logs/space_import.hpp"

namespace limber {
namespace {

using ::testing::SizeIs;

constexpr double kNoiseOfPlaces_m = 1e-4;

class LostBodies : public SpaceImport {
 protected:
  /// Of a kind that begins so; none if there is no such note.
  static const ImportNote* note(const ImportResult& result, const std::string& beginning) {
    const std::vector<ImportNote>& notes = result.report.runs.front().notes;
    const auto found = std::ranges::find_if(
        notes, [&](const ImportNote& one) { return one.what.starts_with(beginning); });
    return found == notes.end() ? nullptr : &*found;
  }
};

// A single one says that the tracker lost the body; many, that the columns are others.
TEST_F(LostBodies, HidesFewQuaternionsThatAreNoneAndRefusesMany) {
  int rows = 0;
  double length = 0.0;
  mistake_ = [&](int row, int plate, SpacePose& pose) {
    if (row >= 20 && row < 20 + rows && plate == 3) {
      pose.rotation.coeffs() *= length;
    }
  };
  for (const double of_length : {0.0, 0.9}) {
    rows = 6;
    length = of_length;
    const ImportResult result = import(log(), mapping());
    const ImportNote* found = note(result, "quaternions that don't have the length 1");
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->count, 6);
    EXPECT_EQ(found->first, fmt::format("line 22, plate 3: {}", of_length));
    EXPECT_EQ(result.recording.episodes.front().untracked_count(), 2) << "0.2 s and 0.25 s";
    EXPECT_LT(errors(result.recording.episodes.front()).position_m, 1e-3);
    rows = 7;
    expect_refusal(log(), mapping(),
                   {"7 of 600 quaternions of plate 3 don't have the length 1; the first, in line "
                    "22, has " +
                        fmt::format("{}.", of_length),
                    "'qx3' … 'qw3' in the order qx, qy, qz, qw"});
  }
}

// All seven are zero where trackers lost a body.
TEST_F(LostBodies, TakesZerosAloneForHiddenWithoutABadQuaternion) {
  mistake_ = [](int row, int plate, SpacePose& pose) {
    if (row == 20 && plate == 3) {
      pose.rotation.coeffs().setZero();
      pose.position_m.setZero();
    }
  };
  const ImportResult result = import(log(), mapping());
  EXPECT_EQ(result.recording.episodes.front().untracked_count(), 1);
  EXPECT_EQ(note(result, "quaternions"), nullptr);
}

// ROS and VRPN write a lost body as an identity.
TEST_F(LostBodies, TakesAnIdentityAtTheOriginForHiddenWhereTheBodyIsElsewhere) {
  Eigen::Vector4d identity;  // x, y, z, w
  mistake_ = [&](int row, int plate, SpacePose& pose) {
    if ((row == 20 && plate == 3) || (row == 40 && plate == 0)) {
      pose.position_m.setZero();
      pose.rotation.coeffs() = identity;
    }
  };
  for (const Eigen::Index cell : {3, 0}) {  // w last or first
    for (const double sign : {1.0, -1.0}) {
      identity = sign * Eigen::Vector4d::Unit(cell);
      const ImportResult result = import(log(), mapping());
      ASSERT_THAT(result.recording.episodes, SizeIs(1));
      EXPECT_EQ(result.recording.untracked_count(), 1) << "a base that stands still is known";
      EXPECT_LT(errors(result.recording.episodes.front()).position_m, 1e-3);
      const ImportNote* found = note(result, "points of zeros alone");
      ASSERT_NE(found, nullptr);
      EXPECT_EQ(found->count, 2);
    }
  }
}

TEST_F(LostBodies, LeavesABaseAtTheOriginThatIsNotTurned) {
  X_LB_ = SpacePose();
  // To the bit; with noise, in which an exact one is as good; and flipped in some rows.
  for (const double noise_m : {0.0, kNoiseOfPlaces_m}) {
    noise_m_ = noise_m;
    mistake_ = [](int row, int plate, SpacePose& pose) {
      if (plate == 0 && row % 100 == 50) {
        pose = SpacePose();
      }
    };
    const ImportResult result = import(log(), mapping("alignment: none\n"));
    EXPECT_EQ(result.recording.untracked_count(), 0);
    EXPECT_EQ(note(result, "points of zeros"), nullptr);
  }
  noise_m_ = 0.0;
  mistake_ = [](int row, int plate, SpacePose& pose) {
    if (plate == 0 && row % 3 == 0) {
      pose.rotation = rotation_of_vector<double>(Eigen::Vector3d(0.0, 0.0, 3.0));
    }
  };
  EXPECT_EQ(note(import(log(), mapping("alignment: none\n")), "points of zeros"), nullptr);
}

TEST_F(LostBodies, TakesZerosOfAPointThatIsElsewhereForHidden) {
  rotations_ = false;
  mistake_ = [](int row, int plate, SpacePose& pose) {
    if (row == 20 && plate == 3) {
      pose.position_m.setZero();
    }
  };
  const Episode episode = import(log(), mapping(axes())).recording.episodes.front();
  EXPECT_EQ(episode.untracked_count(), 1);
  EXPECT_LT(errors(episode).position_m, 1e-3);
}

}  // namespace
}  // namespace limber
