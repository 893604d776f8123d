#include "forecast_check.hpp"

#include "limber/arm/plate_distance.hpp"

namespace limber {

namespace {

constexpr double kMemory = 0.9;  // per frame

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
  forecasts_.push_back({now.before, now.backbone, 0});
}

std::optional<Eigen::Vector2d> ForecastCheck::missed_tip_m(std::size_t age) const {
  for (const Forecast& forecast : forecasts_) {
    if (forecast.age == age) {
      return tip_position_m(forecasts_.back().now) - tip_position_m(forecast.now);
    }
  }
  return std::nullopt;
}

void ForecastCheck::forget() {
  forecasts_.clear();
  missed_m_.resize(0);
}

}  // namespace limber
