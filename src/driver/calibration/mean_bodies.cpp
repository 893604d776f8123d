#include "mean_bodies.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

namespace limber {

namespace {

Eigen::Vector3d turn_between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  const Eigen::AngleAxisd turn(to * from.conjugate());
  return turn.angle() * turn.axis();
}

}  // namespace

MeanBodies mean_bodies(const CalibrationLog& log, std::size_t first, std::size_t end,
                       const char* when) {
  MeanBodies mean;
  std::vector<Eigen::Matrix4d> squares;
  for (std::size_t frame = first; frame < end; ++frame) {
    const std::optional<BodyPoses>& bodies = log.frames[frame].bodies;
    if (!bodies) {
      continue;
    }
    if (mean.count == 0) {
      mean.position.setZero(bodies->rows(), 3);
      squares.assign(static_cast<std::size_t>(bodies->rows()), Eigen::Matrix4d::Zero());
    }
    mean.position += bodies->leftCols<3>();
    for (Eigen::Index i = 0; i < bodies->rows(); ++i) {
      const Eigen::Vector4d q = bodies->row(i).tail<4>();
      squares[static_cast<std::size_t>(i)] += q * q.transpose();
    }
    ++mean.count;
  }
  require_seen(mean.count, end - first, when);
  mean.position /= mean.count;
  for (const Eigen::Matrix4d& square : squares) {
    const Eigen::Vector4d q =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(square).eigenvectors().col(3);
    mean.rotation.emplace_back(q);
  }
  return mean;
}

std::vector<PulseBodies> pulse_bodies(const CalibrationLog& log, double frame_period_s) {
  std::vector<PulseBodies> result;
  for (const CalibrationPulse& pulse : log.pulses) {
    const PulseWindows windows = pulse_windows(pulse, frame_period_s);
    const auto mean = [&](const FrameWindow& window) {
      return mean_bodies(log, window.first, window.end, window.when);
    };
    result.push_back({mean(windows.before), mean(windows.held), mean(windows.after)});
  }
  return result;
}

Eigen::Vector3d turn_between(const MeanBodies& from, const MeanBodies& to, Eigen::Index body) {
  const auto i = static_cast<std::size_t>(body);
  return turn_between(from.rotation[i], to.rotation[i]);
}

BodyNoise body_noise(const CalibrationLog& log, std::size_t first, std::size_t end) {
  double positions = 0.0;
  double rotations = 0.0;
  int count = 0;
  for (std::size_t frame = first + 1; frame < end; ++frame) {
    const std::optional<BodyPoses>& before = log.frames[frame - 1].bodies;
    const std::optional<BodyPoses>& now = log.frames[frame].bodies;
    if (!before || !now) {
      continue;
    }
    positions += (*now - *before).leftCols<3>().squaredNorm();
    for (Eigen::Index i = 0; i < now->rows(); ++i) {
      rotations += turn_between(rotation_of(*before, i), rotation_of(*now, i)).squaredNorm();
      ++count;
    }
  }
  // Two neighbours differ by √2 of what one is off by, along and about three axes.
  const double axes = 2.0 * 3.0 * std::max(count, 1);
  return {std::sqrt(positions / axes), std::sqrt(rotations / axes)};
}

}  // namespace limber
