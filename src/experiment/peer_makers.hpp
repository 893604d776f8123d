#pragma once

#include <string>
#include <vector>

#include "experiment/network_peer.hpp"

namespace limber {

struct PeerMaker {
  std::string name;
  MakeNetworkPeer make;
};

/// Eigen, compiled for the CPU level in use, and the optional peers that are present.
std::vector<PeerMaker> peer_makers();

}  // namespace limber
