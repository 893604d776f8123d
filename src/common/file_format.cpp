#include "limber/common/file_format.hpp"

#include <fmt/format.h>

#include "limber/common/error.hpp"

namespace limber {

std::string_view binary_format(std::string_view head) {
  constexpr std::size_t kHeaderLength = 8;  // bytes of it, the last of them zero; JSON follows
  if (head.starts_with("\x89HDF\r\n")) {
    return kHdf5Format;
  }
  const bool is_safetensors =
      head.size() > kHeaderLength && head[kHeaderLength] == '{' && head[kHeaderLength - 1] == '\0';
  return is_safetensors ? kSafetensorsFormat : std::string_view();
}

void refuse_other_format(std::string_view content, std::string_view expected,
                         const std::string& where) {
  const std::string_view found = binary_format(content);
  if (!found.empty() && found != expected) {
    throw InputError(fmt::format("{}: holds {} ({}); expected {}", where,
                                 found == kHdf5Format ? "a recording" : "a model or a forest",
                                 found, expected));
  }
}

}  // namespace limber
