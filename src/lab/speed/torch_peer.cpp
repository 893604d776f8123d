// The LibTorch peer, a loadable module: at::linear and at::relu_ in inference mode.
#include <ATen/ATen.h>
#include <ATen/Parallel.h>
#include <c10/core/InferenceMode.h>

#include <vector>

#include "peer_module.hpp"

namespace limber {

namespace {

class TorchPeer final : public NetworkPeer {
 public:
  TorchPeer(const PeerLayer* layers, int count, int queries)
      : inputs_(layers[0].inputs), queries_(queries) {
    at::set_num_threads(1);
    const c10::InferenceMode inference;
    for (int l = 0; l < count; ++l) {
      const PeerLayer& layer = layers[l];
      // Column-major out × in is row-major in × out; LibTorch's own layers hold out × in.
      const at::Tensor weight = view(layer.weight, layer.inputs, layer.outputs);
      layers_.push_back({weight.t().contiguous(), view(layer.bias, 1, layer.outputs)[0]});
    }
    outputs_ = layers[count - 1].outputs;
  }

  void evaluate(const float* input, float* output) override {
    const c10::InferenceMode inference;
    at::Tensor x = view(input, queries_, inputs_);
    for (std::size_t l = 0; l < layers_.size(); ++l) {
      x = at::linear(x, layers_[l].weight, layers_[l].bias);
      if (l + 1 < layers_.size()) {
        at::relu_(x);
      }
    }
    view(output, queries_, outputs_).copy_(x);
  }

 private:
  struct Layer {
    at::Tensor weight;
    at::Tensor bias;
  };

  // LibTorch has no tensors of constants; those made of constants here are only read.
  static at::Tensor view(const float* data, int rows, int columns) {
    return at::from_blob(const_cast<float*>(data), {rows, columns}, at::kFloat);
  }

  int inputs_;
  int outputs_ = 0;
  int queries_;
  std::vector<Layer> layers_;
};

}  // namespace

}  // namespace limber

limber::NetworkPeer* limber_make_network_peer(const limber::PeerLayer* layers, int count,
                                              int queries) {
  return new limber::TorchPeer(layers, count, queries);
}
