#include "shape_comparison.hpp"

#include <cmath>
#include <numbers>

namespace limber {

namespace {

constexpr double kMaxTurnRad = std::numbers::pi;  // of one gap; beyond there is no such arc

}  // namespace

ExactArm::Shape shape_of(const Backbone& backbone) {
  ExactArm::Shape shape;
  shape.reserve(static_cast<std::size_t>(backbone.rows()));
  for (Eigen::Index i = 0; i < backbone.rows(); ++i) {
    shape.push_back({double(backbone(i, 0)), double(backbone(i, 1)), double(backbone(i, 2))});
  }
  return shape;
}

bool is_drawable(const ExactArm::Shape& shape) {
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const bool finite = std::isfinite(shape[i].x_m) && std::isfinite(shape[i].y_m) &&
                        std::isfinite(shape[i].theta_rad);
    if (!finite || (i > 0 && std::abs(shape[i].theta_rad - shape[i - 1].theta_rad) > kMaxTurnRad)) {
      return false;
    }
  }
  return true;
}

Deviation deviation(const ExactArm::Shape& own, const ExactArm::Shape& stored) {
  Deviation largest;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    const double x = own[i].x_m - stored[i].x_m;
    const double y = own[i].y_m - stored[i].y_m;
    const double apart = std::sqrt(x * x + y * y);
    const double turned = std::abs(own[i].theta_rad - stored[i].theta_rad);
    if (!(apart <= largest.apart_m)) {
      largest.apart_m = apart;
      largest.plate = static_cast<int>(i);
    }
    if (!(turned <= largest.turned_rad)) {
      largest.turned_rad = turned;
    }
  }
  return largest;
}

}  // namespace limber
