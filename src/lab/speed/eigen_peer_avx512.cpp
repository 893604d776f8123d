// The Eigen peer of CpuLevel::avx512; CMakeLists.txt gives this file its instruction set.
#include "eigen_peer_impl.hpp"

namespace limber {

extern const EigenPeer kAvx512EigenPeer;
const EigenPeer kAvx512EigenPeer = evaluate_with_eigen;

}  // namespace limber
