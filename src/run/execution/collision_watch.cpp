#include "limber/run/collision_watch.hpp"

#include <algorithm>

#include "limber/arm/plate_distance.hpp"

namespace limber {

namespace {

constexpr double kSlackM = 1e-4;  // a tenth of what the checker itself may be off

double longest_gap(const ArmDescription& arm) {
  double longest = 0.0;
  for (const Segment& segment : arm.segments) {
    longest = std::max(longest, segment.length_m / segment.gaps);
  }
  constexpr double kExtension = 1.25;  // a side may be stretched; never by this much
  return kExtension * longest;
}

}  // namespace

CollisionWatch::CollisionWatch(const ArmDescription& arm, const Environment& environment)
    : checker_(arm, environment.obstacles), longest_gap_m_(longest_gap(arm)) {}

void CollisionWatch::observe(double time_s, const Eigen::Ref<const BackboneD>& backbone) {
  if (checker_.obstacle_count() == 0) {
    return;
  }
  if (closest_) {
    const double closest = closest_->clearance.value_m;
    const double still_certain =
        closest >= 0.0 ? std::max(0.0, closest - kSlackM) : closest - kSlackM;
    if (checked_value_m_ - max_motion_m(backbone) > still_certain) {
      return;
    }
  }
  ++checks_;
  const Contact contact{time_s, checker_.clearance(backbone)};
  checked_ = backbone;
  checked_value_m_ = contact.clearance.value_m;
  if (!closest_ || contact.clearance.value_m < closest_->clearance.value_m) {
    closest_ = contact;
  }
  if (!first_collision_ && contact.clearance.value_m < 0.0) {
    first_collision_ = contact;
  }
}

// No point of an arc between two plates moves farther than its plates do, twice over where they
// move apart (its bulge turns with the chord), plus 0.3 of the chord per radian that it turns more.
double CollisionWatch::max_motion_m(const Eigen::Ref<const BackboneD>& backbone) const {
  const double turn_rad = (backbone - checked_).col(2).cwiseAbs().maxCoeff();
  return 2.0 * largest_plate_distance_m(backbone, checked_) + longest_gap_m_ * turn_rad;
}

}  // namespace limber
