#pragma once
// For those who show results.

#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// A point of the drawn world: x to the right, y up.
struct WorldPoint {
  double x_m = 0.0;
  double y_m = 0.0;
};

/// The part of the world that a drawing shows.
struct WorldBox {
  double x_min_m = 0.0, x_max_m = 1.0;
  double y_min_m = 0.0, y_max_m = 1.0;
};

/// A picture in world metres, y up, with both axes to the same scale: arms, obstacles, trees,
/// goals. Shapes are drawn in the order of the calls, and clipped at the edge of the box.
///
/// A shape with a coordinate or size that is not finite is left out and counted, and the picture
/// says so. Polylines break there instead. Coordinates are rounded to 0.01 px.
///
///   SvgDrawing drawing({-0.2, 0.8, -0.6, 0.6});
///   drawing.axes();
///   drawing.circle({0.45, 0.22}, 0.06, {.fill = "#bbbbbb"});
///   drawing.capsule_chain(backbone, radii_m, {.fill = palette_color(1), .opacity = 0.5});
class SvgDrawing {
 public:
  /// @param box       finite, minimum below maximum in both axes, else InputError.
  /// @param width_px  of the world's part, > 0; the height follows from the box.
  explicit SvgDrawing(const WorldBox& box, double width_px = 560.0, std::string title = "");

  void polyline(std::span<const WorldPoint> points, const ShapeStyle& style = {});
  void polygon(std::span<const WorldPoint> points, const ShapeStyle& style = {});
  void circle(WorldPoint center, double radius_m, const ShapeStyle& style = {});
  /// Sides width_m along the direction angle_rad, height_m across it.
  void rectangle(WorldPoint center, double width_m, double height_m, double angle_rad,
                 const ShapeStyle& style = {});
  /// Many short strokes of one style, such as the edges of a tree: points 0–1, 2–3, … are joined.
  void segments(std::span<const WorldPoint> end_points, const ShapeStyle& style = {});
  /// A thick body: gap i, from point i to i + 1, is a capsule of radius radii_m[i]. Filled with
  /// style.fill as one shape (opacity does not add up where capsules overlap), outlined where
  /// style.stroke is not "none". @throws InputError if the sizes do not fit.
  void capsule_chain(std::span<const WorldPoint> points, std::span<const double> radii_m,
                     const ShapeStyle& style);
  /// Five-pointed, the first point upwards.
  void star(WorldPoint center, double radius_m, const ShapeStyle& style = {});
  void arrow(WorldPoint from, WorldPoint to, const ShapeStyle& style = {});
  void text(WorldPoint at, std::string_view text, const TextStyle& style = {});

  /// Grid lines behind what follows, and a frame with ticks in metres around the picture.
  void axes();
  /// An entry of the key under the picture: a swatch of the style and its meaning.
  void legend(std::string_view label, const ShapeStyle& style);

  /// The whole picture.
  std::string svg() const;

 private:
  double pixel_x(double x_m) const;
  double pixel_y(double y_m) const;
  double pixels(double length_m) const;
  /// Counts what is not finite.
  bool drawable(std::span<const WorldPoint> points, double size = 0.0);
  std::string path(std::span<const WorldPoint> points) const;
  std::string frame_and_ticks() const;

  WorldBox box_;
  double scale_;  ///< [px/m]
  std::string title_;
  std::string body_;
  std::vector<LegendEntry> legend_;
  int undrawable_ = 0;  ///< shapes or line points left out because they were not finite
  bool axes_ = false;
};

}  // namespace limber
