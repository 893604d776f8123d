#pragma once

#include <string>

#include "limber/data/recording.hpp"

namespace limber {

/// What `validate` says of names, sizes and rate: known before any episode is read.
void validate_header(const Recording& recording, const std::string& file);

}  // namespace limber
