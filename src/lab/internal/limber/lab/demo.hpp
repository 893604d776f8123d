#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/progress.hpp"

namespace limber {

struct DemoSettings {
  fs::path folder = "out";
  ArmDescription arm;
  bool quick = false;
  bool force = false;  ///< replace a folder that limber demo did not make
  std::uint64_t seed = 1;
  int jobs = 0;  ///< threads, 0: one per core; never changes a result that the clock does not limit
  Progress::Mode progress = Progress::Mode::automatic;
  std::function<void(const std::string&)> say = [](const std::string&) {};
};

/// The whole chain on the virtual arm: characterise → collect → train → evaluate → plan → execute →
/// report. Writes arm.yaml, train.h5, test.h5, model.safetensors, plans, pictures, report.html and,
/// last, summary.json to the folder, and returns the summary (keys in docs/formats.md).
/// @throws InputError, SystemFault, Interrupted; the folder then lacks summary.json, and the next
/// run replaces it.
Json run_demo(const DemoSettings& settings);

}  // namespace limber
