// The oneDNN peer, a loadable module: inner products with ReLU fused, weights in the layout that
// oneDNN chooses for the number of queries.
#include <omp.h>

#include <oneapi/dnnl/dnnl.hpp>
#include <unordered_map>
#include <vector>

#include "peer_module.hpp"

namespace limber {

namespace {

using dnnl::memory;

class OnednnPeer final : public NetworkPeer {
 public:
  OnednnPeer(const PeerLayer* layers, int count, int queries)
      : engine_(dnnl::engine::kind::cpu, 0), stream_(engine_) {
    omp_set_num_threads(1);
    const memory::desc input({queries, layers[0].inputs}, memory::data_type::f32,
                             memory::format_tag::nc);
    memory source(input, engine_, nullptr);
    for (int l = 0; l < count; ++l) {
      source = add_layer(layers[l], source, queries, l + 1 == count);
    }
    stream_.wait();
  }

  void evaluate(const float* input, float* output) override {
    // oneDNN has no memory of constants; it only reads its source.
    steps_.front().arguments.at(DNNL_ARG_SRC).set_data_handle(const_cast<float*>(input));
    steps_.back().arguments.at(DNNL_ARG_DST).set_data_handle(output);
    for (const Step& step : steps_) {
      step.primitive.execute(stream_, step.arguments);
    }
    stream_.wait();
  }

 private:
  struct Step {
    dnnl::inner_product_forward primitive;
    std::unordered_map<int, memory> arguments;
  };

  // Returns where the layer's results are.
  memory add_layer(const PeerLayer& layer, const memory& source, int queries, bool last) {
    using Tag = memory::format_tag;
    constexpr auto kFloat = memory::data_type::f32;
    const memory::dims weight_size{layer.outputs, layer.inputs};
    dnnl::primitive_attr attributes;
    if (!last) {
      dnnl::post_ops relu;
      relu.append_eltwise(1.0F, dnnl::algorithm::eltwise_relu, 0.0F, 0.0F);
      attributes.set_post_ops(relu);
    }
    const memory::desc bias_form({layer.outputs}, kFloat, Tag::x);
    const dnnl::inner_product_forward::primitive_desc form(
        {dnnl::prop_kind::forward_inference, source.get_desc(),
         memory::desc(weight_size, kFloat, Tag::any), bias_form,
         memory::desc({queries, layer.outputs}, kFloat, Tag::nc)},
        attributes, engine_);
    // Column-major out × in is what oneDNN calls io.
    memory given({weight_size, kFloat, Tag::io}, engine_, const_cast<float*>(layer.weight));
    memory weight(form.weights_desc(), engine_);
    dnnl::reorder(given, weight).execute(stream_, given, weight);
    const memory result =
        last ? memory(form.dst_desc(), engine_, nullptr) : memory(form.dst_desc(), engine_);
    steps_.push_back({dnnl::inner_product_forward(form),
                      {{DNNL_ARG_SRC, source},
                       {DNNL_ARG_WEIGHTS, weight},
                       {DNNL_ARG_BIAS, memory(bias_form, engine_, const_cast<float*>(layer.bias))},
                       {DNNL_ARG_DST, result}}});
    return result;
  }

  dnnl::engine engine_;
  dnnl::stream stream_;
  std::vector<Step> steps_;
};

}  // namespace

}  // namespace limber

limber::NetworkPeer* limber_make_network_peer(const limber::PeerLayer* layers, int count,
                                              int queries) {
  return new limber::OnednnPeer(layers, count, queries);
}
