#include "exact_arm.hpp"

#include <cmath>
#include <complex>

namespace limber {

namespace {

using Complex = std::complex<double>;

double sinc(double x) {
  return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x;
}

Complex direction(double angle_rad) {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

/// `step` seen from `pose`, in B.
Pose composed(const Pose& pose, const Pose& step) {
  const Complex way = direction(pose.theta_rad) * Complex(step.x_m, step.y_m);
  return {pose.x_m + way.real(), pose.y_m + way.imag(), pose.theta_rad + step.theta_rad};
}

/// `to` seen from `from`.
Pose relative(const Pose& from, const Pose& to) {
  const Complex way = direction(-from.theta_rad) * Complex(to.x_m - from.x_m, to.y_m - from.y_m);
  return {way.real(), way.imag(), to.theta_rad - from.theta_rad};
}

/// (17) and (18): the segment turns by its command, or not at all, and keeps its length.
Pose unstretched_gap(const Segment& segment, double curvature_per_m) {
  const double length = segment.length_m / segment.gaps;
  const double theta = curvature_per_m * length;
  const Complex chord = length * sinc(theta / 2.0) * direction(theta / 2.0);
  return {chord.real(), chord.imag(), theta};
}

/// One gap of an unloaded segment: the contracted side is e·l0 shorter than the other, a width t
/// apart, so the whole segment turns by e·l0/t, and its middle is (1 − e/2) l0 long.
Pose unloaded_gap(const Segment& segment, double pressure_kpa) {
  double strain = 0.0;
  for (int k = 4; k >= 1; --k) {
    strain = (strain + segment.strain_polynomial[static_cast<std::size_t>(k - 1)]) *
             std::abs(pressure_kpa);
  }
  const double turn = strain * segment.length_m / segment.width_m / segment.gaps;
  const double theta = pressure_kpa > 0.0 ? -turn : turn;
  const double length = (1.0 - strain / 2.0) * segment.length_m / segment.gaps;
  const Complex chord = length * sinc(theta / 2.0) * direction(theta / 2.0);
  return {chord.real(), chord.imag(), theta};
}

/// The same of segment i, whatever its arm's command is.
Pose gap_at(const ArmDescription& arm, std::size_t i, double command) {
  const Segment& segment = arm.segments[i];
  switch (arm.no_load) {
    case NoLoadKind::curvature:
      return unstretched_gap(segment, segment.curvature_per_unit * command);
    case NoLoadKind::straight:
      return unstretched_gap(segment, 0.0);
    default:
      return unloaded_gap(segment, command);
  }
}

std::vector<double> normalised(const std::vector<double>& values, const Normalisation& by) {
  std::vector<double> result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    result.push_back((values[i] - double(by.offset[k])) * double(by.scale[k]));
  }
  return result;
}

void append(std::vector<double>& list, const Pose& pose) {
  list.insert(list.end(), {pose.x_m, pose.y_m, pose.theta_rad});
}

Pose pose_at(const std::vector<double>& list, std::size_t index) {
  return {list[3 * index], list[3 * index + 1], list[3 * index + 2]};
}

/// A shape as the network sees it: every plate about the base, or about the plate before it.
std::vector<double> coordinates(const ExactArm::Shape& shape, BackboneLayout layout) {
  std::vector<double> list;
  if (layout == BackboneLayout::base_poses) {
    for (const Pose& pose : shape) {
      append(list, pose);
    }
    return list;
  }
  for (std::size_t i = 1; i < shape.size(); ++i) {
    append(list, relative(shape[i - 1], shape[i]));
  }
  return list;
}

ExactArm::Shape shape_of(const std::vector<double>& list, BackboneLayout layout) {
  ExactArm::Shape shape;
  if (layout == BackboneLayout::gap_poses) {
    shape.push_back(Pose{});
  }
  for (std::size_t i = 0; 3 * i < list.size(); ++i) {
    const Pose pose = pose_at(list, i);
    shape.push_back(layout == BackboneLayout::base_poses ? pose : composed(shape.back(), pose));
  }
  return shape;
}

/// (5): what is unloaded, and the output added; or (16): what was, drawn by the gate toward what is
/// unloaded, and the change added. The gates' arguments come behind the changes.
std::vector<double> combined(OutputForm form, const std::vector<double>& previous,
                             const std::vector<double>& unloaded,
                             const std::vector<double>& output) {
  std::vector<double> result;
  for (std::size_t i = 0; i < unloaded.size(); ++i) {
    if (form == OutputForm::compensation) {
      result.push_back(unloaded[i] + output[i]);
    } else {
      const double gate = 1.0 / (1.0 + std::exp(-output[unloaded.size() + i]));
      result.push_back((1.0 - gate) * previous[i] + gate * unloaded[i] + output[i]);
    }
  }
  return result;
}

}  // namespace

ExactArm::Shape ExactArm::no_load(const std::vector<double>& pressures_kpa) const {
  Shape shape{Pose{}};
  for (std::size_t i = 0; i < arm_.segments.size(); ++i) {
    const Pose gap = gap_at(arm_, i, pressures_kpa[i]);
    for (int g = 0; g < arm_.segments[i].gaps; ++g) {
      shape.push_back(composed(shape.back(), gap));
    }
  }
  return shape;
}

std::vector<double> ExactArm::network_output(const std::vector<double>& input) const {
  std::vector<double> values = normalised(input, network_->input);
  for (std::size_t l = 0; l < network_->layers.size(); ++l) {
    const Layer& layer = network_->layers[l];
    // Column by column, as the weights lie in memory: a row's sum still grows in the order of k.
    std::vector<double> next(layer.bias.begin(), layer.bias.end());
    for (std::size_t k = 0; k < values.size(); ++k) {
      const float* column = layer.weight.col(static_cast<Eigen::Index>(k)).data();
      for (std::size_t row = 0; row < next.size(); ++row) {
        next[row] += double(column[row]) * values[k];
      }
    }
    if (l + 1 < network_->layers.size()) {
      for (double& value : next) {
        value = value > 0.0 ? value : 0.0;
      }
    }
    values = std::move(next);
  }
  for (Eigen::Index k = 0; k < network_->output.scale.size(); ++k) {  // gates are behind them
    double& value = values[static_cast<std::size_t>(k)];
    value = value / double(network_->output.scale[k]) + double(network_->output.offset[k]);
  }
  return values;
}

ExactArm::Shape ExactArm::next(const std::vector<double>& previous_kpa,
                               const std::vector<double>& current_kpa,
                               const Shape& previous) const {
  const Shape free = no_load(current_kpa);
  if (network_ == nullptr) {
    return free;
  }
  const BackboneLayout layout = network_->layout;
  const std::vector<double> before = coordinates(previous, layout);
  const std::vector<double> unloaded = coordinates(free, layout);
  std::vector<double> input = previous_kpa;
  input.insert(input.end(), current_kpa.begin(), current_kpa.end());
  input.insert(input.end(), before.begin(), before.end());
  if (layout == BackboneLayout::base_poses) {
    input.insert(input.end(), unloaded.begin(), unloaded.end());
  } else {
    for (std::size_t i = 0; i < arm_.segments.size(); ++i) {  // one gap stands for a segment's
      append(input, gap_at(arm_, i, current_kpa[i]));
    }
  }
  return shape_of(combined(network_->form, before, unloaded, network_output(input)), layout);
}

}  // namespace limber
