#include "limber/data/valve_simulation.hpp"

#include "limber/common/error.hpp"
#include "valve_fit.hpp"

namespace limber {

FrameMatrix simulate_valves(const ValveParameters& valves, double rate_hz, const Episode& episode,
                            int first, int count) {
  const auto segments = int(episode.setpoint_kpa.cols());
  const std::string fault = why_unusable(valves, segments);
  if (!fault.empty()) {
    throw InputError("valves: " + fault);
  }
  FrameMatrix result = episode.setpoint_kpa.middleRows(first, count);
  result.row(0) = episode.pressure_kpa.row(first);
  if (valves.is_ideal()) {
    return result;
  }
  std::vector<double> pressure;
  for (int i = 0; i < segments; ++i) {
    const ValveMotion motion(valves.segments[std::size_t(i)], valves.has_sides, 1.0 / rate_hz);
    simulate(motion, ValveRun{&episode, i, first, count}, pressure);
    result.col(i) = Eigen::Map<const Eigen::VectorXd>(pressure.data(), count).cast<float>();
  }
  return result;
}

FrameMatrix simulate_valves(const ValveParameters& valves, double rate_hz, const Episode& episode) {
  return simulate_valves(valves, rate_hz, episode, 0, episode.frame_count());
}

}  // namespace limber
