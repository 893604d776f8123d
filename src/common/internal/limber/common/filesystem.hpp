#pragma once

#include <filesystem>

namespace limber {

namespace fs = std::filesystem;

}  // namespace limber
