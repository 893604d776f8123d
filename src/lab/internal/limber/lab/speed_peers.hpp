#pragma once

#include <string>
#include <vector>

namespace limber {

/// A library that `limber bench` compares limber with, if limber was built with it.
struct OptionalPeer {
  std::string name;  ///< as in the report: "onednn", "torch"
  std::string library;
  std::string how_to_get;
  bool present = false;  ///< limber was built with it and it can be loaded here
};

/// All that limber knows. Peers are loadable modules in lib/limber/peers beside bin/, so that
/// neither the size nor the absence of their libraries affects the program. This call loads them.
std::vector<OptionalPeer> optional_peers();

}  // namespace limber
