#include "limber/driver/wire_calibration.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/sim/misassembly.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr float kRoundingM = 1e-5F;  // float32 some metres away, in mm
constexpr float kRoundingKpa = 1e-4F;

ArmDescription three_segments() {
  ArmDescription arm;
  arm.name = "mine";
  arm.segments.assign(3, {0.2, 0.03, 4, PressureLimits(-50.0, 80.0)});
  arm.frame_rate_hz = 20.0;
  arm.pressure_rate_limit_kpa_per_s = 100.0;
  return arm;
}

ArmState bent(const ArmDescription& arm) {
  ArmState state;
  state.pressure_kpa = Pressures::LinSpaced(arm.segment_count(), -20.0F, 40.0F);
  state.setpoint_kpa = Pressures::LinSpaced(arm.segment_count(), -10.0F, 30.0F);
  Backbone backbone(arm.point_count(), 3);
  for (Eigen::Index i = 0; i < backbone.rows(); ++i) {
    const auto t = static_cast<float>(i);
    backbone.row(i) << 0.04F * t, 0.002F * t * t, 0.5F * t;  // more than a whole turn
  }
  state.backbone = backbone;
  return state;
}

// What one direction does, the other undoes; with every seed.
TEST(WireCalibration, FromWireIsTheInverseOfToWire) {
  const ArmDescription arm = three_segments();
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const WireCalibration truth = draw_misassembly(arm, seed).truth;
    const ArmState state = bent(arm);
    const ArmState back = truth.from_wire(truth.to_wire(state));
    EXPECT_LT((back.pressure_kpa - state.pressure_kpa).cwiseAbs().maxCoeff(), kRoundingKpa);
    EXPECT_EQ(*back.setpoint_kpa, *state.setpoint_kpa);
    EXPECT_LT((*back.backbone - *state.backbone).cwiseAbs().maxCoeff(), kRoundingM);
    const Pressures set = *state.setpoint_kpa;
    EXPECT_EQ(truth.from_wire(truth.to_wire(set)), set);
    const std::vector<PressureLimits> limits(3, PressureLimits(-50.0, 80.0));
    EXPECT_EQ(truth.from_wire(truth.to_wire(limits)), limits);
  }
}

// The same of bodies in 3D, which stand in place of the backbone.
TEST(WireCalibration, BodiesIn3dComeBackAsBackbones) {
  const ArmDescription arm = three_segments();
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Misassembly wrong = draw_misassembly_in_3d(arm, seed);
    const ArmState state = bent(arm);
    ArmState on_wire = wrong.truth.to_wire(state);
    const BodyPoses bodies =
        bodies_in_space(*wrong.truth.tracker->plane, *on_wire.backbone, wrong.body_heights);
    on_wire.backbone.reset();
    const ArmState back = wrong.truth.from_wire(on_wire, bodies);
    EXPECT_LT((*back.backbone - *state.backbone).cwiseAbs().maxCoeff(), kRoundingM);
    EXPECT_FALSE(wrong.truth.from_wire(on_wire, std::nullopt).backbone) << "not seen";
  }
}

// A tracker that takes one body for another: a wrong shape would be worse than none.
TEST(WireCalibration, BodiesFarOutOfThePlaneAreNotSeen) {
  const ArmDescription arm = three_segments();
  const Misassembly wrong = draw_misassembly_in_3d(arm, 3);
  const TrackerPlane& plane = *wrong.truth.tracker->plane;
  ArmState on_wire = wrong.truth.to_wire(bent(arm));
  const BodyPoses bodies = bodies_in_space(plane, *on_wire.backbone, wrong.body_heights);
  on_wire.backbone.reset();
  const auto seen_with = [&](double tilt_rad) {
    const Eigen::Quaterniond over(Eigen::AngleAxisd(tilt_rad, plane.x_axis));
    BodyPoses tilted = bodies;
    tilted.row(4).tail<4>() = (over * rotation_of(bodies, 4)).coeffs().transpose();
    return wrong.truth.from_wire(on_wire, tilted).backbone.has_value();
  };
  EXPECT_TRUE(seen_with(0.49));
  EXPECT_FALSE(seen_with(0.51));
  EXPECT_FALSE(seen_with(3.0));
}

TEST(WireCalibration, IdentityChangesNothing) {
  const ArmDescription arm = three_segments();
  const ArmState state = bent(arm);
  const ArmState same = identity_calibration(arm).from_wire(state);
  EXPECT_EQ(same.pressure_kpa, state.pressure_kpa);
  EXPECT_EQ(*same.backbone, *state.backbone);
}

// A limit of one side goes where that side went.
TEST(WireCalibration, LimitsTurnWithTheirChannel) {
  WireCalibration calibration = identity_calibration(three_segments());
  calibration.valves = {{2, -1.0}, {0, 1.0}, {1, 1.0}};
  const auto of_segments =
      calibration.from_wire({PressureLimits(-1, 2), PressureLimits(-3, 4), PressureLimits(-5, 6)});
  EXPECT_EQ(of_segments[0], PressureLimits(-6, 5));
  EXPECT_EQ(of_segments[1], PressureLimits(-1, 2));
  EXPECT_EQ(of_segments[2], PressureLimits(-3, 4));
}

// A shape that the tracker wraps at half a turn comes back unwrapped along the arm.
TEST(WireCalibration, HeadingsAreUnwrappedAlongTheArm) {
  const ArmDescription arm = three_segments();
  WireCalibration calibration = identity_calibration(arm);
  calibration.tracker = TrackerCalibration{};
  calibration.tracker->marker_offsets.resize(static_cast<std::size_t>(arm.point_count()));
  const ArmState state = bent(arm);
  ArmState wrapped = state;
  for (Eigen::Index i = 0; i < wrapped.backbone->rows(); ++i) {
    float& theta = (*wrapped.backbone)(i, 2);
    theta = std::remainder(theta, 6.2831853F);
  }
  EXPECT_LT((*calibration.from_wire(wrapped).backbone - *state.backbone).cwiseAbs().maxCoeff(),
            kRoundingM);
}

TEST(WireCalibrationFile, SaysTheSameWhenReadAgain) {
  const ArmDescription arm = three_segments();
  WireCalibration truth = draw_misassembly(arm, 5).truth;
  truth.clocks.driver = TimeInterval{1.5, 1.4, 1.6};
  truth.clocks.driver_drift = 2e-5;
  const std::string text = to_yaml(truth);
  const WireCalibration back = parse_wire_calibration(text, "c.yaml");
  EXPECT_EQ(to_yaml(back), text);
  EXPECT_EQ(back.valves, truth.valves);
  EXPECT_EQ(back.tracker->base.x_m, truth.tracker->base.x_m);
}

TEST(WireCalibrationFile, NamesWhatIsWrong) {
  const ArmDescription arm = three_segments();
  const std::string good = to_yaml(draw_misassembly(arm, 5).truth);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  const auto expect = [](const std::string& text, const std::string& message) {
    EXPECT_THAT([&] { parse_wire_calibration(text, "c.yaml"); },
                ThrowsMessage<InputError>(HasSubstr(message)));
  };
  expect(with("driver_calibration/1", "driver_calibration/9"), "schema");
  expect(with("sign: 1", "sign: 0"), "0; expected 1 or -1");
  expect(with("valves: [{channel: ", "valves: [{channel: 9"), "channel");
  expect(with("mirrored:", "mirored:"), "mirored");
  WireCalibration twice = draw_misassembly(arm, 5).truth;
  twice.valves[1].channel = twice.valves[0].channel;
  expect(to_yaml(twice), "is another segment's too");
}

TEST(WireCalibrationFile, SaysThePlaneAgain) {
  const WireCalibration truth = draw_misassembly_in_3d(three_segments(), 5).truth;
  const WireCalibration back = parse_wire_calibration(to_yaml(truth), "c.yaml");
  const TrackerPlane& ours = *back.tracker->plane;
  const TrackerPlane& theirs = *truth.tracker->plane;
  EXPECT_EQ(ours.origin, theirs.origin);
  EXPECT_TRUE(ours.x_axis.isApprox(theirs.x_axis, 1e-15));
  EXPECT_TRUE(ours.y_axis.isApprox(theirs.y_axis, 1e-15));
  ASSERT_EQ(ours.body_rotations.size(), theirs.body_rotations.size());
  EXPECT_TRUE(ours.body_rotations[3].isApprox(theirs.body_rotations[3], 1e-15));
}

TEST(WireCalibrationFile, KeepsEveryNameOfAnArm) {
  WireCalibration truth = draw_misassembly(three_segments(), 5).truth;
  truth.arm = "a \"b\" \\ \n{c}: #";
  EXPECT_EQ(parse_wire_calibration(to_yaml(truth), "c.yaml").arm, truth.arm);
}

TEST(WireCalibrationFile, NamesWhatIsWrongWithAPlane) {
  const auto expect = [](const auto& spoil, const std::string& message) {
    WireCalibration truth = draw_misassembly_in_3d(three_segments(), 5).truth;
    spoil(*truth.tracker);
    EXPECT_THAT([&] { parse_wire_calibration(to_yaml(truth), "c.yaml"); },
                ThrowsMessage<InputError>(HasSubstr(message)));
  };
  using Tracker = TrackerCalibration;
  expect([](Tracker& t) { t.plane->x_axis *= 1.01; }, "x_axis: of length 1.01; expected 1");
  expect([](Tracker& t) { t.plane->y_axis = t.plane->x_axis; }, "not perpendicular to x_axis");
  expect([](Tracker& t) { t.plane->origin.x() = 1e9; }, "origin: expected numbers up to");
  expect([](Tracker& t) { t.plane->body_rotations[2].coeffs() *= 2.0; },
         "body_rotations[2]: of length 2; expected 1");
  expect([](Tracker& t) { t.plane->body_rotations.pop_back(); },
         "12 rotations; marker_offsets has 13 bodies");
  expect([](Tracker& t) { t.radians_per_unit = 0.1; }, "radians_per_unit: expected 1 or -1");
  const std::string good = to_yaml(draw_misassembly_in_3d(three_segments(), 5).truth);
  std::string misspelt = good;
  misspelt.replace(misspelt.find("x_axis"), 6, "x_axes");
  EXPECT_THAT([&] { parse_wire_calibration(misspelt, "c.yaml"); },
              ThrowsMessage<InputError>(HasSubstr("x_axes")));
}

TEST(WireCalibrationFile, BelongsToOneArm) {
  const ArmDescription arm = three_segments();
  const WireCalibration truth = draw_misassembly(arm, 5).truth;
  EXPECT_NO_THROW(require_calibration_of(truth, arm, "c.yaml"));
  ArmDescription longer = arm;
  longer.segments[0].length_m = 0.21;
  EXPECT_THAT([&] { require_calibration_of(truth, longer, "c.yaml"); },
              ThrowsMessage<InputError>(HasSubstr("limber driver calibrate")));
  ArmDescription shorter = arm;
  shorter.segments.pop_back();
  EXPECT_THAT([&] { require_calibration_of(truth, shorter, "c.yaml"); },
              ThrowsMessage<InputError>(HasSubstr("with 3 segments")));
}

}  // namespace
}  // namespace limber
