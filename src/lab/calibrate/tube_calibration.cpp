#include "limber/lab/tube_calibration.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include "binomial_bound.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/version.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/tube_shape.hpp"
#include "limber/report/report_page.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

std::string percent(const Json& share) {
  return fmt::format("{:.2f} %", 100.0 * share.get<double>());
}

std::vector<std::string> row_of(const Json& phase) {
  const bool has_tube = phase.contains("coverage");
  const double environments = phase["environments"].get<double>();
  return {phase["phase"].get<std::string>(),
          has_tube ? fmt::format("{:.3f}", phase["factor"].get<double>()) : "–",
          fmt::format("{}", phase["runs"].get<int>()),
          has_tube
              ? fmt::format("{} ({}–{})", percent(phase["coverage"]["share"]),
                            percent(phase["coverage"]["low"]), percent(phase["coverage"]["high"]))
              : "–",
          fmt::format("{:.1f} %", 100.0 * phase["solved"].get<double>() / environments),
          fmt::format("{:.0f}", phase["cost"].get<double>()),
          fmt::format("{:.2f} cm", phase["mean_largest_tip_error_cm"].get<double>()),
          fmt::format("{}", phase["collided"].get<int>()),
          fmt::format("{}", phase["reached"].get<int>())};
}

void add_levels(const Json& tube, ReportPage& page) {
  ReportTable table{
      "Levels", {"level", "factor", "tip", "end", "end, heading", "tested", "audit"}, {}};
  for (const Json& level : tube["levels"]) {
    table.rows.push_back(
        {percent(level["level"]), fmt::format("{:.3f}", level["factor"].get<double>()),
         fmt::format("{:.2f} cm", level["tip_radius_cm"].get<double>()),
         fmt::format("{:.2f} cm", level["end_radius_cm"].get<double>()),
         fmt::format("{:.3f} rad", level["end_heading_rad"].get<double>()),
         fmt::format("{} of {} outside", level["outside"].get<int>(), level["runs"].get<int>()),
         fmt::format("{} of {} outside", level["audit_outside"].get<int>(),
                     level["audit_runs"].get<int>())});
  }
  page.heading("Tube").table(table);
}

/// Page about a tube's calibration. @param evidence  as evidence.json holds it (docs/tube.md)
std::string evidence_page(const nlohmann::ordered_json& evidence) {
  ReportPage page(
      "limber calibrate",
      fmt::format("arm {}, seed {}, confidence {}", evidence["arm"]["name"].get<std::string>(),
                  evidence["seed"].get<std::uint64_t>(), percent(evidence["confidence"])));
  page.paragraph(
      "How far the arm was from the predicted one, over whole motions, in random environments that "
      "no two phases share. Every phase with a factor planned with that tube. What is promised and "
      "what is not: docs/tube.md.");
  for (const Json& failure : evidence["failures"]) {
    page.remark(failure.get<std::string>());
  }
  if (evidence.contains("tube")) {
    add_levels(evidence["tube"], page);
  }
  ReportTable table{"Phases, in their order; coverage with its 95 % interval",
                    {"phase", "factor", "runs", "coverage", "solved", "cost",
                     "largest tip error, mean", "collided", "reached"},
                    {}};
  for (const Json& phase : evidence["phases"]) {
    table.rows.push_back(row_of(phase));
  }
  page.heading("Evidence").table(table);
  return page.html();
}

namespace fs = std::filesystem;

constexpr const char* kCalibrationFile = "calibration.json";
// Wide tubes are only passed through; where factors end up, a step changes coverage by about half
// a percent.
constexpr double kWideFactors[] = {2.2, 1.95, 1.7};
constexpr double kFirstNarrow = 1.5;
constexpr double kStep = 0.9874;
constexpr int kFactors = 60;               // down to 0.73
constexpr double kScreenConfidence = 0.5;  // a screen only finds what is worth testing
constexpr int kMaxTests = 3;  // of a level whose first test failed; they share its confidence
constexpr double kAuditConfidence = 0.99;  // that an audit contradicts

/// What has to be the same for runs of two starts to be one calibration.
Json identity(const CalibrationSettings& settings) {
  const TubeRunSettings& runs = settings.runs;
  Json json = {{"schema", "limber/calibration/5"},
               {"arm", {{"name", runs.arm.name}, {"hash", runs.arm.hash()}}},
               {"virtual_arm", virtual_arm_hash(runs.executed_arm)},
               {"model", file_hash(settings.model_file)},
               {"valves", runs.valves.hash()},
               {"seed", runs.seed},
               {"max_queries", optional_json(runs.limits.queries)},
               {"time_limit_s", optional_json(runs.limits.time_s)},
               {"levels", settings.levels},
               {"confidence", settings.confidence},
               {"scale_runs", settings.scale_runs},
               {"screen_runs", settings.screen_runs},
               {"test_runs", settings.test_runs},
               {"audit_runs", settings.audit_runs}};
  if (runs.unseen) {
    json["unseen_arms"] = {{"physics", describe(runs.unseen->variation)},
                           {"seconds", runs.unseen->seconds}};
  }
  return json;
}

/// What screens found for a level, as places in the list of factors: the narrowest that held, and
/// the widest that didn't.
struct Screened {
  std::optional<std::size_t> narrowest;
  std::optional<std::size_t> too_narrow;
};

class Calibration {
 public:
  explicit Calibration(const CalibrationSettings& settings)
      : settings_(settings), factors_(tube_factors()), identity_(identity(settings)) {
    prepare_folder();
  }

  CalibrationResult run() {
    find_shape();
    std::vector<Screened> screened;
    for (const double level : settings_.levels) {
      screened.push_back(screen(level));
    }
    for (std::size_t l = 0; l < screened.size(); ++l) {
      if (const std::optional<TubeLevel> found = find_level(settings_.levels[l], screened[l])) {
        shape_.levels.push_back(*found);
      }
    }
    result_.model = settings_.runs.model;
    result_.model.tube.reset();
    if (!shape_.levels.empty()) {
      result_.model.tube = shape_;
      evidence_["tube"] = to_json(shape_);
      if (expected_error_m_ > 0.0) {
        note_expected_error_of_tube(result_.model, expected_error_m_);
      }
    }
    evidence_["failures"] = result_.failures;
    result_.evidence = evidence_;
    folder_->write("evidence.json", evidence_.dump(1) + "\n");
    folder_->write("evidence.html", evidence_page(evidence_));
    return std::move(result_);
  }

 private:
  void prepare_folder() {
    const fs::path file = settings_.folder / kCalibrationFile;
    const bool resumes = settings_.resume && fs::exists(file);
    if (resumes) {
      require_same_run(file, identity_, "calibration only");
    } else if (fs::exists(file) && !settings_.force) {
      throw InputError(
          fmt::format("{}: holds a calibration already: --resume continues it, --force replaces it",
                      settings_.folder.string()));
    }
    folder_.emplace(settings_.folder, "calibrate", OutputFolder::start(resumes, settings_.force),
                    std::vector<fs::path>{settings_.model_file});
    folder_->require_free({"evidence.json", "evidence.html"});
    if (!resumes) {
      Json written = identity_;
      written["program_version"] = version();
      folder_->write(kCalibrationFile, written.dump(1) + "\n");
    }
    evidence_ = identity_;
    evidence_["phases"] = Json::array();
  }

  TubeRuns run_phase(const std::string& name, int runs, const Tube* shape, double factor,
                     bool may_fall_short = false) {
    const TubeRuns done = run_tube_phase(
        settings_.runs, {name, runs, shape, factor, expected_error_m_, may_fall_short}, &*folder_);
    Json json = {{"phase", name}, {"factor", factor}};
    json.update(to_json(done, factor));
    if (shape == nullptr) {
      json.erase("outside");
      json.erase("coverage");
    }
    evidence_["phases"].push_back(json);
    return done;
  }

  void find_shape() {
    const TubeRuns runs = run_phase("shape", settings_.scale_runs, nullptr, 0.0);
    expected_error_m_ = runs.expected_error_m();
    const std::vector<GrowingErrors> motions = runs.errors();
    const auto& [growth, tube] = narrowest_tube(motions, settings_.runs.arm.length_m());
    shape_ = tube_shape(errors_of(motions, growth), tube.growth);
    shape_.source = "virtual arm";
  }

  /// By halving the list of those that are screened, the wide ones and every second narrow one:
  /// narrower tubes leave fewer runs inside, and too wide ones too few environments with a plan.
  Screened screen(double level) {
    constexpr std::size_t kWide = std::size(kWideFactors);
    Screened found;
    std::size_t begin = 0;
    std::size_t end = kWide + (factors_.size() - kWide + 1) / 2;
    while (begin < end) {
      const std::size_t middle = (begin + end) / 2;
      const std::size_t k = middle < kWide ? middle : 2 * middle - kWide;
      const std::optional<int> outside = screen_factor(middle, factors_[k]);
      if (outside &&
          share_at_most(*outside, settings_.screen_runs, kScreenConfidence) > 1.0 - level) {
        found.too_narrow = k;
        end = middle;
      } else {
        found.narrowest = outside ? k : found.narrowest;
        begin = middle + 1;
      }
    }
    return found;
  }

  /// Runs outside; none if most environments have no plan with so wide a tube. Levels share
  /// screens.
  std::optional<int> screen_factor(std::size_t number, double factor) {
    const auto [screen, is_new] = screens_.try_emplace(number);
    if (is_new) {
      const TubeRuns runs = run_phase(fmt::format("screen_{:02}", number), settings_.screen_runs,
                                      &shape_, factor, true);
      settings_.say(fmt::format("factor {:.3f}: {} of {} runs outside", factor,
                                runs.outside(factor), runs.executed()));
      if (runs.executed() == settings_.screen_runs) {
        screen->second = runs.outside(factor);
      }
    }
    return screen->second;
  }

  std::optional<TubeLevel> find_level(double level, const Screened& screened) {
    if (!screened.narrowest) {
      fail(level,
           screened.too_narrow
               ? fmt::format("even factor {:.3g} of the shape is too narrow; wider tubes leave "
                             "too few environments with a plan",
                             factors_[*screened.too_narrow])
               : "no tube of the list leaves enough environments with a plan; a model with "
                 "smaller errors is needed, or a larger budget");
      return std::nullopt;
    }
    std::optional<TubeLevel> narrowest;
    int tests = 0;
    const auto holds = [&](std::size_t k) {
      const std::optional<TubeLevel> found = test_factor(level, factors_[k], tests++);
      narrowest = found ? found : narrowest;
      return found.has_value();
    };
    if (!narrowest_factor(*screened.narrowest, factors_.size(), kMaxTests, holds)) {
      fail(level, fmt::format("no factor held its test on {} runs", settings_.test_runs));
      return std::nullopt;
    }
    audit(*narrowest);
    return narrowest;
  }

  /// In environments of its own. The tests of a level share its confidence (narrowest_factor).
  std::optional<TubeLevel> test_factor(double level, double factor, int test) {
    const TubeRuns runs = run_phase(fmt::format("test_{:g}_{}", 100.0 * level, test),
                                    settings_.test_runs, &shape_, factor);
    const int outside = runs.outside(factor);
    const double confidence = 1.0 - (1.0 - settings_.confidence) / kMaxTests;
    settings_.say(fmt::format("level {}: factor {:.3f}: {} of {} runs outside", level, factor,
                              outside, runs.executed()));
    if (share_at_most(outside, runs.executed(), confidence) > 1.0 - level) {
      return std::nullopt;
    }
    return TubeLevel{.level = level,
                     .factor = factor,
                     .runs = runs.executed(),
                     .outside = outside,
                     .confidence = settings_.confidence};
  }

  void audit(TubeLevel& level) {
    if (settings_.audit_runs == 0) {
      return;
    }
    const TubeRuns runs = run_phase(fmt::format("audit_{:g}", 100.0 * level.level),
                                    settings_.audit_runs, &shape_, level.factor);
    level.audit_runs = runs.executed();
    level.audit_outside = runs.outside(level.factor);
    settings_.say(fmt::format("level {}: audit: {} of {} runs outside", level.level,
                              level.audit_outside, level.audit_runs));
    if (share_at_least(level.audit_outside, level.audit_runs, kAuditConfidence) >
        1.0 - level.level) {
      fail(level.level, fmt::format("its audit contradicts it: {} of {} runs are outside",
                                    level.audit_outside, level.audit_runs));
    }
  }

  void fail(double level, const std::string& why) {
    result_.failures.push_back(fmt::format("level {}: {}", level, why));
  }

  const CalibrationSettings& settings_;
  const std::vector<double> factors_;
  const Json identity_;
  std::optional<OutputFolder> folder_;
  Tube shape_;
  double expected_error_m_ = 0.0;  // of the arm whose tube is the shape; 0: of no family
  std::map<std::size_t, std::optional<int>> screens_;  // runs outside, by number of the screen
  Json evidence_;
  CalibrationResult result_;
};

void require_runs(const char* flag, int runs, int min, int max = 1'000'000) {
  if (runs < min || runs > max) {
    throw InputError(fmt::format("{} {}: expected {} to {}", flag, runs, min, max));
  }
}

}  // namespace

std::vector<double> tube_factors() {
  std::vector<double> factors(std::begin(kWideFactors), std::end(kWideFactors));
  for (double factor = kFirstNarrow; factors.size() < kFactors; factor *= kStep) {
    factors.push_back(factor);
  }
  return factors;
}

int min_test_runs(const CalibrationSettings& settings) {
  return min_runs(settings.levels.back(), 1.0 - (1.0 - settings.confidence) / kMaxTests);
}

void require_usable(const CalibrationSettings& settings) {
  require_runs("--shape-runs", settings.scale_runs, 2);
  require_runs("--audit-runs", settings.audit_runs, 0);
  require_usable_levels(settings.levels, settings.confidence);
  const double highest = settings.levels.back();
  for (const auto& [flag, runs, needed] :
       {std::tuple{"--screen-runs", settings.screen_runs, min_runs(highest, kScreenConfidence)},
        std::tuple{"--test-runs", settings.test_runs, min_test_runs(settings)}}) {
    if (runs < needed) {
      throw InputError(
          fmt::format("{} {}: so few can't show a level of {}: at least {}, or lower --levels",
                      flag, runs, highest, needed));
    }
  }
}

CalibrationResult calibrate_tube(const CalibrationSettings& settings) {
  require_usable(settings);
  return Calibration(settings).run();
}

}  // namespace limber
