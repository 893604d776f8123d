#include <filesystem>

#include "limber/common/data_folder.hpp"
#include "limber/common/error.hpp"
#include "verb.hpp"

namespace limber {

std::string find_arm_file(const std::string& name_or_path) {
  namespace fs = std::filesystem;
  if (fs::is_regular_file(name_or_path)) {
    return name_or_path;
  }
  const fs::path own = data_folder() / "arms" / (name_or_path + ".yaml");
  if (name_or_path.find('/') == std::string::npos && fs::exists(own)) {
    return own.string();
  }
  throw InputError(
      fmt::format("--arm {}: no such file, and none of limber's own arms has that name "
                  "(three_segment, two_segment, five_segment)",
                  name_or_path));
}

}  // namespace limber
