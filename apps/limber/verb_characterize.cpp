#include <filesystem>
#include <map>

#include <fmt/ranges.h>

#include "driver_flags.hpp"
#include "episode_choice.hpp"
#include "limber/arm/characterisation.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/recording_inspection.hpp"
#include "limber/data/simple_model.hpp"
#include "limber/data/space_fit.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/driver/segment_bench.hpp"
#include "limber/logs/command_shares.hpp"
#include "limber/report/valve_plot.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

constexpr const char* kCsvHelp =
    "Fit your own bench data: a CSV file with the header pressure_kpa,strain and optionally "
    "segment (0 is the base). Strain is the change of a side's length over its length at rest, "
    "negative in contraction, measured on one whole free segment: a bare actuator contracts about "
    "a third more, and the error of a model fitted to that is half as large again";

Json to_json(const StrainFit& fit, const std::vector<BenchPoint>& points) {
  Json json;
  json["strain_polynomial"] = fit.polynomial;
  json["pressure_limit_kpa"] = fit.pressure_limit_kpa;
  json["full_strain"] = fit.full_strain;
  json["rms_residual"] = fit.rms_residual;
  json["max_residual"] = fit.max_residual;
  json["refitted"] = fit.refitted;
  json["kept"] = fit.kept;
  json["warnings"] = fit.warnings;
  json["points"] = Json::array();
  for (const BenchPoint& point : points) {
    json["points"].push_back({{"pressure_kpa", point.pressure_kpa}, {"strain", point.strain}});
  }
  return json;
}

std::string to_text(int segment, const StrainFit& fit) {
  const StrainPolynomial& c = fit.polynomial;
  return fmt::format(
      "{}: {} points, full strain {:.4f}, residual {:.2f} % rms, {:.2f} % at most{}{}\n"
      "  e = {:g} p {:+g} p^2 {:+g} p^3 {:+g} p^4   (p in kPa)\n",
      segment_name(segment), fit.points, fit.full_strain, 100.0 * fit.rms_residual,
      100.0 * fit.max_residual,
      fit.refitted ? "; the plain fit fell somewhere, so its slope is held at 0 or above" : "",
      fit.kept ? "; the arm file agrees, so its numbers stay" : "", c[0], c[1], c[2], c[3]);
}

class CharacterizeVerb final : public Verb {
 public:
  CharacterizeVerb()
      : Verb(
            "characterize",
            "Bench test of one free segment, or a fit of your bench data, for the no-load "
            "model; or "
            "the simple model, or the valves, of recordings; or what an arm's own commands make of "
            "its segments, of logs",
            "limber characterize --arm three_segment --out my_arm.yaml --plot bench.svg\n"
            "  limber characterize --arm mine.yaml --recording train.h5 --out fitted.yaml\n"
            "  limber characterize --arm mine.yaml --commands log1.csv log2.csv --mapping "
            "map.yaml\n"
            "  limber characterize --arm one_segment.yaml --driver "
            "\"exec:python3 my_driver.py\" --out fitted.yaml") {}

  void add_flags(CLI::App& app) override {
    add_arm_flag(app, arm_);
    auto* csv = app.add_option("--csv", csv_, kCsvHelp);
    driver_.add_to(app);
    auto* steps =
        app.add_option("--steps", steps_, "Pressure steps of the bench test, of each side")
            ->capture_default_str()
            ->check(CLI::Range(4, 1000));
    auto* plot = app.add_option("--plot", plot_, "Draw points and curves to this SVG file");
    auto* valves = app.add_option("--valves", valves_,
                                  "Identify the valves between this recording's set points and "
                                  "measured pressures instead (docs/valves.md)")
                       ->excludes(csv, plot);
    auto* recordings =
        app.add_option(
               "--recording", recordings_,
               "Fit gains, offsets, lengths and lag of the simple model to these recordings "
               "instead: for those who have logs and no bench test (docs/model.md)")
            ->allow_extra_args(false)
            ->excludes(csv, plot, valves);
    auto* mapping = app.add_option("--mapping", mapping_,
                                   "Of --commands: which columns are what; its command columns are "
                                   "the arm's own (docs/importing.md)");
    auto* commands =
        app.add_option(
               "--commands", command_logs_,
               "Find what the arm's own commands, as six motors of three segments, make of its "
               "segments in these logs instead, and print it for the arm file")
            ->needs(mapping)
            ->excludes(csv, plot, valves);
    mapping->needs(commands);
    steps->excludes(csv, valves, recordings, commands);
    app.add_option("--plots", plots_, "Folder for valves.svg: a motion that was not fitted to")
        ->needs(valves);
    app.add_option("--out", out_,
                   "Write the arm file with the fitted polynomials, or the valves, here");
  }

  int run(const CommonFlags& flags) override {
    driver_.check();
    const bool fits_files =
        !csv_.empty() || !valves_.empty() || !recordings_.empty() || !command_logs_.empty();
    if (fits_files && (driver_.is_program() || driver_.is_dry_run())) {
      throw InputError(fmt::format(
          "{}: is for a bench test; --csv, --valves, --recording and --commands need none",
          driver_.is_program() ? "--driver" : "--dry-run"));
    }
    refuse_if(driver_.limit_scale() != 1.0 && !driver_.is_program() && !driver_.is_dry_run(),
              "--limit-scale: nothing but a driver's bench test keeps to it; it goes with --driver "
              "exec:COMMAND");
    if (!command_logs_.empty()) {
      return run_commands(flags);
    }
    if (!recordings_.empty()) {
      return run_recordings(flags);
    }
    return valves_.empty() ? run_bench(flags) : run_valves(flags);
  }

 private:
  int run_bench(const CommonFlags& flags) {
    const std::string arm_file = find_arm_file(arm_);
    const ArmDescription arm =
        load_asked_arm(arm_file, "characterize's bench test", PolynomialsOf::characterisation);
    require_characterisable(arm);
    if (driver_.is_program() || driver_.is_dry_run()) {
      require_one_segment(arm);
    }
    refuse_to_overwrite_given({out_, plot_}, flags);
    if (driver_.is_dry_run()) {
      const ArmDescription lines = with_lines_for_missing_polynomials(arm);
      return driver_.print_dry_run(lines, flags, [&](ArmDriver& driver) {
        Episode episode;
        (void)measure_segment(arm, in_force(arm), steps_, driver, episode);
      });
    }
    const BenchData bench = driver_.is_program() ? bench_on_driver(arm, arm_file, flags)
                            : csv_.empty()       ? bench_test_all(arm, steps_)
                                                 : read_bench_csv(csv_, arm);
    const CharacterisedArm result = fit(arm, bench);
    warn(flags, result);
    // Everything is ready before the first file is written.
    const std::string yaml = with_strain_polynomials(read_file(arm_file), result.arm);
    const std::string svg = bench_chart(result, bench).svg();
    write_given(out_, [&] { return yaml; });
    write_given(plot_, [&] { return svg; });
    report(flags, result, bench);
    return kExitDone;
  }

  PressureLimits in_force(const ArmDescription& arm) const {
    return with_scaled_limits(arm, driver_.limit_scale()).segments.front().pressure_limit_kpa;
  }

  /// One mounted segment; the run is recorded beside --out.
  BenchData bench_on_driver(const ArmDescription& arm, const std::string& arm_file,
                            const CommonFlags& flags) {
    const std::string file = out_.empty() ? driver_.recording_or_default("", flags)
                                          : fs::path(out_).replace_extension(".bench.h5").string();
    refuse_to_overwrite(file, flags.force);
    const std::unique_ptr<ProcessDriver> driver = driver_.start(arm, arm_file, file, true, flags);
    Recording recording = make_recording(arm, describe(*driver), flags.seed);
    source_ = recording.source;
    recording.settings = fmt::format("bench test of one segment, {} steps", steps_);
    Episode episode;
    BenchData bench;
    const auto keep = [&](const std::string& path) {
      if (episode.frame_count() > 0) {
        recording.episodes = {episode};
        write_recording(path, recording);
        say(flags, "{}: the run, recorded", path);
      }
    };
    try {
      bench = {measure_segment(arm, driver->limits_kpa().front(), steps_, *driver, episode)};
      driver->vent();
    } catch (const std::exception&) {
      driver->vent();
      keep(fs::path(file).replace_extension(".partial.h5").string());
      throw;
    }
    keep(file);
    if (!driver->last_vent().confirmed) {
      throw SystemFault(driver->last_vent().message);
    }
    return bench;
  }

  int run_recordings(const CommonFlags& flags) const {
    refuse_to_overwrite_given({out_}, flags);
    const std::string arm_file = find_arm_file(arm_);
    const ArmDescription any = load_any_arm(arm_file, PolynomialsOf::characterisation);
    if (any.is_spatial()) {
      return run_recordings_in_space(flags, any, arm_file);
    }
    const ArmDescription arm = with_lines_for_missing_polynomials(any);
    std::vector<Episode> episodes = EpisodeReader(flags, arm, false).read_all(recordings_).episodes;
    const std::size_t count = episodes.size();
    const EpisodeErrors errors = leave_out_broken(arm, episodes);
    const SimpleFit fit = fit_simple_model(arm, episodes);
    Json json = to_json(fit);
    std::string text = to_text(fit, arm);
    json["episode_errors"] = to_json(errors);
    text += fmt::format("\nmiddle error at the tip over {} episodes: {:.2f} cm", count,
                        errors.median_cm);
    if (const std::string broken = to_text(errors); !broken.empty()) {
      say(flags, "warning: left out as broken: {}", broken);
    }
    if (!out_.empty()) {
      write_file_atomically(
          out_, with_strain_polynomials(read_file(arm_file), fitted_arm(arm, fit, episodes)));
      json["out"] = out_;
      text += fmt::format("\narm written to {}", out_);
    }
    print_result(flags, json, text);
    return kExitDone;
  }

  /// The matrix from chambers' strains to bends, with dead time and lag.
  int run_recordings_in_space(const CommonFlags& flags, const ArmDescription& arm,
                              const std::string& arm_file) const {
    std::vector<Episode> episodes = EpisodeReader(flags, arm, false).read_all(recordings_).episodes;
    const EpisodeErrors errors = leave_out_broken(arm, episodes);
    if (const std::string broken = to_text(errors); !broken.empty()) {
      say(flags, "warning: left out as broken: {}", broken);
    }
    const SpaceFit fit = fit_space_model(arm, episodes);
    Json json = to_json(fit, arm);
    json["episode_errors"] = to_json(errors);
    std::string text = to_text(fit, arm);
    if (!out_.empty()) {
      write_file_atomically(out_,
                            with_strain_polynomials(read_file(arm_file), with_space_fit(arm, fit)));
      json["out"] = out_;
      text += fmt::format("arm written to {}\n", out_);
    }
    print_result(flags, json, text);
    return kExitDone;
  }

  int run_commands(const CommonFlags& flags) const {
    refuse_if(
        !recordings_.empty() || !out_.empty(),
        "--commands: prints what is to stand in the arm file, and takes no --recording or --out");
    const ArmDescription arm = with_lines_for_missing_polynomials(load_asked_arm(
        find_arm_file(arm_), "characterize --commands", PolynomialsOf::characterisation));
    const CommandShares shares =
        find_command_shares({command_logs_.begin(), command_logs_.end()}, mapping_, arm);
    print_result(flags, to_json(shares, arm), to_text(shares, arm));
    return kExitDone;
  }

  int run_valves(const CommonFlags& flags) const {
    const ArmDescription arm = load_any_arm(find_arm_file(arm_), PolynomialsOf::characterisation);
    const fs::path plot = plots_.empty() ? fs::path() : fs::path(plots_) / "valves.svg";
    refuse_to_overwrite_given({out_, plot}, flags);
    const Recording recording = read_recording(valves_);
    require_sizes_of(recording, arm, valves_);
    refuse_if(
        recording.setpoints_only(),
        "--valves {}: the recording holds set points only, no measured {}s: there is nothing to "
        "identify valves from. A network that learns from it knows them along with the arm",
        valves_, recording.command.name);
    const IdentifiedValves valves =
        identify_valves(recording.episodes, arm, fs::path(valves_).filename().string());
    for (const std::string& warning : valves.findings.warnings) {
      say(flags, "warning: {}", warning);
    }
    Json json = to_json(valves);
    json["hash"] = valves.parameters.hash();
    std::string text = to_text(valves, arm.command.unit, arm.dimension);
    if (!plot.empty()) {
      write_file_atomically(plot, valve_plot_svg(valves.parameters, recording));
      json["plot"] = plot.string();
      text += fmt::format("\nplot written to {}", plot.string());
    }
    if (!valves.parameters.is_ideal() && !out_.empty()) {
      write_valves(out_, valves);
      json["out"] = out_;
      text += fmt::format("\nvalves written to {}", out_);
    }
    print_result(flags, json, text);
    if (valves.parameters.is_ideal()) {
      print_error(fmt::format("{}: no valves were found{}", valves_,
                              out_.empty() ? "" : "; " + out_ + " was not written"));
      return kExitNoSolution;
    }
    return kExitDone;
  }

  CharacterisedArm fit(const ArmDescription& arm, const BenchData& bench) const {
    try {
      return characterise(arm, bench);
    } catch (const InputError& error) {
      throw InputError(
          fmt::format("{}: {}", csv_.empty() ? "bench test of " + arm.name : csv_, error.what()));
    }
  }

  /// Segments fitted to the same data share their warnings.
  static void warn(const CommonFlags& flags, const CharacterisedArm& result) {
    std::map<std::string, std::vector<std::string>> segments_of;
    for (std::size_t i = 0; i < result.fits.size(); ++i) {
      for (const std::string& warning : result.fits[i].warnings) {
        segments_of[warning].push_back(segment_name(Eigen::Index(i)));
      }
    }
    for (const auto& [warning, segments] : segments_of) {
      say(flags, "warning: {}: {}", fmt::join(segments, ", "), warning);
    }
  }

  void report(const CommonFlags& flags, const CharacterisedArm& result,
              const BenchData& bench) const {
    Json json;
    json["arm"] = result.arm.name;
    json["source"] = !source_.empty() ? "bench test on " + source_
                     : csv_.empty()   ? "bench test on the virtual arm"
                                      : csv_;
    json["segments"] = Json::array();
    std::string text;
    for (std::size_t i = 0; i < result.fits.size(); ++i) {
      json["segments"].push_back(to_json(result.fits[i], bench[i]));
      text += to_text(int(i), result.fits[i]);
    }
    if (!out_.empty()) {
      json["out"] = out_;
      text += fmt::format("arm written to {}\n", out_);
    }
    if (!plot_.empty()) {
      json["plot"] = plot_;
      text += fmt::format("plot written to {}\n", plot_);
    }
    if (!text.empty()) {
      text.pop_back();
    }
    print_result(flags, json, text);
  }

  std::string arm_ = "three_segment";
  DriverFlags driver_;
  std::string source_;  // of a bench test on a driver
  std::string csv_;
  std::string out_;
  std::string plot_;
  std::string valves_;
  std::vector<std::string> recordings_;
  std::vector<std::string> command_logs_;
  std::string mapping_;
  std::string plots_;
  int steps_ = 20;
};

}  // namespace

std::unique_ptr<Verb> make_characterize_verb() {
  return std::make_unique<CharacterizeVerb>();
}

}  // namespace limber
