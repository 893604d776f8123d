#include "page_files.hpp"

#include "limber/report/page_bytes.hpp"

namespace limber {

namespace {

const char* media_type_of(std::string_view path) {
  const auto ends = [&](std::string_view ending) { return path.ends_with(ending); };
  return ends(".html")  ? "text/html; charset=utf-8"
         : ends(".js")  ? "text/javascript; charset=utf-8"
         : ends(".css") ? "text/css; charset=utf-8"
         : ends(".svg") ? "image/svg+xml"
                        : "text/plain; charset=utf-8";
}

}  // namespace

std::optional<PageFile> page_file(const std::string& path) {
  const auto found = page_bytes().find(path == "/" ? "/index.html" : path);
  if (found == page_bytes().end()) {
    return std::nullopt;
  }
  return PageFile{found->second, media_type_of(found->first)};
}

}  // namespace limber
