#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace limber {

/// Units that the ranks of an MPI job share out, or one process does alone.
struct RankWork {
  /// Numbers of the units, in the order in which they are handed out. Asked of rank 0 alone. What
  /// it throws, rank 0 throws, after the other ranks were told that there is nothing to do.
  std::function<std::vector<std::size_t>()> list;
  /// Does a unit. It throws nothing.
  std::function<void(std::size_t)> run;
  /// Asked before each; true: no more are handed out.
  std::function<bool()> should_stop;
};

/// What became of it; over all ranks, and of use on rank 0 alone.
struct RankFigures {
  int rank = 0;
  int ranks = 1;
  std::size_t units = 0;         ///< handed out
  double hand_out_mean_s = 0.0;  ///< from a rank's question to its answer, where there was one
  double hand_out_max_s = 0.0;
  double busy_share = 1.0;  ///< of the ranks' time from the first unit to the last one's end
};

/// The entry of lib/limber/limber_mpi.so beside bin/, which alone knows MPI: the program itself
/// neither needs it, nor is another one on a cluster.
using RunOverRanks = RankFigures (*)(const RankWork& work);
inline constexpr const char* kRanksModule = "limber_mpi.so";
inline constexpr const char* kRanksEntry = "limber_run_over_ranks";

/// Whether mpirun or srun started this process as one of several, with MPI.
bool is_rank();

/// Whether limber was built with MPI.
bool has_ranks();

/// @pre is_rank @throws InputError if limber was built without MPI.
RankFigures run_over_ranks(const RankWork& work);
/// In this process alone.
RankFigures run_alone(const RankWork& work);

}  // namespace limber
