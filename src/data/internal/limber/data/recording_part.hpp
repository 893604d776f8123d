#pragma once

#include <filesystem>
#include <span>

#include "limber/data/recording.hpp"

namespace limber {

/// A recording of whose episodes only the times, the physics and the logs' names were read: how
/// much there is, and of which arms. Threads and throws as `read_recording`.
Recording read_recording_outline(const std::filesystem::path& path);

/// A recording with those of its episodes that have these numbers, in this order.
Recording read_recording_part(const std::filesystem::path& path, std::span<const int> episodes);

}  // namespace limber
