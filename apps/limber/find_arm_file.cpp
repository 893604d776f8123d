#include <filesystem>

#include "limber/common/error.hpp"
#include "verb.hpp"

namespace limber {

std::string find_arm_file(const std::string& name_or_path) {
  namespace fs = std::filesystem;
  if (fs::exists(name_or_path)) {
    return name_or_path;
  }
  // build/<preset>/bin/limber in a source tree; <prefix>/bin/limber when installed.
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path folder = program.parent_path();
  for (const fs::path& candidate : {folder / "../../../arms", folder / "../share/limber/arms"}) {
    const fs::path file = candidate / (name_or_path + ".yaml");
    if (fs::exists(file)) {
      return fs::canonical(file).string();
    }
  }
  throw InputError(
      fmt::format("--arm {}: no such file, and none of limber's own arms has that name "
                  "(three_segment, two_segment, five_segment)",
                  name_or_path));
}

}  // namespace limber
