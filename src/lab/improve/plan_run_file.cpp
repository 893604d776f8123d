#include "plan_run_file.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"
#include "limber/common/json_reader.hpp"

namespace limber {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* kPlanRunsSchema = "limber/plan-runs/2";
constexpr double kMaxDistanceM = 1e3;
constexpr double kMaxDurationS = 1e6;
constexpr int kMaxEnvironment = 1'000'000;

Json to_json(const PlanRun& run) {
  return {{"environment", run.environment},
          {"status", run.status},
          {"executed", run.executed},
          {"collided", run.collided},
          {"arrived", run.arrived},
          {"distance_m", run.distance_m ? Json(*run.distance_m) : Json(nullptr)},
          {"duration_s", run.duration_s},
          {"recorded", run.recorded},
          {"was_vented", run.was_vented}};
}

PlanRun read_plan_run(const JsonReader& json) {
  PlanRun run;
  run.environment = json.at("environment").integer(0, kMaxEnvironment);
  run.status = json.at("status").text();
  run.executed = json.at("executed").boolean();
  run.collided = json.at("collided").boolean();
  run.arrived = json.at("arrived").boolean();
  if (!json.at("distance_m").is_null()) {
    run.distance_m = json.at("distance_m").number(0.0, kMaxDistanceM);
  }
  run.duration_s = json.at("duration_s").number(0.0, kMaxDurationS);
  run.recorded = json.at("recorded").boolean();
  run.was_vented = json.at("was_vented").boolean();
  return run;
}

}  // namespace

void write_episodes(const ImproveSettings& settings, const ImproveArm& on, OutputFolder& output,
                    const std::string& name, const std::vector<Episode>& episodes,
                    std::uint64_t seed) {
  Recording recording = make_recording(settings.arm, on.source, seed);
  recording.settings = "executed plans, random environments; " + on.about;
  recording.episodes = episodes;
  output.write_with({name}, [&] { write_recording(output.path() / name, recording); });
}

void write_plan_runs(const ImproveSettings& settings, const ImproveArm& on, OutputFolder& output,
                     const std::string& name, const PlanRuns& runs, std::uint64_t seed) {
  if (!runs.episodes.empty()) {
    write_episodes(settings, on, output, name + ".h5", runs.episodes, seed);
  }
  Json json = {{"schema", kPlanRunsSchema}, {"runs", Json::array()}};
  for (const PlanRun& run : runs.runs) {
    json["runs"].push_back(to_json(run));
  }
  output.write(name + ".json", json.dump(1) + "\n");
}

std::optional<PlanRuns> read_part(const OutputFolder& output, const std::string& batch, int first) {
  const std::string name = part_name(batch, first);
  const fs::path file = output.path() / (name + ".json");
  if (!fs::exists(file)) {
    return std::nullopt;
  }
  PlanRuns part = read_plan_runs(output, name);
  if (part.runs.empty() || part.runs.front().environment != first) {
    throw InputError(fmt::format(
        "{}: runs: begin with environment {}; expected {}", file.string(),
        part.runs.empty() ? "none" : fmt::to_string(part.runs.front().environment), first));
  }
  return part;
}

std::string part_name(const std::string& batch, int first) {
  return fmt::format("{}.parts/{:04}", batch, first);
}

void remove_parts(OutputFolder& output, const std::string& batch, const PlanRuns& runs) {
  const fs::path folder = output.path() / (batch + ".parts");
  if (!fs::exists(folder)) {
    return;
  }
  for (const PlanRun& run : runs.runs) {
    const std::string name = part_name(batch, run.environment);
    output.remove(name + ".json");
    output.remove(name + ".h5");
  }
  std::error_code ignored;  // a folder that holds something else stays
  fs::remove(folder, ignored);
}

void list_joined(OutputFolder& output, const std::string& name) {
  for (const char* extension : {".h5", ".json"}) {
    if (fs::exists(output.path() / (name + extension))) {
      output.write_with({name + extension}, [] {});
    }
  }
}

PlanRuns read_plan_runs(const OutputFolder& output, const std::string& name) {
  const fs::path file = output.path() / (name + ".json");
  const nlohmann::json root = read_json_object(file);
  const JsonReader json(root, file.string());
  json.require_schema(kPlanRunsSchema);
  PlanRuns result;
  for (const JsonReader& run : json.at("runs").elements("a list of runs")) {
    result.runs.push_back(read_plan_run(run));
    result.arm_time_s += result.runs.back().duration_s;
  }
  const auto recorded = static_cast<std::size_t>(std::ranges::count_if(
      result.runs, [](const PlanRun& run) { return run.was_vented && run.recorded; }));
  if (recorded > 0) {
    const fs::path recording = output.path() / (name + ".h5");
    result.episodes = read_recording(recording).episodes;
    if (result.episodes.size() != recorded) {
      throw InputError(fmt::format("{}: {} episodes; {} has {}", recording.string(),
                                   result.episodes.size(), file.string(), recorded));
    }
  }
  return result;
}

}  // namespace limber
