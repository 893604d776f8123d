#pragma once

#include <string>

#include "limber/common/error.hpp"

namespace limber {

/// A model's file holds something else than it must. @param where  the file, and the field in it
[[noreturn]] inline void refuse(const std::string& where, const std::string& what) {
  throw InputError(where + ": " + what);
}

}  // namespace limber
