#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/gap_bounds.hpp"
#include "limber/network/untrained_model.hpp"
#include "network/sample_region.hpp"
#include "support/narrow_bounds.hpp"
#include "support/sample_arm.hpp"
#include "support/space_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

TEST(ModelFile, ComesBackAfterARoundTrip) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "model.safetensors";
  for (const BackboneLayout layout : {BackboneLayout::base_poses, BackboneLayout::gap_poses}) {
    CompensationModel model = untrained_model(sample_arm(3), layout, {7, 9}, 1);
    model.training = {{"seed", "4"}, {"data", "train.h5"}};
    write_model(path, model);
    const CompensationModel back = read_model(path);
    EXPECT_EQ(back.layout, model.layout);
    EXPECT_EQ(back.arm_name, model.arm_name);
    EXPECT_EQ(back.arm_hash, model.arm_hash);
    EXPECT_EQ(back.arm_description, arm_keys_to_yaml(sample_arm(3)));
    EXPECT_EQ(back.segment_count, 3);
    EXPECT_EQ(back.point_count, 16);
    EXPECT_EQ(back.preset, model.preset);
    EXPECT_EQ(back.training, model.training);
    EXPECT_EQ(back.shape(), model.shape());
    for (std::size_t l = 0; l < model.layers.size(); ++l) {
      EXPECT_TRUE(back.layers[l].weight == model.layers[l].weight);
      EXPECT_TRUE(back.layers[l].bias == model.layers[l].bias);
    }
    EXPECT_TRUE(back.input.offset == model.input.offset && back.input.scale == model.input.scale);
    EXPECT_TRUE(back.output.offset == model.output.offset &&
                back.output.scale == model.output.scale);
  }
}

TEST(ModelFile, FilesOfBeforeTheDescriptionAreReadAndBelongToTheArmOfTheirHash) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "model.safetensors";
  ArmDescription arm = sample_arm(3);
  CompensationModel model = untrained_model(arm, BackboneLayout::gap_poses, {7}, 1);
  write_model(path, model);
  const double c1 = arm.segments[0].strain_polynomial[0];
  arm.segments[0].strain_polynomial[0] += 1e-9;  // another machine's fit
  EXPECT_NO_THROW(require_model_of(read_model(path), arm, "m"));
  model.arm_description.clear();
  write_model(path, model);
  const CompensationModel old = read_model(path);
  EXPECT_EQ(old.arm_description, "");
  EXPECT_THAT([&] { require_model_of(old, arm, "m"); },
              ThrowsMessage<InputError>(HasSubstr("what differs is not known")));
  arm.segments[0].strain_polynomial[0] = c1;
  EXPECT_NO_THROW(require_model_of(old, arm, "m"));
}

TEST(ModelFile, EnsemblesKeepAllTheirMembersInOrder) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "model.safetensors";
  const auto member = [](std::uint64_t seed) {
    return untrained_model(sample_arm(2), BackboneLayout::gap_poses, {7, 9}, seed);
  };
  CompensationModel model = member(1);
  model.more_members = {member(2).layers, member(3).layers};
  write_model(path, model);
  const CompensationModel back = read_model(path);
  ASSERT_EQ(back.member_count(), 3);
  for (int k = 0; k < 3; ++k) {
    const CompensationModel wanted = member(static_cast<std::uint64_t>(k) + 1);
    for (std::size_t l = 0; l < wanted.layers.size(); ++l) {
      EXPECT_EQ(back.member(k).layers[l].weight, wanted.layers[l].weight);
      EXPECT_EQ(back.member(k).layers[l].bias, wanted.layers[l].bias);
    }
    EXPECT_EQ(back.member(k).input.scale, wanted.input.scale);
  }

  model.more_members[1] =
      untrained_model(sample_arm(2), BackboneLayout::gap_poses, {7, 8}, 3).layers;
  EXPECT_THAT([&] { write_model(path, model); },
              ThrowsMessage<InputError>(HasSubstr("members.2.layers.* have another shape")));
  model.more_members[1] = member(3).layers;
  model.more_members[0][1].bias[4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT([&] { write_model(path, model); },
              ThrowsMessage<InputError>(HasSubstr("tensor members.1.layers.1.bias[4, 0] is nan")));
}

TEST(ModelFile, KeepsBoundsAndRefusesBrokenOnes) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "model.safetensors";
  CompensationModel model = untrained_model(sample_arm(3), BackboneLayout::gap_poses, {7}, 1);
  write_model(path, model);
  EXPECT_FALSE(read_model(path).bounds.has_value());
  model.bounds = narrow_bounds(sample_arm(3));
  write_model(path, model);
  const CompensationModel back = read_model(path);
  ASSERT_TRUE(back.bounds.has_value());
  EXPECT_EQ(back.bounds->min_length_m, model.bounds->min_length_m);
  EXPECT_EQ(back.bounds->max_length_m, model.bounds->max_length_m);
  EXPECT_EQ(back.bounds->min_turn_rad, model.bounds->min_turn_rad);
  EXPECT_EQ(back.bounds->max_turn_rad, model.bounds->max_turn_rad);
  EXPECT_TRUE(back.member(0).bounds.has_value());

  const auto refusal = [&](const std::function<void(GapBounds&)>& damage) {
    CompensationModel broken = model;
    damage(*broken.bounds);
    try {
      write_model(path, broken);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(refusal([](GapBounds& b) { b.min_length_m[3] = 0.0F; }),
              HasSubstr("bounds.length.min[3] is 0; expected metres, > 0"));
  EXPECT_THAT(refusal([](GapBounds& b) { b.max_turn_rad[2] = -1.0F; }),
              HasSubstr("bounds.turn.min[2] is -0.25; expected at most turn.max, -1"));
  EXPECT_THAT(refusal([](GapBounds& b) { b.max_length_m.conservativeResize(3); }),
              HasSubstr("bounds.length.max has 3 numbers; expected 15"));
  EXPECT_THAT(
      refusal([](GapBounds& b) { b.min_turn_rad[1] = std::numeric_limits<float>::quiet_NaN(); }),
      HasSubstr("bounds.turn.min[1] is nan"));
}

TEST(ModelFile, RefusesABendThatIsNone) {
  const CompensationModel sample =
      untrained_model(testing_support::space_arm(), BackboneLayout::gap_poses, {4}, 1);
  CompensationModel model = sample;
  const Eigen::VectorXf ones = Eigen::VectorXf::Ones(model.point_count - 1);
  model.bounds = GapBounds{0.5F * ones, ones, -ones, ones, ones};
  EXPECT_NO_THROW(validate(model, "m"));
  model.bounds->max_bend_rad[1] = -0.01F;
  EXPECT_THAT([&] { validate(model, "m"); },
              ThrowsMessage<InputError>(HasSubstr("tensor bounds.bend.max[1] is -0.01")));
}

TEST(ModelFile, PlanningAsksForBoundsAndNamesTheCommandThatAddsThem) {
  CompensationModel model = untrained_model(sample_arm(3), BackboneLayout::gap_poses, {7}, 1);
  model.training["data"] = "a.h5 0123, b c.h5 4567";
  EXPECT_THAT(
      [&] { require_bounded(model, "old.safetensors"); },
      ThrowsMessage<InputError>(AllOf(StartsWith("old.safetensors: the model has no bounds"),
                                      HasSubstr("limber train --from old.safetensors "
                                                "--epochs 0 --data a.h5 --data b c.h5 --out"))));
  model.bounds = narrow_bounds(sample_arm(3));
  EXPECT_NO_THROW(require_bounded(model, "old.safetensors"));
}

TEST(ModelFile, ShapeOfThePapersNetwork) {
  EXPECT_EQ(untrained_model(sample_arm(3), BackboneLayout::base_poses, {100, 100, 100}, 1).shape(),
            "102-100-100-100-48");
}

TEST(ModelFile, KeepsTheFormOfTheOutput) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "model.safetensors";
  const CompensationModel gated =
      untrained_model(sample_arm(3), BackboneLayout::gap_poses, {7}, 1, OutputForm::gated_change);
  write_model(path, gated);
  const CompensationModel back = read_model(path);
  EXPECT_EQ(back.form, OutputForm::gated_change);
  EXPECT_EQ(back.shape(), "60-7-90");
  EXPECT_TRUE(back.output.offset == gated.output.offset && back.output.scale == gated.output.scale);
}

TEST(ModelFile, KeepsWhetherVelocitiesAreRead) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "model.safetensors";
  for (const bool reads_velocity : {false, true}) {
    write_model(path, untrained_model(sample_arm(3), BackboneLayout::gap_poses, {7}, 1,
                                      OutputForm::gated_change, reads_velocity));
    const CompensationModel back = read_model(path);
    EXPECT_EQ(back.reads_velocity, reads_velocity);
    EXPECT_EQ(back.shape(), reads_velocity ? "105-7-90" : "60-7-90");
    Safetensors content = parse_safetensors(read_file(path), path);
    content.metadata["reads_velocity"] = "maybe";
    write_file_atomically(path, safetensors_bytes(content));
    EXPECT_THAT([&] { read_model(path); },
                ThrowsMessage<InputError>(HasSubstr("reads_velocity = 'maybe'; expected yes")));
  }
}

TEST(ModelFile, WithoutAFormIsThePapers) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "model.safetensors";
  write_model(path, untrained_model(sample_arm(3), BackboneLayout::base_poses, {7}, 1));
  Safetensors content = parse_safetensors(read_file(path), path);
  content.metadata.erase("output_form");
  write_file_atomically(path, safetensors_bytes(content));
  EXPECT_EQ(read_model(path).form, OutputForm::compensation);
}

TEST(ModelFile, KeepsTheValves) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "model.safetensors";
  CompensationModel model = untrained_model(sample_arm(2), BackboneLayout::gap_poses, {5}, 1);
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  const SegmentValves first{{0.1, 99.5}, {0.12, kNoLimit}, 0.013, 0.2};
  model.valves = ValveParameters{true, {first, {}}};
  model.valves->segments[1].inflating.rate_limit_kpa_per_s = 1.0 / 3.0;
  model.valves->segments[1].venting.rate_limit_kpa_per_s = 70.0;
  model.valve_findings = {"a \"b\".h5", {0.2, 0.5, 1.5, 900}, {8.0, 20.0, 60.0, 900}, "", {"slow"}};
  write_model(path, model);
  for (const CompensationModel& back : {read_model(path), read_model(path).member(0)}) {
    ASSERT_TRUE(back.valves);
    EXPECT_EQ(*back.valves, *model.valves);
    EXPECT_EQ(back.valve_findings.source, model.valve_findings.source);
    EXPECT_EQ(back.valve_findings.held_back.p95_kpa, 0.5);
    EXPECT_EQ(back.valve_findings.from_setpoints.frames, 900);
    EXPECT_EQ(back.valve_findings.warnings, model.valve_findings.warnings);
  }
}

TEST(ModelFile, KeepsTheReasonWhyThereAreNoValves) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "model.safetensors";
  CompensationModel model = untrained_model(sample_arm(2), BackboneLayout::gap_poses, {5}, 1);
  write_model(path, model);
  EXPECT_EQ(parse_safetensors(read_file(path), path).metadata.count("valves"), 0U);
  EXPECT_FALSE(read_model(path).valves);
  model.valve_findings.reason = "the set points never change";
  write_model(path, model);
  EXPECT_FALSE(read_model(path).valves);
  EXPECT_EQ(read_model(path).valve_findings.reason, "the set points never change");
}

TEST(ModelFile, KeepsTheErrorAndWhatWasLearnt) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "model.safetensors";
  CompensationModel model = untrained_model(sample_arm(2), BackboneLayout::gap_poses, {5}, 1);
  write_model(path, model);
  EXPECT_FALSE(read_model(path).prediction_error);
  EXPECT_FALSE(read_model(path).learnt);
  model.prediction_error = PredictionError{27, 10.0, 0.1 / 7.0, 0.1 / 11.0, 0.01, 1.0 / 3.0};
  const LearntRegion region = sample_region(2, model.point_count, 5);
  model.learnt = region;
  write_model(path, model);
  const CompensationModel back = read_model(path);
  EXPECT_EQ(back.prediction_error, model.prediction_error);
  ASSERT_TRUE(back.learnt);
  EXPECT_TRUE(back.learnt->low_kpa == region.low_kpa && back.learnt->high_kpa == region.high_kpa);
  EXPECT_TRUE(back.learnt->steepest_fall_kpa_per_s == region.steepest_fall_kpa_per_s &&
              back.learnt->steepest_rise_kpa_per_s == region.steepest_rise_kpa_per_s);
  EXPECT_TRUE(back.learnt->joint_offset == region.joint_offset &&
              back.learnt->joint_scale == region.joint_scale);
  EXPECT_TRUE(back.learnt->axes == region.axes);
  EXPECT_TRUE(back.learnt->axis_low == region.axis_low &&
              back.learnt->axis_high == region.axis_high);
  EXPECT_TRUE(back.learnt->joint_change == region.joint_change);
  model.learnt->joint_change.resize(0);  // as before there was one
  write_model(path, model);
  EXPECT_EQ(read_model(path).learnt->joint_change.size(), 0);
}

TEST(ModelFile, OnlyTheLeadingMemberHasTheError) {
  CompensationModel model = untrained_model(sample_arm(2), BackboneLayout::gap_poses, {5}, 1);
  model.more_members = {model.layers};
  model.prediction_error = PredictionError{1, 10.0, 0.1, 0.1, 0.1, 0.1};
  EXPECT_TRUE(model.member(0).prediction_error);
  EXPECT_FALSE(model.member(1).prediction_error);
}

TEST(ModelFile, DamageToWhatWasLearntIsNamed) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "model.safetensors";
  CompensationModel model = untrained_model(sample_arm(2), BackboneLayout::gap_poses, {5}, 1);
  model.learnt = sample_region(2, model.point_count, 5);
  write_model(path, model);
  const Safetensors whole = parse_safetensors(read_file(path), path);
  const auto message = [&](auto inflict, const char* expected) {
    Safetensors damaged = whole;
    inflict(damaged.tensors);
    write_file_atomically(path, safetensors_bytes(damaged));
    EXPECT_THAT([&] { (void)read_model(path); },
                ThrowsMessage<InputError>(AllOf(StartsWith(path + ": "), HasSubstr(expected))));
  };
  using Tensors = std::map<std::string, Tensor>;
  message([](Tensors& t) { t.erase("learnt.rates.fall"); }, "no tensor learnt.rates.fall");
  message([](Tensors& t) { t["learnt.joint.change"].values[1] = 0.0F; },
          "tensor learnt.joint.change[1] is 0; expected more than 0");
  message([](Tensors& t) { t.erase("learnt.axes.directions"); },
          "no tensor learnt.axes.directions");
  message(
      [](Tensors& t) {
        t["learnt.pressures.low"] = {{3}, {0, 0, 0}};
      },
      "tensor learnt.pressures.low has 3 numbers; expected 2");
  message([](Tensors& t) { t["learnt.pressures.low"].values[1] = 2000.0F; },
          "tensor learnt.pressures.low[1] is 2000, above its high");
  message([](Tensors& t) { t["learnt.rates.rise"].values[0] = -1.0F; },
          "tensor learnt.rates.rise[0] is -1; expected ≥ 0");
  message([](Tensors& t) { t["learnt.joint.scale"].values[3] = 0.0F; },
          "tensor learnt.joint.scale[3] is 0");
  message([](Tensors& t) { t["learnt.axes.high"].values[2] = -9.0F; },
          "tensor learnt.axes.low[2] is");
  message([](Tensors& t) { t["learnt.joint.offset"].values[0] = std::nanf(""); },
          "tensor learnt.joint.offset[0] is nan; expected a finite number");
  message([](Tensors& t) { t["learnt.axes.directions"].values[7] = std::nanf(""); },
          "tensor learnt.axes.directions holds a number that is not finite");
  message(
      [](Tensors& t) {
        t["learnt.axes.directions"].shape = {1, 115};
      },
      "tensor learnt.axes.directions is 1 × 115; expected up to");
}

TEST(ModelFile, RefusesAChangeThatIsShifted) {
  CompensationModel model =
      untrained_model(sample_arm(3), BackboneLayout::gap_poses, {7}, 1, OutputForm::gated_change);
  model.output.offset[3] = 0.1F;
  EXPECT_THAT([&] { validate(model, "m"); },
              ThrowsMessage<InputError>(
                  HasSubstr("tensor normalisation.output.offset is not 0; expected 0 in a model of "
                            "output_form gated_change")));
}

TEST(ModelFile, IsNotWrittenFromAnInvalidModel) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "model.safetensors";
  CompensationModel model = untrained_model(sample_arm(2), BackboneLayout::gap_poses, {5}, 1);
  model.layers[0].bias[2] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(write_model(path, model), InputError);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ModelFile, MissingFileIsNamed) {
  EXPECT_THAT([] { (void)read_model("nowhere/model.safetensors"); },
              ThrowsMessage<InputError>(HasSubstr("nowhere/model.safetensors")));
}

}  // namespace
}  // namespace limber
