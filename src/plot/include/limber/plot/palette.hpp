#pragma once
// For those who show results.

#include <string>

namespace limber {

/// Colour `index` ≥ 0 of the palette of Okabe and Ito (2008), as "#rrggbb". Colour-blind readers
/// can tell its colours apart. After the last colour it starts again. The first three keep their
/// meaning in all of limber's pictures; see below.
std::string palette_color(int index);

inline constexpr int kNoLoadColor = 0;   ///< vermilion: the no-load model
inline constexpr int kNetworkColor = 1;  ///< blue: the network model
inline constexpr int kTrueArmColor = 2;  ///< black: the true arm

}  // namespace limber
