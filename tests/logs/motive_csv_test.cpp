#include "src/logs/motive_csv.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/logs/log_import.hpp"
#include "support/log_truth.hpp"
#include "support/sample_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::ThrowsMessage;

constexpr double kSixDigits = 2e-6;

std::string fixture(const std::string& name) {
  return std::string(LIMBER_TEST_DATA_DIR) + "/motive/" + name;
}

MotiveTake take_of(const std::string& name) {
  RunReport ignored;
  return read_motive_csv(fixture(name), ignored);
}

/// What all fixtures show: two plates, the second one 0.2 m along x and 0.1 m towards −z from the
/// first, turned by half a radian about y. Z-up fixtures show the same in their axes.
class MotiveVariant : public ::testing::TestWithParam<const char*> {};

TEST_P(MotiveVariant, ShowsTheTwoPlates) {
  const MotiveTake take = take_of(GetParam());
  ASSERT_THAT(take.time_s, SizeIs(3));
  EXPECT_NEAR(take.time_s[2], 2.0 / 120.0, kSixDigits);
  ASSERT_THAT(take.objects, SizeIs(2));
  const MotiveObject& first = take.objects[0];
  const MotiveObject& second = take.objects[1];
  EXPECT_THAT(first.name, HasSubstr("Plate01"));
  EXPECT_THAT(second.name, HasSubstr("Plate02"));
  const bool z_up = std::string(GetParam()).find("z_up") != std::string::npos;
  const int up = z_up ? 2 : 1;
  for (int t = 0; t < 3; ++t) {
    EXPECT_NEAR(second.position_m(t, 0), 0.7, kSixDigits);
    EXPECT_NEAR(second.position_m(t, up), 0.1, kSixDigits);
    EXPECT_NEAR(second.position_m(t, z_up ? 1 : 2) - first.position_m(t, z_up ? 1 : 2),
                z_up ? 0.1 : -0.1, kSixDigits);
    EXPECT_NEAR(second.rotation(t, up), std::sin(0.25), kSixDigits);
    EXPECT_NEAR(second.rotation(t, 3), std::cos(0.25), kSixDigits);
    EXPECT_NEAR(first.rotation(t, 3), 1.0, kSixDigits);
  }
}

INSTANTIATE_TEST_SUITE_P(Fixtures, MotiveVariant,
                         ::testing::Values("rigid_bodies_1_23.csv", "bones_1_25_parent_row.csv",
                                           "time_code.csv", "without_ids.csv",
                                           "without_frame_words.csv",
                                           "euler_millimeters_spreadsheet.csv",
                                           "quoted_header_centimeters_z_up.csv"));

TEST(MotiveCsv, KeepsMeasuredAndSolvedMarkersApart) {
  const MotiveTake take = take_of("measured_and_solved_markers.csv");
  ASSERT_THAT(take.objects, SizeIs(4));
  EXPECT_EQ(take.objects[0].type, "Rigid Body Marker");
  EXPECT_EQ(take.objects[3].type, "Marker");
  EXPECT_EQ(take.objects[3].name, "Arm:Marker2");
  EXPECT_EQ(take.objects[0].position_m(1, 0), 9.0);
  EXPECT_NEAR(take.objects[3].position_m(0, 0), 0.7, kSixDigits);
  EXPECT_TRUE(std::isnan(take.objects[3].position_m(1, 0))) << "a blank cell is no zero";
}

TEST(MotiveCsv, ReadsWhatFollowsATakeNameWithAComma) {
  EXPECT_EQ(take_of("euler_millimeters_spreadsheet.csv").rotation_type, "ZXY");
}

TEST(MotiveCsv, RefusesWhatItCannotTrust) {
  const auto refuses = [](const char* name, const std::string& part) {
    EXPECT_THAT([&] { take_of(name); },
                ThrowsMessage<InputError>(AllOf(HasSubstr(name), HasSubstr(part))));
  };
  refuses("no_header.csv", "'limber import csv', the mapping naming its 'columns'");
  refuses("format_1_1.csv", "format 1.1 or older");
  refuses("local_coordinates.csv", "'Use World Coordinates'");
  refuses("quaternion_of_wrong_length.csv", "expected a unit quaternion X, Y, Z, W");
  refuses("duplicate_names.csv", "two objects of type 'Rigid Body' are called 'Plate01'");
}

/// A take written from the truth, with its pressures on another clock.
class MotiveImport : public ::testing::Test {
 protected:
  static constexpr double kOffset_s = -37.25;
  static constexpr int kRows = 1200;
  static constexpr double kRate_hz = 120.0;

  MotiveImport() : truth_(sample_arm(3)) {
    write_file_atomically(
        folder_.path() / "p.csv",
        LogTruth::table(
            "time_s" + truth_.pressure_names(), 1100, 100.0,
            [&](double t) { return truth_.pressure_cells(t + kOffset_s); }, -kOffset_s));
  }

  /// Motive's own axes, y up: a pose (x, y) of the plane lies at (x, height, −y).
  std::string bodies(bool y_up) const {
    const int m = truth_.arm().point_count();
    std::string types, names, components, axes;
    for (int p = m; p-- > 0;) {  // Motive's order is the user's
      for (const char* axis : {"X", "Y", "Z", "W", "X", "Y", "Z"}) {
        types += ",Rigid Body";
        names += fmt::format(",Plate {}", p + 1);
        axes += fmt::format(",{}", axis);
      }
      components += ",Rotation,Rotation,Rotation,Rotation,Position,Position,Position";
    }
    std::string text =
        "Format Version,1.23,Export Frame Rate,120.0,Rotation Type,Quaternion,Length Units,Meters,"
        "Coordinate Space,Global\n\n," +
        types + "\n," + names + "\n," + components + "\nFrame,Time (Seconds)" + axes + "\n";
    for (int k = 0; k < kRows; ++k) {
      const double t = k / kRate_hz;
      const BackboneD b = truth_.backbone(t);
      text += fmt::format("{},{:.6f}", k, t);
      for (int p = m; p-- > 0;) {
        const double sine = std::sin(0.5 * b(p, 2));
        const double cosine = std::cos(0.5 * b(p, 2));
        text += y_up ? fmt::format(",0,{:.8f},0,{:.8f},{:.8f},0.91,{:.8f}", sine, cosine, b(p, 0),
                                   -b(p, 1))
                     : fmt::format(",0,0,{:.8f},{:.8f},{:.8f},{:.8f},0.91", sine, cosine, b(p, 0),
                                   b(p, 1));
      }
      text += "\n";
    }
    return text;
  }

  ImportResult import(const std::string& text, const std::string& mapping = {}) const {
    write_file_atomically(folder_.path() / "take.csv", text);
    ImportOptions options;
    options.mapping = default_import_mapping(truth_.arm());
    if (!mapping.empty()) {
      write_file_atomically(folder_.path() / "map.yaml", "schema: limber/import/1\n" + mapping);
      options.mapping = read_import_mapping(folder_.path() / "map.yaml", truth_.arm());
    }
    options.command_logs = {folder_.path() / "p.csv"};
    return import_motive({folder_.path() / "take.csv"}, options, truth_.arm());
  }

  void expect_truth(const ImportResult& result) const {
    const Episode& episode = result.recording.episodes.front();
    EXPECT_GT(episode.frame_count(), 190);
    for (Eigen::Index t = 0; t < episode.time_s.size(); ++t) {
      const BackboneD b = truth_.backbone(episode.time_s[t]);
      for (Eigen::Index p = 0; p < b.rows(); ++p) {
        // Frames lie between rows of 120 Hz: a straight line over 8 ms.
        EXPECT_LT((episode.backbone.row(t).segment<3>(3 * p).cast<double>() - b.row(p)).norm(),
                  2e-4);
      }
    }
    EXPECT_NEAR(result.report.runs.front().clock->offset_s, kOffset_s, 2e-3);
  }

  TemporaryFolder folder_;
  LogTruth truth_;
};

TEST_F(MotiveImport, TakesRigidBodiesInTheOrderOfTheirNames) {
  expect_truth(import(bodies(true)));
}

TEST_F(MotiveImport, TakesTheUpAxisFromTheMappingAndFindsAWrongOne) {
  expect_truth(import(bodies(false), "backbone: {up: z}\n"));
  EXPECT_THAT([&] { import(bodies(false)); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("which should leave the arm's plane"),
                                              HasSubstr("backbone: {up: z}"))));
}

TEST_F(MotiveImport, NamesBodiesThatAreThereAndThatAreNot) {
  EXPECT_THAT(
      [&] {
        import(bodies(true),
               "backbone: {points: [{plate: 0, body: Base}, {plate: 15, body: Tip}]}\n");
      },
      ThrowsMessage<InputError>(
          AllOf(HasSubstr("there is no rigid body 'Base'"), HasSubstr("Plate 16, Plate 15"))));
}

TEST_F(MotiveImport, TakesAMarkerOnEachSide) {
  const int m = truth_.arm().point_count();
  std::string types, names, components, axes, points;
  for (int p = 0; p < m; ++p) {
    for (const char* side : {"right", "left"}) {
      types += ",Marker,Marker,Marker";
      names += fmt::format(",Arm:{1} {0},Arm:{1} {0},Arm:{1} {0}", p, side);
      components += ",Position,Position,Position";
      axes += ",X,Y,Z";
    }
    points += fmt::format("{{right: right {0}, left: 'Arm:left {0}'}}, ", p);
  }
  std::string text = "Format Version,1.24,Length Units,Meters,Coordinate Space,Global\n\n," +
                     types + "\n," + names + "\n," + components + "\nFrame,Time (Seconds)" + axes +
                     "\n";
  for (int k = 0; k < kRows; ++k) {
    const double t = k / kRate_hz;
    const BackboneD b = truth_.backbone(t);
    text += fmt::format("{},{:.6f}", k, t);
    for (int p = 0; p < m; ++p) {
      for (const double y : {-0.02, 0.02}) {
        text += fmt::format(",{:.8f},0.91,{:.8f}", b(p, 0) - y * std::sin(b(p, 2)),
                            -(b(p, 1) + y * std::cos(b(p, 2))));
      }
    }
    text += "\n";
  }
  expect_truth(import(text, "backbone: {points: [" + points + "]}\n"));
}

TEST_F(MotiveImport, NeedsALogOfPressures) {
  write_file_atomically(folder_.path() / "take.csv", bodies(true));
  EXPECT_THAT(
      [&] {
        import_motive({folder_.path() / "take.csv"}, {default_import_mapping(truth_.arm()), {}, {}},
                      truth_.arm());
      },
      ThrowsMessage<InputError>(HasSubstr("give the log of them with --pressures")));
}

}  // namespace
}  // namespace limber
