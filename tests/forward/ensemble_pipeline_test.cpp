#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/forward/parallel_forward.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

using Eigen::MatrixXf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kRounding = 1e-6;  // float32, of numbers of the order of 1

CompensationModel network(const ArmDescription& arm, std::uint64_t seed,
                          BackboneLayout layout = BackboneLayout::gap_poses) {
  return untrained_model(arm, layout, {20, 20}, seed);
}

/// Of one normalisation; member k has the weights of seed `seeds[k]`.
CompensationModel mean_of(const ArmDescription& arm, const std::vector<std::uint64_t>& seeds,
                          BackboneLayout layout = BackboneLayout::gap_poses) {
  CompensationModel model = network(arm, seeds.front(), layout);
  for (std::size_t k = 1; k < seeds.size(); ++k) {
    model.more_members.push_back(network(arm, seeds[k], layout).layers);
  }
  model.answer = EnsembleAnswer::mean;
  return model;
}

/// k random queries.
struct Queries {
  MatrixXf previous_kpa, current_kpa, previous;

  Queries(const ArmDescription& arm, int count) {
    RandomStream random(7, 1);
    const auto within = [&](double limit) {
      return [&random, limit] { return static_cast<float>(random.uniform(-limit, limit)); };
    };
    previous_kpa = MatrixXf::NullaryExpr(arm.segment_count(), count, within(80.0));
    current_kpa = MatrixXf::NullaryExpr(arm.segment_count(), count, within(80.0));
    previous = MatrixXf::NullaryExpr(3 * arm.point_count(), count, within(0.5));
  }

  MatrixXf answers(const ForwardModel& model) const {
    ForwardModel::Workspace workspace;
    MatrixXf next(previous.rows(), previous.cols());
    model.step_batch(previous_kpa, current_kpa, previous, next, workspace);
    return next;
  }
};

TEST(EnsemblePipeline, NetworksThatAgreeGiveTheirOwnAnswerToTheBit) {
  const ArmDescription arm = sample_arm(3);
  const Queries queries(arm, 150);
  for (const std::size_t members : {2U, 3U, 7U}) {
    const ForwardModel mean(arm, mean_of(arm, std::vector<std::uint64_t>(members, 4)));
    EXPECT_EQ(queries.answers(mean), queries.answers(ForwardModel(arm, network(arm, 4))));
  }
}

TEST(EnsemblePipeline, TheMeanIsThatOfTheNetworksOwnAnswersInDouble) {
  const ArmDescription arm = sample_arm(3);
  const std::vector<std::uint64_t> seeds{1, 2, 3, 4, 5};
  const Queries queries(arm, 70);
  for (const BackboneLayout layout : {BackboneLayout::gap_poses, BackboneLayout::base_poses}) {
    const CompensationModel model = mean_of(arm, seeds, layout);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(queries.previous.rows(), 70);
    for (int k = 0; k < model.member_count(); ++k) {
      sum += queries.answers(ForwardModel(arm, model.member(k))).cast<double>();
    }
    const MatrixXf found = queries.answers(ForwardModel(arm, model));
    EXPECT_LT((found.cast<double>() - sum / 5.0).cwiseAbs().maxCoeff(), kRounding);
    EXPECT_GT((found - queries.answers(ForwardModel(arm, model.member(0)))).norm(), 1e-3F)
        << "the networks differ";
  }
}

TEST(EnsemblePipeline, AnAnswerDependsOnItsColumnAloneAndMayReplaceItsQuestion) {
  const ArmDescription arm = sample_arm(2);
  const ForwardModel model(arm, mean_of(arm, {1, 2, 3}));
  const int count = 300;
  const Queries queries(arm, count);
  const MatrixXf together = queries.answers(model);
  ForwardModel::Workspace workspace;
  for (int j = 0; j < count; j += 7) {
    MatrixXf alone(together.rows(), 1);
    model.step_batch(queries.previous_kpa.col(j), queries.current_kpa.col(j),
                     queries.previous.col(j), alone, workspace);
    EXPECT_EQ(alone.col(0), together.col(j)) << j;
  }
  MatrixXf in_place = queries.previous;
  model.step_batch(queries.previous_kpa, queries.current_kpa, in_place, in_place, workspace);
  EXPECT_EQ(in_place, together);
  for (const int jobs : {1, 3}) {
    MatrixXf parallel(together.rows(), count);
    ParallelForward(jobs).step_batch(model, queries.previous_kpa, queries.current_kpa,
                                     queries.previous, parallel);
    EXPECT_EQ(parallel, together) << jobs << " threads";
  }
}

TEST(EnsemblePipeline, OneNetworkHasNoMean) {
  const ArmDescription arm = sample_arm(2);
  EXPECT_THAT([&] { ForwardModel(arm, mean_of(arm, {1})); },
              ThrowsMessage<InputError>(HasSubstr("holds one network, so there is no mean")));
}

}  // namespace
}  // namespace limber
