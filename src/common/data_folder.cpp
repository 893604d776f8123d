#include "limber/common/data_folder.hpp"

#include <cstdlib>
#include <vector>

#include <fmt/format.h>

#include "limber/common/error.hpp"

namespace limber {

namespace fs = std::filesystem;

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

}  // namespace limber
