#include "limber/training/parameter_layout.hpp"

#include <cassert>
#include <cmath>

#include <Eigen/Cholesky>

#include "limber/common/random_stream.hpp"
#include "limber/network/arm_gain.hpp"

namespace limber {

namespace {

constexpr float kLastLayerShare = 0.1F;
constexpr double kFirstArmSpread = 0.3;
// Added to the variance of the arms' vectors: a direction that none of them uses stays one.
constexpr double kLeastArmSpread = 1e-6;

void append_rows(const Eigen::MatrixXd& rows, Eigen::MatrixXf& matrix) {
  matrix.conservativeResize(matrix.rows() + rows.rows(), rows.cols());
  matrix.bottomRows(rows.rows()) = rows.cast<float>();
}

}  // namespace

ParameterLayout::ParameterLayout(std::vector<int> widths, ArmVectorTable arms)
    : widths_(std::move(widths)), arms_(arms) {
  assert(widths_.size() >= 2);
  for (int layer = 0; layer < layer_count(); ++layer) {
    offsets_.push_back(arms_at_);
    arms_at_ += Eigen::Index(outputs(layer)) * (inputs(layer) + 1);
  }
  for (int layer = 0; layer + 1 < layer_count(); ++layer) {
    modulation_offsets_.push_back(arms_at_);
    arms_at_ += Eigen::Index{2} * outputs(layer) * arms_.size;
  }
}

Eigen::VectorXf initial_parameters(const ParameterLayout& layout, std::uint64_t seed,
                                   std::uint64_t first_stream, FirstWeights kind) {
  Eigen::VectorXf parameters = Eigen::VectorXf::Zero(layout.size());
  for (int layer = 0; layer < layout.layer_count(); ++layer) {
    RandomStream stream(seed, first_stream + std::uint64_t(layer));
    const bool last = layer + 1 == layout.layer_count();
    const auto inputs = float(layout.inputs(layer));
    const bool he = kind == FirstWeights::he;
    const float limit =
        he ? std::sqrt(6.0F / inputs) * (last ? kLastLayerShare : 1.0F) : 1.0F / std::sqrt(inputs);
    const Eigen::Index end =
        he ? layout.bias_offset(layer) : layout.bias_offset(layer) + layout.outputs(layer);
    for (Eigen::Index i = layout.weight_offset(layer); i < end; ++i) {
      parameters[i] = float(stream.uniform(-limit, limit));
    }
  }
  const auto streams = std::uint64_t(layout.layer_count());
  for (int layer = 0; layer + 1 < layout.layer_count() && layout.arms().size > 0; ++layer) {
    RandomStream stream(seed, first_stream + streams + 1 + std::uint64_t(layer));
    const float limit = std::sqrt(6.0F / float(layout.inputs(layer) + layout.arms().size));
    const Eigen::Index units = layout.outputs(layer);
    for (Eigen::Index i = 0; i < 2 * units * layout.arms().size; ++i) {
      const bool is_shift = i % (2 * units) >= units;
      parameters[layout.modulation_offset(layer) + i] =
          is_shift ? float(stream.uniform(-limit, limit)) : 0.0F;
    }
  }
  RandomStream stream(seed, first_stream + streams);
  for (Eigen::Index i = layout.arm_offset(0); i < layout.size(); ++i) {
    parameters[i] = float(kFirstArmSpread * stream.normal()) / kArmVectorScale;
  }
  return parameters;
}

void set_gate_biases(const ParameterLayout& layout, int gates, double bias,
                     Eigen::VectorXf& parameters) {
  const int last = layout.layer_count() - 1;
  parameters.segment(layout.bias_offset(last) + layout.outputs(last) - gates, gates)
      .setConstant(float(bias));
}

std::vector<Layer> to_layers(const ParameterLayout& layout, const Eigen::VectorXf& parameters) {
  std::vector<Layer> layers;
  for (int layer = 0; layer < layout.layer_count(); ++layer) {
    const int in = layout.inputs(layer);
    const int out = layout.outputs(layer);
    layers.push_back({Eigen::Map<const Eigen::MatrixXf>(
                          parameters.data() + layout.weight_offset(layer), out, in),
                      parameters.segment(layout.bias_offset(layer), out)});
  }
  return layers;
}

Eigen::VectorXf to_parameters(const ParameterLayout& layout, const std::vector<Layer>& layers) {
  Eigen::VectorXf parameters(layout.size());
  for (int layer = 0; layer < layout.layer_count(); ++layer) {
    const Layer& source = layers[layer];
    assert(source.weight.rows() == layout.outputs(layer));
    assert(source.weight.cols() == layout.inputs(layer));
    parameters.segment(layout.weight_offset(layer), source.weight.size()) =
        source.weight.reshaped();
    parameters.segment(layout.bias_offset(layer), source.bias.size()) = source.bias;
  }
  return parameters;
}

void make_family(const ParameterLayout& layout, const Eigen::VectorXf& parameters,
                 CompensationModel& model) {
  const auto [size, count] = layout.arms();
  const Eigen::MatrixXd arms =
      kArmVectorScale *
      Eigen::Map<const Eigen::MatrixXf>(parameters.data() + layout.arm_offset(0), size, count)
          .cast<double>();
  const Eigen::VectorXd mean = arms.rowwise().mean();
  const Eigen::MatrixXd centred = arms.colwise() - mean;
  const Eigen::MatrixXd covariance = centred * centred.transpose() / count +
                                     kLeastArmSpread * Eigen::MatrixXd::Identity(size, size);
  const Eigen::LLT<Eigen::MatrixXd> root(covariance);
  const Eigen::MatrixXd to_own_scale = root.matrixL();
  ArmFamily family;
  family.arms = root.matrixL().solve(centred).cast<float>();
  for (int layer = 0; layer + 1 < layout.layer_count(); ++layer) {
    const Eigen::Index units = layout.outputs(layer);
    // What e does to the layer's units.
    const Eigen::MatrixXd share =
        Eigen::Map<const Eigen::MatrixXf>(parameters.data() + layout.modulation_offset(layer),
                                          2 * units, size)
            .cast<double>();
    const auto log_gains = share.topRows(units);
    const auto shifts = share.bottomRows(units);
    const Eigen::VectorXd of_middle = log_gains * mean;
    const Eigen::VectorXd gain = of_middle.unaryExpr(&log_arm_gain<double>).array().exp();
    auto& [weight, bias] = model.layers[layer];
    weight = gain.cast<float>().asDiagonal() * weight;
    bias = (gain.array() * (bias.cast<double>() + shifts * mean).array()).cast<float>();
    append_rows(
        (Eigen::MatrixXd(units, 1 + size) << of_middle, log_gains * to_own_scale).finished(),
        family.log_gains);
    append_rows(gain.asDiagonal() * shifts * to_own_scale, family.shifts);
  }
  model.family = std::move(family);
}

}  // namespace limber
