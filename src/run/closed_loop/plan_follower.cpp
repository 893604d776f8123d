#include "plan_follower.hpp"

#include "limber/arm/plate_distance.hpp"

namespace limber {

void PlanFollower::forget() {
  feedback_.forget();
  off_plan_.setZero();
  farthest_m_ = 0.0;
}

void PlanFollower::learn(const Backbone& planned, const Backbone& shape) {
  feedback_.learn(planned, shape);
  off_plan_ = shape - planned;
  farthest_m_ = largest_plate_distance_m(shape, planned);
}

}  // namespace limber
