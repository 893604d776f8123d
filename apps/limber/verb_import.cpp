#include <filesystem>
#include <map>

#include "limber/arm/arm_identity.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/simple_model.hpp"
#include "limber/logs/log_import.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

// Clocks that count from 1970 and from the start of a log are 2e9 s apart.
constexpr double kMaxOffsetS = 1e10;

class ImportVerb final : public Verb {
 public:
  ImportVerb()
      : Verb("import", "Make a recording of motion-capture and pressure logs",
             "limber import motive take1.csv --pressures "
             "pressures1.csv --arm mine.yaml --out train.h5\n"
             "  limber import csv run1.csv run2.csv --mapping mapping.yaml --arm mine.yaml "
             "--dry-run") {}

  void add_flags(CLI::App& app) override {
    app.add_option("format", format_, "motive: OptiTrack's export; csv: any table, with --mapping")
        ->required()
        ->check(CLI::IsMember({"motive", "csv"}));
    app.add_option("logs", logs_, "Motion logs, one per recording")->required();
    app.add_option("--pressures", command_logs_,
                   "Log of pressures (or the arm's other commands) on its own clock; one for each "
                   "motion log, in the same order")
        ->allow_extra_args(false);
    app.add_option(
        "--mapping", mapping_,
        "File that says which column or object is which plate, units, axes (docs/importing.md)");
    add_arm_flag(app, arm_);
    app.add_option("--time-offset-s", time_offset_s_,
                   "What to add to the pressure log's times; by default found by correlation")
        ->check(CLI::Range(-kMaxOffsetS, kMaxOffsetS))
        ->needs("--pressures");
    app.add_option("--out", out_, "Recording to write");
    app.add_flag("--dry-run", dry_run_, "Report what would be dropped and changed; write nothing");
  }

  int run(const CommonFlags& flags) override {
    refuse_if(out_.empty() == !dry_run_, "expected either --out FILE or --dry-run");
    if (!dry_run_) {
      refuse_to_overwrite(out_, flags.force);
    }
    const ArmDescription of_file = load_any_arm(arm_, PolynomialsOf::characterisation);
    if (of_file.no_load == NoLoadKind::fitted) {
      (void)load_any_arm(arm_);  // refuses a missing matrix: clocks are compared by it
    }
    const ArmDescription arm = with_lines_for_missing_polynomials(of_file);
    if (arm.hash() != of_file.hash()) {
      say(flags,
          "note: arm '{}' has segments without a usable strain polynomial: clocks and columns are "
          "compared with strains that rise evenly; limber characterize --recording fits them to "
          "what comes out",
          arm.name);
    }
    refuse_if(format_ == "csv" && mapping_.empty(),
              "import csv needs --mapping MAP.yaml, which "
              "says what the columns are (docs/importing.md)");
    ImportOptions options;
    options.mapping =
        mapping_.empty() ? default_import_mapping(arm) : read_import_mapping(mapping_, arm);
    options.command_logs.assign(command_logs_.begin(), command_logs_.end());
    options.time_offset_s = time_offset_s_;
    std::map<std::string, std::string> path_of_hash;
    for (const std::string& log : logs_) {
      (void)add_different(path_of_hash, log);
    }
    const std::vector<fs::path> logs(logs_.begin(), logs_.end());
    ImportResult result =
        format_ == "motive" ? import_motive(logs, options, arm) : import_csv(logs, options, arm);
    const ArmIdentity own = identity_of(of_file);
    result.recording.arm_hash = own.hash;
    result.recording.arm_description = own.description;
    if (!dry_run_) {
      write_recording(out_, result.recording);
    }
    Json json;
    json["file"] = dry_run_ ? Json(nullptr) : Json(out_);
    json["arm"] = result.recording.arm_name;
    json["commands_are"] = commands_are(result.recording.setpoints_only());
    json.update(to_json(result.report));
    print_result(flags, json,
                 to_text(result.report) + (dry_run_ ? ". Nothing was written" : " in " + out_));
    return kExitDone;
  }

 private:
  std::string format_;
  std::vector<std::string> logs_;
  std::vector<std::string> command_logs_;
  std::string mapping_;
  std::string arm_ = "three_segment";
  std::optional<double> time_offset_s_;
  std::string out_;
  bool dry_run_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_import_verb() {
  return std::make_unique<ImportVerb>();
}

}  // namespace limber
