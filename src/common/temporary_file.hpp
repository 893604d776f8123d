#pragma once

#include <filesystem>
#include <string>

#include "limber/common/filesystem.hpp"

namespace limber {

/// Name under which this process writes a file called `name`, another one at each call:
/// `.NAME.HOST-NAMESPACE.PID-START-N.tmp`. NAME is cut where the whole would be too long. Host and
/// namespace say who can tell whether the process runs; its start tells it from a later one that
/// got the same number.
std::string temporary_name(const std::string& name);

/// The same as remove_abandoned_files (common/atomic_file.hpp), once per folder and process.
void remove_abandoned_files_once(const fs::path& folder);

}  // namespace limber
