// The LIBXSMM peer, a loadable module: its generated kernels for exactly these shapes, bias put
// into the result before the products are added, ReLU while a tile of the result is in the first
// cache.
#include <libxsmm.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "peer_module.hpp"

namespace limber {

namespace {

constexpr int kTileQueries = 64;

// Compiled for each instruction set, as LIBXSMM's own code is.
#if defined(__x86_64__)
#define LIMBER_FOR_EACH_CPU __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define LIMBER_FOR_EACH_CPU
#endif

LIMBER_FOR_EACH_CPU void fill_with_bias(const PeerLayer& layer, int queries, float* result) {
  for (int q = 0; q < queries; ++q) {
    for (int i = 0; i < layer.outputs; ++i) {
      result[q * layer.outputs + i] = layer.bias[i];
    }
  }
}

LIMBER_FOR_EACH_CPU void relu(int count, float* result) {
  for (int i = 0; i < count; ++i) {
    result[i] = result[i] > 0.0F ? result[i] : 0.0F;
  }
}

class LibxsmmPeer final : public NetworkPeer {
 public:
  LibxsmmPeer(const PeerLayer* layers, int count, int queries) : queries_(queries) {
    for (int l = 0; l < count; ++l) {
      layers_.push_back(make_layer(layers[l], l + 1 == count));
      widest_ = std::max(widest_, layers[l].outputs);
    }
    scratch_.resize(2 * std::size_t(widest_ * kTileQueries));
  }

  void evaluate(const float* input, float* output) override {
    const int inputs = layers_.front().form.inputs;
    const int outputs = layers_.back().form.outputs;
    for (int j = 0; j < queries_; j += kTileQueries) {
      evaluate_tile(std::min(kTileQueries, queries_ - j), input + j * inputs, output + j * outputs);
    }
  }

 private:
  struct GeneratedLayer {
    PeerLayer form;
    bool last;
    libxsmm_smmfunction whole;  // kTileQueries queries
    libxsmm_smmfunction rest;   // what is left of queries_
  };

  libxsmm_smmfunction kernel_of(const PeerLayer& layer, int queries) const {
    if (queries == 0) {
      return nullptr;
    }
    const float one = 1.0F;
    const libxsmm_smmfunction kernel =
        libxsmm_smmdispatch(layer.outputs, queries, layer.inputs, nullptr, nullptr, nullptr, &one,
                            &one, nullptr, nullptr);
    if (kernel == nullptr) {
      throw std::runtime_error("LIBXSMM generated no kernel for this CPU");
    }
    return kernel;
  }

  GeneratedLayer make_layer(const PeerLayer& layer, bool last) const {
    return {layer, last, kernel_of(layer, queries_ < kTileQueries ? 0 : kTileQueries),
            kernel_of(layer, queries_ % kTileQueries)};
  }

  void evaluate_tile(int queries, const float* input, float* output) {
    const float* x = input;
    float* y = scratch_.data();
    float* other = y + widest_ * kTileQueries;
    for (const GeneratedLayer& layer : layers_) {
      const int outputs = layer.form.outputs;
      float* const result = layer.last ? output : y;
      fill_with_bias(layer.form, queries, result);
      (queries == kTileQueries ? layer.whole : layer.rest)(layer.form.weight, x, result);
      if (!layer.last) {
        relu(queries * outputs, result);
      }
      x = result;
      std::swap(y, other);
    }
  }

  int queries_;
  int widest_ = 0;
  std::vector<GeneratedLayer> layers_;
  std::vector<float> scratch_;
};

}  // namespace

}  // namespace limber

limber::NetworkPeer* limber_make_network_peer(const limber::PeerLayer* layers, int count,
                                              int queries) {
  return new limber::LibxsmmPeer(layers, count, queries);
}
