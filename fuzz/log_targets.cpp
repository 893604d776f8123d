#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "limber/arm/characterisation.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/logs/command_shares.hpp"
#include "limber/logs/log_import.hpp"
#include "limber/run/tip_path.hpp"
#include "support/log_truth.hpp"
#include "support/sample_arm.hpp"
#include "target.hpp"

namespace limber::fuzz {

namespace {

const ArmDescription& one_segment() {
  static const ArmDescription arm = sample_arm(1);
  return arm;
}

/// Two plates, as the takes of the reader's tests have.
const ArmDescription& two_plates() {
  static const ArmDescription arm = one_segment_with(1);
  return arm;
}

/// Pressures of two seconds, on the clock of the takes.
const std::filesystem::path& commands_of_takes() {
  static const std::filesystem::path file = [] {
    const LogTruth truth(two_plates());
    auto path = scratch_folder() / "commands.log.csv";
    write_file_atomically(path, LogTruth::table("time_s,pressure_0_kpa", 40, 20.0,
                                                [&](double t) { return truth.pressure_cells(t); }));
    return path;
  }();
  return file;
}

/// An input is a log; or a mapping, kBreak and a log; or these, kBreak and a log of the commands.
template <class Import>
void import(const Input& input, const ArmDescription& arm, ImportOptions options,
            Import&& import_logs) {
  options.mapping = default_import_mapping(arm);
  const auto [first, second] = two_files(input.bytes);
  if (second) {
    const auto mapping = scratch_folder() / "map.log.csv";  // a refusal of it names log.csv, too
    const auto [log, commands] = two_files(*second);
    write_file_atomically(mapping, first);
    write_file_atomically(input.file, log);
    options.mapping = read_import_mapping(mapping, arm);
    if (commands) {
      options.command_logs = {scratch_folder() / "set.log.csv"};
      write_file_atomically(options.command_logs.front(), *commands);
    }
  }
  const ImportResult result = import_logs({input.file}, options, arm);
  validate(result.recording, "the import");
  (void)to_text(result.report);
  (void)to_json(result.report).dump();
}

void import_generic(const Input& input) {
  import(input, one_segment(), {}, import_csv);
}

void import_in_space(const Input& input) {
  import(input, small_space_arm(), {}, import_csv);
}

void import_takes(const Input& input) {
  ImportOptions options;
  options.command_logs = {commands_of_takes()};
  options.time_offset_s = 0.0;
  import(input, two_plates(), options, import_motive);
}

/// Pressures of two seconds, of chambers.
const std::filesystem::path& commands_in_space() {
  static const std::filesystem::path file = [] {
    auto path = scratch_folder() / "chambers.log.csv";
    const std::string names = "time_s,pressure_0_kpa,pressure_1_kpa,pressure_2_kpa";
    write_file_atomically(path, LogTruth::table(names, 40, 20.0, [](double t) {
                            return fmt::format(",{:.4f},{:.4f},{:.4f}", 50.0 + 45.0 * std::sin(t),
                                               50.0 + 45.0 * std::sin(2.0 * t),
                                               50.0 + 45.0 * std::cos(t));
                          }));
    return path;
  }();
  return file;
}

void import_takes_in_space(const Input& input) {
  ImportOptions options;
  options.command_logs = {commands_in_space()};
  options.time_offset_s = 0.0;
  import(input, small_space_arm(), options, import_motive);
}

/// A mapping of an arm's own commands, kBreak and a log.
void find_shares(const Input& input) {
  const auto [first, second] = two_files(input.bytes);
  const auto mapping = scratch_folder() / "map.log.csv";
  write_file_atomically(mapping, first);
  write_file_atomically(input.file, second.value_or(""));
  naming(input.file, [&] {
    const CommandShares shares = find_command_shares({input.file}, mapping, one_segment());
    (void)to_text(shares, one_segment());
  });
}

/// What a log of one segment and its mapping say, and what is wrong with it.
struct SeedLog {
  std::string more = {};  // of the mapping
  double pressure_factor = 1.0;
  double length_factor = 1.0;
  bool apart = false;       // the commands have a log of their own, on another clock
  bool flips = false;       // headings, for a second
  bool hides = false;       // the tip, for half a second
  bool repeats = false;     // rows of the tracker, for a second
  bool turns_back = false;  // plates from the tip to the base

  std::string text() const {
    const LogTruth truth(one_segment());
    const int points = one_segment().point_count();
    std::string header = "time_s" + (apart ? "" : truth.pressure_names());
    std::string mapping =
        "schema: limber/import/1\ntime: {column: time_s}\npressures:\n  columns: "
        "[pressure_1_kpa]\n" +
        more + "backbone:\n  points:\n";
    for (int p = 0; p < points; ++p) {
      header += fmt::format(",x{0},y{0},theta{0}", p);
      mapping += fmt::format("    - {{plate: {0}, x: x{1}, y: y{1}, theta: theta{1}}}\n", p,
                             turns_back ? points - 1 - p : p);
    }
    constexpr int kRows = 150;
    const std::string log = LogTruth::table(header, kRows, 20.0, [&](double t) {
      std::string cells = apart ? "" : truth.pressure_cells(t, pressure_factor);
      const BackboneD backbone = truth.backbone(repeats && t > 5.0 && t < 6.0 ? 5.0 : t);
      for (int p = 0; p < points; ++p) {
        const double heading =
            backbone(p, 2) + (flips && p > 0 && t > 3.0 && t < 4.0 ? 3.14159 : 0.0);
        cells += hides && p == points - 1 && t > 2.0 && t < 2.5
                     ? ",,,"
                     : fmt::format(",{:.5f},{:.5f},{:.5f}", length_factor * backbone(p, 0),
                                   length_factor * backbone(p, 1), heading);
      }
      return cells;
    });
    const std::string text = mapping + std::string(kBreak) + log;
    constexpr double kOtherClock_s = 0.7;
    return !apart
               ? text
               : text + std::string(kBreak) +
                     LogTruth::table("time_s" + truth.pressure_names(), kRows, 20.0, [&](double t) {
                       return truth.pressure_cells(t + kOtherClock_s);
                     });
  }
};

std::vector<std::string> generic_seeds() {
  return mapped<std::string>(
      std::vector<SeedLog>{{},
                           {.more = "alignment: {x_m: 0, y_m: 0, heading_rad: 0}\n", .hides = true},
                           {.more = "alignment: {straight_s: [0, 0.2]}\n", .flips = true},
                           {.more = "alignment: none\n", .repeats = true},
                           {.apart = true},
                           {.pressure_factor = -1.0},
                           {.pressure_factor = 1e-3},
                           {.length_factor = 1e3},
                           {.turns_back = true}},
      [](const SeedLog& seed) { return seed.text(); });
}

/// Two rigid bodies for a second, of which one moves.
std::string long_take() {
  const std::string take = source_file("tests/data/motive/rigid_bodies_1_23.csv");
  std::string text = take.substr(0, take.find("0,0.000000,"));
  for (std::size_t at = text.find("120.0"); at != std::string::npos; at = text.find("120.0")) {
    text.replace(at, 5, "20.0");
  }
  const LogTruth truth(two_plates());
  constexpr int kTakeFrames = 20;
  for (int k = 0; k < kTakeFrames; ++k) {
    const double time_s = 0.05 * k;
    const BackboneD b = truth.backbone(time_s);
    const double half_rad = b(1, 2) / 2.0;
    text += fmt::format("{},{:.6f},0,0,0,1,0,0.1,0,0.0002,0,{:.6f},0,{:.6f},{:.6f},0.1,{:.6f},0\n",
                        k, time_s, std::sin(half_rad), std::cos(half_rad), b(1, 0), -b(1, 1));
  }
  return text;
}

/// Every variant that the tests of the reader have.
std::vector<std::string> take_seeds() {
  std::vector<std::string> seeds;
  for (const auto& entry :
       std::filesystem::directory_iterator(LIMBER_SOURCE_DIR "/tests/data/motive")) {
    seeds.push_back(read_file(entry.path()));
  }
  std::sort(seeds.begin(), seeds.end());
  seeds.push_back(long_take());
  return seeds;
}

void fit_bench(const Input& input) {
  const BenchData bench = read_bench_csv(input.file, one_segment());
  naming(input.file, [&] { const NoLoadModel model(characterise(one_segment(), bench).arm); });
}

std::vector<std::string> bench_seeds() {
  std::string text = "pressure_kpa,strain\n# bent\n";
  for (int p = 0; p <= 100; p += 10) {
    text += fmt::format("{},{:.5f}\n", p, -0.0015 * p);
  }
  return {text};
}

void read_track(const Input& input) {
  const TipPath path = read_tip_path(input.file);
  (void)path.length_m();
  (void)path.closes();
  require(path.at(path.duration_s() / 2.0).allFinite(), "a path that leads nowhere");
  path.require_within(three_segments().length_m(), input.file);
}

std::vector<std::string> track_seeds() {
  return {"time_s,x_m,y_m\n0,0.6,0\n1,0.55,0.1\n2.5,0.5,-0.1\n4,0.6,0\n"};
}

}  // namespace

std::vector<Target> log_targets() {
  return {{"csv_log", "log.csv", import_generic, generic_seeds},
          {"space_csv_log", "log.csv", import_in_space},
          {"motive", "log.csv", import_takes, take_seeds},
          {"space_motive", "log.csv", import_takes_in_space},
          {"command_shares", "log.csv", find_shares},
          {"bench", "bench.csv", fit_bench, bench_seeds},
          {"track", "track.csv", read_track, track_seeds}};
}

}  // namespace limber::fuzz
