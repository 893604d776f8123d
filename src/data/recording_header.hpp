#pragma once

#include <string>

#include "limber/data/recording.hpp"

namespace limber {

inline constexpr std::size_t kLongestText = std::size_t{1} << 26U;  // bytes of a recording's text

/// What `validate` says of names, sizes and rate: known before any episode is read.
void validate_header(const Recording& recording, const std::string& file);

}  // namespace limber
