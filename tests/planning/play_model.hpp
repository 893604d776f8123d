#pragma once

#include "limber/forward/forward_model.hpp"
#include "planning/random_shapes.hpp"

namespace limber {

/// A network with weights set by hand that makes every pose entry b follow the no-load model c like
/// a play of half width w, b_t = clamp(b_{t−1}, c − w, c + w): the simplest arm whose shape depends
/// on how its pressures were reached. With d = b_{t−1} − c its output is
/// relu(d) − relu(−d) + relu(−d − w) − relu(d − w). Headings have no play.
inline CompensationModel play_network(const ArmDescription& arm, float half_width_m) {
  const int n = arm.segment_count();
  const int entries = 3 * arm.point_count();
  CompensationModel model;
  model.layout = BackboneLayout::base_poses;
  model.arm_name = arm.name;
  model.arm_hash = arm.hash();
  model.segment_count = n;
  model.point_count = arm.point_count();
  model.preset = "paper";
  Layer hidden{Eigen::MatrixXf::Zero(4 * entries, 2 * n + 2 * entries),
               Eigen::VectorXf::Zero(4 * entries)};
  Layer output{Eigen::MatrixXf::Zero(entries, 4 * entries), Eigen::VectorXf::Zero(entries)};
  for (int k = 0; k < entries; ++k) {
    const bool heading = k % 3 == 2;
    const int previous = 2 * n + k;           // b_{t−1} …
    const int no_load = 2 * n + entries + k;  // … and c among the inputs
    const float signs[] = {1.0F, -1.0F, -1.0F, 1.0F};
    const float weights[] = {1.0F, -1.0F, 1.0F, -1.0F};
    for (int u = 0; u < 4; ++u) {
      hidden.weight(4 * k + u, previous) = signs[u];
      hidden.weight(4 * k + u, no_load) = -signs[u];
      hidden.bias[4 * k + u] = u < 2 || heading ? 0.0F : -half_width_m;
      output.weight(k, 4 * k + u) = weights[u];
    }
  }
  model.layers = {hidden, output};
  model.input = {Eigen::VectorXf::Zero(2 * n + 2 * entries),
                 Eigen::VectorXf::Ones(2 * n + 2 * entries)};
  model.output = {Eigen::VectorXf::Zero(entries), Eigen::VectorXf::Ones(entries)};
  return model;
}

}  // namespace limber
