#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "limber/common/atomic_file.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/common/error.hpp"
#include "limber/common/file_format.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/utf8.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "verb.hpp"

namespace limber {

namespace {

/// @throws InputError if there is nothing of that name.
std::string find_own_file(const std::string& name_or_path, const char* folder, const char* ending,
                          const char* complaint) {
  const std::string found = own_file(name_or_path, folder, ending).string();
  std::error_code error;
  if (found.empty() && fs::exists(name_or_path, error)) {
    return name_or_path;  // a folder, a pipe: what reads it says so
  }
  if (found.empty()) {
    throw InputError(fmt::format(fmt::runtime(complaint), name_or_path));
  }
  return found;
}

}  // namespace

void add_arm_flag(CLI::App& app, std::string& arm) {
  app.add_option("--arm", arm, "Arm file, or the name of one of limber's own")
      ->capture_default_str();
}

std::string find_arm_file(const std::string& name_or_path) {
  return find_own_file(
      name_or_path, "arms", ".yaml",
      "--arm {}: no such file, and none of limber's own arms has that name "
      "(three_segment, two_segment, five_segment, motor_driven, uneven_limits, hanging_3x2, "
      "hanging_3x3, upright_4x2)");
}

ArmDescription load_any_arm(const std::string& name_or_path, PolynomialsOf polynomials) {
  ArmDescription arm = load_arm(find_arm_file(name_or_path), polynomials);
  virtual_arm_parameters(arm);  // refuses what is wrong there, whoever needs it
  return arm;
}

ArmDescription load_asked_arm(const std::string& name_or_path, const std::string& what,
                              PolynomialsOf polynomials) {
  ArmDescription arm = load_any_arm(name_or_path, polynomials);
  require_planar(arm, what);
  return arm;
}

std::string find_environment_file(const std::string& name_or_path) {
  return find_own_file(
      name_or_path, "environments", ".yaml",
      "--environment {}: no such file, and none of limber's own environments has that name");
}

void add_source(std::string& sources, const fs::path& path, const std::string& hash) {
  sources += fmt::format("{}{} {}", sources.empty() ? "" : ", ", path.filename().string(), hash);
}

std::string find_family_file(const std::string& name_or_path) {
  return find_own_file(name_or_path, "families", ".safetensors",
                       "--model {}: no such file, and none of limber's own families has that name "
                       "(three_segment, three_segment_small, two_segment)");
}

std::string find_any_file(const std::string& name_or_path) {
  for (const auto& [folder, ending] :
       {std::pair{"arms", ".yaml"}, std::pair{"environments", ".yaml"},
        std::pair{"families", ".safetensors"}}) {
    if (const auto found = own_file(name_or_path, folder, ending); !found.empty()) {
      return found.string();
    }
  }
  return name_or_path;  // what reads it says what is wrong
}

FileKind kind_of(const fs::path& file) {
  constexpr std::size_t kHeaderLooked = 65536;  // a forest's: four tensors, and its arm's keys
  const std::string head = read_head(file, kHeaderLooked);
  const std::string_view format = binary_format(head);
  if (format == kHdf5Format) {
    return FileKind::recording;
  }
  if (format == kSafetensorsFormat) {
    return head.find("limber/forest/") == head.npos ? FileKind::model : FileKind::forest;
  }
  const std::string content = read_file(file);
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
