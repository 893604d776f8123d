#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "limber/common/filesystem.hpp"
#include "limber/lab/campaign_folder.hpp"

namespace limber {

/// Writes table.csv, one row per finished unit with what it varied and every number of its result
/// but times, and report.html with the campaign's charts. One result is in memory at a time, and of
/// each unit a number or two per chart. @return how many units are finished
std::size_t write_campaign_table(const Campaign& campaign, CampaignFolder& folder);

/// Joins what `collect` units recorded: recording.h5, or, where that would be larger than what is
/// read, recording_000.h5 and so on. One unit's recording is in memory at a time.
std::vector<fs::path> join_campaign_recordings(const Campaign& campaign, CampaignFolder& folder);

/// What a unit's files are called in its folder.
inline constexpr const char* kUnitRecording = "recording.h5";
inline constexpr const char* kUnitModel = "model.safetensors";
inline constexpr const char* kUnitExperiment = "experiment";

}  // namespace limber
