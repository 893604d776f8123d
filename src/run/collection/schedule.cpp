#include "limber/run/schedule.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/run/safety_settings.hpp"

namespace limber {

namespace {

constexpr int kTransitionEpisodes = 16;
constexpr int kMaxFullSchedule = 3;  // channels; 729 transitions
constexpr int kMaxWalk = 6;          // channels; 531 441 edges held in memory
constexpr int kMaxDrawn = 20;        // channels in one draw: 3^20 corners fit into 32 bits
constexpr int kMaxCount = 10'000'000;
constexpr double kLongestHold_s = 3600.0;
constexpr std::uint64_t kScheduleStream = 0x7363'6865'6475'6c65;  // apart from a driver's streams

/// Vertices of an Eulerian circuit of the complete directed graph with self-loops (Hierholzer),
/// from vertex 0 back to it: vertices² + 1 entries. Order sampled by `random`.
std::vector<int> eulerian_circuit(int vertices, RandomStream& random) {
  std::vector<std::vector<int>> unused(vertices);
  for (std::vector<int>& successors : unused) {
    successors.resize(vertices);
    std::iota(successors.begin(), successors.end(), 0);
    for (std::size_t i = successors.size(); i > 1; --i) {
      std::swap(successors[i - 1], successors[random.index(std::uint32_t(i))]);
    }
  }
  std::vector<int> path = {0};
  std::vector<int> circuit;
  while (!path.empty()) {
    std::vector<int>& successors = unused[path.back()];
    if (successors.empty()) {
      circuit.push_back(path.back());
      path.pop_back();
    } else {
      path.push_back(successors.back());
      successors.pop_back();
    }
  }
  std::reverse(circuit.begin(), circuit.end());
  return circuit;
}

/// Corners one after another, one per column.
using Walk = Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic>;

/// @pre channels ≤ kMaxDrawn
std::uint32_t corner_count(int channels) {
  std::uint32_t count = 1;
  for (int i = 0; i < channels; ++i) {
    count *= kCornerStates;
  }
  return count;
}

/// The base-3 digits of a corner's number, the lowest first.
void write_states(std::uint32_t corner, Eigen::Ref<CornerStates> states) {
  for (std::uint8_t& state : states) {
    state = std::uint8_t(corner % kCornerStates);
    corner /= kCornerStates;
  }
}

Walk eulerian_walk(int channels, RandomStream& random) {
  const std::vector<int> circuit = eulerian_circuit(int(corner_count(channels)), random);
  Walk walk(channels, std::ssize(circuit));
  for (Eigen::Index i = 0; i < walk.cols(); ++i) {
    write_states(std::uint32_t(circuit[i]), walk.col(i));
  }
  return walk;
}

Walk random_walk(int channels, int steps, RandomStream& random) {
  Walk walk = Walk::Zero(channels, steps + 1);
  for (Eigen::Index i = 1; i < walk.cols(); ++i) {
    for (int first = 0; first < channels; first += kMaxDrawn) {
      const int drawn = std::min(kMaxDrawn, channels - first);
      write_states(random.index(corner_count(drawn)), walk.col(i).segment(first, drawn));
    }
  }
  return walk;
}

void require(bool condition, const std::string& message) {
  if (!condition) {
    throw InputError(message);
  }
}

void check(const ScheduleSettings& settings) {
  require(settings.count >= 0 && settings.count <= kMaxCount,
          fmt::format("--count {}: expected a number of motions from 1 to {}", settings.count,
                      kMaxCount));
  require(settings.episodes >= 0 && settings.episodes <= 1'000'000,
          fmt::format("--episodes {}: expected from 1 to 1000000", settings.episodes));
  require(settings.hold_s > 0.0 && settings.hold_s <= kLongestHold_s,
          fmt::format("--hold-s {}: expected seconds, > 0 and at most {}", settings.hold_s,
                      kLongestHold_s));
  const double min_s = settings.hold_min_s.value_or(0.0);
  require(min_s >= 0.0 && min_s <= settings.hold_s,
          fmt::format("--hold-min-s {}: expected seconds from 0 to --hold-s {}", min_s,
                      settings.hold_s));
}

Motion make_motion(const ScheduleSettings& settings, Pressures setpoint_kpa, RandomStream& random) {
  const double hold_s =
      settings.hold_min_s ? random.uniform(*settings.hold_min_s, settings.hold_s) : settings.hold_s;
  return {std::move(setpoint_kpa), hold_s, !settings.hold_min_s.has_value()};
}

int transition_count(const ArmDescription& arm, const ScheduleSettings& settings) {
  const int n = arm.channel_count();
  const double all = std::pow(double(kCornerStates), 2 * n);
  if (settings.count == 0) {
    require(n <= kMaxFullSchedule,
            fmt::format("--schedule transitions: arm '{}' has {} {}, so {:.0f} ordered "
                        "transitions, {:.1f} h at {} s each; give --count N to take N of them",
                        arm.name, n, arm.is_spatial() ? "chambers" : "segments", all,
                        all * settings.hold_s / 3600.0, settings.hold_s));
    return int(all);
  }
  require(settings.count <= all,
          fmt::format("--count {}: arm '{}' has only {:.0f} ordered transitions", settings.count,
                      arm.name, all));
  return settings.count;
}

std::vector<EpisodeSchedule> transition_schedule(const ArmDescription& arm,
                                                 const ScheduleSettings& settings,
                                                 std::uint64_t seed) {
  const int n = arm.channel_count();
  const int count = transition_count(arm, settings);
  RandomStream random(seed, kScheduleStream);
  const Walk walk = n <= kMaxWalk ? eulerian_walk(n, random) : random_walk(n, count, random);
  const int wanted = settings.episodes == 0 ? kTransitionEpisodes : settings.episodes;
  const int episodes = std::min(wanted, count);
  std::vector<EpisodeSchedule> result(episodes);
  for (int e = 0; e < episodes; ++e) {
    const Eigen::Index first = std::int64_t{e} * count / episodes;
    const Eigen::Index last = std::int64_t{e + 1} * count / episodes;
    EpisodeSchedule& episode = result[e];
    episode.first_kpa = corner_configuration(arm, walk.col(first));
    for (Eigen::Index i = first; i < last; ++i) {
      episode.motions.push_back(
          make_motion(settings, corner_configuration(arm, walk.col(i + 1)), random));
    }
  }
  return result;
}

std::vector<EpisodeSchedule> random_schedule(const ArmDescription& arm,
                                             const ScheduleSettings& settings, std::uint64_t seed) {
  require(settings.count > 0, "--schedule random: --count N is missing, motions of each episode");
  const int episodes = std::max(1, settings.episodes);
  std::vector<EpisodeSchedule> result(episodes);
  for (std::size_t e = 0; e < result.size(); ++e) {
    RandomStream random(seed, kScheduleStream + 1 + e);
    result[e].first_kpa = Pressures::Zero(arm.channel_count());
    for (int i = 0; i < settings.count; ++i) {
      Pressures setpoint_kpa(arm.channel_count());
      for (Eigen::Index s = 0; s < setpoint_kpa.size(); ++s) {
        const PressureLimits& limits = arm.limits_of_channel(int(s));
        setpoint_kpa[s] = float(random.uniform(limits.lower_kpa, limits.upper_kpa));
      }
      result[e].motions.push_back(make_motion(settings, std::move(setpoint_kpa), random));
    }
  }
  return result;
}

}  // namespace

std::vector<EpisodeSchedule> make_schedule(const ArmDescription& arm,
                                           const ScheduleSettings& settings, std::uint64_t seed) {
  check(settings);
  const ArmDescription scaled = with_scaled_limits(arm, settings.limit_scale);
  std::vector<EpisodeSchedule> episodes = settings.kind == ScheduleKind::transitions
                                              ? transition_schedule(scaled, settings, seed)
                                              : random_schedule(scaled, settings, seed);
  for (EpisodeSchedule& episode : episodes) {
    episode.approach = settings.approach;
  }
  return episodes;
}

ScheduleSettings identifying_schedule(Dimension dimension) {
  return {.kind = ScheduleKind::random,
          .count = dimension == Dimension::plane ? 36 : 68,
          .approach = Approach::straight,
          .hold_s = 1.0,
          .hold_min_s = 0.2};
}

std::string describe(const ScheduleSettings& settings) {
  const bool transitions = settings.kind == ScheduleKind::transitions;
  std::string text = transitions ? "transitions" : "random";
  text += settings.count == 0
              ? ", all"
              : fmt::format(", {} motions{}", settings.count, transitions ? "" : " an episode");
  if (settings.episodes != 0) {
    text += fmt::format(", {} episodes", settings.episodes);
  }
  text += settings.approach == Approach::step ? ", step" : ", straight";
  text += settings.hold_min_s
              ? fmt::format(", holds from {} to {} s", *settings.hold_min_s, settings.hold_s)
              : fmt::format(", hold {} s and until reached", settings.hold_s);
  if (settings.limit_scale != 1.0) {
    text += fmt::format(", limits times {}", settings.limit_scale);
  }
  return text;
}

Pressures corner_configuration(const ArmDescription& arm,
                               const Eigen::Ref<const CornerStates>& states) {
  assert(states.size() == arm.channel_count());
  Pressures result(arm.channel_count());
  for (Eigen::Index s = 0; s < result.size(); ++s) {
    const PressureLimits& limits = arm.limits_of_channel(int(s));
    result[s] = float(corner_kpa(limits, states[s]));
  }
  return result;
}

}  // namespace limber
