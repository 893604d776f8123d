#include "src/certificate/exact_arm.hpp"

#include <gmock/gmock.h>

#include "limber/common/cpu_level.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/network/untrained_model.hpp"
#include "planning/play_model.hpp"
#include "src/certificate/exact_network.hpp"
#include "src/certificate/frame_checks.hpp"
#include "support/narrow_bounds.hpp"

namespace limber {
namespace {

using ::testing::DoubleNear;
using ::testing::Pointwise;

constexpr double kFloatModelM = 2e-6;  // float32 forward model over a 0.7 m arm, one step
constexpr double kFloatModelRad = 2e-5;

std::vector<double> doubles(const Pressures& q) {
  return {q.begin(), q.end()};
}

/// With bounds or without, reading velocities or not.
class ExactArmOfKind : public testing::TestWithParam<std::tuple<bool, bool>> {};

TEST_P(ExactArmOfKind, AgreesWithTheForwardModelInEveryLayoutAndForm) {
  const ArmDescription arm = three_segment_arm();
  RandomStream random(1, 0);
  for (const auto& [layout, form] :
       {std::pair{BackboneLayout::base_poses, OutputForm::compensation},
        {BackboneLayout::base_poses, OutputForm::gated_change},
        {BackboneLayout::gap_poses, OutputForm::compensation},
        {BackboneLayout::gap_poses, OutputForm::gated_change}}) {
    CompensationModel model =
        untrained_model(arm, layout, {100, 100, 100}, 5, form, std::get<1>(GetParam()));
    if (std::get<0>(GetParam())) {
      model.bounds = narrow_bounds(arm);
    }
    const ForwardModel fast(arm, model);
    const ExactArm exact(arm, &fast.compensation());
    const NoLoadModel no_load(arm);
    ForwardModel::Workspace workspace;
    ExactNetwork::Workspace of_exact;
    for (int trial = 0; trial < 200; ++trial) {
      const Pressures before = random_pressures(arm, random);
      const Pressures now = random_pressures(arm, random);
      const Pressures of_shape = random_pressures(arm, random);
      const Backbone from = no_load_backbone(no_load, of_shape);
      const Backbone earlier = no_load_backbone(no_load, 0.9F * of_shape);
      Backbone to(arm.point_count(), 3);
      fast.step(before, now, earlier, from, to, workspace);
      const std::array<ExactArm::Shape, 2> shapes{shape_of(earlier), shape_of(from)};
      const ExactArm::Past past{&shapes[0], &shapes[1]};
      const ExactArm::Shape shape =
          exact.next_two(doubles(before), doubles(now), {past, past}, of_exact)[1];
      ASSERT_EQ(shape.size(), 16U);
      for (std::size_t i = 0; i < shape.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        EXPECT_NEAR(shape[i].x_m, to(row, 0), kFloatModelM) << trial << ' ' << i;
        EXPECT_NEAR(shape[i].y_m, to(row, 1), kFloatModelM) << trial << ' ' << i;
        EXPECT_NEAR(shape[i].theta_rad, to(row, 2), kFloatModelRad) << trial << ' ' << i;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BoundsAndChange, ExactArmOfKind,
                         testing::Combine(testing::Bool(), testing::Bool()));

// Valves overshoot: e = P(L) + max(0, P'(L)) (|p| − L) beyond the larger limit L, docs/model.md.
TEST(ExactArm, BeyondTheLimitStrainGoesOnAlongTheEndSlope) {
  constexpr double kRoundingRad = 1e-12;
  ArmDescription arm = three_segment_arm();  // P(100) = 0.2 and P'(100) = 3e-3 per kPa
  arm.segments[1].pressure_limit_kpa = {-60.0, 100.0};
  arm.segments[2].strain_polynomial = {2e-3, -1e-5, 0.0, -1e-11};  // 0.099, where it falls
  const ExactArm::Shape shape = ExactArm(arm, nullptr).no_load({110.0, -110.0, 110.0});
  EXPECT_NEAR(shape[5].theta_rad, -0.23 * 0.235 / 0.05, kRoundingRad);
  EXPECT_NEAR(shape[10].theta_rad - shape[5].theta_rad, 0.23 * 0.235 / 0.03, kRoundingRad);
  EXPECT_NEAR(shape[15].theta_rad - shape[10].theta_rad, -0.099 * 0.235 / 0.0172, kRoundingRad);
}

TEST(ExactArm, AgreesWithTheNoLoadModelAlsoBeyondTheLimits) {
  constexpr double kRounding = 1e-10;  // [m], [rad]; double over a 0.7 m arm, and its series
  const ArmDescription arm = three_segment_arm();
  const NoLoadModel fast(arm);
  const ExactArm exact(arm, nullptr);
  RandomStream random(7, 0);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::VectorXd kpa = 1.1 * random_pressures(arm, random).cast<double>();
    BackboneD expected(arm.point_count(), 3);
    fast.backbone(kpa, expected);
    const ExactArm::Shape shape = exact.no_load({kpa.begin(), kpa.end()});
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      EXPECT_NEAR(shape[i].x_m, expected(row, 0), kRounding) << trial << ' ' << i;
      EXPECT_NEAR(shape[i].y_m, expected(row, 1), kRounding) << trial << ' ' << i;
      EXPECT_NEAR(shape[i].theta_rad, expected(row, 2), kRounding) << trial << ' ' << i;
    }
  }
}

// Row by row and number by number, as docs/model.md has it.
TEST(ExactNetwork, AgreesWithPlainLoopsAndToTheBitOnEveryCpu) {
  constexpr double kRounding = 1e-13;
  const ArmDescription arm = three_segment_arm();
  RandomStream random(6, 0);
  for (const int width : {1, 7, 33, 100}) {
    const CompensationModel model = untrained_model(arm, BackboneLayout::gap_poses, {width, width},
                                                    9, OutputForm::gated_change);
    ExactNetwork::Workspace workspace;
    for (std::vector<double>& input : workspace.input) {
      for (Eigen::Index k = 0; k < model.input.scale.size(); ++k) {
        input.push_back(random.uniform(-1.0, 1.0));
      }
    }
    ExactNetwork(model, CpuLevel::baseline).run(workspace);
    const auto output = workspace.output;
    for (const CpuLevel level : available_cpu_levels()) {
      ExactNetwork(model, level).run(workspace);
      EXPECT_EQ(workspace.output, output) << to_string(level);
    }
    for (std::size_t c = 0; c < 2; ++c) {
      std::vector<double> values;
      for (Eigen::Index k = 0; k < model.input.scale.size(); ++k) {
        values.push_back(
            (workspace.input[c][static_cast<std::size_t>(k)] - double(model.input.offset[k])) *
            double(model.input.scale[k]));
      }
      for (const Layer& layer : model.layers) {
        std::vector<double> next;
        for (Eigen::Index row = 0; row < layer.weight.rows(); ++row) {
          double sum = double(layer.bias[row]);
          for (Eigen::Index k = 0; k < layer.weight.cols(); ++k) {
            sum += double(layer.weight(row, k)) * values[static_cast<std::size_t>(k)];
          }
          next.push_back(&layer == &model.layers.back() ? sum : std::max(sum, 0.0));
        }
        values = next;
      }
      for (Eigen::Index k = 0; k < model.output.scale.size(); ++k) {
        double& value = values[static_cast<std::size_t>(k)];
        value = value / double(model.output.scale[k]) + double(model.output.offset[k]);
      }
      EXPECT_THAT(output[c], Pointwise(DoubleNear(kRounding), values)) << width;
    }
  }
}

}  // namespace
}  // namespace limber
