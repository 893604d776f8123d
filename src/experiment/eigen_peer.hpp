#pragma once

#include "limber/common/cpu_level.hpp"

namespace limber {

/// One layer as Eigen reads it: weight out × in, column-major.
struct EigenPeerLayer {
  int inputs;
  int outputs;
  const float* weight;
  const float* bias;
};

/// The network as one would write it with Eigen alone, the peer in `limber bench`: `queries`
/// columns of inputs to columns of outputs, ReLU between layers. `scratch` holds 2·widest·queries.
using EigenPeer = void (*)(const EigenPeerLayer* layers, int count, int queries, const float* input,
                           float* scratch, int widest, float* output);

/// Compiled for `level` as limber's own kernels are. @pre this CPU runs it.
EigenPeer eigen_peer(CpuLevel level);

}  // namespace limber
