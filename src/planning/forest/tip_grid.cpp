#include "limber/planning/tip_grid.hpp"

#include <algorithm>

namespace limber {

namespace {

constexpr int kMaxCells = 64;  // along the longer side of what the tips reach

}  // namespace

TipGrid::TipGrid(const Eigen::Matrix3Xf& tips, const std::vector<float>& costs_kpa) {
  if (tips.cols() == 0) {
    return;
  }
  low_m_ = tips.topRows<2>().rowwise().minCoeff();
  const Eigen::Vector2f size_m = tips.topRows<2>().rowwise().maxCoeff() - low_m_;
  constexpr float kMinCellM = 1e-3F;
  cell_m_ = std::max(size_m.maxCoeff() / static_cast<float>(kMaxCells), kMinCellM);
  columns_ = cell_index(size_m.x(), kMaxCells) + 1;
  rows_ = cell_index(size_m.y(), kMaxCells) + 1;
  const auto cell_of = [&](Eigen::Index i) { return cell(column(tips(0, i)), row(tips(1, i))); };
  // A counting sort: how many there are in each cell, where each cell begins, then everyone's
  // place.
  begins_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (Eigen::Index i = 0; i < tips.cols(); ++i) {
    ++begins_[cell_of(i) + 1];
  }
  for (std::size_t c = 1; c < begins_.size(); ++c) {
    begins_[c] += begins_[c - 1];
  }
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  tips_.resize(static_cast<std::size_t>(tips.cols()));
  for (Eigen::Index i = 0; i < tips.cols(); ++i) {
    tips_[next[cell_of(i)]++] = {tips(0, i), tips(1, i), tips(2, i),
                                 costs_kpa[static_cast<std::size_t>(i)],
                                 static_cast<std::int32_t>(i)};
  }
}

int TipGrid::cell_index(float distance_m, int count) const {
  // Compared as floats: a point far away does not fit an int, nor does one that is not a number.
  const float cells = distance_m / cell_m_;
  if (!(cells > 0.0F)) {
    return 0;
  }
  return cells < static_cast<float>(count) ? static_cast<int>(cells) : count - 1;
}

}  // namespace limber
