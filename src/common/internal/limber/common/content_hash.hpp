#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "limber/common/filesystem.hpp"

namespace limber {

/// 128-bit xxHash of `content` as 32 hexadecimal digits: tells whether a file is the one that a
/// plan or a model was made with. It guards against accidents, not attackers.
std::string content_hash(std::string_view content);
/// The same of a file, which is not held. @throws as read_file.
std::string file_hash(const fs::path& path);

/// Adds a recording to those before it. @return its hash
/// @throws InputError where one of them has the same content.
std::string add_different(std::map<std::string, std::string>& path_of_hash, const fs::path& path);

}  // namespace limber
