#include "file_kind.hpp"

#include <string_view>

#include "limber/common/utf8.hpp"

namespace limber {

FileKind kind_of(const std::string& content) {
  if (content.rfind("\x89HDF\r\n", 0) == 0) {
    return FileKind::recording;
  }
  constexpr std::size_t kSafetensorsHeader = 8;  // its length, then JSON
  constexpr std::size_t kHeaderLooked = 65536;   // a forest's: four tensors, and its arm's keys
  if (content.size() > kSafetensorsHeader && content[kSafetensorsHeader] == '{' &&
      content[kSafetensorsHeader - 1] == '\0') {
    const std::string_view header = std::string_view(content).substr(0, kHeaderLooked);
    return header.find("limber/forest/") == header.npos ? FileKind::model : FileKind::forest;
  }
  // JSON is YAML too: arms, environments and valves may be written either way.
  // A byte order mark, which every reader of text skips, says nothing about the kind.
  const std::size_t begin = content.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  const std::size_t first = content.find_first_not_of(" \t\r\n", begin);
  const bool braced = first != std::string::npos && content[first] == '{';
  const bool names_plan = content.find("limber/plan/") != std::string::npos;  // may hold valves
  const bool names_yaml_schema = content.find("limber/arm/") != std::string::npos ||
                                 content.find("limber/environment/") != std::string::npos ||
                                 content.find("limber/valves/") != std::string::npos;
  return braced && (names_plan || !names_yaml_schema) ? FileKind::plan : FileKind::yaml;
}

}  // namespace limber
