#include "held_poses.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace limber {

namespace {

// Arms settle in about a second (docs/importing.md), and begin to move long before.
constexpr double kLongestAnswer_s = 1.0;
constexpr double kMovedAway = 0.5;  // of the range of a command's limits

/// Rows of commands in force from one time to another, the one before included.
struct CommandRows {
  Eigen::Index begin = 0;
  Eigen::Index count = 0;
};

CommandRows rows_between(const std::vector<double>& time_s, double from_s, double to_s) {
  const auto after_from = std::ranges::upper_bound(time_s, from_s);
  const auto begin = after_from == time_s.begin() ? after_from : after_from - 1;
  const auto end = std::upper_bound(begin, time_s.end(), to_s);
  return {begin - time_s.begin(), end - begin};
}

bool moves_away(const CommandTrack& commands, const CommandRows& rows, const ArmDescription& arm) {
  for (Eigen::Index i = 0; i < commands.values.cols(); ++i) {
    const auto column = commands.values.col(i).segment(rows.begin, rows.count).array();
    const double lowest = column.isFinite().select(column, HUGE_VAL).minCoeff();
    const double highest = column.isFinite().select(column, -HUGE_VAL).maxCoeff();
    const double range = 2.0 * arm.limits_of_channel(int(i)).half_width_kpa();
    if (highest - lowest > kMovedAway * range) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<bool> rows_that_hang(const BackboneTrack& motion, const CommandTrack& commands,
                                 const ArmDescription& arm) {
  std::vector<bool> hang(motion.time_s.size(), false);
  for (std::size_t first = 0; first < hang.size();) {
    std::size_t last = first;
    // Poses that are not there are NaN, and equal to none.
    while (last + 1 < hang.size() &&
           motion.poses.row(Eigen::Index(last + 1)) == motion.poses.row(Eigen::Index(first))) {
      ++last;
    }
    const double answered_s = motion.time_s[last] - kLongestAnswer_s;
    if (answered_s > motion.time_s[first]) {
      const CommandRows rows = rows_between(commands.time_s, motion.time_s[first], answered_s);
      if (rows.count > 0 && moves_away(commands, rows, arm)) {
        std::fill(hang.begin() + std::ptrdiff_t(first) + 1, hang.begin() + std::ptrdiff_t(last) + 1,
                  true);
      }
    }
    first = last + 1;
  }
  return hang;
}

}  // namespace limber
