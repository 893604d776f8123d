#pragma once
// For those who show results.

#include <string>

namespace limber {

/// Colour `index` ≥ 0 of the palette of Okabe and Ito (2008), which colour-blind readers can tell
/// apart, as "#rrggbb"; it starts again after the last. The first three keep their meaning in all
/// of limber's pictures; see below.
std::string palette_color(int index);

inline constexpr int kNoLoadColor = 0;   ///< vermilion: the no-load model
inline constexpr int kNetworkColor = 1;  ///< blue: the network model
inline constexpr int kTrueArmColor = 2;  ///< black: the arm as it really was

}  // namespace limber
