// WindowKernels<double>: plain loops.
#include "training_kernels.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "space_frame_error.hpp"
#include "state_bound_kernels.hpp"

namespace limber {

namespace {

using Matrix = Eigen::MatrixXd;
using View = Eigen::Map<Matrix>;
using ConstView = Eigen::Map<const Matrix>;

double with_sign_of(double difference, double factor) {
  return difference == 0.0 ? 0.0 : std::copysign(factor, difference);
}

/// One window; its numbers are `stride` apart. The equations: FrameError.
struct ChainedWindow {
  int gaps, stride;
  const double* weight;
  const double* scale;
  const double* offset;
  const double* state;
  const double* target;
  double window_weight;
  double* gradient;
  double* heading;

  double gap(int r) const { return state[r * stride] * scale[r] + offset[r]; }

  /// Error; leaves weight ∘ sign(error) in the gradient's place.
  double forward() const {
    double x = 0.0;
    double y = 0.0;
    double theta = 0.0;
    double error = 0.0;
    const auto compare = [&](int r, double predicted) {
      const double difference = predicted - target[r * stride];
      gradient[r * stride] = with_sign_of(difference, weight[r]);
      error += weight[r] * std::abs(difference);
    };
    for (int i = 0; i < gaps; ++i) {
      heading[i] = theta;
      x += std::cos(theta) * gap(kPoseSize * i) - std::sin(theta) * gap(kPoseSize * i + 1);
      y += std::sin(theta) * gap(kPoseSize * i) + std::cos(theta) * gap(kPoseSize * i + 1);
      theta += gap(kPoseSize * i + 2);
      compare(kPoseSize * i, x);
      compare(kPoseSize * i + 1, y);
      compare(kPoseSize * i + 2, theta);
    }
    return error;
  }

  void backward() const {
    double by_x = 0.0;
    double by_y = 0.0;
    double by_theta = 0.0;
    for (int i = gaps - 1; i >= 0; --i) {
      double* g = gradient + kPoseSize * i * stride;
      by_x += window_weight * g[0];
      by_y += window_weight * g[stride];
      by_theta += window_weight * g[2 * stride];
      const double along = std::cos(heading[i]) * by_x + std::sin(heading[i]) * by_y;
      const double across = std::cos(heading[i]) * by_y - std::sin(heading[i]) * by_x;
      g[0] = along * scale[kPoseSize * i];
      g[stride] = across * scale[kPoseSize * i + 1];
      g[2 * stride] = by_theta * scale[kPoseSize * i + 2];
      by_theta += gap(kPoseSize * i) * across - gap(kPoseSize * i + 1) * along;
    }
  }
};

void layer(int stride, int m, int k, const double* x, const double* weight, const double* bias,
           bool relu, double* y) {
  View result(y, stride, m);
  result.noalias() = ConstView(x, stride, k) * ConstView(weight, m, k).transpose();
  result.rowwise() += Eigen::Map<const Eigen::RowVectorXd>(bias, m);
  if (relu) {
    result = result.cwiseMax(0.0);
  }
}

void layer_back(int stride, int m, int k, const double* dy, const double* weight, double* dx) {
  View(dx, stride, k).noalias() = ConstView(dy, stride, m) * ConstView(weight, m, k);
}

void weight_gradient(int blocks, int stride, int m, int k, const double* dy, const double* x,
                     int x_block, double* gradient) {
  for (int block = 0; block < blocks; ++block, dy += m * stride, x += x_block) {
    View(gradient, m, k) += ConstView(dy, stride, m).transpose() * ConstView(x, stride, k);
  }
}

void bias_gradient(int blocks, int stride, int m, const double* dy, double* gradient) {
  for (int block = 0; block < blocks; ++block, dy += m * stride) {
    View(gradient, 1, m) += ConstView(dy, stride, m).colwise().sum();
  }
}

void relu_gradient(int count, const double* activation, double* gradient) {
  for (int i = 0; i < count; ++i) {
    gradient[i] = activation[i] > 0.0 ? gradient[i] : 0.0;
  }
}

void modulate(int count, const double* gain, const double* shift, double* y) {
  for (int i = 0; i < count; ++i) {
    y[i] = gain[i] * std::max(y[i] + shift[i], 0.0);
  }
}

void modulate_back(int count, const double* gain, const double* y, double* dy, double* dlog_gain,
                   double* dshift) {
  for (int i = 0; i < count; ++i) {
    dlog_gain[i] += dy[i] * y[i];
    dy[i] = y[i] > 0.0 ? gain[i] * dy[i] : 0.0;
    dshift[i] += dy[i];
  }
}

void gather(int row_count, int stride, const double* columns, int ld, const int* index,
            double* rows) {
  for (int j = 0; j < stride; ++j) {
    for (int r = 0; r < row_count; ++r) {
      rows[r * stride + j] = columns[std::ptrdiff_t(index[j]) * ld + r];
    }
  }
}

void add_scaled(int size, int stride, const double* scale, const double* output,
                const double* uncompensated, double* state) {
  const Eigen::Map<const Eigen::RowVectorXd> factor(scale, size);
  View(state, stride, size) =
      ConstView(uncompensated, stride, size) +
      (ConstView(output, stride, size).array().rowwise() * factor.array()).matrix();
}

void carry(int size, int stride, const double* scale, const double* error, double* carried,
           double* delta) {
  const Eigen::Map<const Eigen::RowVectorXd> factor(scale, size);
  View sum(carried, stride, size);
  sum += ConstView(error, stride, size);
  View(delta, stride, size) = (sum.array().rowwise() * factor.array()).matrix();
}

void gated_change(int size, int stride, const double* scale, const double* output,
                  const double* uncompensated, const double* previous, double* gate,
                  double* state) {
  for (int r = 0; r < size; ++r) {
    for (int i = r * stride; i < (r + 1) * stride; ++i) {
      gate[i] = 1.0 / (1.0 + std::exp(-output[size * stride + i]));
      state[i] = previous[i] + gate[i] * (uncompensated[i] - previous[i]) + scale[r] * output[i];
    }
  }
}

void gated_carry(int size, int stride, const double* scale, const double* error,
                 const double* uncompensated, const double* previous, const double* gate,
                 const double* carried, double* direct, double* delta) {
  for (int r = 0; r < size; ++r) {
    for (int i = r * stride; i < (r + 1) * stride; ++i) {
      const double sum = carried[i] + direct[i] + error[i];
      delta[i] = scale[r] * sum;
      delta[size * stride + i] = sum * (uncompensated[i] - previous[i]) * gate[i] * (1.0 - gate[i]);
      direct[i] = (1.0 - gate[i]) * sum;
    }
  }
}

void bound(const StateBoundsView<double>& bounds, int stride, const double* unbounded,
           double* state) {
  for (int j = 0; j < stride; ++j) {
    if (bounds.of_base_poses) {
      bound_base_window(bounds, stride, unbounded + j, state + j);
      continue;
    }
    for (int g = 0; g < bounds.gap_count; ++g) {
      for (int r = bounds.gap_size * g; r < bounds.gap_size * (g + 1); ++r) {
        state[r * stride + j] = unbounded[r * stride + j];
      }
      bound_gap_of_window(bounds, g, stride, unbounded + j, state + j);
    }
  }
}

void bound_back(const StateBoundsView<double>& bounds, int stride, const double* unbounded,
                double* carried, double* direct, double* error) {
  for (int j = 0; j < stride; ++j) {
    if (bounds.of_base_poses) {
      bound_base_window_back(bounds, stride, unbounded + j, carried + j, direct + j, error + j);
      continue;
    }
    for (int g = 0; g < bounds.gap_count; ++g) {
      bound_gap_of_window_back(bounds, g, stride, unbounded + j, carried + j, direct + j,
                               error + j);
    }
  }
}

double entry_error(int size, int stride, const double* weight, const double* state,
                   const double* target, const double* window_weight, double* gradient) {
  double sum = 0.0;
  for (int j = 0; j < stride; ++j) {
    for (int r = 0; r < size; ++r) {
      const int at = r * stride + j;
      const double difference = state[at] - target[at];
      sum += window_weight[j] * weight[r] * std::abs(difference);
      gradient[at] = with_sign_of(difference, weight[r] * window_weight[j]);
    }
  }
  return sum;
}

struct OneWindow {
  static constexpr int kLanesOfN = 1;
  static double load(const double* p) { return *p; }
  static void store(double* p, double x) { *p = x; }
  static double all(double x) { return x; }
  static double signed_weight(double difference, double weight) {
    return with_sign_of(difference, weight);
  }
};

using InPlane = ChainedWindow;
using InSpace = SpaceChainedError<double, OneWindow, double>;

/// Of all windows. @tparam Window  InPlane or InSpace
template <class Window>
double chain(int gaps, int stride, const double* weight, const double* scale, const double* offset,
             const double* state, const double* target, const double* window_weight,
             double* gradient, double* scratch) {
  double sum = 0.0;
  for (int j = 0; j < stride; ++j) {
    const Window window = {gaps,      stride,     weight,           scale,        offset,
                           state + j, target + j, window_weight[j], gradient + j, scratch};
    sum += window_weight[j] * window.forward();
    window.backward();
  }
  return sum;
}

}  // namespace

template <>
const WindowKernels<double>& window_kernels(CpuLevel) {
  static constexpr WindowKernels<double> kKernels = {
      1,           layer,         layer_back, weight_gradient, bias_gradient,  relu_gradient,
      modulate,    modulate_back, gather,     add_scaled,      carry,          gated_change,
      gated_carry, bound,         bound_back, entry_error,     chain<InPlane>, chain<InSpace>};
  return kKernels;
}

}  // namespace limber
