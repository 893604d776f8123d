#pragma once

#include "network_peer.hpp"

namespace limber {

/// The network with Eigen alone, `queries` columns of inputs to columns of outputs. `scratch` holds
/// 2·widest·queries. Compiled once for every CPU level.
using EigenPeer = void (*)(const PeerLayer* layers, int count, int queries, const float* input,
                           float* scratch, int widest, float* output);

/// The peer `eigen`, compiled for cpu_level() as limber's own kernels are.
NetworkPeer* make_eigen_peer(const PeerLayer* layers, int count, int queries);

}  // namespace limber
