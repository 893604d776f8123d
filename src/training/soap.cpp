#include "soap.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "flushed_subnormals.hpp"
#include "training_kernels.hpp"

namespace limber {

namespace {

using Eigen::Map;
using Eigen::MatrixXf;

// Every kernel's registers hold 16 numbers or a part of them: so many rows, or a multiple, have the
// matrices on the left of its products. Those beyond m are zero.
constexpr int kRows = 16;
// The averages take every fourth gradient: every one would lower a family's loss by 2 % only.
constexpr std::int64_t kAverageInterval = 4;
constexpr float kAverageDecay = 0.96F;
// Steps between new eigenvectors: 10 would lower that loss by 2 % too, 100 give the same.
constexpr std::int64_t kTurnInterval = 40;

int padded(int rows) {
  return (rows + kRows - 1) / kRows * kRows;
}

/// One weight's part of OptimiserState::rotations.
struct Rotations {
  Rotations(int m, int k, float* at)
      : left_average(at, m, m),
        right_average(at + left_average.size(), k, k),
        left(right_average.data() + right_average.size(), padded(m), m),
        right(left.data() + left.size(), k, k) {}

  static Eigen::Index size(int m, int k) {
    return (Eigen::Index{m} + padded(m)) * m + 2 * Eigen::Index{k} * k;
  }

  Map<MatrixXf> left_average;   ///< of G·Gᵀ
  Map<MatrixXf> right_average;  ///< of Gᵀ·G
  Map<MatrixXf> left;           ///< U
  Map<MatrixXf> right;          ///< V
};

// The products of the kernels that train, whose windows are a's rows here.
MatrixXf times(const auto& a, const auto& b) {
  MatrixXf result(a.rows(), b.cols());
  window_kernels<float>().layer_back(int(a.rows()), int(b.rows()), int(b.cols()), a.data(),
                                     b.data(), result.data());
  return result;
}

MatrixXf times_transposed(const auto& a, const auto& b) {
  MatrixXf result(a.rows(), b.rows());
  const Eigen::VectorXf zero = Eigen::VectorXf::Zero(b.rows());
  window_kernels<float>().layer(int(a.rows()), int(b.rows()), int(b.cols()), a.data(), b.data(),
                                zero.data(), false, result.data());
  return result;
}

MatrixXf transposed_times(const auto& a, const auto& b) {
  MatrixXf result = MatrixXf::Zero(a.cols(), b.cols());
  window_kernels<float>().weight_gradient(1, int(a.rows()), int(a.cols()), int(b.cols()), a.data(),
                                          b.data(), 0, result.data());
  return result;
}

MatrixXf with_padding(const auto& matrix) {
  MatrixXf result = MatrixXf::Zero(padded(int(matrix.rows())), matrix.cols());
  result.topRows(matrix.rows()) = matrix;
  return result;
}

/// Uᵀ·matrix·V, of a matrix with padding.
MatrixXf turned(const Rotations& rotations, const MatrixXf& matrix) {
  return transposed_times(rotations.left, times(matrix, rotations.right));
}

/// U·matrix·Vᵀ, with padding.
MatrixXf turned_back(const Rotations& rotations, const auto& matrix) {
  return times_transposed(times(rotations.left, matrix), rotations.right);
}

void add_to_averages(float decay, const auto& g, const MatrixXf& padded_g, Rotations& rotations) {
  const float share = 1.0F - decay;
  rotations.left_average =
      decay * rotations.left_average + share * times_transposed(padded_g, g).topRows(g.rows());
  rotations.right_average =
      decay * rotations.right_average + share * transposed_times(padded_g, padded_g);
}

MatrixXf eigenvectors(const MatrixXf& average) {
  return Eigen::SelfAdjointEigenSolver<MatrixXf>(average).eigenvectors();
}

/// One step of orthogonal iteration.
MatrixXf nearer_eigenvectors(const auto& average, const auto& vectors) {
  const Eigen::HouseholderQR<MatrixXf> factors(average * vectors);
  return factors.householderQ() * MatrixXf::Identity(average.rows(), average.cols());
}

/// New eigenvectors; the first moment is turned from the old to the new.
void renew(Rotations& rotations, Map<MatrixXf> first_moment) {
  const MatrixXf moment = turned_back(rotations, first_moment);
  const auto m = first_moment.rows();
  rotations.left.topRows(m) =
      nearer_eigenvectors(rotations.left_average, rotations.left.topRows(m));
  rotations.right = nearer_eigenvectors(rotations.right_average, rotations.right);
  first_moment = turned(rotations, moment);
}

}  // namespace

Soap::Soap(const ParameterLayout& layout, int networks, int jobs)
    : parameters_(layout.size() * networks), arena_(jobs) {
  for (Eigen::Index network = 0; network < networks; ++network) {
    const Eigen::Index from = network * layout.size();
    for (int layer = 0; layer < layout.layer_count(); ++layer) {
      const int m = layout.outputs(layer);
      add_weight(m, layout.inputs(layer), from + layout.weight_offset(layer));
      others_.emplace_back(from + layout.bias_offset(layer), from + layout.bias_offset(layer) + m);
    }
    for (int layer = 0; layer + 1 < layout.layer_count() && layout.arms().size > 0; ++layer) {
      add_weight(2 * layout.outputs(layer), layout.arms().size,
                 from + layout.modulation_offset(layer));
    }
    others_.emplace_back(from + layout.arm_offset(0), from + layout.size());
  }
}

void Soap::add_weight(int m, int k, Eigen::Index at) {
  weights_.push_back({m, k, at, rotations_});
  rotations_ += Rotations::size(m, k);
}

OptimiserState Soap::first_state() const {
  OptimiserState state;
  state.first_moment.setZero(parameters_);
  state.second_moment.setZero(parameters_);
  state.rotations.setZero(rotations_);
  return state;
}

void Soap::step_weight(const Weight& weight, const float* gradient, double learning_rate,
                       OptimiserState& state, float* parameters) {
  const FlushedSubnormals flushed;
  const auto [m, k, at, rotations_at] = weight;
  const Map<const MatrixXf> g(gradient + at, m, k);
  const MatrixXf padded_g = with_padding(g);
  Rotations rotations(m, k, state.rotations.data() + rotations_at);
  const Map<MatrixXf> first_moment(state.first_moment.data() + at, m, k);
  if (state.step == 1) {
    add_to_averages(0.0F, g, padded_g, rotations);
    rotations.left.topRows(m) = eigenvectors(rotations.left_average);
    rotations.right = eigenvectors(rotations.right_average);
    return;
  }
  MatrixXf change = MatrixXf::Zero(m, k);
  adam_step(state.step - 1, learning_rate, int(change.size()), turned(rotations, padded_g).data(),
            state.first_moment.data() + at, state.second_moment.data() + at, change.data());
  Map<MatrixXf>(parameters + at, m, k) += turned_back(rotations, change).topRows(m);
  if (state.step % kAverageInterval == 0) {
    add_to_averages(kAverageDecay, g, padded_g, rotations);
  }
  if (state.step % kTurnInterval == 0) {
    renew(rotations, first_moment);
  }
}

void Soap::step(const Eigen::VectorXf& gradient, double learning_rate, OptimiserState& state,
                Eigen::VectorXf& parameters) {
  ++state.step;
  for (const auto& [first, end] : others_) {
    adam_step(state.step, learning_rate, int(end - first), gradient.data() + first,
              state.first_moment.data() + first, state.second_moment.data() + first,
              parameters.data() + first);
  }
  arena_.for_each(weights_.size(), [&](std::size_t i) {
    step_weight(weights_[i], gradient.data(), learning_rate, state, parameters.data());
  });
}

}  // namespace limber
