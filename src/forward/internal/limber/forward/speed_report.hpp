#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace limber {

/// Speed of queries asked in one way: `batch_size` queries at a time on `threads` threads.
struct QueryRate {
  int batch_size = 1;
  int threads = 1;
  double queries_per_s = 0.0;
};

/// A network's speed, whole queries: from (q_{t−1}, q_t, B_{t−1}) to B_t in user units.
struct NetworkSpeed {
  std::string shape;   ///< "102-100-100-100-48"
  std::string layout;  ///< "base_poses", "gap_poses"
  QueryRate single;
  QueryRate batch;                  ///< the fastest of `batches` on one thread
  std::vector<QueryRate> batches;   ///< on one thread, then large ones on all
  double fraction_of_fma_peak = 0;  ///< hidden layers with bias and ReLU, padding not counted
};

/// The fastest of some rates on one thread. @pre there is one
inline QueryRate fastest_batch(const std::vector<QueryRate>& rates) {
  const QueryRate* best = &rates.front();
  for (const QueryRate& rate : rates) {
    if (rate.threads == 1 && rate.queries_per_s > best->queries_per_s) {
      best = &rate;
    }
  }
  return *best;
}

/// Another library on the same weights and inputs, one thread.
struct PeerSpeed {
  std::string name;
  QueryRate single;
  std::vector<QueryRate> batches;
};

struct SpeedReport {
  std::string cpu;
  std::string cpu_level;
  int threads = 1;                   ///< that the largest batches were split over
  int lanes = 1;                     ///< floats in a vector register
  double clock_ghz = 0.0;            ///< from a chain of operations, one per cycle
  double fma_peak_gmac_per_s = 0.0;  ///< one core, registers only: mean of before and after
  double fma_peak_difference = 0.0;  ///< relative, of before and after; small on a quiet machine
  std::int64_t queries = 0;          ///< asked in each measurement of one query at a time
  QueryRate no_load_single;
  QueryRate no_load_batch;
  NetworkSpeed paper_shape;         ///< three hidden layers of 100 units, base poses
  std::vector<NetworkSpeed> model;  ///< the given model, if its shape or layout is another
  std::vector<PeerSpeed> peers;     ///< on the paper's shape; Eigen is the first
};

/// What the paper's implementation answers, queries per second.
inline constexpr double kPaperNoLoadQueriesPerS = 978.0;
inline constexpr double kPaperNetworkQueriesPerS = 510.0;

}  // namespace limber
