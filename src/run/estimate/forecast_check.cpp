#include "forecast_check.hpp"

#include <algorithm>

#include "limber/arm/plate_distance.hpp"

namespace limber {

namespace {

constexpr double kMemory = 0.9;    // per frame
constexpr double kTipShare = 0.2;  // of the low-pass, in each frame
constexpr double kMaxTipM = 0.05;

}  // namespace

void ForecastCheck::step(const MotionModel& model, const Pressures& before_kpa,
                         const Pressures& pressure_kpa, MotionModel::Workspace& workspace) {
  missed_m_ *= kMemory;
  if (!forecasts_.empty() && forecasts_.front().age >= frames_) {
    forecasts_.pop_front();
  }
  for (Forecast& forecast : forecasts_) {
    model.step_shape(before_kpa, pressure_kpa, forecast.before, forecast.now, workspace);
    ++forecast.age;
  }
}

void ForecastCheck::compare(const MotionState& now) {
  if (!forecasts_.empty()) {
    const Eigen::VectorXd off_m = plate_distances_m(now.backbone, forecasts_.front().now);
    missed_m_ = missed_m_.size() == 0 ? off_m : off_m.cwiseMax(missed_m_).eval();
  }
  for (const Forecast& forecast : forecasts_) {
    if (forecast.age == tip_frames_) {
      const Eigen::Vector2d off_m = tip_position_m(now.backbone) - tip_position_m(forecast.now);
      missed_tip_m_ += kTipShare * (off_m - missed_tip_m_);
      missed_tip_m_ *= std::min(1.0, kMaxTipM / std::max(missed_tip_m_.norm(), kMaxTipM));
    }
  }
  forecasts_.push_back({now.before, now.backbone, 0});
}

void ForecastCheck::forget() {
  forecasts_.clear();
  missed_m_.resize(0);
  missed_tip_m_.setZero();
}

}  // namespace limber
