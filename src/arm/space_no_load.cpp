#include "limber/arm/space_no_load.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/QR>

#include "limber/arm/space_pose.hpp"

namespace limber {

namespace {

constexpr double kSameColumn = 1e-9;  // of the largest: angles and radii have fewer digits
constexpr double kOneWay = 0.2;       // chambers within 15 to 22 degrees of opposite bend one way

Eigen::Index rank_of(const Eigen::MatrixXd& matrix, double least) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> parts(matrix);
  return parts.setThreshold(least).rank();
}

/// Of a segment whose chambers are springs of equal stiffness: the constant strain that fits all of
/// their own strains best. A chamber at (y, z) has ε = ε0 − κz y + κy z.
Eigen::MatrixXd shape_of_chambers(const Segment& segment) {
  const auto count = Eigen::Index(segment.chambers.size());
  Eigen::MatrixXd places(count, kShapeRows);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Chamber& chamber = segment.chambers[i];
    const double angle_rad = chamber.angle_deg * std::numbers::pi / 180.0;
    places.row(i) << chamber.radius_m * std::sin(angle_rad),
        -chamber.radius_m * std::cos(angle_rad), 1.0;
  }
  // Two opposite chambers bend it one way only. Two pairs of tendons at right angles, a chamber
  // each, bend it both ways: what bends can do is no extension then, and the length stays.
  const Eigen::MatrixXd bends = places.leftCols<2>();
  Eigen::MatrixXd shape = Eigen::MatrixXd::Zero(kShapeRows, count);
  if (rank_of(places, kSameColumn) > rank_of(bends, kOneWay)) {
    shape = places.completeOrthogonalDecomposition().pseudoInverse();
  } else {
    shape.topRows<2>() = bends.completeOrthogonalDecomposition().pseudoInverse();
  }
  shape.topRows<2>() *= segment.length_m;  // curvature times length
  return shape;
}

/// @param numbers  bend about y and about z, extension
SpaceSegmentShape shape_of(const Segment& segment, const Eigen::Vector3d& numbers) {
  return {{0.0, numbers[0], numbers[1]}, segment.length_m * (1.0 + numbers[2])};
}

}  // namespace

SpaceNoLoad::SpaceNoLoad(const ArmDescription& arm) : arm_(arm) {
  shape_ = Eigen::MatrixXd::Zero(kShapeRows * arm.segment_count(), arm.channel_count());
  Eigen::Index first = 0;
  for (int i = 0; i < arm.segment_count(); ++i) {
    const Segment& segment = arm.segments[i];
    const auto chambers = Eigen::Index(segment.chambers.size());
    if (arm.no_load == NoLoadKind::chambers) {
      shape_.block(kShapeRows * i, first, kShapeRows, chambers) = shape_of_chambers(segment);
    } else if (arm.no_load == NoLoadKind::fitted) {
      shape_.middleRows<kShapeRows>(kShapeRows * i) = segment.shape_of_strains;
    }
    first += chambers;
  }
}

Eigen::VectorXd SpaceNoLoad::strains(const Eigen::Ref<const Eigen::VectorXd>& commands) const {
  Eigen::VectorXd result(commands.size());
  for (Eigen::Index i = 0; i < commands.size(); ++i) {
    const Chamber& chamber = arm_.chamber(int(i));
    double strain = commands[i];
    if (chamber.strain_polynomial != StrainPolynomial{}) {
      const double size = strain_beyond(chamber.strain_polynomial, chamber.limit_kpa.largest_kpa(),
                                        std::abs(commands[i]));
      strain = std::copysign(size, commands[i]);
    }
    result[i] = chamber.sense * strain;
  }
  return result;
}

SpaceSegmentShape SpaceNoLoad::segment_shape(int segment, const Eigen::VectorXd& strains) const {
  return shape_of(arm_.segments[segment],
                  shape_.middleRows<kShapeRows>(kShapeRows * segment) * strains);
}

void SpaceNoLoad::poses(const Eigen::Ref<const Eigen::VectorXd>& commands,
                        Eigen::Ref<Eigen::VectorXf> numbers) const {
  poses_of_shapes(shape_ * strains(commands), numbers);
}

void SpaceNoLoad::poses_of_shapes(const Eigen::Ref<const Eigen::VectorXd>& shapes,
                                  Eigen::Ref<Eigen::VectorXf> numbers) const {
  SpacePose pose;
  numbers.head<kSpacePoseSize>() = numbers_of(pose).cast<float>();
  Eigen::Index at = 0;
  for (int i = 0; i < arm_.segment_count(); ++i) {
    const Segment& segment = arm_.segments[i];
    const SpaceSegmentShape shape = shape_of(segment, shapes.segment<kShapeRows>(kShapeRows * i));
    const int gaps = segment.gaps;
    const SpacePose step =
        element<double>(shape.length_m / gaps, Eigen::Vector3d(shape.rotation_rad / gaps));
    for (int g = 0; g < gaps; ++g) {
      pose = compose(pose, step);
      at += kSpacePoseSize;
      numbers.segment<kSpacePoseSize>(at) = numbers_of(pose).cast<float>();
    }
  }
}

Eigen::VectorXd shapes_of_poses(const ArmDescription& arm,
                                const Eigen::Ref<const Eigen::VectorXd>& poses) {
  Eigen::VectorXd shapes(kShapeRows * arm.segment_count());
  const auto pose = [&](Eigen::Index plate) {
    return space_pose_of(poses.segment<kSpacePoseSize>(kSpacePoseSize * plate));
  };
  Eigen::Index plate = 0;
  for (int i = 0; i < arm.segment_count(); ++i) {
    const Segment& segment = arm.segments[i];
    Eigen::Vector3d turned = Eigen::Vector3d::Zero();
    double length_m = 0.0;
    for (int g = 0; g < segment.gaps; ++g, ++plate) {
      const SpacePose step = between(pose(plate), pose(plate + 1));
      const Eigen::Vector3d omega = rotation_vector(step.rotation);
      turned += omega;
      const double half = 0.5 * std::hypot(omega.y(), omega.z());
      length_m += step.position_m.norm() / sine_over(half);  // the arc over its chord
    }
    shapes.segment<kShapeRows>(kShapeRows * i) << turned.y(), turned.z(),
        length_m / segment.length_m - 1.0;
  }
  return shapes;
}

}  // namespace limber
