#include "logs/space_import.hpp"

#include <gmock/gmock.h>

#include "src/logs/space_backbone.hpp"
#include "src/logs/space_tracks.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr double kExact = 2e-5;   // [m], [rad]: straight lines between rows 10 ms apart
constexpr double kSingle = 1e-5;  // single precision
constexpr double kNoise_m = 1e-4;
constexpr double kNoise_rad = 1e-3;
constexpr double kOfNoise = 6.0;  // of its standard deviation, over all frames and plates

TEST(SpaceLifting, ArcToItsEndIsTheElement) {
  for (const Eigen::Vector3d& omega :
       {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(0.0, 1e-7, -2e-7),
        Eigen::Vector3d(0.0, 0.7, -0.4), Eigen::Vector3d(0.0, -1.9, 2.0)}) {
    const SpacePose end = element(0.3, omega);
    const SpacePose arc = arc_to(end.position_m);
    EXPECT_LT((rotation_vector(arc.rotation) - omega).norm(), 1e-9);
  }
}

TEST(SpaceLifting, PartOfAnElementIsTheElementOfThatPart) {
  const Eigen::Vector3d omega(0.3, -0.9, 0.5);
  const SpacePose part = along(element(0.3, omega), 0.4);
  const SpacePose expected = element(0.4 * 0.3, Eigen::Vector3d(0.4 * omega));
  EXPECT_LT((part.position_m - expected.position_m).norm(), 1e-12);
  EXPECT_LT(part.rotation.angularDistance(expected.rotation), 1e-7);
}

TEST(EulerAngles, TurnInTheirOrderEachAboutTheAxisAsTurnedBefore) {
  const Eigen::Vector3d a(0.3, -1.1, 2.0);
  const auto turn = [](double angle, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(angle, axis);
  };
  const Eigen::Quaterniond zyx(turn(a[0], Eigen::Vector3d::UnitZ()) *
                               turn(a[1], Eigen::Vector3d::UnitY()) *
                               turn(a[2], Eigen::Vector3d::UnitX()));
  const Eigen::Quaterniond xzx(turn(a[0], Eigen::Vector3d::UnitX()) *
                               turn(a[1], Eigen::Vector3d::UnitZ()) *
                               turn(a[2], Eigen::Vector3d::UnitX()));
  EXPECT_LT(rotation_of_euler("zyx", a).angularDistance(zyx), 1e-7);
  EXPECT_LT(rotation_of_euler("xzx", a).angularDistance(xzx), 1e-7);
}

TEST_F(SpaceImport, GivesThePosesInTheBasesFrame) {
  const ImportResult result = import(log(), mapping());
  ASSERT_THAT(result.recording.episodes, SizeIs(1));
  const Episode& episode = result.recording.episodes.front();
  EXPECT_EQ(episode.frame_count(), 120);
  EXPECT_EQ(episode.untracked_count(), 0);
  EXPECT_FALSE(episode.lifted);
  EXPECT_EQ(result.recording.channel_count(), 6);
  EXPECT_LT(errors(episode).position_m, kExact);
  EXPECT_LT(errors(episode).rotation_rad, kExact);
  EXPECT_NEAR(episode.pressure_kpa(7, 4), command(0.35, 4), 1e-3);
  EXPECT_NO_THROW(validate(result.recording, "imported"));
  const SpaceRunReport& space = *result.report.runs.front().space;
  EXPECT_LT((space.base_m - X_LB_.position_m).norm(), kSingle);
  EXPECT_LT((space.x_axis - X_LB_.rotation * Eigen::Vector3d::UnitX()).norm(), kSingle);
  EXPECT_THAT(space.gaps, SizeIs(4));
  EXPECT_NEAR(space.gaps[3].length_m, 0.075, 0.004);
}

TEST_F(SpaceImport, BearsNoiseSignsAndRepeatedRows) {
  noise_m_ = kNoise_m;
  noise_rad_ = kNoise_rad;
  sign_flips_ = true;
  repeat_every_ = 7;
  const ImportResult result = import(log(), mapping());
  const Episode& episode = result.recording.episodes.front();
  EXPECT_LT(errors(episode).position_m, kOfNoise * kNoise_m);
  EXPECT_LT(errors(episode).rotation_rad, kOfNoise * kNoise_rad);
  EXPECT_EQ(result.report.runs.front().space->repeated_rows, 86);
  EXPECT_THAT(result.report.runs.front().space->flips, SizeIs(0));
  for (Eigen::Index t = 1; t < episode.time_s.size(); ++t) {
    EXPECT_GT(episode.backbone.row(t).tail<4>().dot(episode.backbone.row(t - 1).tail<4>()), 0.9F);
  }
}

TEST_F(SpaceImport, LiftsPosesFromPointsAlone) {
  rotations_ = false;
  plates_ = {1, 2, 3, 4};
  const ImportResult result = import(log(), mapping(axes()));
  const Episode& episode = result.recording.episodes.front();
  EXPECT_TRUE(episode.lifted);
  EXPECT_LT(errors(episode).position_m, kExact);
  EXPECT_LT(errors(episode).rotation_rad, 5.0 * kExact);
  EXPECT_EQ(episode.backbone.leftCols(6).cwiseAbs().maxCoeff(), 0.0F);
}

TEST_F(SpaceImport, PutsPlatesWithoutAPointOnTheArcBetweenTheirNeighbours) {
  plates_ = {0, 2, 4};
  EXPECT_LT(errors(import(log(), mapping()).recording.episodes.front()).position_m, kExact);
  rotations_ = false;
  EXPECT_LT(errors(import(log(), mapping(axes(false))).recording.episodes.front()).position_m,
            kExact);
}

TEST_F(SpaceImport, TakesAxisAndBodiesZerosFromTheRest) {
  rests_s_ = 2.0;
  for (int i = 0; i < 5; ++i) {
    body_turns_.push_back(rotation_of_vector<double>(Eigen::Vector3d(0.3 * i, 1.0 - i, 0.7)));
  }
  const Eigen::Vector3d y = X_LB_.rotation * Eigen::Vector3d::UnitY();
  const ImportResult result = import(
      log(),
      mapping(fmt::format("alignment: {{rest_s: [0, 1.9], y_axis: [{:.9f}, {:.9f}, {:.9f}]}}\n",
                          y.x(), y.y(), y.z())));
  // Frames at the jump from rest to motion lie on a straight line.
  const Episode& episode = result.recording.episodes.front();
  Episode moving = episode;
  moving.time_s = episode.time_s.tail(70);
  moving.backbone = episode.backbone.bottomRows(70);
  EXPECT_LT(errors(moving).position_m, kExact);
  EXPECT_LT(errors(moving).rotation_rad, kExact);
}

TEST_F(SpaceImport, ReadsEulerAnglesOfAnyOrder) {
  for (const char* order : {"zyx", "xyz"}) {
    euler_ = order;
    const Episode episode = import(log(), mapping()).recording.episodes.front();
    EXPECT_LT(errors(episode).position_m, kExact) << order;
    EXPECT_LT(errors(episode).rotation_rad, kExact) << order;
  }
}

TEST_F(SpaceImport, HidesSingleFlipsAndTurnsLastingOnesBack) {
  const Eigen::Quaterniond flip = rotation_of_vector<double>(Eigen::Vector3d(0.0, 0.0, M_PI));
  mistake_ = [&](int row, int plate, SpacePose& pose) {
    const bool single = plate == 2 && row == 150;
    const bool lasting = plate == 4 && row >= 300 && row < 400;
    const bool base = plate == 0 && row % 3 == 0;
    if (single || lasting || base) {
      pose.rotation = pose.rotation * flip;
    }
  };
  const ImportResult result = import(log(), mapping());
  const Episode& episode = result.recording.episodes.front();
  EXPECT_EQ(episode.untracked_count(), 1);
  EXPECT_FALSE(episode.was_tracked(30));
  EXPECT_LT(errors(episode).rotation_rad, 0.03) << "a row's motion is lost at a flip";
  const std::vector<SpaceFlips>& flips = result.report.runs.front().space->flips;
  ASSERT_THAT(flips, SizeIs(3));
  EXPECT_EQ(flips[0].turned_rows, 200);
  EXPECT_EQ(flips[0].hidden_rows, 0);
  EXPECT_EQ(flips[1].hidden_rows, 1);
  EXPECT_NEAR(flips[1].first_s, 1.5, 1e-9);
  EXPECT_EQ(flips[2].turned_rows, 100);
  EXPECT_EQ(flips[2].kinds, 1);
  EXPECT_THAT(to_text(result.report), HasSubstr("'x4' (plate 4) jumps while its place does not"));
}

// What came back right behind a silence is no flip, although a flip went before it.
TEST_F(SpaceImport, TurnsNothingBackBehindASilence) {
  mistake_ = [](int row, int plate, SpacePose& pose) {
    if (plate == 4 && row >= 100 && row < 150) {
      pose.rotation = pose.rotation * rotation_of_vector<double>(Eigen::Vector3d(0.0, 0.0, M_PI));
    } else if (plate == 4 && row >= 150 && row < 200) {
      pose.rotation.coeffs().setZero();
      pose.position_m.setZero();
    }
  };
  const ImportResult result = import(log(), mapping());
  const std::vector<SpaceFlips>& flips = result.report.runs.front().space->flips;
  ASSERT_THAT(flips, SizeIs(1));
  EXPECT_EQ(flips[0].turned_rows, 50);
  EXPECT_NEAR(flips[0].largest_rad, M_PI, 0.1);
  EXPECT_LT(errors(result.recording.episodes.front()).rotation_rad, 0.03);
}

TEST_F(SpaceImport, CountsRowsOfANominalRateAndAddsOffsets) {
  std::string map = replaced(mapping(), "time: {column: t}", "time: {rate_hz: 100}");
  map = replaced(map, "pressures:\n", "pressures:\n  offset: [-1, -2, -3, -4, -5, -6]\n");
  const Episode episode = import(log(), map).recording.episodes.front();
  EXPECT_LT(errors(episode).position_m, kExact);
  EXPECT_NEAR(episode.pressure_kpa(7, 4), command(0.35, 4) - 5.0, 1e-3);
}

TEST_F(SpaceImport, HoldsSetPointsWhereNothingWasMeasured) {
  const Recording recording =
      import(log(), replaced(mapping(), "pressures:\n", "pressures:\n  measured: false\n"))
          .recording;
  EXPECT_TRUE(recording.setpoints_only());
}

TEST_F(SpaceImport, RefusesWhatItCanNotKnow) {
  euler_ = "zyx";
  expect_refusal(log(), replaced(mapping(), "  euler: {order: zyx, unit: deg}\n", ""),
                 {"backbone.points[0].euler", "without an order and a unit", "euler: {order: zyx"});
  expect_refusal(log(), replaced(mapping(), "order: zyx", "order: zzx"), {"zzx", "such as zyx"});
  euler_.clear();
  expect_refusal(log(), replaced(mapping(), ", p5]", "]"),
                 {"5 columns found; expected 6, one for each chamber of arm 'space2'"});
  expect_refusal(log(), replaced(mapping(), "pressures:", "pressures:\n  right: [p0]"),
                 {"chambers of an arm in space have no sides"});
  expect_refusal(log(), replaced(mapping(), ", qw: qw1", ""),
                 {"3 of the columns qx, qy, qz, qw found"});
  expect_refusal(log(), mapping("alignment: {x_axis: [1, 0, 0], y_axis: [2, 0, 0]}\n"),
                 {"alignment.y_axis", "lies along x_axis"});
  rotations_ = false;
  expect_refusal(log(), mapping(), {"plate 0, the base, has no rotation", "x_axis: [x, y, z]"});
  plates_ = {1, 2, 3, 4};
  expect_refusal(log(), mapping(axes(false)), {"no point is plate 0", "position_m: [x, y, z]"});
}

TEST_F(SpaceImport, NamesAllSlowLogsAtOnce) {
  rate_hz_ = 10.0;
  expect_refusal(log(), mapping(), {"10 rows per second"});
  ImportOptions options;
  options.mapping = read_import_mapping(folder_.path() / "map.yaml", arm_);
  const std::vector<std::filesystem::path> logs(2, folder_.path() / "run.csv");
  EXPECT_THAT([&] { import_csv(logs, options, arm_); },
              ::testing::ThrowsMessage<InputError>(HasSubstr("2 of 2 logs are slower")));
}

TEST_F(SpaceImport, ManyLogsKeepWhatTellsAWrongFileInTheirLines) {
  mistake_ = [](int row, int plate, SpacePose& pose) {
    if (row == 150 && plate == 2) {
      pose.rotation = pose.rotation * rotation_of_vector<double>(Eigen::Vector3d(0.0, 0.0, M_PI));
    }
  };
  ImportReport report = import(log(), mapping()).report;
  report.runs.resize(4, report.runs.front());
  report.runs[2].space->gaps[1].length_m = 1.3 * report.runs[2].space->gaps[1].arm_m;
  const std::string text = to_text(report);
  EXPECT_THAT(text, HasSubstr("worst gap +30 %, 0 degrees off its arc, 1 rows of flips"));
}

TEST_F(SpaceImport, WarnsOfRotationsThatAreNotThoseOfTheArcs) {
  const auto warning = [&] {
    const ImportReport report = import(log(), mapping()).report;
    for (const ImportNote& note : report.runs.front().notes) {
      if (note.what.starts_with("warning: measured rotations")) {
        return note.first;
      }
    }
    return std::string();
  };
  const auto turn_tip = [&](double degrees) {
    body_turns_.assign(plates_.size(), Eigen::Quaterniond::Identity());
    body_turns_.back() =
        rotation_of_vector<double>(Eigen::Vector3d(0.0, 0.0, degrees / 180.0 * M_PI));
  };
  for (const double degrees : {0.0, 25.0}) {
    turn_tip(degrees);
    EXPECT_EQ(warning(), "") << degrees;
  }
  for (const double degrees : {35.0, 90.0}) {
    turn_tip(degrees);
    EXPECT_THAT(warning(), HasSubstr(fmt::format("{} degrees from plate 3 to plate 4", degrees)));
  }
  plates_ = {0, 1, 4};  // segments bend apart between the last two
  turn_tip(35.0);
  EXPECT_EQ(warning(), "");
  turn_tip(90.0);
  EXPECT_THAT(warning(), HasSubstr("from plate 1 to plate 4"));
}

TEST_F(SpaceImport, OfAnArmAlongAnAxisIsNotTurnedByNoise) {
  rotations_ = false;
  X_LB_.rotation = rotation_of_vector<double>(Eigen::Vector3d(0.0, -0.5 * M_PI, 0.0));  // x up
  const auto y_axis = [&](const char* x_axis) {
    const std::string alignment = fmt::format("alignment: {{x_axis: {}}}\n", x_axis);
    return import(log(), mapping(alignment)).report.runs.front().space->y_axis;
  };
  EXPECT_GT(y_axis("[1e-4, 2e-4, 1]").dot(y_axis("[2e-4, 1e-4, 1]")), 0.999);
}

TEST_F(SpaceImport, NamesDistancesAndDirectionsThatAreNotTheArms) {
  std::string in_mm = replaced(mapping(axes(false)), "backbone:\n", "backbone:\n  unit: mm\n");
  expect_refusal(log(), in_mm, {"'x0' (plate 0) and 'x1' (plate 1) are", "are allowed"});
  X_LB_.rotation = Eigen::Quaterniond::Identity();
  expect_refusal(log(), mapping("alignment: {x_axis: [0, 0, 1]}\n"),
                 {"'x1' (plate 1) lies", "off the x axis", "rest_s: [from, to]"});
}

// A part of a real module's log: no header, no times, absolute pressures, the tip alone.
TEST(SpaceExample, OfARealModuleIsImported) {
  const std::string folder = std::string(LIMBER_SOURCE_DIR) + "/examples/space/";
  const ArmDescription arm = load_arm(folder + "stiff_flop.yaml");
  ImportOptions options;
  options.mapping = read_import_mapping(folder + "stiff_flop_mapping.yaml", arm);
  const ImportResult result = import_csv({folder + "stiff_flop_40s.csv"}, options, arm);
  ASSERT_THAT(result.recording.episodes, SizeIs(1));
  const Episode& episode = result.recording.episodes.front();
  EXPECT_EQ(episode.frame_count(), 1600);
  EXPECT_TRUE(episode.lifted);
  // At rest for 7 s: straight, as long as it was built, and without pressure.
  constexpr int kRest = 281;
  const Eigen::VectorXf tip = episode.backbone.topRows(kRest).rightCols(7).colwise().mean();
  EXPECT_LT((tip.head<3>() - Eigen::Vector3f(0.054F, 0.0F, 0.0F)).norm(), 1e-3F);
  EXPECT_LT(episode.pressure_kpa.topRows(kRest).colwise().mean().cwiseAbs().maxCoeff(), 0.05F);
  EXPECT_NO_THROW(validate(result.recording, "imported"));
}

}  // namespace
}  // namespace limber
