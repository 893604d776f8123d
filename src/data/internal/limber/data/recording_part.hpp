#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "limber/common/filesystem.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// One recording of the episodes of many files, in their order, with one of them in memory at a
/// time. Everything else is the first one's, but for the seed.
/// @param parts  one at least
/// @throws InputError where one is of another arm or other commands, as `read_recording` too;
/// SystemFault if the disk refuses or has too little space.
void join_recordings(const fs::path& path, const std::vector<fs::path>& parts, std::uint64_t seed);

/// A recording of whose episodes only the times, the physics and the logs' names were read: how
/// much there is, and of which arms. Threads and throws as `read_recording`.
Recording read_recording_outline(const fs::path& path);

/// A recording with those of its episodes that have these numbers, in this order.
Recording read_recording_part(const fs::path& path, std::span<const int> episodes);

}  // namespace limber
