#pragma once

#include <string>
#include <vector>

namespace limber {

/// One layer as peers read it: weight out × in, column-major.
struct PeerLayer {
  int inputs;
  int outputs;
  const float* weight;
  const float* bias;
};

/// The network written plainly with another library, for timing in `limber bench`: ReLU between
/// layers, one thread, a fixed number of queries at a time.
class NetworkPeer {
 public:
  virtual ~NetworkPeer() = default;
  /// `input` one query per column, `output` its answers; column-major without gaps.
  virtual void evaluate(const float* input, float* output) = 0;
};

/// Makes a peer that answers `queries` at a time; the caller owns it. `layers` (`count` of them)
/// and their weights outlive it.
using MakeNetworkPeer = NetworkPeer* (*)(const PeerLayer* layers, int count, int queries);

struct PeerMaker {
  std::string name;
  MakeNetworkPeer make;
};

/// Eigen, compiled for the CPU level in use, and with `optional` the optional peers that are here.
std::vector<PeerMaker> peer_makers(bool optional);

}  // namespace limber
