#include <filesystem>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/units.hpp"
#include "limber/lab/environment_measures.hpp"
#include "limber/lab/witnessed_environment.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/planning/problem_check.hpp"
#include "limber/report/plan_picture.hpp"
#include "limber/world/collision.hpp"
#include "model_flags.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

constexpr int kStraightLineStarts = 100;

class EnvironmentVerb final : public Verb {
 public:
  EnvironmentVerb()
      : Verb("environment", "Check an environment file, or sample some",
             "limber environment --random --seed 7 --count 5 --out my_environments\n"
             "  limber environment check my_environments/random_7_001.yaml") {}

  void add_flags(CLI::App& app) override {
    app.add_option("check", check_,
                   "The word check: is the file's start free, and its goal in reach and free?")
        ->type_name("");
    app.add_option("file", file_, "Environment to check, or the name of one of limber's own");
    app.add_flag("--random", random_, "Sample environments about motions of the arm");
    auto* witness =
        app.add_option(
               "--witness", witness_,
               "What moves to find the goals: the virtual arm or, where there is none like the "
               "arm, its model")
            ->check(CLI::IsMember({"arm", "model"}))
            ->capture_default_str();
    auto* count = app.add_option("--count", count_, "How many to sample")
                      ->capture_default_str()
                      ->check(CLI::Range(1, 100000));
    random_only_ = {witness, count,
                    app.add_option("--out", out_, "Folder for random environments")};
    add_arm_flag(app, arm_);
    app.add_option("--model", model_,
                   "Network that says what is in reach, and is the witness of --witness model; by "
                   "default the no-load model");
    valves_.add_valves_to(app);
    auto* margin = app.add_option("--margin-m", margin_m_, "Clearance that the check asks for")
                       ->check(CLI::Range(0.0, kMaxMarginM))
                       ->capture_default_str();
    check_only_ = {margin, app.add_option("--svg", svg_, "Draw the checked environment here")};
  }

  int run(const CommonFlags& flags) override {
    const bool check = check_ == "check" && !file_.empty();
    refuse_if(check == random_ || (!check && !check_.empty()),
              "expected either 'limber environment check FILE' or "
              "'limber environment --random --count N --out DIR'");
    for (const CLI::Option* option : check ? random_only_ : check_only_) {
      if (option->count() > 0) {
        throw InputError(fmt::format("{}: {} has no use for it; it goes with {}",
                                     option->get_name(), check ? "check" : "--random",
                                     check ? "--random" : "check"));
      }
    }
    const ArmDescription arm = load_asked_arm(arm_, "limber environment");
    if (!check && witness_ == "arm") {
      require_virtual_witness(arm);
      return run_random(arm, virtual_witness(arm), flags);
    }
    const ForwardModel forward =
        model_.empty() ? ForwardModel(arm) : ForwardModel(arm, read_model_of_one_arm(model_, arm));
    const MotionModel model = valves_.motion_model(arm, forward);
    return check ? run_check(arm, model, flags) : run_random(arm, model_witness(arm, model), flags);
  }

 private:
  int run_check(const ArmDescription& arm, const MotionModel& model, const CommonFlags& flags) {
    const Environment environment = load_environment(find_environment_file(file_), arm);
    refuse_to_overwrite_given({svg_}, flags);
    const PlanningProblem problem{arm, model, environment, margin_m_};
    const CollisionChecker checker(arm, environment.obstacles, margin_m_);
    const ProblemCheck check = check_problem(problem, checker, flags.seed);
    const Clearance start = checker.clearance(start_state(environment, arm).backbone);
    const bool has_clearance = start.obstacle >= 0;
    const bool easy =
        !check.refusal && straight_line_solves(problem, {}, kStraightLineStarts, flags.seed);
    Json json;
    json["status"] = check.refusal ? to_string(*check.refusal) : "ok";
    json["reason"] = check.reason;
    json["warnings"] = check.warnings;
    json["name"] = environment.name;
    json["obstacles"] = environment.obstacles.size();
    json["start_clearance_cm"] = has_clearance ? Json(start.value_m * kCmPerM) : Json(nullptr);
    json["straight_line_solves"] = easy;
    std::string text =
        check.refusal
            ? fmt::format("{}: {}: {}", file_, to_string(*check.refusal), check.reason)
            : fmt::format(
                  "{}: '{}' is fine: {} obstacles, start {}, a straight motion of set points {} it",
                  file_, environment.name, environment.obstacles.size(),
                  has_clearance ? fmt::format("{:.2f} cm clear of {}", start.value_m * kCmPerM,
                                              obstacle_name(environment, start.obstacle))
                                : "free",
                  easy ? "solves" : "does not solve");
    for (const std::string& warning : check.warnings) {
      text += "\nwarning: " + warning;
    }
    write_given(svg_, [&] { return environment_picture(arm, environment); });
    print_result(flags, json, check.refusal ? "" : text);
    if (check.refusal) {
      print_error(text);
    }
    return check.refusal ? kExitBadInput : kExitDone;  // as `limber plan` would
  }

  void require_virtual_witness(const ArmDescription& arm) const {
    refuse_if(!arm.command.is_pressure_kpa(),
              "arm '{}' has no virtual twin, as it is not driven by pressures in kPa: with "
              "--witness model --model MODEL its network moves in its place",
              arm.name);
    refuse_if(
        !model_.empty() || valves_.says_valves(),
        "--model, --valves and --no-valves: the witness is the virtual arm, and asks no model; "
        "with --witness model it is that model");
  }

  int run_random(const ArmDescription& arm, const Witness& witness, const CommonFlags& flags) {
    refuse_if(out_.empty(), "--random needs --out DIR, the folder for the environments");
    const auto path = [&](int k) {
      return fs::path(out_) / fmt::format("random_{}_{:03}.yaml", flags.seed, k);
    };
    for (int k = 1; k <= count_; ++k) {
      refuse_to_overwrite(path(k), flags.force);
    }
    Progress progress("environments", "sampled", std::uint64_t(count_), flags.progress());
    Json files = Json::array();
    for (int k = 1; k <= count_; ++k) {
      throw_if_interrupted();
      const std::optional<WitnessedEnvironment> sampled =
          witnessed_environment(arm, witness, flags.seed, std::uint64_t(k));
      refuse_if(
          !sampled,
          "no environment {} of seed {} for arm '{}': in a hundred random motions its tip comes "
          "nowhere; the pressure limits in the arm file may be too narrow",
          k, flags.seed, arm.name);
      write_file_atomically(path(k), environment_to_yaml(sampled->environment));
      files.push_back(path(k).string());
      progress.advance();
    }
    progress.finish();
    print_result(flags, {{"count", count_}, {"seed", flags.seed}, {"files", files}},
                 fmt::format("{} environments in {} (seed {})", count_, out_, flags.seed));
    return kExitDone;
  }

  std::string check_;
  std::string file_;
  bool random_ = false;
  std::string witness_ = "arm";
  int count_ = 1;
  std::string out_;
  std::string arm_ = "three_segment";
  std::string model_;
  ModelFlags valves_;
  double margin_m_ = 0.0;
  std::string svg_;
  std::vector<const CLI::Option*> random_only_;
  std::vector<const CLI::Option*> check_only_;
};

}  // namespace

std::unique_ptr<Verb> make_environment_verb() {
  return std::make_unique<EnvironmentVerb>();
}

}  // namespace limber
