#include "limber/lab/tube_calibration.hpp"

#include <cstdint>
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
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/version.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/tube_shape.hpp"
#include "limber/report/report_page.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

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
std::string evidence_page(const Json& evidence) {
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

constexpr const char* kCalibrationFile = "calibration.json";
constexpr double kScreenConfidence = 0.5;  // a screen only says what is worth testing
constexpr int kMaxTests = 3;               // of a level; they share its confidence
constexpr double kPassesTest = 0.8;        // how likely a factor that is tested is to hold
constexpr const char* kTooFewPlans =
    "so wide a tube leaves too few environments with a plan; a model with smaller errors is "
    "needed, or a larger budget";
constexpr double kAuditConfidence = 0.99;  // that an audit contradicts

/// What has to be the same for runs of two starts to be one calibration.
Json identity(const CalibrationSettings& settings) {
  const TubeRunSettings& runs = settings.runs;
  Json json = {{"schema", "limber/calibration/6"},
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

class Calibration {
 public:
  explicit Calibration(const CalibrationSettings& settings)
      : settings_(settings), identity_(identity(settings)) {
    prepare_folder();
  }

  CalibrationResult run() {
    find_shape();
    const TubeRuns screen = run_phase("screen", settings_.screen_runs, first_factor_);
    for (const double level : settings_.levels) {
      if (screen.executed() < settings_.screen_runs) {
        fail(level, kTooFewPlans);
      } else if (const std::optional<TubeLevel> found = find_level(level, screen)) {
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

  /// With fewer runs where a tube leaves hardly any environment with a plan.
  /// @param factor  0: without a tube
  TubeRuns run_phase(const std::string& name, int runs, double factor) {
    const bool has_tube = factor > 0.0;
    const TubeRuns done = run_tube_phase(
        settings_.runs,
        {name, runs, has_tube ? &shape_ : nullptr, factor, expected_error_m_, has_tube}, &*folder_);
    Json json = {{"phase", name}, {"factor", factor}};
    json.update(to_json(done, factor));
    if (!has_tube) {
      json.erase("outside");
      json.erase("coverage");
    }
    evidence_["phases"].push_back(json);
    return done;
  }

  void find_shape() {
    const TubeRuns runs = run_phase("shape", settings_.scale_runs, 0.0);
    expected_error_m_ = runs.expected_error_m();
    const std::vector<GrowingErrors> motions = runs.errors();
    const auto& [candidate, tube] = narrowest_tube(motions, settings_.runs.arm.length_m());
    shape_ = tube_shape(errors_of(motions, candidate), tube.growth);
    shape_.source = "virtual arm";
    first_factor_ = tube.levels.front().factor;
  }

  double test_confidence() const { return 1.0 - (1.0 - settings_.confidence) / kMaxTests; }

  /// With which a test would leave as few runs outside as mostly passes it, as far as runs with
  /// about such a factor tell.
  double factor_by(const TubeRuns& runs, double level) const {
    return conformal_quantile(
        runs.scores(),
        1.0 - share_that_passes(settings_.test_runs, level, test_confidence(), kPassesTest));
  }

  /// The first factor that holds its test. Each is chosen by the runs before.
  std::optional<TubeLevel> find_level(double level, TubeRuns runs) {
    for (int test = 0; test < kMaxTests; ++test) {
      const double factor = factor_by(runs, level);
      runs =
          run_phase(fmt::format("test_{:g}_{}", 100.0 * level, test), settings_.test_runs, factor);
      if (runs.executed() < settings_.test_runs) {
        fail(level, kTooFewPlans);
        return std::nullopt;
      }
      const int outside = runs.outside(factor);
      settings_.say(fmt::format("level {}: factor {:.3f}: {} of {} runs outside", level, factor,
                                outside, runs.executed()));
      if (share_at_most(outside, runs.executed(), test_confidence()) <= 1.0 - level) {
        TubeLevel found{.level = level,
                        .factor = factor,
                        .runs = runs.executed(),
                        .outside = outside,
                        .confidence = settings_.confidence};
        audit(found);
        return found;
      }
    }
    fail(level, fmt::format("no factor held its test on {} runs", settings_.test_runs));
    return std::nullopt;
  }

  void audit(TubeLevel& level) {
    if (settings_.audit_runs == 0) {
      return;
    }
    const TubeRuns runs = run_phase(fmt::format("audit_{:g}", 100.0 * level.level),
                                    settings_.audit_runs, level.factor);
    level.audit_runs = runs.executed();
    level.audit_outside = runs.outside(level.factor);
    settings_.say(fmt::format("level {}: audit: {} of {} runs outside", level.level,
                              level.audit_outside, level.audit_runs));
    if (level.audit_runs < settings_.audit_runs) {
      fail(level.level, kTooFewPlans);
    } else if (share_at_least(level.audit_outside, level.audit_runs, kAuditConfidence) >
               1.0 - level.level) {
      fail(level.level, fmt::format("its audit contradicts it: {} of {} runs are outside",
                                    level.audit_outside, level.audit_runs));
    }
  }

  void fail(double level, const std::string& why) {
    result_.failures.push_back(fmt::format("level {}: {}", level, why));
  }

  const CalibrationSettings& settings_;
  const Json identity_;
  std::optional<OutputFolder> folder_;
  Tube shape_;
  double first_factor_ = 0.0;      // by the runs of the shape, which had no tube
  double expected_error_m_ = 0.0;  // of the arm whose tube is the shape; 0: of no family
  Json evidence_;
  CalibrationResult result_;
};

void require_runs(const char* flag, int runs, int min, int max = 1'000'000) {
  refuse_if(runs < min || runs > max, "{} {}: expected {} to {}", flag, runs, min, max);
}

}  // namespace

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
    refuse_if(runs < needed,
              "{} {}: so few can't show a level of {}: at least {}, or lower --levels", flag, runs,
              highest, needed);
  }
}

CalibrationResult calibrate_tube(const CalibrationSettings& settings) {
  require_usable(settings);
  return Calibration(settings).run();
}

}  // namespace limber
