#include "exact_network.hpp"

#include <algorithm>
#include <cassert>

namespace limber {

extern const LayerOfTwoKernel kBaselineLayerOfTwoKernel;
#if defined(__x86_64__)
extern const LayerOfTwoKernel kAvx2LayerOfTwoKernel;
extern const LayerOfTwoKernel kAvx512LayerOfTwoKernel;
#endif

LayerOfTwoKernel layer_of_two_kernel(CpuLevel level) {
#if defined(__x86_64__)
  if (level == CpuLevel::avx512) {
    return kAvx512LayerOfTwoKernel;
  }
  if (level == CpuLevel::avx2) {
    return kAvx2LayerOfTwoKernel;
  }
#endif
  assert(level == CpuLevel::baseline);
  return kBaselineLayerOfTwoKernel;
}

namespace {

constexpr std::size_t kRows = 8;  // of an Eight

std::size_t eights(std::size_t rows) {
  return (rows + kRows - 1) / kRows;
}

double* numbers(std::vector<Eight>& list) {
  return list.data()->value;
}

}  // namespace

ExactNetwork::ExactNetwork(const CompensationModel& network, CpuLevel level)
    : input_(in_double(network.input)),
      output_(in_double(network.output)),
      kernel_(layer_of_two_kernel(level)) {
  for (const Layer& layer : network.layers) {
    layers_.push_back(packed(layer));
  }
}

ExactNetwork::PackedLayer ExactNetwork::packed(const Layer& layer) {
  PackedLayer result;
  result.rows = std::size_t(layer.weight.rows());
  result.columns = std::size_t(layer.weight.cols());
  result.weight.resize(eights(result.rows) * result.columns);
  result.bias.resize(eights(result.rows));
  for (std::size_t row = 0; row < result.rows; ++row) {
    const auto r = Eigen::Index(row);
    for (std::size_t k = 0; k < result.columns; ++k) {
      result.weight[row / kRows * result.columns + k].value[row % kRows] =
          double(layer.weight(r, Eigen::Index(k)));
    }
    result.bias[row / kRows].value[row % kRows] = double(layer.bias[r]);
  }
  return result;
}

ExactNetwork::Affine ExactNetwork::in_double(const Normalisation& normalisation) {
  return {{normalisation.offset.begin(), normalisation.offset.end()},
          {normalisation.scale.begin(), normalisation.scale.end()}};
}

void ExactNetwork::run(Workspace& workspace) const {
  std::size_t widest = eights(input_.scale.size());
  for (const PackedLayer& layer : layers_) {
    widest = std::max(widest, layer.bias.size());
  }
  for (std::size_t c = 0; c < 2; ++c) {
    workspace.now[c].resize(widest);
    workspace.next[c].resize(widest);
    double* now = numbers(workspace.now[c]);
    for (std::size_t i = 0; i < input_.scale.size(); ++i) {
      now[i] = (workspace.input[c][i] - input_.offset[i]) * input_.scale[i];
    }
  }
  workspace.nonzero.resize(kRows * widest);
  for (const PackedLayer& layer : layers_) {
    const double* const x[2] = {numbers(workspace.now[0]), numbers(workspace.now[1])};
    Eight* const y[2] = {workspace.next[0].data(), workspace.next[1].data()};
    std::size_t count = 0;
    for (std::size_t k = 0; k < layer.columns; ++k) {
      workspace.nonzero[count] = k;
      count += std::size_t{x[0][k] != 0.0} | std::size_t{x[1][k] != 0.0};
    }
    const bool is_last = &layer == &layers_.back();
    kernel_({layer.weight.data(), layer.bias.data(), layer.bias.size(), layer.columns, !is_last},
            workspace.nonzero.data(), count, x, y);
    std::swap(workspace.now, workspace.next);
  }
  for (std::size_t c = 0; c < 2; ++c) {
    const double* now = numbers(workspace.now[c]);
    workspace.output[c].assign(now, now + layers_.back().rows);
    for (std::size_t i = 0; i < output_.scale.size(); ++i) {  // gates are behind them
      double& value = workspace.output[c][i];
      value = value / output_.scale[i] + output_.offset[i];
    }
  }
}

}  // namespace limber
