#include "limber/plot/svg_drawing.hpp"

#include <array>
#include <cassert>

namespace limber {

std::string palette_color(int index) {
  assert(index >= 0);
  static constexpr std::array kColors{"#d55e00", "#0072b2", "#111111", "#009e73",
                                      "#cc79a7", "#e69f00", "#56b4e9", "#b8a900"};
  return kColors[static_cast<std::size_t>(index) % kColors.size()];
}

}  // namespace limber
