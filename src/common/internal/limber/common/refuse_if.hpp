#pragma once

#include <utility>

#include <fmt/format.h>

#include "limber/common/error.hpp"

namespace limber {

/// Most checks of what comes from outside. The arguments are evaluated where nothing is bad, too:
/// what is there only then, or takes long to find, wants an `if`.
/// @throws InputError with the message if it `is_bad`.
template <typename... Arguments>
void refuse_if(bool is_bad, fmt::format_string<Arguments...> message, Arguments&&... arguments) {
  if (is_bad) {
    throw InputError(fmt::format(message, std::forward<Arguments>(arguments)...));
  }
}

}  // namespace limber
