#include "src/planning/pressure_tree.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "limber/network/untrained_model.hpp"
#include "planning/random_shapes.hpp"

namespace limber {
namespace {

class PressureTrees : public ::testing::Test {
 protected:
  MotionState random_state() {
    Backbone b = start_.backbone;
    for (Eigen::Index i = 1; i < b.rows(); ++i) {
      b(i, 1) += static_cast<float>(random_.uniform(-0.01, 0.01));
    }
    const Pressures kpa = random_pressures(arm_, random_);
    return model_.moving_state(model_.valves().settled_state(kpa), b, 0.9F * b);
  }

  /// A tree of random parents, and who they are.
  std::vector<int> grow(int count) {
    std::vector<int> parents{-1};
    states_.push_back(random_state());
    tree_.add(states_.back(), -1, 0.0);
    for (int i = 1; i < count; ++i) {
      parents.push_back(static_cast<int>(random_.index(static_cast<std::uint32_t>(i))));
      states_.push_back(random_state());
      EXPECT_EQ(tree_.add(states_.back(), parents.back(), double(i)), i);
    }
    return parents;
  }

  std::vector<int> children(int i) const {
    std::vector<int> found;
    tree_.visit_children(i, [&](int child) { found.push_back(child); });
    std::sort(found.begin(), found.end());
    return found;
  }

  void expect_parents(const std::vector<int>& parents) const {
    for (int i = 0; i < tree_.size(); ++i) {
      EXPECT_EQ(tree_.parent(i), parents[static_cast<std::size_t>(i)]);
      std::vector<int> expected;
      for (int k = 0; k < tree_.size(); ++k) {
        if (parents[static_cast<std::size_t>(k)] == i) {
          expected.push_back(k);
        }
      }
      EXPECT_EQ(children(i), expected) << "node " << i;
    }
  }

  RandomStream random_{1, 1};
  ArmDescription arm_ = three_segment_arm();
  // It reads velocities, so that a state has everything that one can have.
  ForwardModel forward_{arm_, untrained_model(arm_, BackboneLayout::gap_poses, {8}, 1,
                                              OutputForm::gated_change, true)};
  MotionModel model_{forward_};
  ArmStart start_ = start_state(Environment{}, arm_);
  PressureTree tree_{model_};
  std::vector<MotionState> states_;
};

TEST_F(PressureTrees, GivesBackWhatWasAdded) {
  const std::vector<int> parents = grow(200);
  expect_parents(parents);
  for (int i = 0; i < tree_.size(); ++i) {
    const MotionState& state = states_[static_cast<std::size_t>(i)];
    EXPECT_TRUE(tree_.state(i) == state);
    EXPECT_EQ(Pressures(tree_.setpoint_kpa(i)), Pressures(state.setpoint_kpa()));
    EXPECT_EQ(tree_.cost_kpa(i), double(i));
    const Pose tip = model_.settled_tip(state.valves, state.backbone);
    EXPECT_EQ(tree_.settled_tip(i).x_m, tip.x_m);
    EXPECT_EQ(tree_.settled_tip(i).theta_rad, tip.theta_rad);
  }
}

TEST_F(PressureTrees, PathsLeadFromTheRootByParents) {
  const std::vector<int> parents = grow(100);
  for (int i = 0; i < tree_.size(); ++i) {
    const std::vector<int> nodes = tree_.nodes_to(i);
    const std::vector<Pressures> path = tree_.path_to(i);
    ASSERT_EQ(nodes.size(), path.size());
    EXPECT_EQ(nodes.front(), 0);
    EXPECT_EQ(nodes.back(), i);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      EXPECT_EQ(path[k], Pressures(tree_.setpoint_kpa(nodes[k])));
      EXPECT_EQ(k == 0 ? -1 : nodes[k - 1], parents[static_cast<std::size_t>(nodes[k])]);
    }
  }
}

TEST_F(PressureTrees, AfterAnyRehangingEveryNodeHangsOnce) {
  std::vector<int> parents = grow(60);
  for (int k = 0; k < 500; ++k) {
    const int node = 1 + static_cast<int>(random_.index(59));
    const auto parent = static_cast<int>(random_.index(60));
    const std::vector<int> above = tree_.nodes_to(parent);
    if (std::find(above.begin(), above.end(), node) != above.end()) {
      continue;  // below it, or itself
    }
    tree_.set_parent(node, parent);
    parents[static_cast<std::size_t>(node)] = parent;
  }
  expect_parents(parents);
}

TEST_F(PressureTrees, AnotherStateReplacesANodesAndNoOthers) {
  grow(20);
  const MotionState other = random_state();
  tree_.set_state(7, other);
  for (int i = 0; i < tree_.size(); ++i) {
    EXPECT_TRUE(tree_.state(i) == (i == 7 ? other : states_[static_cast<std::size_t>(i)]));
  }
  EXPECT_EQ(tree_.settled_tip(7).y_m, model_.settled_tip(other.valves, other.backbone).y_m);
}

}  // namespace
}  // namespace limber
