#pragma once

#include <string>
#include <vector>

namespace limber {

/// A library that `limber bench` is compared with where limber was built beside it.
struct OptionalPeer {
  std::string name;  ///< as in the report: "onednn", "torch"
  std::string library;
  std::string how_to_get;
  bool present = false;  ///< limber was built with it and it can be loaded here
};

/// All that limber knows of. Peers are loadable modules in lib/limber/peers beside bin/, so that
/// neither their libraries' size nor their absence touches the program; asking loads them.
std::vector<OptionalPeer> optional_peers();

}  // namespace limber
