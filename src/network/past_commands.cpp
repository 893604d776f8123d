#include "limber/network/past_commands.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace limber {

std::vector<int> default_past_commands(const ArmDescription& arm) {
  constexpr std::array<double, 4> kPast_s = {0.1, 0.2, 0.4, 0.8};  // docs/space.md
  std::vector<int> past;
  for (const double seconds : kPast_s) {
    const auto frames = int(std::lround(seconds * arm.frame_rate_hz));
    if (arm.is_spatial() && frames > (past.empty() ? 0 : past.back())) {
      past.push_back(frames);
    }
  }
  return past;
}

Eigen::MatrixXf with_past_commands(const Eigen::Ref<const Eigen::MatrixXf>& commands,
                                   const std::vector<int>& past) {
  const Eigen::Index n = commands.rows();
  Eigen::MatrixXf told(n * (1 + std::ssize(past)), commands.cols());
  for (Eigen::Index t = 0; t < commands.cols(); ++t) {
    told.col(t).head(n) = commands.col(t);
    for (std::size_t k = 0; k < past.size(); ++k) {
      told.col(t).segment(n * Eigen::Index(k + 1), n) =
          commands.col(std::max(t - past[k], Eigen::Index{0}));
    }
  }
  return told;
}

}  // namespace limber
