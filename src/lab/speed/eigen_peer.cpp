#include "eigen_peer.hpp"

#include <algorithm>
#include <cassert>

#include "limber/common/aligned_floats.hpp"
#include "limber/common/cpu_level.hpp"

namespace limber {

extern const EigenPeer kBaselineEigenPeer;
#if defined(__x86_64__)
extern const EigenPeer kAvx2EigenPeer;
extern const EigenPeer kAvx512EigenPeer;
#endif

namespace {

EigenPeer compiled_for(CpuLevel level) {
#if defined(__x86_64__)
  if (level == CpuLevel::avx512) {
    return kAvx512EigenPeer;
  }
  if (level == CpuLevel::avx2) {
    return kAvx2EigenPeer;
  }
#endif
  assert(level == CpuLevel::baseline);
  return kBaselineEigenPeer;
}

class EigenNetworkPeer final : public NetworkPeer {
 public:
  EigenNetworkPeer(const PeerLayer* layers, int count, int queries)
      : evaluate_(compiled_for(cpu_level())), layers_(layers), count_(count), queries_(queries) {
    for (int l = 0; l < count; ++l) {
      widest_ = std::max(widest_, layers[l].outputs);
    }
    scratch_.resize(2 * std::size_t(widest_) * std::size_t(queries));
  }

  void evaluate(const float* input, float* output) override {
    evaluate_(layers_, count_, queries_, input, scratch_.data(), widest_, output);
  }

 private:
  EigenPeer evaluate_;
  const PeerLayer* layers_;
  int count_;
  int queries_;
  int widest_ = 0;
  AlignedFloats scratch_;
};

}  // namespace

NetworkPeer* make_eigen_peer(const PeerLayer* layers, int count, int queries) {
  return new EigenNetworkPeer(layers, count, queries);
}

}  // namespace limber
