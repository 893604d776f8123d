#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "arm_control.hpp"
#include "jobs.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/driver/process_driver.hpp"
#include "limber/run/executor.hpp"
#include "studio_scene.hpp"

namespace limber {

/// A plan for the arm behind the driver.
struct ArmRunJob {
  FoundPlan found;
  double limit_scale = 0.1;  ///< of the arm's pressure limits
  bool replan = false;
  bool drop_obstacle = false;  ///< into its way while it moves; nothing has to stand there
};

struct ArmRunReport {
  std::string message;  ///< how it ended, and what became of the vent
  Json run;             ///< the whole motion (docs/studio_api.md, `arm_run`)
};

/// Of an arm that a run has found changed: writes the model that knows it, for the next plan.
/// @param recording  of the run; the model lies beside it
/// @return that, in words; empty: nothing was found, or the run ended in a fault
std::string keep_arm(const fs::path& recording, const StudioScene& scene,
                     const ExecutionResult& result);

/// Runs it as `limber execute --driver` does, and records it. Vented when this returns or throws.
/// @param driver     command, safety and calibration; the rest is filled in
/// @param recording  file to write; the driver's log, the run's plans and what it has found of the
///                   arm lie beside it
/// @param control    is told of a driver that keeps no frames
/// @param on_frame   takes each frame as it happens (`arm_frame`)
/// @throws InputError where the plan does not fit, nothing was moved; SystemFault.
ArmRunReport run_on_arm(const ArmRunJob& job, const StudioScene& scene,
                        ProcessDriverSettings driver, const fs::path& recording,
                        ArmControl& control, const std::function<void(const Json&)>& on_frame);

}  // namespace limber
