#include "limber/lab/rank_work.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

// What Open MPI's mpirun and Slurm's srun with PMIx or PMI-2 tell each rank.
constexpr std::array kRankVariables = {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"};

fs::path ranks_module() {
  return fs::read_symlink("/proc/self/exe").parent_path() / "../lib/limber" / kRanksModule;
}

RunOverRanks load_ranks() {
  const fs::path module = ranks_module();
  refuse_if(
      !has_ranks(),
      "started by mpirun or srun, but limber was built without MPI: apt install libopenmpi-dev "
      "and build limber again, or give each process a --shard");
  // Global, because Open MPI's own modules look for its names.
  void* handle = dlopen(module.c_str(), RTLD_NOW | RTLD_GLOBAL);
  void* entry = handle != nullptr ? dlsym(handle, kRanksEntry) : nullptr;
  if (entry == nullptr) {
    throw SystemFault(fmt::format("{}: can't be loaded: {}", module.string(), dlerror()));
  }
  return reinterpret_cast<RunOverRanks>(entry);
}

}  // namespace

bool is_rank() {
  return std::ranges::any_of(kRankVariables,
                             [](const char* name) { return std::getenv(name) != nullptr; });
}

bool has_ranks() {
  return fs::exists(ranks_module());
}

RankFigures run_over_ranks(const RankWork& work) {
  return load_ranks()(work);
}

RankFigures run_alone(const RankWork& work) {
  RankFigures figures;
  for (const std::size_t unit : work.list()) {
    if (work.should_stop()) {
      break;
    }
    work.run(unit);
    ++figures.units;
  }
  return figures;
}

}  // namespace limber
