#pragma once

#include "limber/forward/forward_model.hpp"
#include "planning/random_shapes.hpp"

namespace limber {

/// A network with weights set by hand that makes every pose entry b follow the no-load model c like
/// a play of half width w, b_t = clamp(b_{t−1}, c − w, c + w): the simplest arm whose shape depends
/// on how its pressures were reached. With d = b_{t−1} − c its output is
/// relu(d) − relu(−d) + relu(−d − w) − relu(d − w). Headings have no play. With `momentum` > 0 it
/// reads velocities, and adds that share of the frame before's change.
inline CompensationModel play_network(const ArmDescription& arm, float half_width_m,
                                      float momentum = 0.0F) {
  const int n = arm.segment_count();
  const int entries = 3 * arm.point_count();
  CompensationModel model;
  model.layout = BackboneLayout::base_poses;
  model.reads_velocity = momentum > 0.0F;
  const int inputs = 2 * n + (model.reads_velocity ? 3 : 2) * entries;
  const int units = model.reads_velocity ? 6 : 4;
  model.arm_name = arm.name;
  model.arm_hash = arm.hash();
  model.segment_count = n;
  model.point_count = arm.point_count();
  model.preset = "paper";
  Layer hidden{Eigen::MatrixXf::Zero(units * entries, inputs),
               Eigen::VectorXf::Zero(units * entries)};
  Layer output{Eigen::MatrixXf::Zero(entries, units * entries), Eigen::VectorXf::Zero(entries)};
  for (int k = 0; k < entries; ++k) {
    const bool heading = k % 3 == 2;
    const int previous = 2 * n + k;           // b_{t−1} …
    const int no_load = 2 * n + entries + k;  // … and c among the inputs
    const float signs[] = {1.0F, -1.0F, -1.0F, 1.0F};
    const float weights[] = {1.0F, -1.0F, 1.0F, -1.0F};
    for (int u = 0; u < 4; ++u) {
      hidden.weight(units * k + u, previous) = signs[u];
      hidden.weight(units * k + u, no_load) = -signs[u];
      hidden.bias[units * k + u] = u < 2 || heading ? 0.0F : -half_width_m;
      output.weight(k, units * k + u) = weights[u];
    }
    for (int u = 4; u < units; ++u) {
      const float sign = u == 4 ? 1.0F : -1.0F;
      hidden.weight(units * k + u, no_load + entries) = sign;  // b_{t−1} − b_{t−2}
      output.weight(k, units * k + u) = sign * momentum;
    }
  }
  model.layers = {hidden, output};
  model.input = {Eigen::VectorXf::Zero(inputs), Eigen::VectorXf::Ones(inputs)};
  model.output = {Eigen::VectorXf::Zero(entries), Eigen::VectorXf::Ones(entries)};
  return model;
}

}  // namespace limber
