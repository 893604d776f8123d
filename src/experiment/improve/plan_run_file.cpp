#include "plan_run_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"
#include "limber/common/json_reader.hpp"

namespace limber {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* kPlanRunsSchema = "limber/plan-runs/1";
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
          {"duration_s", run.duration_s}};
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
  return run;
}

void write_json(OutputFolder& output, const std::string& name, const std::vector<PlanRun>& runs,
                bool recorded) {
  Json json = {{"schema", kPlanRunsSchema}, {"recorded", recorded}, {"runs", Json::array()}};
  for (const PlanRun& run : runs) {
    json["runs"].push_back(to_json(run));
  }
  output.write(name + ".json", json.dump(1) + "\n");
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

void write_part(const ImproveSettings& settings, const ImproveArm& on, OutputFolder& output,
                const std::string& name, const PlanRunPart& part, std::uint64_t seed) {
  if (part.episode) {
    write_episodes(settings, on, output, name + ".h5", {*part.episode}, seed);
  }
  write_json(output, name, {part.run}, part.episode.has_value());
}

std::optional<PlanRunPart> read_part(const fs::path& folder, const std::string& name,
                                     int environment) {
  const fs::path file = folder / (name + ".json");
  if (!fs::exists(file)) {
    return std::nullopt;
  }
  const nlohmann::json root = read_json_object(file);
  const JsonReader json(root, file.string());
  json.require_schema(kPlanRunsSchema);
  const std::vector<JsonReader> runs = json.at("runs").elements("a list of one run");
  if (runs.size() != 1) {
    json.at("runs").refuse_found("expected one run");
  }
  PlanRunPart part;
  part.run = read_plan_run(runs.front());
  if (part.run.environment != environment) {
    runs.front().refuse(
        fmt::format("is of environment {}; expected {}", part.run.environment, environment));
  }
  if (json.at("recorded").boolean()) {
    part.episode = read_recording(folder / (name + ".h5")).episodes.front();
  }
  return part;
}

std::string part_name(const std::string& batch, int environment) {
  return fmt::format("{}.parts/{:04}", batch, environment);
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

void write_joined(const ImproveSettings& settings, const ImproveArm& on, OutputFolder& output,
                  const std::string& name, const PlanRuns& runs, std::uint64_t seed) {
  if (!runs.episodes.empty()) {
    write_episodes(settings, on, output, name + ".h5", runs.episodes, seed);
  }
  write_json(output, name, runs.runs, !runs.episodes.empty());
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
  if (json.at("recorded").boolean()) {
    result.episodes = read_recording(output.path() / (name + ".h5")).episodes;
  }
  return result;
}

}  // namespace limber
