#include "limber/network/packed_network.hpp"

#include <algorithm>
#include <cassert>

namespace limber {

// W (x − offset)·scale + b for the first layer, (W x + b)/scale + offset for the last; gates, which
// follow the backbone's numbers there, are not normalised.
std::vector<Layer> folded_layers(const CompensationModel& model) {
  std::vector<Layer> layers = model.layers;
  for (std::size_t l = 0; l < layers.size(); ++l) {
    Eigen::MatrixXd weight = layers[l].weight.cast<double>();
    Eigen::VectorXd bias = layers[l].bias.cast<double>();
    const bool last = l + 1 == layers.size();
    if (l == 0) {
      weight = weight * model.input.scale.cast<double>().asDiagonal();
      bias -= weight * model.input.offset.cast<double>();
    }
    if (last) {
      const Eigen::Index size = model.output.scale.size();
      const Eigen::VectorXd range = model.output.scale.cast<double>().cwiseInverse();
      weight.topRows(size) = range.asDiagonal() * weight.topRows(size);
      bias.head(size) = bias.head(size).cwiseProduct(range) + model.output.offset.cast<double>();
    }
    layers[l] = {weight.cast<float>(), bias.cast<float>()};
  }
  return layers;
}

PackedNetwork::PackedNetwork(const CompensationModel& model, CpuLevel level)
    : kernels_(gemm_kernels(level)) {
  for (const Layer& folded : folded_layers(model)) {
    PackedLayer layer;
    layer.inputs = int(folded.weight.cols());
    layer.outputs = int(folded.weight.rows());
    layer.padded_outputs = (layer.outputs + kernels_.lanes - 1) / kernels_.lanes * kernels_.lanes;
    layer.relu = layers_.size() + 1 < model.layers.size();
    const auto padded = std::size_t(layer.padded_outputs);
    layer.weight.assign(padded * std::size_t(layer.inputs), 0.0F);
    layer.bias.assign(padded, 0.0F);
    layer.transposed_weight.resize(std::size_t(layer.inputs) * std::size_t(layer.outputs));
    Eigen::Map<Eigen::MatrixXf>(layer.weight.data(), layer.padded_outputs, layer.inputs)
        .topRows(layer.outputs) = folded.weight;
    Eigen::Map<Eigen::MatrixXf>(layer.transposed_weight.data(), layer.inputs, layer.outputs) =
        folded.weight.transpose();
    Eigen::Map<Eigen::VectorXf>(layer.bias.data(), layer.outputs) = folded.bias;
    padded_width_ = std::max(padded_width_, layer.padded_outputs);
    layers_.push_back(std::move(layer));
  }
}

long PackedNetwork::multiply_adds(int count) const {
  long sum = 0;
  for (int l = 0; l < count; ++l) {
    const PackedLayer& layer = layers_[l];
    sum += static_cast<long>(layer.inputs) * layer.outputs;
  }
  return sum;
}

const float* PackedNetwork::evaluate(const float* input, float* scratch) const {
  const float* x = input;
  float* y = scratch;
  float* other = scratch + padded_width_;
  for (const PackedLayer& layer : layers_) {
    kernels_.query_layer(layer.padded_outputs, layer.inputs, layer.weight.data(), x,
                         layer.bias.data(), layer.relu, y);
    x = y;
    std::swap(y, other);
  }
  return x;
}

const float* PackedNetwork::evaluate_columns(int queries, const float* input, int ld,
                                             float* scratch) const {
  if (queries == 1) {
    return evaluate(input, scratch);
  }
  const float* x = input;
  float* y = scratch;
  float* other = scratch + std::ptrdiff_t(padded_width_) * queries;
  for (const PackedLayer& layer : layers_) {
    kernels_.layer(layer.padded_outputs, queries, layer.inputs, layer.weight.data(),
                   layer.padded_outputs, x, ld, layer.bias.data(), layer.relu, y, padded_width_);
    x = y;
    ld = padded_width_;
    std::swap(y, other);
  }
  return x;
}

const float* PackedNetwork::evaluate_rows(int queries, const float* input, float* scratch) const {
  return evaluate_layers_of_rows(layer_count(), queries, input, scratch);
}

const float* PackedNetwork::evaluate_layers_of_rows(int count, int queries, const float* input,
                                                    float* scratch) const {
  assert(count <= layer_count());
  const float* x = input;
  float* y = scratch;
  float* other = scratch + std::ptrdiff_t(padded_width_) * queries;
  for (int l = 0; l < count; ++l) {
    const PackedLayer& layer = layers_[l];
    kernels_.layer_of_rows(queries, layer.outputs, layer.inputs, x, queries,
                           layer.transposed_weight.data(), layer.inputs, layer.bias.data(),
                           layer.relu, y, queries);
    x = y;
    std::swap(y, other);
  }
  return x;
}

}  // namespace limber
