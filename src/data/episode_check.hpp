#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "episode_path.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/utf8.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// What HDF5 gives back as it was written: it ends a text at a zero byte.
inline bool can_be_kept(const std::string& text) {
  return is_utf8(text) && text.find('\0') == std::string::npos;
}

/// Refuses one data set of one episode.
class EpisodeCheck {
 public:
  EpisodeCheck(const std::string& file, std::size_t index) : file_(file), index_(index) {}

  [[noreturn]] void refuse(const char* data_set, const std::string& message) const {
    throw InputError(fmt::format("{}: {}/{}: {}", file_, episode_path(index_), data_set, message));
  }

  void shape(const char* data_set, const FrameMatrix& matrix, Eigen::Index rows,
             Eigen::Index columns) const {
    if (matrix.rows() != rows || matrix.cols() != columns) {
      refuse(data_set, fmt::format("{} × {} numbers found; expected {} frames × {}", matrix.rows(),
                                   matrix.cols(), rows, columns));
    }
  }

  void finite(const char* data_set, const FrameMatrix& matrix) const {
    if (matrix.allFinite()) {
      return;
    }
    for (Eigen::Index t = 0; t < matrix.rows(); ++t) {
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
        if (!std::isfinite(matrix(t, j))) {
          refuse(data_set, fmt::format("{}, number {} is {}; expected a finite number",
                                       frame_name(t), j, matrix(t, j)));
        }
      }
    }
  }

  template <class Values>
  void length(const char* data_set, const Values& values, Eigen::Index frames) const {
    if (Eigen::Index(values.size()) != frames) {
      refuse(data_set, fmt::format("{} numbers found; expected one for each of the {} frames",
                                   values.size(), frames));
    }
  }

  void times(const Eigen::VectorXd& time_s) const {
    if (time_s.size() == 0) {
      refuse("time_s", "no frames; expected at least one");
    }
    for (Eigen::Index t = 0; t < time_s.size(); ++t) {
      if (!std::isfinite(time_s[t])) {
        refuse("time_s", fmt::format("{} is {}; expected a finite time", frame_name(t), time_s[t]));
      }
      if (t > 0 && time_s[t] <= time_s[t - 1]) {
        refuse("time_s", fmt::format("{} at {} s follows {} at {} s; expected times to increase",
                                     frame_name(t), time_s[t], frame_name(t - 1), time_s[t - 1]));
      }
    }
  }

  void unit_quaternions(const FrameMatrix& backbone) const {
    constexpr double kUnit = 1e-3;  // rounding of whoever wrote it; a tracker's zeros are refused
    constexpr Eigen::Index kFirst = 3;
    for (Eigen::Index t = 0; t < backbone.rows(); ++t) {
      for (Eigen::Index at = kFirst; at < backbone.cols(); at += kSpacePoseSize) {
        const double norm = double(backbone.row(t).segment<4>(at).norm());
        if (std::abs(norm - 1.0) > kUnit) {
          refuse("backbone", fmt::format("{}, {}: the quaternion's length is {:.4g}; expected 1",
                                         frame_name(t), plate_name(at / kSpacePoseSize), norm));
        }
      }
    }
  }

  void motions(const std::vector<int>& motion_index) const {
    for (std::size_t t = 0; t < motion_index.size(); ++t) {
      const int before = t == 0 ? 0 : motion_index[t - 1];
      if (motion_index[t] < before) {
        refuse("motion_index", fmt::format("{} is {}; expected {} or more: motions are "
                                           "numbered from 0 and do not decrease",
                                           frame_name(t), motion_index[t], before));
      }
    }
  }

 private:
  const std::string& file_;
  std::size_t index_;
};

/// What is known of each frame has the sizes expected, and finite numbers.
void validate_frames(const Episode& episode, const EpisodeCheck& check, int channel_count,
                     int point_count);
/// The same, and all else that an episode holds.
void validate_episode(const Episode& episode, const EpisodeCheck& check, int channel_count,
                      int point_count);

}  // namespace limber
