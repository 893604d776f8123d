#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/sample_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

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
        Damage{
            "description_of_another_arm",
            [](Safetensors& s) { s.metadata["arm_description"] = arm_keys_to_yaml(sample_arm(2)); },
            "metadata arm_description: an arm of 2 segments"},
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
               "tensor normalisation.output.scale[4] is 0; expected a scale other than 0"},
        Damage{"scale_without_an_inverse",
               [](Safetensors& s) { s.tensors["normalisation.input.scale"].values[2] = 1e-40F; },
               "tensor normalisation.input.scale[2] is 1e-40; expected a scale other than 0, whose "
               "inverse is finite"},
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
