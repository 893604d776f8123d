#include "experiment/eigen_peer.hpp"

#include <cassert>

namespace limber {

extern const EigenPeer kBaselineEigenPeer;
#if defined(__x86_64__)
extern const EigenPeer kAvx2EigenPeer;
extern const EigenPeer kAvx512EigenPeer;
#endif

EigenPeer eigen_peer(CpuLevel level) {
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

}  // namespace limber
