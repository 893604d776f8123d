#include "limber/network/gemm_kernels.hpp"

#include <cstdlib>
#include <fstream>

#include <fmt/format.h>

#include "limber/common/error.hpp"

namespace limber {

extern const GemmKernels kGemmKernels_baseline;
#if defined(__x86_64__)
extern const GemmKernels kGemmKernels_avx2;
extern const GemmKernels kGemmKernels_avx512;
#endif

namespace {

const GemmKernels& choose() {
  const std::vector<const GemmKernels*> available = available_gemm_kernels();
  const char* forced = std::getenv("LIMBER_CPU");
  if (forced == nullptr || *forced == '\0') {
    return *available.back();
  }
  std::string names;
  for (const GemmKernels* kernels : available) {
    if (std::string(kernels->name) == forced) {
      return *kernels;
    }
    names += names.empty() ? kernels->name : std::string(", ") + kernels->name;
  }
  throw InputError(
      fmt::format("LIMBER_CPU={}; expected one of what this CPU runs: {}", forced, names));
}

}  // namespace

const GemmKernels& gemm_kernels() {
  static const GemmKernels& chosen = choose();
  return chosen;
}

std::vector<const GemmKernels*> available_gemm_kernels() {
  std::vector<const GemmKernels*> levels = {&kGemmKernels_baseline};
#if defined(__x86_64__)
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool avx512 =
      avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl");
  if (avx2) {
    levels.push_back(&kGemmKernels_avx2);
  }
  if (avx512) {
    levels.push_back(&kGemmKernels_avx512);
  }
#endif
  return levels;
}

std::string cpu_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

}  // namespace limber
