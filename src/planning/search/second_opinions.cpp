#include "second_opinions.hpp"

#include <algorithm>

#include "limber/common/mapped.hpp"

namespace limber {

SecondOpinions::Other::Other(const PlanningProblem& problem, int member,
                             const CollisionChecker& checker)
    : forward(problem.arm, problem.model.compensation().member(member)),
      simulator(problem.arm, MotionModel(forward, problem.model.valves()), checker) {}

SecondOpinions::SecondOpinions(const PlanningProblem& problem, const CollisionChecker& checker)
    : problem_(problem), start_(start_of(problem)) {
  const int members = problem.model.has_network() ? problem.model.compensation().member_count() : 1;
  for (int member = 1; member < members; ++member) {
    others_.push_back(std::make_unique<Other>(problem, member, checker));
  }
}

bool SecondOpinions::agree(const std::vector<Pressures>& waypoints_kpa) {
  const PoseGoal& goal = problem_.environment.goal;
  return std::all_of(others_.begin(), others_.end(), [&](const std::unique_ptr<Other>& other) {
    MotionState state = start_;
    for (std::size_t i = 1; i < waypoints_kpa.size(); ++i) {
      if (!other->simulator.move(state, waypoints_kpa[i], state)) {
        return false;
      }
    }
    return other->simulator.hold(state, state) &&
           is_within(goal, pose_error(goal, tip_pose(state.backbone)));
  });
}

std::uint64_t SecondOpinions::queries() const {
  return sum_of<std::uint64_t>(
      others_, [&](const std::unique_ptr<Other>& other) { return other->simulator.queries(); });
}

}  // namespace limber
