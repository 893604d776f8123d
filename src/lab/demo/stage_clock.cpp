#include "stage_clock.hpp"

namespace limber {

void StageClock::start(const std::string& name) {
  stop();
  running_ = name;
  started_ = Clock::now();
}

void StageClock::stop() {
  if (!running_.empty()) {
    stages_.emplace_back(running_, std::chrono::duration<double>(Clock::now() - started_).count());
    running_.clear();
  }
}

double StageClock::total_s() const {
  double sum = 0.0;
  for (const auto& [name, seconds] : stages_) {
    sum += seconds;
  }
  return sum;
}

}  // namespace limber
