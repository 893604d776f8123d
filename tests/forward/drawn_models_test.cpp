// Laws of networks drawn by a number, of arms in the plane and in space: their files, and what they
// predict.
#include <cstring>

#include <gmock/gmock.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "limber/network/untrained_model.hpp"
#include "network/sample_region.hpp"
#include "support/drawn_arm.hpp"
#include "support/property.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

constexpr float kRounding = 2e-5F;  // [m], [rad]; float32 over an arm of 2 m, of many turns
constexpr int kFrames = 6;
constexpr int kSlowerFiles = 2;
constexpr int kSlowerBatches = 5;

/// To the bit, whatever the numbers are.
bool are_same(const Eigen::MatrixXf& a, const Eigen::MatrixXf& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() &&
         (a.size() == 0 ||
          std::memcmp(a.data(), b.data(), std::size_t(a.size()) * sizeof(float)) == 0);
}

struct Drawn {
  RandomStream random;
  ArmDescription arm;
  CompensationModel model;

  Drawn(std::uint64_t number, bool in_space)
      : random(number, 0),
        arm(in_space ? drawn::space_arm(number, random) : drawn::arm(number, random)) {
    const bool of_base = !in_space && drawn::chance(random, 0.5);
    std::vector<int> hidden(1 + random.index(3));
    for (int& units : hidden) {
      units = 1 + int(random.index(20));
    }
    const bool is_gated = drawn::chance(random, 0.5);
    const bool reads_velocity = drawn::chance(random, 0.5);
    const std::vector<int> past =
        in_space && drawn::chance(random, 0.5) ? std::vector<int>{1, 3} : std::vector<int>{};
    const auto network = [&](std::uint64_t seed) {
      return untrained_model(
          arm, of_base ? BackboneLayout::base_poses : BackboneLayout::gap_poses, hidden, seed,
          is_gated ? OutputForm::gated_change : OutputForm::compensation, reads_velocity, past);
    };
    model = network(number);
    for (std::uint64_t more = random.index(3); more > 0; --more) {
      model.more_members.push_back(network(number + more).layers);
    }
  }

  /// About every gap at rest, so narrow that shapes would leave them.
  void add_bounds() {
    const int gaps = arm.point_count() - 1;
    GapBounds bounds{Eigen::VectorXf(gaps), Eigen::VectorXf(gaps), Eigen::VectorXf(gaps),
                     Eigen::VectorXf(gaps)};
    for (int g = 0; g < gaps; ++g) {
      const Segment& segment = arm.segments[std::size_t(arm.segment_of_gap(g))];
      const double rest = segment.length_m / segment.gaps;
      bounds.min_length_m[g] = float(random.uniform(0.9, 0.98) * rest);
      bounds.max_length_m[g] = float(random.uniform(0.985, 1.01) * rest);
      bounds.min_turn_rad[g] = float(random.uniform(-0.5, -0.05));
      bounds.max_turn_rad[g] = float(random.uniform(0.05, 0.5));
    }
    if (arm.is_spatial()) {
      bounds.max_bend_rad = Eigen::VectorXf::Constant(gaps, 0.4F);
    }
    model.bounds = bounds;
  }

  void add_findings() {
    model.training = {{"seed", drawn_text()}, {"data", drawn_text()}};
    model.prediction_error = PredictionError{1 + int(random.index(1000)), random.uniform(0.1, 9.0),
                                             random.uniform(0.0, 0.1),    random.uniform(0.0, 0.1),
                                             random.uniform(0.0, 0.1),    random.uniform(0.0, 1.0)};
    Tube tube;
    for (int p = 0; p < arm.point_count(); ++p) {
      tube.plate_scale_m.push_back(random.uniform(1e-6, 0.1));
    }
    tube.end_scale_m = random.uniform(1e-6, 0.1);
    tube.end_heading_scale_rad = random.uniform(1e-6, 1.0);
    tube.growth = {random.uniform(0.01, 1.0), random.uniform(0.0, 0.5)};
    tube.source = drawn_text();
    for (double level = random.uniform(0.3, 0.6); level < 1.0; level += random.uniform(0.1, 0.3)) {
      const int runs = int(random.index(5000));
      tube.levels.push_back({level, random.uniform(0.1, 9.0), runs, runs / 7,
                             random.uniform(0.01, 0.99), runs / 2, runs / 9});
    }
    model.tube = tube;
    ValveParameters valves;
    for (int i = 0; i < arm.channel_count(); ++i) {
      valves.segments.push_back({{random.uniform(0.0, 0.2), random.uniform(20.0, 300.0)},
                                 {random.uniform(0.0, 0.2), random.uniform(20.0, 300.0)},
                                 random.uniform(0.0, 0.2),
                                 random.uniform(0.0, 3.0)});
    }
    model.set_valves({valves, {}});
    if (!arm.is_spatial()) {
      model.learnt = sample_region(arm.segment_count(), arm.point_count(), 4);
    }
  }

  Eigen::MatrixXf commands(int frames) {
    Eigen::MatrixXf kpa(arm.channel_count(), frames);
    for (int k = 0; k < frames; ++k) {
      kpa.col(k) = drawn::pressures(arm, random);
    }
    return kpa;
  }

  Eigen::MatrixXf rollout(const CompensationModel& network, const Eigen::MatrixXf& kpa) const {
    const int size = arm.point_count() * pose_size(arm.dimension);
    Eigen::MatrixXf shapes = Eigen::MatrixXf::Zero(size, kpa.cols());
    Eigen::VectorXf start(size);
    NoLoadModel(arm).poses(kpa.col(0), start);
    shapes.col(0) = start;
    ForwardModel::Workspace workspace;
    ForwardModel(arm, network).rollout(kpa, shapes, workspace);
    return shapes;
  }
};

void check_same_findings(const CompensationModel& a, const CompensationModel& b) {
  RC_ASSERT(a.training == b.training);
  RC_ASSERT(a.prediction_error == b.prediction_error);
  RC_ASSERT(a.tube == b.tube);
  RC_ASSERT(a.valves == b.valves);
  RC_ASSERT(a.learnt.has_value() == b.learnt.has_value());
  if (a.learnt) {
    RC_ASSERT(are_same(a.learnt->axes, b.learnt->axes));
    RC_ASSERT(are_same(a.learnt->joint_scale, b.learnt->joint_scale));
    RC_ASSERT(are_same(a.learnt->axis_high, b.learnt->axis_high));
    RC_ASSERT(are_same(a.learnt->joint_change, b.learnt->joint_change));
  }
  RC_ASSERT(a.bounds.has_value() == b.bounds.has_value());
  if (a.bounds) {
    RC_ASSERT(are_same(a.bounds->min_length_m, b.bounds->min_length_m));
    RC_ASSERT(are_same(a.bounds->max_turn_rad, b.bounds->max_turn_rad));
    RC_ASSERT(are_same(a.bounds->max_bend_rad, b.bounds->max_bend_rad));
  }
}

TEST(DrawnModels, FromTheirFilesTheyPredictTheSameToTheBit) {
  expect_law(
      "a model that is written and read is the model, and predicts what it predicted",
      [] {
        Drawn drawn(drawn_number(), *rc::gen::arbitrary<bool>());
        drawn.add_findings();
        if (drawn::chance(drawn.random, 0.5)) {
          drawn.add_bounds();
        }
        const TemporaryFolder folder;
        const auto path = folder.path() / "m.safetensors";
        write_model(path, drawn.model);
        const CompensationModel again = read_model(path);
        check_same_findings(drawn.model, again);
        const Eigen::MatrixXf kpa = drawn.commands(kFrames);
        RC_ASSERT(again.member_count() == drawn.model.member_count());
        for (int k = 0; k < again.member_count(); ++k) {
          RC_ASSERT(are_same(drawn.rollout(again.member(k), kpa),
                             drawn.rollout(drawn.model.member(k), kpa)));
        }
        const std::string written = read_file(path);
        write_model(path, again);
        RC_ASSERT(read_file(path) == written);
      },
      kSlowerFiles);
}

TEST(DrawnModels, PredictionsKeepTheirBounds) {
  expect_law("no gap of a prediction is longer, shorter or more bent than the bounds say", [] {
    Drawn drawn(drawn_number(), false);
    drawn.add_bounds();
    const GapBounds& bounds = *drawn.model.bounds;
    const Eigen::MatrixXf shapes = drawn.rollout(drawn.model, drawn.commands(kFrames));
    for (int k = 1; k < kFrames; ++k) {
      for (Eigen::Index g = 0; g < bounds.min_length_m.size(); ++g) {
        const Eigen::Vector3f step =
            shapes.col(k).segment<3>(3 * (g + 1)) - shapes.col(k).segment<3>(3 * g);
        RC_ASSERT(step.head<2>().norm() >= bounds.min_length_m[g] - kRounding);
        RC_ASSERT(step.head<2>().norm() <= bounds.max_length_m[g] + kRounding);
        RC_ASSERT(step[2] >= bounds.min_turn_rad[g] - kRounding);
        RC_ASSERT(step[2] <= bounds.max_turn_rad[g] + kRounding);
      }
    }
  });
}

TEST(DrawnModels, AnswersDoNotDependOnTheNumberOfThreads) {
  expect_law(
      "a batch split over threads is the batch",
      [] {
        Drawn drawn(drawn_number(), *rc::gen::arbitrary<bool>());
        const int queries = 1 + int(drawn.random.index(1500));
        const ForwardModel model(drawn.arm, drawn.model);
        const Eigen::MatrixXf before = model.told_commands(drawn.commands(queries));
        const Eigen::MatrixXf now = model.told_commands(drawn.commands(queries));
        Eigen::VectorXf pose(drawn.arm.point_count() * pose_size(drawn.arm.dimension));
        Eigen::MatrixXf previous(pose.size(), queries);
        for (int k = 0; k < queries; ++k) {
          model.no_load().poses(before.col(k).head(drawn.arm.channel_count()), pose);
          previous.col(k) = pose;
        }
        Eigen::MatrixXf wanted = Eigen::MatrixXf::Zero(pose.size(), queries);
        ForwardModel::Workspace workspace;
        model.step_batch(before, now, previous, wanted, workspace);
        for (const int jobs : {1, 2, 3}) {
          ParallelForward parallel(jobs);
          Eigen::MatrixXf answers = Eigen::MatrixXf::Zero(pose.size(), queries);
          parallel.step_batch(model, before, now, previous, answers);
          RC_ASSERT(are_same(answers, wanted));
        }
      },
      kSlowerBatches);
}

}  // namespace
}  // namespace limber
