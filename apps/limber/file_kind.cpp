#include "file_kind.hpp"

namespace limber {

FileKind kind_of(const std::string& content) {
  if (content.rfind("\x89HDF\r\n", 0) == 0) {
    return FileKind::recording;
  }
  constexpr std::size_t kSafetensorsHeader = 8;  // its length, then JSON
  if (content.size() > kSafetensorsHeader && content[kSafetensorsHeader] == '{' &&
      content[kSafetensorsHeader - 1] == '\0') {
    return FileKind::model;
  }
  // JSON is YAML too: arms and environments may be written either way.
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  const bool braced = first != std::string::npos && content[first] == '{';
  const bool names_yaml_schema = content.find("limber/arm/") != std::string::npos ||
                                 content.find("limber/environment/") != std::string::npos;
  return braced && !names_yaml_schema ? FileKind::plan : FileKind::yaml;
}

}  // namespace limber
