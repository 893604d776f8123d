#include "limber/training/ensemble_evaluation.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/network/untrained_model.hpp"
#include "limber/report/training_report.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

constexpr double kRounding = 1e-4;  // [cm], float32 over half a metre, added up over frames

/// Networks of weight 0 whose biases move the tip's x by so many metres a step from no load.
CompensationModel shifted(const ArmDescription& arm, const std::vector<float>& shifts_m) {
  CompensationModel model = untrained_model(arm, BackboneLayout::base_poses, {}, 1);
  model.input.offset.setZero();
  model.input.scale.setOnes();
  model.output.offset.setZero();
  model.output.scale.setOnes();
  std::vector<std::vector<Layer>> members;
  for (const float shift_m : shifts_m) {
    Layer layer = model.layers.front();
    layer.weight.setZero();
    layer.bias.setZero();
    layer.bias[layer.bias.size() - 3] = shift_m;
    members.push_back({layer});
  }
  model.layers = members.front();
  model.more_members.assign(members.begin() + 1, members.end());
  return model;
}

TEST(RankCorrelation, SeesOrderAlone) {
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3, 4}, {0.1, 5, 6, 1000}), 1.0);
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3, 4}, {9, 8, 7, -1}), -1.0);
  // By hand: ranks 0, 1, 2, 3 and 1, 0, 3, 2: 1 − 6·4/(4·15).
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3, 4}, {2, 1, 9, 5}), 0.6);
  // Ties share their ranks: 0.5, 0.5, 2 against 0, 1, 2.
  EXPECT_NEAR(rank_correlation({1, 1, 2}, {1, 2, 3}), std::sqrt(0.75), 1e-12);
  EXPECT_TRUE(std::isnan(rank_correlation({1, 1}, {1, 2})));
}

// Members 1 and 3 cm beside no load: the mean is 2 cm beside it, the spread 1 cm.
TEST(EvaluateEnsemble, MeanAndSpreadAreThoseOfTheMembers) {
  const ArmDescription arm = three_segment_arm();
  Episode episode = toy_episode(arm, 5, 20, 3, 0.0F);  // no play: the no-load model is right
  const EnsembleForward ensemble(arm, shifted(arm, {0.01F, 0.03F}));
  const EnsembleEvaluation evaluation = evaluate_ensemble(ensemble, {episode});
  EXPECT_EQ(evaluation.members, 2);
  for (const EnsembleErrors& errors :
       {evaluation.one_step, evaluation.window_32, evaluation.per_motion, evaluation.open_loop}) {
    EXPECT_NEAR(errors.mean.position_cm.mean, 2.0, kRounding);
    EXPECT_NEAR(errors.spread.mean_cm, 1.0, kRounding);
    EXPECT_NEAR(errors.spread.factor_for_95, 2.0, 1e-3);
  }
  const EnsembleForward wider(arm, shifted(arm, {0.0F, 0.03F}));
  EXPECT_DOUBLE_EQ(evaluate_ensemble(wider, {episode}).one_step.spread.covered_by_two, 1.0);
  const EnsembleForward closer(arm, shifted(arm, {0.02F, 0.03F}));
  EXPECT_DOUBLE_EQ(evaluate_ensemble(closer, {episode}).one_step.spread.covered_by_two, 0.0);
}

TEST(EvaluateEnsemble, UntrackedFramesChangeNothing) {
  const ArmDescription arm = three_segment_arm();
  Episode episode = toy_episode(arm, 5, 20, 3);
  episode.tracked.assign(101, 1);
  episode.tracked[0] = episode.tracked[40] = episode.tracked[64] = 0;
  const EnsembleForward ensemble(arm, shifted(arm, {0.01F, 0.03F}));
  const auto before = to_json(evaluate_ensemble(ensemble, {episode}));
  for (const int t : {0, 40, 64}) {
    episode.backbone.row(t).setConstant(9.0F);
  }
  EXPECT_EQ(before, to_json(evaluate_ensemble(ensemble, {episode})));
}

}  // namespace
}  // namespace limber
