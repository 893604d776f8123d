#pragma once

#include <string>
#include <vector>

#include "network_peer.hpp"

namespace limber {

struct PeerMaker {
  std::string name;
  MakeNetworkPeer make;
};

/// Eigen, compiled for the CPU level in use, and with `optional` the optional peers that are here.
std::vector<PeerMaker> peer_makers(bool optional);

}  // namespace limber
