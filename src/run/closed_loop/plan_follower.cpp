#include "plan_follower.hpp"

namespace limber {

void PlanFollower::forget() {
  feedback_.forget();
  off_plan_.setZero();
}

void PlanFollower::learn(const Backbone& planned, const Backbone& shape) {
  feedback_.learn(planned, shape);
  off_plan_ = shape - planned;
}

double PlanFollower::farthest_m() const {
  return double(off_plan_.leftCols<2>().rowwise().norm().maxCoeff());
}

}  // namespace limber
