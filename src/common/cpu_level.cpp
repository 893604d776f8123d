#include "limber/common/cpu_level.hpp"

#include <unistd.h>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"

namespace limber {

const char* to_string(CpuLevel level) {
  constexpr std::array kNames = {"baseline", "avx2", "avx512"};  // in the order of CpuLevel
  return kNames[std::size_t(level)];
}

std::vector<CpuLevel> available_cpu_levels() {
  std::vector<CpuLevel> levels = {CpuLevel::baseline};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    levels.push_back(CpuLevel::avx2);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")) {
      levels.push_back(CpuLevel::avx512);
    }
  }
#endif
  return levels;
}

CpuLevel cpu_level_for(const std::string& forced) {
  const std::vector<CpuLevel> levels = available_cpu_levels();
  if (forced.empty()) {
    return levels.back();
  }
  std::string names;
  for (const CpuLevel level : levels) {
    if (forced == to_string(level)) {
      return level;
    }
    names += (names.empty() ? "" : ", ") + std::string(to_string(level));
  }
  throw InputError(
      fmt::format("LIMBER_CPU={}; expected one of what this CPU runs: {}", forced, names));
}

CpuLevel cpu_level() {
  static const CpuLevel level = [] {
    const char* forced = std::getenv("LIMBER_CPU");
    return cpu_level_for(forced != nullptr ? forced : "");
  }();
  return level;
}

std::string cpu_name() {
  std::istringstream file;
  try {
    file.str(read_file("/proc/cpuinfo"));
  } catch (const std::exception&) {
    return "unknown";  // a missing name is no reason to stop
  }
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

std::string host_name() {
  char name[256] = {};
  return ::gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
}

}  // namespace limber
