#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace limber {

/// Wall time of each stage of a long run, in order.
class StageClock {
 public:
  /// Ends the stage that runs, if any, and starts `name`.
  void start(const std::string& name);
  /// Ends the last stage.
  void stop();

  /// (stage, seconds), finished stages only.
  const std::vector<std::pair<std::string, double>>& stages() const { return stages_; }
  double total_s() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::vector<std::pair<std::string, double>> stages_;
  std::string running_;
  Clock::time_point started_;
};

}  // namespace limber
