#pragma once

// Compiled once per CPU level, each time with Eigen's namespace renamed (CMakeLists.txt): the
// linker must not mix functions of Eigen that were compiled for different instruction sets.

#include <Eigen/Core>

#include "eigen_peer.hpp"

namespace limber {
namespace {

using ConstMatrix = Eigen::Map<const Eigen::MatrixXf>;
using ConstVector = Eigen::Map<const Eigen::VectorXf>;

void evaluate_with_eigen(const PeerLayer* layers, int count, int queries, const float* input,
                         float* scratch, int widest, float* output) {
  const float* x = input;
  for (int l = 0; l < count; ++l) {
    const PeerLayer& layer = layers[l];
    const bool last = l + 1 == count;
    float* y = last ? output : scratch + (l % 2) * widest * queries;
    const ConstMatrix weight(layer.weight, layer.outputs, layer.inputs);
    const ConstVector bias(layer.bias, layer.outputs);
    if (queries == 1) {
      Eigen::Map<Eigen::VectorXf> out(y, layer.outputs);
      out.noalias() = weight * ConstVector(x, layer.inputs);
      out += bias;
      if (!last) {
        out = out.cwiseMax(0.0F);
      }
    } else {
      Eigen::Map<Eigen::MatrixXf> out(y, layer.outputs, queries);
      out.noalias() = weight * ConstMatrix(x, layer.inputs, queries);
      out.colwise() += bias;
      if (!last) {
        out = out.cwiseMax(0.0F);
      }
    }
    x = y;
  }
}

constexpr EigenPeer kEigenPeer = evaluate_with_eigen;

}  // namespace
}  // namespace limber
