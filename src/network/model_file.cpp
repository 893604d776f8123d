#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "family_tensors.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/common/utf8.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/past_commands.hpp"
#include "model_tensors.hpp"
#include "refusal.hpp"

namespace limber {

namespace {

constexpr const char* kSchema = "limber/model/1";
constexpr const char* kTrainingPrefix = "training.";
constexpr const char* kValvesKey = "valves";
constexpr const char* kLearntFromKey = "learnt_from";
constexpr const char* kErrorKey = "prediction_error";
constexpr const char* kReadsVelocityKey = "reads_velocity";
constexpr const char* kPastCommandsKey = "past_commands";
constexpr const char* kTubeKey = "tube";
constexpr const char* kDimensionKey = "dimension";
constexpr const char* kChamberCountKey = "chamber_count";
constexpr const char* kAxes = "axes.directions";
constexpr const char* kLearntPrefix = "learnt.";
constexpr const char* kBoundsPrefix = "bounds.";

std::string member_prefix(std::size_t member) {
  return fmt::format("members.{}.layers.", member);
}

void add_layers(Safetensors& content, const std::string& prefix, const std::vector<Layer>& layers) {
  for (std::size_t l = 0; l < layers.size(); ++l) {
    content.tensors[fmt::format("{}{}.weight", prefix, l)] = matrix_tensor(layers[l].weight);
    content.tensors[fmt::format("{}{}.bias", prefix, l)] = vector_tensor(layers[l].bias);
  }
}

int count_at(const Safetensors& content, const std::string& key, const std::string& where) {
  const std::string text = text_at(content, key, where);
  if (text.empty() || text.size() > 6 ||
      !std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; })) {
    refuse(where, fmt::format("metadata {} = '{}'; expected a whole number", key, shortened(text)));
  }
  return *number_in<int>(text);
}

/// The one of two choices that the metadata name.
template <class Choice>
Choice choice_at(const Safetensors& content, const char* key, Choice first, Choice second,
                 const char* (*name_of)(Choice), const std::string& where) {
  const std::string text = text_at(content, key, where);
  for (const Choice choice : {first, second}) {
    if (text == name_of(choice)) {
      return choice;
    }
  }
  refuse(where, fmt::format("metadata {} = '{}'; expected {} or {}", key, shortened(text),
                            name_of(first), name_of(second)));
}

// Models of before there was a choice don't.
bool reads_velocity_at(const Safetensors& content, const std::string& where) {
  const auto found = content.metadata.find(kReadsVelocityKey);
  if (found != content.metadata.end() && found->second != "yes") {
    refuse(where, fmt::format("metadata {} = '{}'; expected yes, or no such key", kReadsVelocityKey,
                              shortened(found->second)));
  }
  return found != content.metadata.end();
}

// Models of planar arms don't say.
void read_space_into(CompensationModel& model, const Safetensors& content,
                     const std::string& where) {
  if (content.metadata.count(kDimensionKey) == 0) {
    return;
  }
  if (count_at(content, kDimensionKey, where) != position_size(Dimension::space)) {
    refuse(where, fmt::format("metadata {} = '{}'; expected 3, or no such key", kDimensionKey,
                              shortened(content.metadata.at(kDimensionKey))));
  }
  model.dimension = Dimension::space;
  model.chamber_count = count_at(content, kChamberCountKey, where);
  if (content.metadata.count(kPastCommandsKey) != 0) {
    const nlohmann::json past =
        nlohmann::json::parse(content.metadata.at(kPastCommandsKey), nullptr, false);
    for (const JsonReader& frames :
         JsonReader(past, where + ": metadata past_commands").elements("frames ago")) {
      model.past_commands.push_back(frames.integer(1, kMaxPastFrames));
    }
  }
}

void require_described_arm(const CompensationModel& model, const std::string& where) {
  if (model.arm_description.empty()) {
    return;
  }
  const std::string metadata = where + ": metadata arm_description";
  const ArmDescription arm = read_arm_keys(model.arm_description, metadata);
  refuse_if(
      arm.dimension != model.dimension || arm.segment_count() != model.segment_count ||
          arm.channel_count() != model.channel_count() || arm.point_count() != model.point_count,
      "{}: an arm of {} segments, {} commands and {} plates; the model is of one of {}, {} and "
      "{}: one of them is damaged",
      metadata, arm.segment_count(), arm.channel_count(), arm.point_count(), model.segment_count,
      model.channel_count(), model.point_count);
}

void read_measured_into(CompensationModel& model, const Safetensors& content,
                        const std::string& where) {
  const auto reader_at = [&](const char* key) {
    const auto found = content.metadata.find(key);
    return found == content.metadata.end()
               ? std::nullopt
               : std::optional(YamlReader::from_text(found->second, where + ": metadata " + key));
  };
  // Older models, from before valves were identified, and models of recordings without set points
  // have none.
  if (const std::optional<YamlReader> reader = reader_at(kValvesKey)) {
    const IdentifiedValves valves = read_valves(*reader);
    require_no_valves_before(model, valves.parameters, where + ": metadata valves");
    model.set_valves(valves);
  }
  // Older models, from before it was measured, and models of recordings too short for it have none.
  if (const std::optional<YamlReader> reader = reader_at(kErrorKey)) {
    model.prediction_error = read_prediction_error(*reader);
  }
  // Only models that were calibrated have one.
  if (const std::optional<YamlReader> reader = reader_at(kTubeKey)) {
    model.tube = read_tube(*reader);
  }
}

struct LearntVector {
  const char* name;
  Eigen::VectorXf LearntRegion::*vector;
};
constexpr std::array kLearntVectors = {
    LearntVector{"pressures.low", &LearntRegion::low_kpa},
    LearntVector{"pressures.high", &LearntRegion::high_kpa},
    LearntVector{"rates.fall", &LearntRegion::steepest_fall_kpa_per_s},
    LearntVector{"rates.rise", &LearntRegion::steepest_rise_kpa_per_s},
    LearntVector{"joint.offset", &LearntRegion::joint_offset},
    LearntVector{"joint.scale", &LearntRegion::joint_scale},
    LearntVector{"joint.change", &LearntRegion::joint_change},
    LearntVector{"axes.low", &LearntRegion::axis_low},
    LearntVector{"axes.high", &LearntRegion::axis_high}};

struct BoundsVector {
  const char* name;
  Eigen::VectorXf GapBounds::*vector;
};
constexpr std::array kBoundsVectors = {BoundsVector{"length.min", &GapBounds::min_length_m},
                                       BoundsVector{"length.max", &GapBounds::max_length_m},
                                       BoundsVector{"turn.min", &GapBounds::min_turn_rad},
                                       BoundsVector{"turn.max", &GapBounds::max_turn_rad},
                                       BoundsVector{"bend.max", &GapBounds::max_bend_rad}};

/// Tensors that some models don't have are left out where they are empty.
bool may_be_missing(const std::string& name) {
  return name == "joint.change" || name == "bend.max";
}

template <class Part, class Vectors>
void add_vectors(Safetensors& content, const std::string& prefix, const Part& part,
                 const Vectors& vectors) {
  for (const auto& [name, vector] : vectors) {
    if ((part.*vector).size() > 0 || !may_be_missing(name)) {
      content.tensors[prefix + name] = vector_tensor(part.*vector);
    }
  }
}

template <class Part, class Vectors>
Part read_vectors(TensorReader& tensors, const std::string& prefix, const Vectors& vectors) {
  Part part;
  for (const auto& [name, vector] : vectors) {
    if (tensors.has(prefix + name) || !may_be_missing(name)) {
      part.*vector = tensors.vector(prefix + name);
    }
  }
  return part;
}

}  // namespace

void write_model(const fs::path& path, const CompensationModel& model) {
  validate(model, path.string());
  Safetensors content;
  add_layers(content, "layers.", model.layers);
  for (std::size_t k = 0; k < model.more_members.size(); ++k) {
    add_layers(content, member_prefix(k + 1), model.more_members[k]);
  }
  content.tensors["normalisation.input.offset"] = vector_tensor(model.input.offset);
  content.tensors["normalisation.input.scale"] = vector_tensor(model.input.scale);
  content.tensors["normalisation.output.offset"] = vector_tensor(model.output.offset);
  content.tensors["normalisation.output.scale"] = vector_tensor(model.output.scale);
  content.metadata = {{"schema", kSchema},
                      {"arm_name", model.arm_name},
                      {"arm_hash", model.arm_hash},
                      {"layout", to_string(model.layout)},
                      {"output_form", to_string(model.form)},
                      {"segment_count", std::to_string(model.segment_count)},
                      {"point_count", std::to_string(model.point_count)},
                      {"preset", model.preset},
                      {kLearntFromKey, commands_are(model.learnt_from_setpoints)}};
  if (model.dimension == Dimension::space) {
    content.metadata[kDimensionKey] = "3";
    content.metadata[kChamberCountKey] = std::to_string(model.chamber_count);
    if (!model.past_commands.empty()) {
      content.metadata[kPastCommandsKey] =
          fmt::format("[{}]", fmt::join(model.past_commands, ", "));
    }
  }
  if (model.reads_velocity) {
    content.metadata[kReadsVelocityKey] = "yes";
  }
  if (!model.arm_description.empty()) {
    content.metadata["arm_description"] = model.arm_description;
  }
  for (const auto& [key, value] : model.training) {
    content.metadata[kTrainingPrefix + key] = value;
  }
  if (model.valves || !model.valve_findings.reason.empty()) {
    content.metadata[kValvesKey] = to_json(model.identified_valves()).dump();
  }
  if (model.prediction_error) {
    content.metadata[kErrorKey] = prediction_error_to_metadata(*model.prediction_error);
  }
  if (model.tube) {
    content.metadata[kTubeKey] = tube_to_metadata(*model.tube);
  }
  if (model.learnt) {
    add_vectors(content, kLearntPrefix, *model.learnt, kLearntVectors);
    content.tensors[std::string(kLearntPrefix) + kAxes] = matrix_tensor(model.learnt->axes);
  }
  if (model.bounds) {
    add_vectors(content, kBoundsPrefix, *model.bounds, kBoundsVectors);
  }
  if (model.family) {
    add_family(content, model);
  }
  write_file_atomically(path, safetensors_bytes(content));
}

CompensationModel read_model(const fs::path& path) {
  const std::string where = path.string();
  Safetensors content = parse_safetensors(read_file(path), where);
  const std::string schema = text_at(content, "schema", where);
  if (schema != kSchema) {
    refuse(where, fmt::format("metadata schema = '{}'; expected {}", shortened(schema), kSchema));
  }
  CompensationModel model;
  model.arm_name = text_at(content, "arm_name", where);
  model.arm_hash = text_at(content, "arm_hash", where);
  if (content.metadata.count("arm_description") > 0) {
    model.arm_description = content.metadata.at("arm_description");
  }
  model.layout = choice_at(content, "layout", BackboneLayout::base_poses, BackboneLayout::gap_poses,
                           to_string, where);
  // Older files, from before there was a choice, don't say; they have the paper's form.
  if (content.metadata.count("output_form") > 0) {
    model.form = choice_at(content, "output_form", OutputForm::compensation,
                           OutputForm::gated_change, to_string, where);
  }
  model.reads_velocity = reads_velocity_at(content, where);
  model.segment_count = count_at(content, "segment_count", where);
  model.point_count = count_at(content, "point_count", where);
  read_space_into(model, content, where);
  model.preset = text_at(content, "preset", where);
  for (const auto& [key, value] : content.metadata) {
    if (key.rfind(kTrainingPrefix, 0) == 0) {
      model.training[key.substr(std::char_traits<char>::length(kTrainingPrefix))] = value;
    }
  }
  // Older models, from before set points alone were learnt from, don't say; they are of one kind.
  if (content.metadata.count(kLearntFromKey) > 0) {
    model.learnt_from_setpoints =
        choice_at(content, kLearntFromKey, false, true, commands_are, where);
  }
  read_measured_into(model, content, where);
  TensorReader tensors(content, where);
  model.layers = tensors.layers("layers.");
  while (tensors.has(member_prefix(model.more_members.size() + 1) + "0.weight")) {
    model.more_members.push_back(tensors.layers(member_prefix(model.more_members.size() + 1)));
  }
  model.input = {tensors.vector("normalisation.input.offset"),
                 tensors.vector("normalisation.input.scale")};
  model.output = {tensors.vector("normalisation.output.offset"),
                  tensors.vector("normalisation.output.scale")};
  if (tensors.has_any(kLearntPrefix)) {
    model.learnt = read_vectors<LearntRegion>(tensors, kLearntPrefix, kLearntVectors);
    model.learnt->axes = tensors.matrix(std::string(kLearntPrefix) + kAxes);
  }
  if (tensors.has_any(kBoundsPrefix)) {
    model.bounds = read_vectors<GapBounds>(tensors, kBoundsPrefix, kBoundsVectors);
  }
  if (tensors.has_any(kFamilyTensors)) {
    read_family_into(model, content, tensors, where);
  }
  tensors.require_all_taken();
  validate(model, where);
  require_described_arm(model, where);
  return model;
}

}  // namespace limber
