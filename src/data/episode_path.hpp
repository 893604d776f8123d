#pragma once

#include <cstddef>
#include <string>

namespace limber {

/// Group of an episode within a recording file, "episodes/000007"; also how messages name it.
std::string episode_path(std::size_t index);

}  // namespace limber
