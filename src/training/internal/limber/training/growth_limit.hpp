#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>

namespace limber {

/// Shortens what a group's windows carry back from frame to frame to `limit` times the sum of what
/// the frames behind put in: each window by itself. Rows of `stride` windows.
template <class Scalar, class Storage>
class GrowthLimit {
 public:
  /// @param limit  0: nothing is shortened
  GrowthLimit(Scalar limit, int stride) : limit_(limit), stride_(stride) {
    put_in_.resize(is_on() ? std::size_t(stride) : 0);
    size_.resize(put_in_.size());
  }

  bool is_on() const { return limit_ > 0; }
  /// Before a group's last frame.
  void begin() { std::fill(put_in_.begin(), put_in_.end(), Scalar(0)); }

  /// @param error  a frame's own gradient, `rows` rows
  void put_in(const Scalar* error, int rows) {
    std::fill(size_.begin(), size_.end(), Scalar(0));
    for (int r = 0; r < rows; ++r) {
      for (int i = 0; i < stride_; ++i) {
        size_[i] += error[r * stride_ + i] * error[r * stride_ + i];
      }
    }
    for (int i = 0; i < stride_; ++i) {
      put_in_[i] += std::sqrt(size_[i]);
    }
  }

  /// Of carried + direct; `changed` is shortened along with them.
  void shorten(Storage& carried, Storage& direct, Storage& changed) {
    std::fill(size_.begin(), size_.end(), Scalar(0));
    const int size = int(carried.size());
    for (int row = 0; row < size; row += stride_) {
      for (int i = 0; i < stride_; ++i) {
        const Scalar whole = carried[row + i] + direct[row + i];
        size_[i] += whole * whole;
      }
    }
    for (int i = 0; i < stride_; ++i) {
      const Scalar longest = limit_ * put_in_[i];
      size_[i] = longest / std::max(longest, std::sqrt(size_[i]));
      if (!(size_[i] >= 0)) {
        size_[i] = 0;  // nothing was put in, or the gradient is beyond all numbers
      }
    }
    for (Storage* part : {&carried, &direct, &changed}) {
      for (auto row = part->begin(); row != part->end(); row += stride_) {
        std::transform(row, row + stride_, size_.begin(), row, std::multiplies<>());
      }
    }
  }

 private:
  Scalar limit_;
  int stride_;
  Storage put_in_;  // of each window: norms of the frames' error gradients, summed
  Storage size_;    // of each window: a norm, then the factor that keeps it from growing
};

}  // namespace limber
