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

/// How a shape looks: "none" leaves fill or stroke out. Colours are any of CSS's.
struct ShapeStyle {
  std::string fill = "none";
  std::string stroke = "#222222";
  double width_px = 2.0;
  double opacity = 1.0;  ///< in [0, 1]
  bool dashed = false;
};

/// A line of the key under a picture.
struct LegendEntry {
  std::string label{};
  ShapeStyle style{};
  bool dot = false;  ///< the swatch is a dot rather than a line or a box
};

enum class TextAnchor { kStart, kMiddle, kEnd };

struct TextStyle {
  std::string color = "#222222";
  double size_px = 15.0;
  TextAnchor anchor = TextAnchor::kStart;
  bool bold = false;
};

}  // namespace limber
