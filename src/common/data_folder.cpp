#include "limber/common/data_folder.hpp"

#include <cstdlib>
#include <vector>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"

namespace limber {

fs::path data_folder() {
  std::vector<fs::path> candidates;
  if (const char* chosen = std::getenv("LIMBER_DATA_DIR")) {
    candidates.emplace_back(chosen);
  } else {
    std::error_code error;
    const fs::path bin = fs::read_symlink("/proc/self/exe", error).parent_path();
    candidates = {bin / "../../..", bin / "../share/limber"};
  }
  std::string tried;
  for (const fs::path& candidate : candidates) {
    if (fs::is_directory(candidate / "arms")) {
      return fs::canonical(candidate);
    }
    tried += fmt::format(" {}", candidate.lexically_normal().string());
  }
  throw SystemFault(fmt::format(
      "limber's arms/ and environments/ were not found in:{}; set LIMBER_DATA_DIR", tried));
}

fs::path own_file(const std::string& name_or_path, const char* folder, const char* ending) {
  std::error_code error;  // of a name that is too long, or in a folder that is closed to us
  if (fs::is_regular_file(name_or_path, error)) {
    return name_or_path;
  }
  const fs::path own = data_folder() / folder / (name_or_path + ending);
  const bool is_own = name_or_path.find('/') == std::string::npos && fs::exists(own, error);
  return is_own ? own : fs::path();
}

}  // namespace limber
