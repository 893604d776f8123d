#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace limber {

struct PageFile {
  std::string_view bytes;
  const char* media_type = "";
};

/// What the browser gets for `path`; "/" is the page itself. None: there is no such file.
std::optional<PageFile> page_file(const std::string& path);

}  // namespace limber
