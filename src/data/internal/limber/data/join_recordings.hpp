#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace limber {

/// One recording of the episodes of many files, in their order, with one of them in memory at a
/// time. Everything else is the first one's, but for the seed.
/// @param parts  one at least
/// @throws InputError where one is of another arm or other commands, as `read_recording` too;
/// SystemFault if the disk refuses or has too little space.
void join_recordings(const std::filesystem::path& path,
                     const std::vector<std::filesystem::path>& parts, std::uint64_t seed);

}  // namespace limber
