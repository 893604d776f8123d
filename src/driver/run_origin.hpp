#pragma once

#include <string>

namespace limber {

/// "user@host": who started a run on an arm, as far as the system knows.
std::string who_started_this();

}  // namespace limber
