#include "limber/lab/speed_peers.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

#include "eigen_peer.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/mapped.hpp"
#include "network_peer.hpp"

namespace limber {

namespace {

constexpr const char* kPeerModuleEntry = "limber_make_network_peer";

struct KnownPeer {
  const char* name;
  const char* library;
  const char* how_to_get;
};

constexpr KnownPeer kKnownPeers[] = {
    {"libxsmm", "LIBXSMM", "apt install libxsmm-dev (x86-64) and build limber again"},
    {"onednn", "oneDNN", "apt install libdnnl-dev and build limber again"},
    {"torch", "LibTorch", "apt install libtorch-dev and build limber again"},
};

// Null if limber was built without the peer, or its library is not there any more. Modules stay
// loaded: their libraries' threads may outlive a measurement.
MakeNetworkPeer load_maker(const std::string& name) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path module =
      program.parent_path() / "../lib/limber/peers" / ("limber_" + name + "_peer.so");
  if (error || !fs::exists(module, error)) {
    return nullptr;
  }
  // OpenBLAS, where LibTorch has it, reads its number of threads while it is loaded.
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  void* handle = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* entry = handle != nullptr ? dlsym(handle, kPeerModuleEntry) : nullptr;
  return reinterpret_cast<MakeNetworkPeer>(entry);
}

}  // namespace

std::vector<OptionalPeer> optional_peers() {
  return mapped<OptionalPeer>(kKnownPeers, [&](const KnownPeer& known) {
    return OptionalPeer{known.name, known.library, known.how_to_get,
                        load_maker(known.name) != nullptr};
  });
}

std::vector<PeerMaker> peer_makers(bool optional) {
  std::vector<PeerMaker> makers{{"eigen", make_eigen_peer}};
  if (!optional) {
    return makers;
  }
  for (const KnownPeer& known : kKnownPeers) {
    if (const MakeNetworkPeer make = load_maker(known.name)) {
      makers.push_back({known.name, make});
    }
  }
  return makers;
}

}  // namespace limber
