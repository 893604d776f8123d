#include "limber/network/untrained_model.hpp"

#include <cassert>
#include <cmath>

#include "limber/common/random_stream.hpp"
#include "limber/network/backbone_layout.hpp"

namespace limber {

namespace {

constexpr float kBend_rad = 3.0F;          // a segment's largest turn, about
constexpr float kCompensation_m = 0.02F;   // output range of a position
constexpr float kCompensation_rad = 0.1F;  // and of an angle
constexpr float kChangeShare = 0.1F;       // of all these, what changes within a frame

Layer random_layer(int inputs, int outputs, RandomStream& random) {
  // He's bound: the spread of the numbers stays the same from layer to layer.
  const double bound = std::sqrt(6.0 / inputs);
  Layer layer;
  layer.weight = Eigen::MatrixXf::NullaryExpr(outputs, inputs,
                                              [&] { return float(random.uniform(-bound, bound)); });
  layer.bias =
      Eigen::VectorXf::NullaryExpr(outputs, [&] { return float(random.uniform(-0.1, 0.1)); });
  return layer;
}

// Largest magnitudes of poses: positions first, then angles.
Eigen::VectorXf pose_ranges(Dimension dimension, Eigen::Index size, float metres, float radians) {
  return Eigen::VectorXf::NullaryExpr(size, [&](Eigen::Index i) {
    return i % gap_size(dimension) < position_size(dimension) ? metres : radians;
  });
}

}  // namespace

CompensationModel untrained_model(const ArmDescription& arm, BackboneLayout layout,
                                  const std::vector<int>& hidden, std::uint64_t seed,
                                  OutputForm form, bool reads_velocity,
                                  const std::vector<int>& past_commands) {
  const NetworkLayout sizes(layout, form, arm, reads_velocity, past_commands.size());
  CompensationModel model;
  model.layout = layout;
  model.form = form;
  model.reads_velocity = reads_velocity;
  model.past_commands = past_commands;
  model.set_arm(arm);
  model.preset = "untrained";

  RandomStream random(seed, 0);
  int inputs = sizes.input_size();
  for (const int units : hidden) {
    assert(units > 0);
    model.layers.push_back(random_layer(inputs, units, random));
    inputs = units;
  }
  model.layers.push_back(random_layer(inputs, sizes.output_size(), random));

  // In base poses the arm's whole length and all segments' turns count, in gap poses one gap's.
  const bool base = layout == BackboneLayout::base_poses;
  const auto length = float(arm.length_m());
  const float share = base ? 1.0F : 1.0F / float(arm.point_count() - 1);
  const float turn = kBend_rad * float(arm.segment_count());
  Eigen::VectorXf low(sizes.input_size());
  Eigen::VectorXf high(sizes.input_size());
  for (int i = 0; i < sizes.command_size(); ++i) {
    const PressureLimits& limits = arm.limits_of_channel(i % arm.channel_count());
    for (const int row : {sizes.previous_pressure_row() + i, sizes.pressure_row() + i}) {
      low[row] = float(limits.lower_kpa);
      high[row] = float(limits.upper_kpa);
    }
  }
  const int poses = sizes.backbone_size() + sizes.no_load_size();
  high.segment(sizes.backbone_row(), poses) =
      pose_ranges(arm.dimension, poses, length * share, turn * share);
  const int changes = sizes.input_size() - sizes.change_row();
  high.tail(changes) =
      kChangeShare * pose_ranges(arm.dimension, changes, length * share, turn * share);
  low.tail(poses + changes) = -high.tail(poses + changes);
  model.input.offset = low;
  model.input.scale = (high - low).cwiseInverse();
  const Eigen::VectorXf output = pose_ranges(arm.dimension, sizes.backbone_size(),
                                             kCompensation_m * share, kCompensation_rad * share);
  if (form == OutputForm::gated_change) {
    model.output.offset = Eigen::VectorXf::Zero(sizes.backbone_size());
    model.output.scale = (kChangeShare * output).cwiseInverse();
  } else {
    model.output.offset = -output;
    model.output.scale = (2.0F * output).cwiseInverse();
  }
  return model;
}

}  // namespace limber
