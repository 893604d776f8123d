#pragma once

#include <vector>

#include "limber/data/recording.hpp"

namespace limber {

/// One segment's values over all frames, for a chart.
inline std::vector<double> frame_column(const FrameMatrix& values, int segment) {
  const Eigen::VectorXd numbers = values.col(segment).cast<double>();
  return {numbers.begin(), numbers.end()};
}

}  // namespace limber
