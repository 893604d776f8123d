#include "limber/forward/forward_model.hpp"

#include <algorithm>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/network/backbone_layout.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/narrow_bounds.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

using Eigen::MatrixXd;
using Eigen::MatrixXf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kRelativeToLength = 1e-5;  // of the arm's length, in metres and radians: float32
// A gate's rounding moves all that it weighs, and a change's counts as much as ten of a pose's.
constexpr double kGatedRelativeToLength = 2e-5;

struct Queries {
  MatrixXf previous_kpa;
  MatrixXf current_kpa;
  MatrixXf previous;
  MatrixXf before;  ///< a frame earlier
};

// Pressures a little past the limits; backbones near what the arm does, from other pressures.
Queries random_queries(const ArmDescription& arm, int count, std::uint64_t seed) {
  const NoLoadModel no_load(arm);
  RandomStream random(seed, 0);
  const auto pressure = [&] { return static_cast<float>(random.uniform(-104.0, 104.0)); };
  const int n = arm.segment_count();
  Queries queries{MatrixXf::NullaryExpr(n, count, pressure),
                  MatrixXf::NullaryExpr(n, count, pressure), MatrixXf(3 * arm.point_count(), count),
                  MatrixXf(3 * arm.point_count(), count)};
  for (int j = 0; j < count; ++j) {
    const Pressures kpa = Pressures::NullaryExpr(n, pressure);
    Backbone backbone(arm.point_count(), 3);
    no_load.backbone(kpa, backbone);
    queries.previous.col(j) = Eigen::Map<Eigen::VectorXf>(backbone.data(), backbone.size());
    no_load.backbone(Pressures(0.9F * kpa), backbone);
    queries.before.col(j) = Eigen::Map<Eigen::VectorXf>(backbone.data(), backbone.size());
  }
  return queries;
}

// (5) or (16) as it is written, in double precision: normalise, layers, denormalise, add B̃ or the
// previous backbone.
MatrixXd reference(const ArmDescription& arm, const CompensationModel* model,
                   const Queries& queries) {
  const NoLoadModel no_load(arm);
  MatrixXd answers(queries.previous.rows(), queries.previous.cols());
  for (Eigen::Index j = 0; j < answers.cols(); ++j) {
    BackboneD unloaded(arm.point_count(), 3);
    no_load.backbone(Eigen::VectorXd(queries.current_kpa.col(j).cast<double>()), unloaded);
    answers.col(j) = Eigen::Map<Eigen::VectorXd>(unloaded.data(), unloaded.size());
  }
  if (model == nullptr) {
    return answers;
  }
  const bool gaps = model->layout == BackboneLayout::gap_poses;
  const NetworkLayout layout(model->layout, model->form, arm, model->reads_velocity);
  const MatrixXd previous_base = queries.previous.cast<double>();
  const MatrixXd previous = gaps ? gap_poses_of(previous_base) : previous_base;
  const MatrixXd no_load_encoded = gaps ? gap_poses_of(answers) : answers;
  MatrixXd x(layout.input_size(), answers.cols());
  const MatrixXd before_base = queries.before.cast<double>();
  const MatrixXd change = previous - (gaps ? gap_poses_of(before_base) : before_base);
  x << queries.previous_kpa.cast<double>(), queries.current_kpa.cast<double>(), previous,
      layout.no_load_input(no_load_encoded.cast<float>()).cast<double>(),
      model->reads_velocity ? change : MatrixXd(0, change.cols());
  x = model->input.scale.cast<double>().asDiagonal() *
      (x.colwise() - model->input.offset.cast<double>());
  for (std::size_t l = 0; l < model->layers.size(); ++l) {
    const Layer& layer = model->layers[l];
    x = (layer.weight.cast<double>() * x).colwise() + layer.bias.cast<double>().eval();
    if (l + 1 < model->layers.size()) {
      x = x.cwiseMax(0.0);
    }
  }
  const MatrixXd output = (model->output.scale.cast<double>().cwiseInverse().asDiagonal() *
                           x.topRows(layout.backbone_size()))
                              .colwise() +
                          model->output.offset.cast<double>().eval();
  MatrixXd next = no_load_encoded + output;
  if (model->form == OutputForm::gated_change) {
    const Eigen::ArrayXXd gate =
        1.0 / (1.0 + (-x.bottomRows(layout.backbone_size())).array().exp());
    next = previous + output + (gate * (no_load_encoded - previous).array()).matrix();
  }
  if (model->bounds) {
    next = within_bounds(*model->bounds, next, model->layout);
  }
  return gaps ? base_poses_of(next) : next;
}

MatrixXf answers_of(const ForwardModel& model, const Queries& queries) {
  MatrixXf answers(queries.previous.rows(), queries.previous.cols());
  ForwardModel::Workspace workspace;
  model.step_batch(queries.previous_kpa, queries.current_kpa, queries.before, queries.previous,
                   answers, workspace);
  return answers;
}

std::vector<ForwardModel> models_of(const ArmDescription& arm, CpuLevel level) {
  std::vector<ForwardModel> models;
  models.emplace_back(arm, level);
  for (const BackboneLayout layout : {BackboneLayout::base_poses, BackboneLayout::gap_poses}) {
    for (const OutputForm form : {OutputForm::compensation, OutputForm::gated_change}) {
      for (const bool reads_velocity : {false, true}) {
        const CompensationModel network =
            untrained_model(arm, layout, {100, 37, 100}, 3, form, reads_velocity);
        models.emplace_back(arm, network, level);
        CompensationModel bounded = network;
        bounded.bounds = narrow_bounds(arm);
        models.emplace_back(arm, std::move(bounded), level);
      }
    }
  }
  return models;
}

class ForwardModelOfLevel : public ::testing::TestWithParam<CpuLevel> {};

INSTANTIATE_TEST_SUITE_P(Levels, ForwardModelOfLevel, ::testing::ValuesIn(available_cpu_levels()),
                         [](const auto& level) { return std::string(to_string(level.param)); });

TEST_P(ForwardModelOfLevel, AgreesWithDoublePrecision) {
  for (const int segments : {1, 2, 3, 5}) {
    const ArmDescription arm = sample_arm(segments);
    for (const ForwardModel& model : models_of(arm, GetParam())) {
      for (const int count : {1, 3, 7, 65, 131}) {
        const Queries queries = random_queries(arm, count, 17);
        const MatrixXd wanted =
            reference(arm, model.has_network() ? &model.compensation() : nullptr, queries);
        const double error =
            (answers_of(model, queries).cast<double>() - wanted).cwiseAbs().maxCoeff();
        const bool gated =
            model.has_network() &&
            (model.compensation().form == OutputForm::gated_change || model.reads_velocity());
        EXPECT_LT(error, (gated ? kGatedRelativeToLength : kRelativeToLength) * arm.length_m())
            << segments << " segments, " << count << " queries, "
            << (model.has_network() ? to_string(model.compensation().layout) : "no load");
      }
    }
  }
}

TEST_P(ForwardModelOfLevel, AgreesForArmsOfOtherCommands) {
  for (const NoLoadKind kind : {NoLoadKind::curvature, NoLoadKind::straight}) {
    ArmDescription arm = sample_arm(3);
    arm.command = {"motor angle", "deg"};
    arm.no_load = kind;
    arm.segments[0].curvature_per_unit = 0.1;
    arm.segments[1].curvature_per_unit = -0.07;
    arm.segments[2].curvature_per_unit = 1e-5;  // nearly straight: the series
    const Queries queries = random_queries(arm, 70, 9);
    for (const ForwardModel& model : models_of(arm, GetParam())) {
      const CompensationModel* network = model.has_network() ? &model.compensation() : nullptr;
      const MatrixXd difference =
          answers_of(model, queries).cast<double>() - reference(arm, network, queries);
      EXPECT_LT(difference.cwiseAbs().maxCoeff(), kRelativeToLength * arm.length_m() * 10);
    }
  }
}

TEST_P(ForwardModelOfLevel, QueryIsTheSameToTheBitAloneAndAnywhereInABatch) {
  const ArmDescription arm = sample_arm(3);
  const Queries queries = random_queries(arm, 150, 23);
  for (const ForwardModel& model : models_of(arm, GetParam())) {
    const MatrixXf together = answers_of(model, queries);
    ForwardModel::Workspace workspace;
    for (int j = 0; j < 150; ++j) {
      Backbone alone(arm.point_count(), 3);
      const auto backbone_of = [&](const MatrixXf& backbones) {
        return Backbone(Eigen::Map<const Backbone>(backbones.col(j).data(), arm.point_count(), 3));
      };
      model.step(queries.previous_kpa.col(j), queries.current_kpa.col(j),
                 backbone_of(queries.before), backbone_of(queries.previous), alone, workspace);
      EXPECT_TRUE(Eigen::Map<Eigen::VectorXf>(alone.data(), alone.size()) == together.col(j))
          << "query " << j;
    }
    for (const int from : {1, 13, 120}) {
      for (const int count : {2, 3, 5, 12, 13, 17, 30}) {
        const Queries part = {queries.previous_kpa.middleCols(from, count),
                              queries.current_kpa.middleCols(from, count),
                              queries.previous.middleCols(from, count),
                              queries.before.middleCols(from, count)};
        EXPECT_TRUE(answers_of(model, part) == together.middleCols(from, count))
            << count << " queries from " << from;
      }
    }
  }
}

TEST_P(ForwardModelOfLevel, AnswersMayReplaceTheQuestions) {
  const ArmDescription arm = sample_arm(3);
  const Queries queries = random_queries(arm, 70, 29);
  for (const ForwardModel& model : models_of(arm, GetParam())) {
    const MatrixXf wanted = answers_of(model, queries);
    ForwardModel::Workspace workspace;
    MatrixXf in_place = queries.previous;
    model.step_batch(queries.previous_kpa, queries.current_kpa, queries.before, in_place, in_place,
                     workspace);
    EXPECT_TRUE(in_place == wanted);
    in_place = queries.before;
    model.step_batch(queries.previous_kpa, queries.current_kpa, in_place, queries.previous,
                     in_place, workspace);
    EXPECT_TRUE(in_place == wanted);
  }
}

TEST_P(ForwardModelOfLevel, RolloutFeedsItsAnswersBack) {
  const ArmDescription arm = sample_arm(2);
  const MatrixXf pressures = random_queries(arm, 9, 31).current_kpa;
  for (const ForwardModel& model : models_of(arm, GetParam())) {
    MatrixXf backbones = MatrixXf::Zero(3 * arm.point_count(), 9);
    ForwardModel::Workspace workspace;
    model.rollout(pressures, backbones, workspace);
    for (int t = 1; t < 9; ++t) {
      const Queries step = {pressures.col(t - 1), pressures.col(t), backbones.col(t - 1),
                            backbones.col(std::max(t - 2, 0))};
      EXPECT_TRUE(answers_of(model, step) == backbones.col(t)) << "frame " << t;
    }
  }
}

TEST(ForwardModel, WorkspaceServesModelsOfAnySizeInTurn) {
  const ArmDescription small = sample_arm(1);
  const ArmDescription large = sample_arm(5);
  const ForwardModel first(small, untrained_model(small, BackboneLayout::gap_poses, {8}, 1));
  const ForwardModel second(large, untrained_model(large, BackboneLayout::gap_poses, {200}, 1));
  const Queries few = random_queries(small, 5, 1);
  const Queries many = random_queries(large, 5, 1);
  const MatrixXf wanted = answers_of(first, few);  // which reads no change
  ForwardModel::Workspace workspace;
  MatrixXf large_answers(many.previous.rows(), 5);
  second.step_batch(many.previous_kpa, many.current_kpa, many.previous, large_answers, workspace);
  MatrixXf answers(few.previous.rows(), 5);
  first.step_batch(few.previous_kpa, few.current_kpa, few.previous, answers, workspace);
  EXPECT_TRUE(answers == wanted);
}

TEST(ForwardModel, CheckedStepGivesWhatStepGives) {
  const ArmDescription arm = sample_arm(3);
  const ForwardModel model(arm, untrained_model(arm, BackboneLayout::gap_poses, {100}, 1,
                                                OutputForm::gated_change, true));
  Queries query = random_queries(arm, 1, 37);
  const int points = arm.point_count();
  const Backbone previous = Eigen::Map<const Backbone>(query.previous.data(), points, 3);
  const Backbone before = Eigen::Map<const Backbone>(query.before.data(), points, 3);
  const auto answer = [](const Backbone& next) {
    return MatrixXf(Eigen::Map<const MatrixXf>(next.data(), next.size(), 1));
  };
  const Pressures from = query.previous_kpa.col(0);
  const Pressures to = query.current_kpa.col(0);
  const MatrixXf moving = answers_of(model, query);
  EXPECT_TRUE(answer(model.checked_step(from, to, before, previous)) == moving);
  query.before = query.previous;
  const MatrixXf still = answers_of(model, query);
  EXPECT_TRUE(answer(model.checked_step(from, to, previous)) == still);
  EXPECT_GT((moving - still).cwiseAbs().maxCoeff(), 1e-4F) << "the change is read";
}

TEST(ForwardModel, CheckedStepNamesWhatIsWrong) {
  const ArmDescription arm = sample_arm(3);
  const ForwardModel model(arm);
  const Pressures fine = Pressures::Zero(3);
  Backbone straight(16, 3);
  straight.setZero();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(
      [&] { (void)model.checked_step(Pressures::Zero(4), fine, straight); },
      ThrowsMessage<InputError>(HasSubstr("previous_kpa: 4 pressures; the arm has 3 segments")));
  EXPECT_THAT(
      [&] { (void)model.checked_step(fine, Eigen::Vector3f(0, 0, 111), straight); },
      ThrowsMessage<InputError>(HasSubstr(
          "current_kpa[2] = 111 kPa; expected -110 to 110 kPa, the segment's limits of ± 100 kPa "
          "and 5 % of their range for overshoot")));
  EXPECT_NO_THROW((void)model.checked_step(fine, Eigen::Vector3f(0, -110, 108), straight))
      << "as starts in motion are read";
  EXPECT_THAT([&] { (void)model.checked_step(fine, Eigen::Vector3f(0, nan, 0), straight); },
              ThrowsMessage<InputError>(HasSubstr("current_kpa[1] = nan kPa")));
  EXPECT_THAT([&] { (void)model.checked_step(fine, fine, Backbone::Zero(15, 3)); },
              ThrowsMessage<InputError>(HasSubstr("previous: 15 points; the arm has 16")));
  straight(7, 1) = std::numeric_limits<float>::infinity();
  EXPECT_THAT([&] { (void)model.checked_step(fine, fine, straight); },
              ThrowsMessage<InputError>(HasSubstr("previous[7] = (0, inf, 0)")));
}

TEST(ForwardModel, RefusesAModelOfAnotherArm) {
  ArmDescription arm = sample_arm(3);
  const CompensationModel model = untrained_model(arm, BackboneLayout::gap_poses, {10}, 1);
  arm.name = "longer";
  arm.segments[1].length_m += 0.01;
  EXPECT_THAT([&] { ForwardModel(arm, model); },
              ThrowsMessage<InputError>(
                  testing::AllOf(HasSubstr("trained for arm 'sample3'"), HasSubstr("arm 'longer'"),
                                 HasSubstr(model.arm_hash), HasSubstr(arm.hash()))));
}

}  // namespace
}  // namespace limber
