#include "limber/arm/no_load_model.hpp"

#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/arm/space_no_load.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr double kRoundingOfLimit = 1.0 + 1e-12;  // a command turned into a curvature and back

}  // namespace

NoLoadModel::NoLoadModel(const ArmDescription& arm)
    : arm_name_(arm.name),
      segments_(arm.segments),
      kind_(arm.no_load),
      command_(arm.command),
      dimension_(arm.dimension),
      channel_count_(arm.channel_count()),
      point_count_(arm.point_count()) {
  if (arm.is_spatial()) {
    for (int c = 0; kind_ == NoLoadKind::chambers && c < channel_count_; ++c) {
      const std::string reason =
          why_unusable(arm.chamber(c).strain_polynomial, arm.limits_of_channel(c).largest_kpa());
      if (!reason.empty()) {
        throw InputError(fmt::format("{}: strain_polynomial {}", channel_name(arm, c), reason));
      }
    }
    in_space_ = std::make_shared<const SpaceNoLoad>(arm);
    return;
  }
  for (int i = 0; kind_ == NoLoadKind::strain_polynomial && i < segment_count(); ++i) {
    const std::string reason =
        why_unusable(segment(i).strain_polynomial, segment(i).pressure_limit_kpa.largest_kpa());
    refuse_if(!reason.empty(), "segments[{}].strain_polynomial {}", i, reason);
  }
}

double NoLoadModel::strain(int index, double pressure_kpa) const {
  const Segment& s = segment(index);
  return strain_beyond(s.strain_polynomial, s.pressure_limit_kpa.largest_kpa(),
                       std::abs(pressure_kpa));
}

SegmentShape NoLoadModel::segment_shape(int index, double pressure_kpa) const {
  const Segment& s = segment(index);
  if (kind_ == NoLoadKind::curvature) {
    return {s.curvature_per_unit * pressure_kpa, s.length_m};
  }
  if (kind_ == NoLoadKind::straight) {
    return {0.0, s.length_m};
  }
  const double e = strain(index, pressure_kpa);
  const double curvature = e / (s.width_m * (1.0 - 0.5 * e));  // (3) without its pole at e = 0
  return {pressure_kpa > 0.0 ? -curvature : curvature, (1.0 - 0.5 * e) * s.length_m};
}

SegmentPressure NoLoadModel::pressure_for_curvature(int index, double curvature_per_m) const {
  const Segment& s = segment(index);
  if (kind_ == NoLoadKind::straight) {
    return {0.0, curvature_per_m == 0.0};
  }
  if (kind_ == NoLoadKind::curvature) {
    const double command = curvature_per_m / s.curvature_per_unit;
    const PressureLimits rounded = s.pressure_limit_kpa.widened(kRoundingOfLimit);
    return {s.pressure_limit_kpa.clamped(command), rounded.clamped(command) == command};
  }
  const double bend = s.width_m * std::abs(curvature_per_m);
  const double e = 2.0 * bend / (2.0 + bend);
  const double sign = curvature_per_m > 0.0 ? -1.0 : 1.0;
  const double limit = std::abs(s.pressure_limit_kpa.side_kpa(sign));
  if (e > strain_at(s.strain_polynomial, limit)) {
    return {sign * limit, false};
  }
  // P is monotone: bisection cannot fail, and 60 halvings reach the last bit.
  double low = 0.0;
  double high = limit;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (strain_at(s.strain_polynomial, middle) < e ? low : high) = middle;
  }
  return {sign * high, true};
}

double NoLoadModel::length_for_curvature(int index, double curvature_per_m) const {
  const Segment& s = segment(index);
  if (kind_ != NoLoadKind::strain_polynomial) {
    return s.length_m;
  }
  return 2.0 * s.length_m / (2.0 + s.width_m * std::abs(curvature_per_m));
}

double NoLoadModel::curvature_limit_per_m(int index) const {
  const double largest = segment(index).pressure_limit_kpa.largest_kpa();
  return std::abs(segment_shape(index, largest).curvature_per_m);
}

template <class Scalar>
void NoLoadModel::chain(
    const Eigen::Ref<const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>>& pressures_kpa,
    Eigen::Ref<BackboneOf<Scalar>>& backbone) const {
  assert(pressures_kpa.size() == channel_count() && backbone.rows() == point_count_);
  PoseOf<Scalar> pose;
  backbone.row(0) = numbers_of(pose);
  int point = 0;
  for (int i = 0; i < segment_count(); ++i) {
    const SegmentShape shape = segment_shape(i, double(pressures_kpa[i]));
    const int gaps = segment(i).gaps;
    const Scalar gap_length = Scalar(shape.length_m / gaps);
    const Scalar gap_angle = Scalar(shape.curvature_per_m * shape.length_m / gaps);
    const PoseOf<Scalar> step = arc(gap_length, gap_angle);
    for (int g = 0; g < gaps; ++g) {
      pose = compose(pose, step);
      backbone.row(++point) = numbers_of(pose);
    }
  }
}

void NoLoadModel::poses(const Eigen::Ref<const Eigen::VectorXf>& pressures_kpa,
                        Eigen::Ref<Eigen::VectorXf> numbers) const {
  if (in_space_) {
    in_space_->poses(pressures_kpa.cast<double>(), numbers);
    return;
  }
  Eigen::Map<Backbone> rows(numbers.data(), point_count_, kPoseSize);
  backbone(pressures_kpa, rows);
}

void NoLoadModel::backbone(const Eigen::Ref<const Eigen::VectorXf>& pressures_kpa,
                           Eigen::Ref<Backbone> backbone) const {
  chain<float>(pressures_kpa, backbone);
}

void NoLoadModel::backbone(const Eigen::Ref<const Eigen::VectorXd>& pressures_kpa,
                           Eigen::Ref<BackboneD> backbone) const {
  chain<double>(pressures_kpa, backbone);
}

}  // namespace limber
