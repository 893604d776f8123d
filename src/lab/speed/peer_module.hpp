#pragma once

#include "network_peer.hpp"

/// What a peer's loadable module exports (kPeerModuleEntry in speed_peers.cpp names it).
extern "C" __attribute__((visibility("default"))) limber::NetworkPeer* limber_make_network_peer(
    const limber::PeerLayer* layers, int count, int queries);
