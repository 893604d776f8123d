#pragma once
// For those who plan.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace limber {

/// Poses of tips, and the cost to get there, in square cells, to find those near a point quickly.
/// Constant after construction.
class TipGrid {
 public:
  struct Tip {
    float x_m;
    float y_m;
    float theta_rad;
    float cost_kpa;
    std::int32_t node;
  };

  TipGrid() = default;
  /// @param tips       3×N, (x_m, y_m, theta_rad) of node 0 … N − 1, finite
  /// @param costs_kpa  size N
  TipGrid(const Eigen::Matrix3Xf& tips, const std::vector<float>& costs_kpa);

  /// Calls visit(tip) for every tip at most `radius_m` from a point (apart from rounding), in the
  /// order of cells, and in a cell in the order of nodes.
  template <class Visit>
  void visit_near(const Eigen::Vector2f& point_m, float radius_m, Visit&& visit) const {
    if (tips_.empty()) {
      return;
    }
    const int first_column = column(point_m.x() - radius_m);
    const int last_column = column(point_m.x() + radius_m);
    const int last_row = row(point_m.y() + radius_m);
    for (int r = row(point_m.y() - radius_m); r <= last_row; ++r) {
      const std::size_t end = begins_[cell(last_column, r) + 1];
      for (std::size_t i = begins_[cell(first_column, r)]; i < end; ++i) {
        const Tip& tip = tips_[i];
        const float dx = tip.x_m - point_m.x();
        const float dy = tip.y_m - point_m.y();
        if (dx * dx + dy * dy <= radius_m * radius_m) {
          visit(tip);
        }
      }
    }
  }

 private:
  int column(float x_m) const { return cell_index(x_m - low_m_.x(), columns_); }
  int row(float y_m) const { return cell_index(y_m - low_m_.y(), rows_); }
  int cell_index(float distance_m, int count) const;
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  Eigen::Vector2f low_m_ = Eigen::Vector2f::Zero();
  float cell_m_ = 1.0F;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::size_t> begins_;  // of a cell's tips, a row's cells side by side; and the end
  std::vector<Tip> tips_;
};

}  // namespace limber
