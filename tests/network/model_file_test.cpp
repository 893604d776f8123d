#include <fstream>
#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/untrained_model.hpp"
#include "network/sample_region.hpp"
#include "support/sample_arm.hpp"
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

struct Damage {
  const char* name;
  std::function<void(Safetensors&)> inflict;
  const char* message;
};

class DamagedModelFile : public ::testing::TestWithParam<Damage> {};

TEST_P(DamagedModelFile, IsRefusedByName) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "model.safetensors";
  write_model(path, untrained_model(sample_arm(3), BackboneLayout::base_poses, {7, 9}, 1));
  Safetensors content = parse_safetensors(read_file(path), path);
  GetParam().inflict(content);
  write_file_atomically(path, safetensors_bytes(content));
  EXPECT_THAT(
      [&] { (void)read_model(path); },
      ThrowsMessage<InputError>(AllOf(StartsWith(path + ": "), HasSubstr(GetParam().message))));
}

Damage metadata_damage(const char* name, const char* key, const char* value, const char* message) {
  return {name, [=](Safetensors& s) { s.metadata[key] = value; }, message};
}

INSTANTIATE_TEST_SUITE_P(
    Ways, DamagedModelFile,
    ::testing::Values(
        metadata_damage("schema", "schema", "limber/model/9",
                        "metadata schema = 'limber/model/9'; expected limber/model/1"),
        metadata_damage("layout", "layout", "sideways",
                        "metadata layout = 'sideways'; expected base_poses or gap_poses"),
        metadata_damage("form", "output_form", "guess",
                        "metadata output_form = 'guess'; expected compensation or gated_change"),
        metadata_damage("other_form", "output_form", "gated_change",
                        "tensor layers.2.weight has 48 rows; expected 96"),
        metadata_damage("count", "segment_count", "-3",
                        "metadata segment_count = '-3'; expected a whole number"),
        metadata_damage("no_segment", "segment_count", "0", "segment_count 0 and point_count 16"),
        metadata_damage("other_size", "point_count", "17",
                        "tensor layers.0.weight has 102 columns; expected 108"),
        metadata_damage("valves_of_another_arm", "valves",
                        R"({"schema":"limber/valves/1","has_sides":true,"segments":[
                            {"inflate_time_constant_s":0.1,"vent_time_constant_s":0.1,
                             "dead_time_s":0,"dead_band_kpa":0}]})",
                        "metadata valves: 1 segments found; the arm has 3"),
        metadata_damage("negative_valves", "valves",
                        R"({"schema":"limber/valves/1","has_sides":true,"segments":[
                            {"inflate_time_constant_s":-1}]})",
                        "metadata valves:2: segments[0].inflate_time_constant_s: -1 found"),
        metadata_damage(
            "error_without_runs", "prediction_error",
            R"({"runs":0,"run_s":10,"largest_position_m":0.1,"off_path_m":0.1,"end_position_m":0.1,
                            "end_orientation_rad":0.1})",
            "metadata prediction_error:1: runs: 0 found"),
        metadata_damage("error_of_another_kind", "prediction_error", R"({"runs":3,"mood":2})",
                        "metadata prediction_error:1: mood"),
        Damage{"no_schema", [](Safetensors& s) { s.metadata.erase("schema"); },
               "no metadata key schema"},
        Damage{"no_hash", [](Safetensors& s) { s.metadata.erase("arm_hash"); },
               "no metadata key arm_hash"},
        Damage{"no_layers",
               [](Safetensors& s) {
                 std::erase_if(s.tensors, [](const auto& item) { return item.first[0] == 'l'; });
               },
               "no tensor layers.0.weight"},
        Damage{"no_bias", [](Safetensors& s) { s.tensors.erase("layers.1.bias"); },
               "no tensor layers.1.bias"},
        Damage{"layer_left_out",
               [](Safetensors& s) {
                 s.tensors.erase("layers.1.weight");
                 s.tensors.erase("layers.1.bias");
               },
               "tensor layers.2.bias does not belong in a model file"},
        Damage{"no_scale", [](Safetensors& s) { s.tensors.erase("normalisation.input.scale"); },
               "no tensor normalisation.input.scale"},
        Damage{"zero_scale",
               [](Safetensors& s) { s.tensors["normalisation.output.scale"].values[4] = 0.0F; },
               "tensor normalisation.output.scale[4] is 0"},
        Damage{"not_a_number",
               [](Safetensors& s) {
                 s.tensors["layers.1.weight"].values[7] = std::numeric_limits<float>::quiet_NaN();
               },
               "tensor layers.1.weight[1, 0] is nan; expected a finite number"},
        Damage{"flat_weight",
               [](Safetensors& s) { s.tensors["layers.0.weight"].shape = {7 * 102}; },
               "tensor layers.0.weight has 1 dimensions; expected [out, in]"},
        Damage{"layers_do_not_chain",
               [](Safetensors& s) {
                 s.tensors["layers.1.weight"].shape = {7, 9};
               },
               "tensor layers.1.weight has 9 columns; expected 7, the size of the layer before it"},
        Damage{"bias_of_another_layer",
               [](Safetensors& s) { s.tensors["layers.1.bias"] = s.tensors["layers.0.bias"]; },
               "tensor layers.1.bias has 7 numbers; expected 9"},
        Damage{"output_of_another_layout",
               [](Safetensors& s) {
                 s.tensors["layers.2.weight"] = {{45, 9}, std::vector<float>(45 * 9)};
                 s.tensors["layers.2.bias"] = {{45}, std::vector<float>(45)};
               },
               "tensor layers.2.weight has 45 rows; expected 48"},
        Damage{"stray_tensor",
               [](Safetensors& s) {
                 s.tensors["extra"] = {{1}, {0.0F}};
               },
               "tensor extra does not belong in a model file"},
        Damage{"stray_tensor_of_whole_numbers",
               [](Safetensors& s) {
                 s.shorts["extra"] = {{1}, {0}};
               },
               "tensor extra does not belong in a model file"}),
    [](const auto& damage) { return std::string(damage.param.name); });

}  // namespace
}  // namespace limber
