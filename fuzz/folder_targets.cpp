#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/lab/tube_runs.hpp"
#include "limber/network/untrained_model.hpp"
#include "src/studio/experiment_folder.hpp"
#include "target.hpp"

namespace limber::fuzz {

namespace {

namespace fs = std::filesystem;

constexpr const char* kTrialFile = "x/trials/hard_051_network_1.json";

/// What `limber experiment` left in a project, as the studio reads it: the table, kBreak, and a
/// trial that it shows.
void read_experiment(const Input& input) {
  static const fs::path project = [] {
    fs::path path = scratch_folder() / "project_of_results";
    fs::create_directories(path / "x/trials");
    write_file_atomically(path / "x/experiment.json", "{}");
    return path;
  }();
  const auto [table, trial] = two_files(input.bytes);
  write_file_atomically(project / "x/table.json", table);
  write_file_atomically(project / kTrialFile, trial.value_or(""));
  const ProjectFolder folder(project);
  const ExperimentFolder experiment(folder, "x");
  (void)experiment.rows().dump();
  (void)experiment.runs(0).dump();
}

/// A folder whose list of own files is the input: only what lies in it may be removed.
void open_output_folder(const Input& input) {
  const fs::path parent = scratch_folder() / "outputs";
  const fs::path folder = parent / "out";
  fs::create_directories(folder / "plots");
  for (const char* name : {"kept", "out/a", "out/plots/b.svg"}) {
    write_file_atomically(parent / name, "a");
  }
  write_file_atomically(folder / ".limber-x", input.bytes);
  const OutputFolder opened(folder, "x", OutputFolder::Start::forced);
  (void)opened.about_left();
  require(fs::exists(parent / "kept"), "a list of own files removed another's");
  require_same_run(input.file, {{"schema", "limber/output/1"}}, "run");
}

/// Runs that a stopped calibration had finished. Where they are too few, it goes on, and is
/// stopped.
void read_tube_runs(const Input& input) {
  static const TubeRunSettings settings = [] {
    request_interrupt();
    TubeRunSettings of;
    of.arm = small_arm();
    of.executed_arm = small_arm();
    of.model = untrained_model(small_arm(), BackboneLayout::gap_poses, {2}, 1);
    of.model.set_arm(small_arm());
    of.jobs = 1;
    of.progress = Progress::Mode::quiet;
    return of;
  }();
  static OutputFolder folder(scratch_folder() / "tube", "calibrate", OutputFolder::Start::fresh);
  fs::create_directories(folder.path() / "runs");
  fs::copy_file(input.file, folder.path() / "runs/shape.0000.json",
                fs::copy_options::overwrite_existing);
  const TubePhase phase{"shape", 2};
  try {
    const TubeRuns runs = run_tube_phase(settings, phase, &folder);
    (void)to_json(runs, 1.0).dump();
    (void)narrowest_tube(runs.errors(), small_arm().length_m());
  } catch (const Interrupted&) {
  }
}

}  // namespace

std::vector<Target> folder_targets() {
  return {{"experiment", "", read_experiment},
          {"output_folder", "output.json", open_output_folder},
          {"tube_runs", "shape.0000.json", read_tube_runs}};
}

}  // namespace limber::fuzz
