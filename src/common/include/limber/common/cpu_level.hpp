#pragma once
// For those who ask a model where the arm goes.

#include <string>
#include <vector>

namespace limber {

/// Instruction sets that limber's kernels are compiled for. The program itself runs on any CPU of
/// its architecture; kernels of a higher level are chosen at run time.
enum class CpuLevel {
  baseline,  ///< SSE2 on x86-64, 4 floats per vector; NEON on arm64
  avx2,      ///< AVX2 and FMA, 8 floats
  avx512,    ///< AVX-512 F and VL, 16 floats
};

/// "baseline", "avx2", "avx512".
const char* to_string(CpuLevel level);

/// The highest level this CPU runs. The environment variable LIMBER_CPU forces a lower one; it is
/// read once. @throws InputError if LIMBER_CPU names no level, or one that this CPU lacks.
CpuLevel cpu_level();

/// The level that `cpu_level` would choose with LIMBER_CPU=`forced`; empty for no choice.
CpuLevel cpu_level_for(const std::string& forced);

/// Every level this CPU runs, lowest first.
std::vector<CpuLevel> available_cpu_levels();

/// Model name of the CPU as the system gives it, or "unknown".
std::string cpu_name();
/// Of this machine, or "unknown".
std::string host_name();

}  // namespace limber
