#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"
#include "limber/network/packed_network.hpp"
#include "limber/network/untrained_model.hpp"
#include "src/lab/speed/network_peer.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

using Eigen::MatrixXd;
using Eigen::MatrixXf;

// (5)'s network on folded layers, in double precision.
MatrixXd reference(const std::vector<Layer>& layers, const MatrixXf& input) {
  MatrixXd x = input.cast<double>();
  for (std::size_t l = 0; l < layers.size(); ++l) {
    x = (layers[l].weight.cast<double>() * x).colwise() + layers[l].bias.cast<double>().eval();
    if (l + 1 < layers.size()) {
      x = x.cwiseMax(0.0);
    }
  }
  return x;
}

TEST(NetworkPeer, EveryoneAgreesWithDoublePrecision) {
  for (const int segments : {1, 2, 3, 5}) {
    const ArmDescription arm = sample_arm(segments);
    const std::vector<Layer> layers =
        folded_layers(untrained_model(arm, BackboneLayout::base_poses, {100, 37, 100}, 5));
    std::vector<PeerLayer> views;
    for (const Layer& layer : layers) {
      views.push_back({static_cast<int>(layer.weight.cols()), static_cast<int>(layer.weight.rows()),
                       layer.weight.data(), layer.bias.data()});
    }
    RandomStream random(7, 0);
    for (const int queries : {1, 3, 7, 65, 131}) {
      const MatrixXf input = MatrixXf::NullaryExpr(layers.front().weight.cols(), queries, [&] {
        return static_cast<float>(random.uniform(-1.0, 1.0));
      });
      const MatrixXd wanted = reference(layers, input);
      for (const PeerMaker& maker : peer_makers(true)) {
        const std::unique_ptr<NetworkPeer> peer(
            maker.make(views.data(), static_cast<int>(views.size()), queries));
        MatrixXf output =
            MatrixXf::Constant(wanted.rows(), queries, std::numeric_limits<float>::quiet_NaN());
        peer->evaluate(input.data(), output.data());
        EXPECT_LT((output.cast<double>() - wanted).cwiseAbs().maxCoeff(), 1e-5 * arm.length_m())
            << maker.name << ", " << segments << " segments, " << queries << " queries";
      }
    }
  }
}

}  // namespace
}  // namespace limber
