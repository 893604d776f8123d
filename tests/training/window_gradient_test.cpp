#include "limber/training/window_gradient.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "src/training/training_tables.hpp"
#include "support/narrow_bounds.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

// Central differences of step 1e-6 in double: rounding 1e-10 of the loss, truncation below that.
constexpr double kDifferenceStep = 1e-6;
constexpr double kDifferenceTolerance = 1e-6;
// Both sides compute in double, in another order of summation.
constexpr double kPyTorchTolerance = 1e-12;
// float32 sums of a thousand terms.
constexpr double kSinglePrecisionTolerance = 2e-4;

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

FrameTable<double> in_double(const FrameTable<float>& frames) {
  return {frames.pressure.cast<double>(),      frames.no_load.cast<double>(),
          frames.uncompensated.cast<double>(), frames.state.cast<double>(),
          frames.target.cast<double>(),        frames.tracked,
          frames.change.cast<double>()};
}

StateMap<double> in_double(const StateMap<float>& map) {
  return {map.output_scale.cast<double>(), map.error.cast<double>(), map.form,
          map.bounds.cast<double>(), map.change_scale.cast<double>()};
}

TrainingSettings settings_for(BackboneLayout layout, bool error_in_base_poses, Scaling scaling,
                              OutputForm form = OutputForm::compensation) {
  TrainingSettings settings;
  settings.layout = layout;
  settings.form = form;
  settings.error_in_base_poses = error_in_base_poses;
  settings.scaling = scaling;
  return settings;
}

/// Of parameter i.
void expect_difference(const Vector& gradient, Eigen::Index i, Vector& parameters,
                       WindowGradient<double>& window) {
  const double value = parameters[i];
  parameters[i] = value + kDifferenceStep;
  const double above = window.forward(parameters.data());
  parameters[i] = value - kDifferenceStep;
  const double below = window.forward(parameters.data());
  parameters[i] = value;
  EXPECT_NEAR(gradient[i], (above - below) / (2 * kDifferenceStep),
              kDifferenceTolerance * (1.0 + std::abs(gradient[i])))
      << "parameter " << i;
}

class GradientInLayout
    : public testing::TestWithParam<std::tuple<BackboneLayout, bool, OutputForm, bool, bool>> {};

TEST_P(GradientInLayout, AgreesWithFiniteDifferencesOverAWholeWindow) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = settings_for(std::get<0>(GetParam()), std::get<1>(GetParam()),
                                           Scaling::unit_range, std::get<2>(GetParam()));
  settings.reads_velocity = std::get<4>(GetParam());
  TrainingTables tables = make_training_tables(arm, {toy_episode(arm, 4, 20, 3)}, settings);
  if (std::get<3>(GetParam())) {
    set_bounds(tables, settings, narrow_bounds(arm));
    tables.map.bounds.lead_back = false;
  }
  const int inputs = static_cast<int>(tables.input.scale.size());
  const int outputs = tables.map.output_count();
  const ParameterLayout layout({inputs, 9, 8, outputs});
  Vector parameters = (0.3 * initial_parameters(layout, 5)).cast<double>();
  const FrameTable<double> frames = in_double(tables.frames);
  WindowGradient<double> window(layout, in_double(tables.map), arm.segment_count(), 7, 3);
  const std::vector<int> starts = {2, 20, 45};
  window.load(frames, starts);

  Vector gradient(layout.size());
  window.forward(parameters.data());
  window.backward(parameters.data(), gradient.data());
  ASSERT_GT(gradient.norm(), 1e-3);
  for (Eigen::Index i = 0; i < layout.size(); i += 3) {
    expect_difference(gradient, i, parameters, window);
  }
}

INSTANTIATE_TEST_SUITE_P(
    BothLayouts, GradientInLayout,
    testing::Combine(testing::Values(BackboneLayout::base_poses, BackboneLayout::gap_poses),
                     testing::Bool(),
                     testing::Values(OutputForm::compensation, OutputForm::gated_change),
                     testing::Bool(), testing::Bool()));

// Windows of three arms, one arm in two of them: each arm's vector gets what its windows give.
TEST(WindowGradient, OfTheVectorsOfAFamilysArmsAgreesWithFiniteDifferences) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings;
  settings.reads_velocity = true;
  TrainingTables tables = make_training_tables(arm, {toy_episode(arm, 4, 20, 3)}, settings);
  FrameTable<double> frames = in_double(tables.frames);
  const std::vector<int> starts = {2, 20, 45, 60};
  frames.arm.assign(static_cast<std::size_t>(frames.state.cols()), 0);
  frames.arm[20] = 2;
  frames.arm[45] = 1;
  frames.arm[60] = 2;
  constexpr int kSize = 3;
  const ParameterLayout layout(
      {static_cast<int>(tables.input.scale.size()), 9, 8, tables.map.output_count()}, {kSize, 4});
  Vector parameters = (0.3 * initial_parameters(layout, 5)).cast<double>();
  for (Eigen::Index i = layout.modulation_offset(0); i < layout.arm_offset(0); ++i) {
    parameters[i] = 0.3 * std::sin(double(i));  // gains and shifts of both hidden layers
  }
  WindowGradient<double> window(layout, in_double(tables.map), arm.segment_count(), 7, 4);
  window.load(frames, starts);
  Vector gradient(layout.size());
  window.forward(parameters.data());
  window.backward(parameters.data(), gradient.data());
  EXPECT_GT(gradient.segment(layout.arm_offset(0), 3 * kSize).cwiseAbs().minCoeff(), 1e-6);
  EXPECT_TRUE(gradient.tail(kSize).isZero(0.0)) << "of an arm without a window";
  for (Eigen::Index i = 0; i < layout.size(); i += i < layout.arm_offset(0) - 7 ? 7 : 1) {
    expect_difference(gradient, i, parameters, window);
  }
}

/// A network of large weights, which amplifies whatever it is told.
struct Amplifier {
  ArmDescription arm = three_segment_arm();
  TrainingSettings settings = [] {
    TrainingSettings result;
    result.reads_velocity = true;
    return result;
  }();
  TrainingTables tables = make_training_tables(arm, {toy_episode(arm, 4, 20, 3)}, settings);
  ParameterLayout layout{
      {static_cast<int>(tables.input.scale.size()), 20, 20, tables.map.output_count()}};
  Vector parameters = (2.5 * initial_parameters(layout, 5)).cast<double>();

  Vector gradient(const std::vector<int>& starts, double growth_limit) const {
    StateMap<double> map = in_double(tables.map);
    map.growth_limit = growth_limit;
    WindowGradient<double> window(layout, map, arm.segment_count(), 16, 4);
    window.load(in_double(tables.frames), starts);
    window.forward(parameters.data());
    Vector result(layout.size());
    window.backward(parameters.data(), result.data());
    return result;
  }
};

TEST(WindowGradient, WhatGrowsOnItsWayBackIsShortened) {
  const Amplifier amplifier;
  const double free = amplifier.gradient({2, 30}, 0.0).norm();
  EXPECT_EQ(amplifier.gradient({2, 30}, 1e100), amplifier.gradient({2, 30}, 0.0));
  const double kept = amplifier.gradient({2, 30}, 1.5).norm();
  EXPECT_GT(free, 10.0 * kept) << "it amplifies";
  EXPECT_GT(kept, 0.0);
  EXPECT_LT(amplifier.gradient({2, 30}, 0.1).norm(), kept);
}

// A window that has run away leaves the others' gradients as they are.
TEST(WindowGradient, EachWindowIsShortenedByItself) {
  const Amplifier amplifier;
  const Vector sum = amplifier.gradient({2}, 1.5) + amplifier.gradient({30}, 1.5);
  const Vector together = amplifier.gradient({2, 30}, 1.5);
  EXPECT_LT((together - sum).norm(), 1e-9 * sum.norm());
}

// With the errors E_k of one frame each: (E_0 + E_1) / 2 where all count alike, with power 1
// (E_0 + E_1 / 2) / (1 + 1 / 2).
TEST(WindowGradient, FirstFramesCountMoreByTheirPower) {
  const Amplifier some;
  const auto loss = [&](int frames, double power) {
    StateMap<double> map = in_double(some.tables.map);
    map.first_frames_power = power;
    WindowGradient<double> window(some.layout, map, some.arm.segment_count(), frames, 4);
    window.load(in_double(some.tables.frames), std::vector<int>{2, 30});
    return window.forward(some.parameters.data());
  };
  const double first = loss(1, 0.0);
  const double second = 2.0 * loss(2, 0.0) - first;
  EXPECT_DOUBLE_EQ(loss(1, 1.0), first);
  EXPECT_NEAR(loss(2, 1.0), (first + second / 2.0) / 1.5, 1e-12 * (first + second));
}

struct PyTorchCase {
  nlohmann::json values =
      nlohmann::json::parse(std::ifstream(LIMBER_TEST_DATA_DIR "/pytorch_gradients.json"));

  Vector vector(const char* key) const {
    const auto numbers = values.at(key).get<std::vector<double>>();
    return Eigen::Map<const Vector>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  }
  Matrix matrix(const char* key, Eigen::Index rows) const {
    const Vector numbers = vector(key);
    return numbers.reshaped(rows, numbers.size() / rows);
  }
  FrameTable<double> frames() const {
    const Eigen::Index state = vector("output_scale").size();
    const auto widths = values.at("widths").get<std::vector<int>>();
    const Eigen::Index segments = values.at("segments").get<int>();
    return {matrix("pressure", segments),
            matrix("no_load", widths[0] - 2 * segments - state),
            matrix("uncompensated", state),
            matrix("state", state),
            {},
            {}};
  }
};

TEST(WindowGradient, EqualsPyTorchs) {
  const PyTorchCase stored;
  const ParameterLayout layout(stored.values.at("widths").get<std::vector<int>>());
  const auto starts = stored.values.at("starts").get<std::vector<int>>();
  WindowGradient<double> window(
      layout, {stored.vector("output_scale"), FrameError<double>(stored.vector("loss_weight"))},
      stored.values.at("segments"), stored.values.at("window_frames"), 5);
  window.load(stored.frames(), starts);
  const Vector parameters = stored.vector("parameters");
  Vector gradient(layout.size());
  EXPECT_NEAR(window.forward(parameters.data()), stored.values.at("loss"), kPyTorchTolerance * 100);
  window.backward(parameters.data(), gradient.data());
  const Vector expected = stored.vector("gradient");
  EXPECT_LT((gradient - expected).lpNorm<Eigen::Infinity>(),
            kPyTorchTolerance * expected.lpNorm<Eigen::Infinity>());
}

class SinglePrecision
    : public testing::TestWithParam<std::tuple<OutputForm, BackboneLayout, bool>> {};

TEST_P(SinglePrecision, FollowsDouble) {
  const ArmDescription arm = three_segment_arm();
  const TrainingSettings settings =
      settings_for(std::get<1>(GetParam()), true, Scaling::unit_spread, std::get<0>(GetParam()));
  TrainingTables tables = make_training_tables(arm, {toy_episode(arm, 4, 20, 3)}, settings);
  if (std::get<2>(GetParam())) {
    set_bounds(tables, settings, narrow_bounds(arm));
  }
  const ParameterLayout layout(
      {static_cast<int>(tables.input.scale.size()), 100, 100, 100, tables.map.output_count()});
  const Eigen::VectorXf parameters = initial_parameters(layout, 5);
  const Vector exact = parameters.cast<double>();
  const std::vector<int> starts = {2, 20, 45};
  WindowGradient<float> single(layout, tables.map, arm.segment_count(), 7, 3);
  WindowGradient<double> reference(layout, in_double(tables.map), arm.segment_count(), 7, 3);
  single.load(tables.frames, starts);
  reference.load(in_double(tables.frames), starts);
  Eigen::VectorXf gradient(layout.size());
  Vector expected(layout.size());
  const double loss = reference.forward(exact.data());
  EXPECT_NEAR(single.forward(parameters.data()), loss, kSinglePrecisionTolerance * loss);
  single.backward(parameters.data(), gradient.data());
  reference.backward(exact.data(), expected.data());
  EXPECT_LT((gradient.cast<double>() - expected).norm(),
            kSinglePrecisionTolerance * expected.norm());
}

INSTANTIATE_TEST_SUITE_P(
    BothForms, SinglePrecision,
    testing::Combine(testing::Values(OutputForm::compensation, OutputForm::gated_change),
                     testing::Values(BackboneLayout::base_poses, BackboneLayout::gap_poses),
                     testing::Bool()));

TEST(WindowGradient, AWindowDoesNotDependOnItsNeighbours) {
  const PyTorchCase stored;
  const ParameterLayout layout(stored.values.at("widths").get<std::vector<int>>());
  const StateMap<double> map{stored.vector("output_scale"),
                             FrameError<double>(stored.vector("loss_weight"))};
  const Vector parameters = stored.vector("parameters");
  const FrameTable<double> frames = stored.frames();
  WindowGradient<double> window(layout, map, 2, 6, 3);
  const auto loss_of = [&](std::vector<int> starts) {
    window.load(frames, starts);
    return window.forward(parameters.data());
  };
  EXPECT_NEAR(loss_of({0, 7, 14}), loss_of({0}) + loss_of({7}) + loss_of({14}), 1e-12);
}

// More windows than one group holds, the last group partly filled.
TEST(WindowGradient, GroupsOfWindowsAddUp) {
  const ArmDescription arm = three_segment_arm();
  const TrainingTables tables =
      make_training_tables(arm, {toy_episode(arm, 20, 20, 3)},
                           settings_for(BackboneLayout::gap_poses, true, Scaling::unit_spread));
  const ParameterLayout layout({static_cast<int>(tables.input.scale.size()), 20,
                                static_cast<int>(tables.output.scale.size())});
  const Eigen::VectorXf parameters = initial_parameters(layout, 5);
  const std::vector<int> starts = window_starts(tables.episodes, {}, 5, 0);
  ASSERT_EQ(starts.size(), 80U);
  WindowGradient<float> together(layout, tables.map, 3, 5, 80);
  WindowGradient<float> alone(layout, tables.map, 3, 5, 1);
  together.load(tables.frames, starts);
  const double loss = together.forward(parameters.data());
  Eigen::VectorXf gradient(layout.size());
  together.backward(parameters.data(), gradient.data());
  double sum = 0.0;
  Vector expected = Vector::Zero(layout.size());
  for (const int start : starts) {
    Eigen::VectorXf part(layout.size());
    alone.load(tables.frames, std::vector<int>{start});
    sum += alone.forward(parameters.data());
    alone.backward(parameters.data(), part.data());
    expected += part.cast<double>();
  }
  EXPECT_NEAR(loss, sum, kSinglePrecisionTolerance * sum);
  EXPECT_LT((gradient.cast<double>() - expected).norm(),
            kSinglePrecisionTolerance * expected.norm());
}

// What stands in a frame that was not tracked is a guess: no guess may reach loss or gradient.
TEST(WindowGradient, UnseenFramesCountNothing) {
  const PyTorchCase stored;
  const ParameterLayout layout(stored.values.at("widths").get<std::vector<int>>());
  const StateMap<double> map{stored.vector("output_scale"),
                             FrameError<double>(stored.vector("loss_weight"))};
  const Vector parameters = stored.vector("parameters");
  FrameTable<double> frames = stored.frames();
  WindowGradient<double> window(layout, map, 2, 6, 3);
  const auto evaluate = [&](Vector& gradient) {
    window.load(frames, std::vector<int>{0, 7});
    const double loss = window.forward(parameters.data());
    window.backward(parameters.data(), gradient.data());
    return loss;
  };
  Vector all(layout.size());
  const double whole = evaluate(all);
  frames.tracked.assign(static_cast<std::size_t>(frames.state.cols()), 1);
  frames.tracked[3] = 0;
  frames.tracked[13] = 0;
  Vector some(layout.size());
  const double partial = evaluate(some);
  EXPECT_NE(partial, whole);
  frames.state.col(3).setConstant(50.0);
  frames.state.col(13).setConstant(-50.0);
  Vector other(layout.size());
  EXPECT_EQ(evaluate(other), partial);
  EXPECT_EQ(other, some);

  // A window's error is the mean over the frames seen: five of six here.
  frames = stored.frames();
  double sum = 0.0;
  for (const int length : {2, 3, 6}) {
    WindowGradient<double> part(layout, map, 2, length, 1);
    part.load(frames, std::vector<int>{0});
    sum += (length == 3 ? -1.0 : 1.0) * length * part.forward(parameters.data());
  }
  frames.tracked.assign(static_cast<std::size_t>(frames.state.cols()), 1);
  frames.tracked[3] = 0;
  window.load(frames, std::vector<int>{0});
  EXPECT_NEAR(window.forward(parameters.data()), sum / 5.0, 1e-12);
}

TEST(WindowGradient, PerfectOutputHasNoLossAndNoGradient) {
  const PyTorchCase stored;
  const ParameterLayout layout(stored.values.at("widths").get<std::vector<int>>());
  FrameTable<double> frames = stored.frames();
  frames.state = frames.uncompensated;
  const Vector parameters = Vector::Zero(layout.size());
  WindowGradient<double> window(
      layout, {stored.vector("output_scale"), FrameError<double>(stored.vector("loss_weight"))}, 2,
      6, 3);
  window.load(frames, std::vector<int>{0, 7});
  EXPECT_EQ(window.forward(parameters.data()), 0.0);
  Vector gradient(layout.size());
  window.backward(parameters.data(), gradient.data());
  EXPECT_EQ(gradient.norm(), 0.0);
}

}  // namespace
}  // namespace limber
