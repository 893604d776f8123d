#pragma once

#include <string>

namespace limber {

/// What a file of limber's holds; an arm and an environment are both YAML.
enum class FileKind { recording, model, forest, plan, yaml };

/// By content, never by name.
FileKind kind_of(const std::string& content);

}  // namespace limber
