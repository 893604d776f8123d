// The Eigen peer of CpuLevel::avx2; CMakeLists.txt gives this file its instruction set.
#include "eigen_peer_impl.hpp"

namespace limber {

extern const EigenPeer kAvx2EigenPeer;
const EigenPeer kAvx2EigenPeer = evaluate_with_eigen;

}  // namespace limber
