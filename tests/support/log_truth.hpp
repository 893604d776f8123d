#pragma once

#include <cmath>
#include <functional>
#include <string>

#include <fmt/format.h>

#include "limber/arm/no_load_model.hpp"

namespace limber {

/// An arm that follows its no-load model without delay, under pressures that never repeat: what
/// logs in the tests are written from.
class LogTruth {
 public:
  explicit LogTruth(ArmDescription arm) : arm_(std::move(arm)), model_(arm_) {}

  const ArmDescription& arm() const { return arm_; }

  Eigen::VectorXd pressures(double time_s) const {
    Eigen::VectorXd q(arm_.segment_count());
    for (int i = 0; i < arm_.segment_count(); ++i) {
      const double limit = arm_.segments[std::size_t(i)].pressure_limit_kpa.largest_kpa();
      const double a = (0.9 + 0.37 * i + 0.02 * time_s) * time_s;
      q[i] = 0.9 * limit * std::sin(a + 0.8 * std::sin(0.31 * a + i));
    }
    return q;
  }

  BackboneD backbone(double time_s) const {
    BackboneD poses(arm_.point_count(), 3);
    model_.backbone(Eigen::Ref<const Eigen::VectorXd>(pressures(time_s)),
                    Eigen::Ref<BackboneD>(poses));
    return poses;
  }

  /// A CSV of `rows` rows, `row(time)` giving the cells behind the time.
  static std::string table(const std::string& header, int rows, double rate_hz,
                           const std::function<std::string(double)>& row, double start_s = 0.0) {
    std::string text = header + "\n";
    for (int k = 0; k < rows; ++k) {
      const double time_s = start_s + k / rate_hz;
      text += fmt::format("{:.6f}{}\n", time_s, row(time_s));
    }
    return text;
  }

  std::string pressure_names() const {
    std::string text;
    for (int i = 1; i <= arm_.segment_count(); ++i) {
      text += fmt::format(",pressure_{}_kpa", i);
    }
    return text;
  }

  std::string pressure_cells(double time_s, double factor = 1.0) const {
    std::string text;
    for (const double p : pressures(time_s)) {
      text += fmt::format(",{:.6f}", factor * p);
    }
    return text;
  }

 private:
  ArmDescription arm_;
  NoLoadModel model_;
};

}  // namespace limber
