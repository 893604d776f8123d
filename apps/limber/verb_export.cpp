#include <filesystem>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/data/recording_export.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/onnx_export.hpp"
#include "limber/sim/mjcf.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "limber/world/plan.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

constexpr int kReferenceQueries = 100;

class ExportVerb final : public Verb {
 public:
  ExportVerb()
      : Verb("export",
             "What a file holds, for other programs: CSV, Motive's CSV, ONNX, MuJoCo's XML",
             "limber export three_segment --mjcf arm.xml\n"
             "  limber export train.h5 --motive logs --time-offset-s "
             "12.5 --noise-m 0.0005 --occlusions 20\n"
             "  limber export model.safetensors --onnx model.onnx") {}

  void add_flags(CLI::App& app) override {
    app.add_option("file", file_,
                   "Recording, model, plan or arm; or the name of one of limber's own")
        ->required();
    app.add_option("--csv", csv_,
                   "Folder for tables: a recording's episodes, a plan's set points and shapes, a "
                   "model's reference queries");
    CLI::Option* motive = app.add_option("--motive", motive_,
                                         "Folder for a recording as OptiTrack Motive would "
                                         "have logged it, with pressures in a log of their own");
    app.add_option("--onnx", onnx_, "File for a model's network with its normalisation");
    app.add_option("--mjcf", mjcf_, "File for an arm's chain as MuJoCo's XML");
    app.add_option("--arm", arm_,
                   "For a plan: the arm whose limits and steps its set points are checked against; "
                   "needed for a plan without a certificate");
    for (CLI::Option* option :
         {app.add_option("--rate-hz", settings_.rate_hz,
                         "Rows per second; the recording's by default")
              ->check(more_than_zero()),
          app.add_option("--time-offset-s", settings_.time_offset_s,
                         "What import has to add to the pressure log's times"),
          app.add_option("--noise-m", settings_.noise_m, "Noise of positions, standard deviation"),
          app.add_option("--noise-rad", settings_.noise_rad, "Noise of headings"),
          app.add_option("--occlusions", settings_.occlusions,
                         "How often a plate is hidden in each episode"),
          app.add_option("--occlusion-s", settings_.occlusion_s, "For how long")
              ->capture_default_str(),
          app.add_flag("--markers", settings_.markers,
                       "Two markers per plate instead of rigid bodies")}) {
      option->group("With --motive")->needs(motive);
    }
    app.get_option("--occlusion-s")->needs("--occlusions");
  }

  int run(const CommonFlags& flags) override {
    refuse_if(csv_.empty() && motive_.empty() && onnx_.empty() && mjcf_.empty(),
              "expected at least one of --csv DIR, --motive DIR, --onnx FILE, --mjcf FILE");
    settings_.seed = flags.seed;
    file_ = find_any_file(file_);
    refuse_to_overwrite_given({onnx_, mjcf_}, flags);
    for (const std::string& folder : {csv_, motive_}) {
      if (!folder.empty()) {
        refuse_to_fill(folder, flags.force);
      }
    }
    export_by_kind();
    std::string text;
    Json json = {{"file", file_}, {"written", Json::array()}};
    for (const fs::path& path : written_) {
      json["written"].push_back(path.string());
      text += (text.empty() ? "" : "\n") + path.string();
    }
    print_result(flags, json, text);
    return kExitDone;
  }

 private:
  static void refuse_to_fill(const fs::path& folder, bool force) {
    std::error_code error;
    require_writable_folder(folder);
    refuse_if(!force && fs::exists(folder, error) && !fs::is_empty(folder, error),
              "{}: the folder is not empty; --force writes into it", folder.string());
  }

  void export_by_kind() {
    switch (kind_of(file_)) {
      case FileKind::recording:
        require_only(csv_, motive_, "a recording", "--csv or --motive");
        require_no_arm("a recording");
        export_recording();
        break;
      case FileKind::model:
        require_only(csv_, onnx_, "a model", "--csv or --onnx");
        require_no_arm("a model");
        export_model();
        break;
      case FileKind::plan:
        require_only(csv_, csv_, "a plan", "--csv");
        export_plan();
        break;
      case FileKind::forest:
        throw InputError(
            fmt::format("{}: a forest; any reader of safetensors opens it as it is", file_));
      default:
        refuse_if(read_file(file_).find("limber/arm/") == std::string::npos,
                  "{}: not a recording, model, plan or arm; nothing else can be exported", file_);
        require_only(mjcf_, mjcf_, "an arm", "--mjcf");
        require_no_arm("an arm");
        export_arm();
    }
  }

  void require_no_arm(const char* kind) const {
    refuse_if(!arm_.empty(), "{}: {}; --arm belongs to a plan", file_, kind);
  }

  void require_only(const std::string& one, const std::string& other, const char* kind,
                    const char* allowed) const {
    for (const std::string* given : {&csv_, &motive_, &onnx_, &mjcf_}) {
      refuse_if(!given->empty() && given != &one && given != &other, "{}: {}; expected {}", file_,
                kind, allowed);
    }
  }

  void export_recording() {
    const Recording recording = read_recording(file_);
    if (!csv_.empty()) {
      add(export_csv(recording, csv_));
    }
    if (!motive_.empty()) {
      add(export_motive(recording, motive_, settings_));
    }
  }

  void export_model() {
    const CompensationModel model = read_model_of_one_arm(file_);
    if (!onnx_.empty()) {
      write_onnx(onnx_, model);
      add({onnx_});
    }
    if (!csv_.empty()) {
      const fs::path path = fs::path(csv_) / "reference_queries.csv";
      write_file_atomically(path, reference_queries_csv(model, kReferenceQueries, settings_.seed));
      add({path});
    }
  }

  void export_plan() {
    const Plan plan = read_plan(file_);
    require_safe_to_command(plan);
    const fs::path setpoints = fs::path(csv_) / "setpoints.csv";
    const fs::path shapes = fs::path(csv_) / "backbones.csv";
    write_setpoints_csv(setpoints, plan);
    write_backbones_csv(shapes, plan);
    add({setpoints, shapes});
    if (arm_.empty() && plan.arm_description.empty()) {
      return;
    }
    const ArmDescription arm = arm_.empty() ? read_arm_keys(plan.arm_description, file_)
                                            : load_asked_arm(arm_, "limber export");
    if (!arm.commands.empty()) {
      const fs::path commands = fs::path(csv_) / "commands.csv";
      write_commands_csv(commands, plan, arm);
      add({commands});
    }
  }

  /// Set points go to valves, which follow whatever they are given.
  void require_safe_to_command(const Plan& plan) const {
    if (!arm_.empty()) {
      require_plan_of(plan, load_asked_arm(arm_, "limber export"), file_);
    } else if (!plan.certified) {
      throw InputError(fmt::format(
          "{}: certificate: missing, so nothing says that its set points keep to the limits of arm "
          "'{}'. Give --arm ARM.yaml to check them against it, or plan again",
          file_, plan.arm_name));
    }
  }

  void export_arm() {
    const ArmDescription arm = load_arm(file_);
    require_pressure_driven(arm, "the virtual arm");
    const VirtualArmParameters parameters = virtual_arm_parameters(arm);
    write_file_atomically(mjcf_, chain_mjcf(arm, parameters, parameters.time_step_s));
    add({mjcf_});
  }

  void add(const std::vector<fs::path>& files) {
    written_.insert(written_.end(), files.begin(), files.end());
  }

  std::string file_;
  std::string arm_;
  std::string csv_;
  std::string motive_;
  std::string onnx_;
  std::string mjcf_;
  LogExportSettings settings_;
  std::vector<fs::path> written_;
};

}  // namespace

std::unique_ptr<Verb> make_export_verb() {
  return std::make_unique<ExportVerb>();
}

}  // namespace limber
