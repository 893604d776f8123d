// The Eigen peer of CpuLevel::baseline; CMakeLists.txt gives this file its instruction set.
#include "eigen_peer_impl.hpp"

namespace limber {

extern const EigenPeer kBaselineEigenPeer;
const EigenPeer kBaselineEigenPeer = evaluate_with_eigen;

}  // namespace limber
