#pragma once

#include <string>

namespace limber {

/// What a limber file holds; an arm, an environment and valves are all YAML.
enum class FileKind { recording, model, forest, plan, yaml };

/// Decides by content, never by name.
FileKind kind_of(const std::string& content);

}  // namespace limber
