#pragma once

#include <cstdint>
#include <string>

#include "limber/data/recording.hpp"

namespace limber {

/// Deflate makes data at most 1032 times smaller; what is smaller than this was never written.
inline constexpr std::uintmax_t kMaxCompression = 1100;

inline constexpr std::size_t kLongestText = std::size_t{1} << 26U;  // bytes of a recording's text

/// What `validate` says of names, sizes and rate: known before any episode is read.
void validate_header(const Recording& recording, const std::string& file);

}  // namespace limber
