#include "limber/network/compensation_model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/gap_bounds.hpp"
#include "limber/network/past_commands.hpp"
#include "refusal.hpp"

namespace limber {

namespace {

struct Sizes {
  Eigen::Index input = 0;
  Eigen::Index backbone = 0;
  Eigen::Index output = 0;
};

// As in NetworkLayout, from the counts alone: a model file carries no arm.
Sizes expected_sizes(const CompensationModel& model) {
  const Eigen::Index n = model.command_size();
  const Eigen::Index m = model.point_count;
  const bool base = model.layout == BackboneLayout::base_poses;
  const Eigen::Index gap = gap_size(model.dimension);
  const Eigen::Index backbone = base ? kPoseSize * m : gap * (m - 1);
  const Eigen::Index no_load = base ? kPoseSize * m : gap * model.segment_count;
  const bool gated = model.form == OutputForm::gated_change;
  const Eigen::Index change = model.reads_velocity ? backbone : 0;
  return {2 * n + backbone + no_load + change, backbone, gated ? 2 * backbone : backbone};
}

void validate_past_commands(const CompensationModel& model, const std::string& where) {
  int before = 0;
  for (const int frames : model.past_commands) {
    if (model.dimension != Dimension::space || frames <= before || frames > kMaxPastFrames) {
      refuse(where, fmt::format("past_commands [{}]; expected frames ago, ascending from 1 to {}, "
                                "and none of an arm in a plane",
                                fmt::join(model.past_commands, ", "), kMaxPastFrames));
    }
    before = frames;
  }
}

void validate_normalisation(const std::string& where, const std::string& name,
                            const Normalisation& normalisation, Eigen::Index size) {
  require_vector(where, name + ".offset", normalisation.offset, size);
  require_vector(where, name + ".scale", normalisation.scale, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    if (!std::isfinite(1.0F / normalisation.scale[i])) {  // numbers are multiplied by it
      refuse(where, fmt::format("tensor {}.scale[{}] is {}; expected a scale other than 0, whose "
                                "inverse is finite (1 for a number that never changes)",
                                name, i, normalisation.scale[i]));
    }
  }
}

// `prefix` is that of the layers' tensors.
void validate_layers(const std::string& where, const std::string& prefix,
                     const std::vector<Layer>& layers, Sizes sizes) {
  refuse_if(layers.empty(), "{}: no tensor {}0.weight; expected at least one layer", where, prefix);
  Eigen::Index inputs = sizes.input;
  const char* source = "the layout's input";
  for (std::size_t l = 0; l < layers.size(); ++l) {
    const Layer& layer = layers[l];
    refuse_if(layer.weight.cols() != inputs,
              "{}: tensor {}{}.weight has {} columns; expected {}, the size of {}", where, prefix,
              l, layer.weight.cols(), inputs, source);
    refuse_if(layer.bias.size() != layer.weight.rows(),
              "{}: tensor {}{}.bias has {} numbers; expected {}, the rows of {}{}.weight", where,
              prefix, l, layer.bias.size(), layer.weight.rows(), prefix, l);
    require_finite(where, fmt::format("{}{}.weight", prefix, l), layer.weight);
    require_finite(where, fmt::format("{}{}.bias", prefix, l), layer.bias);
    inputs = layer.weight.rows();
    source = "the layer before it";
  }
  refuse_if(inputs != sizes.output,
            "{}: tensor {}{}.weight has {} rows; expected {}, the size of the layout's output",
            where, prefix, layers.size() - 1, inputs, sizes.output);
}

void validate_members(const std::string& where, const CompensationModel& model, Sizes sizes) {
  for (std::size_t k = 0; k < model.more_members.size(); ++k) {
    const std::vector<Layer>& layers = model.more_members[k];
    const std::string prefix = fmt::format("members.{}.layers.", k + 1);
    validate_layers(where, prefix, layers, sizes);
    const auto units = [](const Layer& layer) { return layer.weight.rows(); };
    refuse_if(!std::ranges::equal(layers, model.layers, {}, units, units),
              "{}: tensors {}* have another shape than layers.*; "
              "the members of an ensemble are alike",
              where, prefix);
  }
}

}  // namespace

void require_vector(const std::string& where, const std::string& name,
                    const Eigen::VectorXf& values, Eigen::Index size) {
  refuse_if(values.size() != size, "{}: tensor {} has {} numbers; expected {}", where, name,
            values.size(), size);
  for (Eigen::Index i = 0; i < size; ++i) {
    if (!std::isfinite(values[i])) {
      refuse(where,
             fmt::format("tensor {}[{}] is {}; expected a finite number", name, i, values[i]));
    }
  }
}

void require_finite(const std::string& where, const std::string& name,
                    const Eigen::Ref<const Eigen::MatrixXf>& values) {
  for (Eigen::Index j = 0; j < values.cols(); ++j) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      if (!std::isfinite(values(i, j))) {
        refuse(where, fmt::format("tensor {}[{}, {}] is {}; expected a finite number", name, i, j,
                                  values(i, j)));
      }
    }
  }
}

const char* to_string(BackboneLayout layout) {
  return layout == BackboneLayout::base_poses ? "base_poses" : "gap_poses";
}

CompensationModel CompensationModel::member(int index) const {
  CompensationModel one = *this;
  one.more_members.clear();
  one.training.clear();
  if (index > 0) {
    one.layers = more_members[std::size_t(index) - 1];
    one.prediction_error.reset();
    one.tube.reset();
  }
  return one;
}

IdentifiedValves CompensationModel::identified_valves() const {
  return {valves.value_or(ValveParameters{}), valve_findings};
}

void CompensationModel::set_valves(const IdentifiedValves& identified) {
  require_no_valves_before(*this, identified.parameters, "valves");
  const ValveParameters& found = identified.parameters;
  valves = found.is_ideal() ? std::nullopt : std::optional(found);
  valve_findings = identified.findings;
}

void CompensationModel::set_arm(const ArmDescription& arm) {
  const ArmIdentity identity = identity_of(arm);
  arm_name = identity.name;
  arm_hash = identity.hash;
  arm_description = identity.description;
  dimension = arm.dimension;
  segment_count = arm.segment_count();
  chamber_count = arm.is_spatial() ? arm.channel_count() : 0;
  point_count = arm.point_count();
}

const char* to_string(OutputForm form) {
  return form == OutputForm::compensation ? "compensation" : "gated_change";
}

std::string CompensationModel::shape() const {
  if (layers.empty()) {
    return "";
  }
  std::string text = std::to_string(layers.front().weight.cols());
  for (const Layer& layer : layers) {
    text += "-" + std::to_string(layer.weight.rows());
  }
  return text;
}

void validate(const CompensationModel& model, const std::string& where) {
  refuse_if(model.segment_count < 1 || model.point_count < model.segment_count + 1,
            "{}: segment_count {} and point_count {}; expected at least 1 segment and "
            "one more point than segments",
            where, model.segment_count, model.point_count);
  if (model.dimension == Dimension::space &&
      (model.chamber_count < 1 || model.layout != BackboneLayout::gap_poses)) {
    refuse(where, fmt::format("chamber_count {} and layout {}; expected at least 1 chamber and "
                              "gap_poses of an arm in space",
                              model.chamber_count, to_string(model.layout)));
  }
  validate_past_commands(model, where);
  const Sizes sizes = expected_sizes(model);
  validate_layers(where, "layers.", model.layers, sizes);
  validate_members(where, model, sizes);
  validate_normalisation(where, "normalisation.input", model.input, sizes.input);
  validate_normalisation(where, "normalisation.output", model.output, sizes.backbone);
  if (model.form == OutputForm::gated_change && !model.output.offset.isZero(0.0F)) {
    refuse(where, fmt::format("tensor normalisation.output.offset is not 0; expected 0 in a model "
                              "of output_form {}, whose changes are scaled and not shifted",
                              to_string(model.form)));
  }
  if (model.valves) {
    const std::string fault = why_unusable(*model.valves, model.channel_count());
    if (!fault.empty()) {
      refuse(where, "metadata valves: " + fault);
    }
    require_no_valves_before(model, *model.valves, where);
  }
  if (model.prediction_error) {
    validate(*model.prediction_error, where + ": metadata");
    refuse_if(model.dimension == Dimension::plane && !model.prediction_error->end_orientation_rad,
              "{}: metadata prediction_error: end_orientation_rad is missing", where);
  }
  if (model.tube) {
    validate(*model.tube, where + ": metadata");
    if (int(model.tube->plate_scale_m.size()) != model.point_count) {
      refuse(where, fmt::format("metadata tube.plate_scale_m has {} "
                                "numbers; expected {}, one per plate",
                                model.tube->plate_scale_m.size(), model.point_count));
    }
  }
  if (model.family) {
    validate(*model.family, model.layers, where);
    refuse_if(model.member_count() > 1, "{}: holds several networks and a family; a family has one",
              where);
  }
  if (model.member_of_family) {
    refuse_if(!model.family, "{}: no tensor family.columns; expected one beside family.e", where);
    validate(*model.member_of_family, *model.family, where);
  }
  if (model.learnt) {
    refuse_if(model.dimension == Dimension::space,
              "{}: tensors learnt.* are of planar arms; expected none for an arm in space", where);
    validate(*model.learnt, model.segment_count, model.point_count, where);
  }
  if (model.bounds) {
    validate(*model.bounds, model.dimension, model.point_count, where);
  }
}

void require_no_valves_before(const CompensationModel& model, const ValveParameters& valves,
                              const std::string& where) {
  if (model.learnt_from_setpoints && !valves.is_ideal()) {
    refuse(where,
           "a valve model (hash " + valves.hash() +
               ") and a network that learnt from set points, which knows the valves along with the "
               "arm; their lag would count twice. Use the network without valves");
  }
}

void require_model_of(const CompensationModel& model, const ArmDescription& arm,
                      const std::string& where) {
  const std::string why = why_another_arm(model.arm(), arm, where);
  if (!why.empty()) {
    throw InputError(fmt::format(
        "{}: trained for arm '{}' (hash {}); this is arm '{}' (hash {}): {}. Use the arm file that "
        "the model was trained with (--arm), or train a model for this one",
        where, model.arm_name, model.arm_hash, arm.name, arm.hash(), why));
  }
  refuse_if(model.segment_count != arm.segment_count() || model.point_count != arm.point_count() ||
                model.dimension != arm.dimension || model.channel_count() != arm.channel_count(),
            "{}: made for {} segments and {} points; arm '{}' has {} and {}", where,
            model.segment_count, model.point_count, arm.name, arm.segment_count(),
            arm.point_count());
}

}  // namespace limber
