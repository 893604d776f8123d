#include <fmt/ranges.h>

#include "episode_choice.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/units.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/physical_traits.hpp"
#include "limber/report/training_report.hpp"
#include "limber/training/adaptation.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

class AdaptVerb final : public Verb {
 public:
  AdaptVerb()
      : Verb("adapt", "Make a family's network one arm's, from a minute of its motion",
             "limber collect --schedule identify --out minute.h5\n"
             "  limber adapt --model three_segment --recording minute.h5 --out mine.safetensors") {}

  void add_flags(CLI::App& app) override {
    add_arm_flag(app, arm_);
    app.add_option(
           "--model", family_file_,
           "Family, as limber family or train --family makes it, or the name of one of limber's "
           "own; or a model of adapt's, whose family it is then")
        ->required();
    app.add_option("--recording", recordings_, "Motions of the arm; repeat for more")->required();
    app.add_option("--weights", weights_,
                   "auto: where the family does not contain the arm, weights are trained too, and "
                   "kept if that is better on the seconds held back; never: e alone")
        ->check(CLI::IsMember({"auto", "never"}))
        ->capture_default_str();
    app.add_option("--out", out_, "Model of this arm to write")->required();
  }

  int run(const CommonFlags& flags) override {
    refuse_to_overwrite(out_, flags.force);
    family_file_ = find_family_file(family_file_);
    settings_.weights = weights_ == "auto" ? AdaptWeights::automatic : AdaptWeights::never;
    const ArmDescription arm = load_any_arm(arm_);
    const CompensationModel family = read_model(family_file_);
    require_family(family, family_file_);
    require_model_of(family, arm, family_file_);
    EpisodeReader reader(flags, arm, family.learnt_from_setpoints);
    const std::vector<Episode> episodes = reader.read_all(recordings_).episodes;
    take_common(flags, settings_);
    Adaptation done = adapt(arm, family, episodes, settings_);
    if (family.member_of_family && family.tube && !done.model.tube) {
      say(flags,
          "warning: {} is one arm's already, and its tube is lost; adapt its family to keep one",
          family_file_);
    }
    note_origin(family, reader.sources(), done);
    write_model(out_, done.model);
    print_result(flags, to_json(done), to_text(done, arm));
    return kExitDone;
  }

 private:
  void note_origin(const CompensationModel& family, const std::string& sources,
                   Adaptation& done) const {
    const std::string hash =
        family.member_of_family ? family.member_of_family->family_hash : file_hash(family_file_);
    if (done.model.member_of_family) {
      done.model.member_of_family->family_hash = hash;
    }
    done.model.training["data"] = sources;
    done.model.training["from"] = hash;
  }

  Json to_json(const Adaptation& done) const {
    Json json;
    json["file"] = out_;
    json["seconds"] = done.seconds;
    json["moving_s"] = done.moving_s;
    json["held_back_s"] = done.held_back_s;
    json["error_cm"] = {{"family_middle", json_number(kCmPerM * done.middle_error_m)},
                        {"e_alone", json_number(kCmPerM * done.fitted_error_m)},
                        {"with_weights", json_number(kCmPerM * done.trained_error_m)},
                        {"arms_of_the_family", json_number(kCmPerM * done.family_error_m)}};
    json["e"] = nullptr;
    json["sd"] = nullptr;
    if (const auto& member = done.model.member_of_family) {
      const Eigen::VectorXf deviation = member->covariance.diagonal().cwiseSqrt();
      json["e"] = std::vector<float>(member->e.begin(), member->e.end());
      json["sd"] = std::vector<float>(deviation.begin(), deviation.end());
    }
    json["traits"] = limber::to_json(done.traits);
    json["distance_from_family"] = done.distance;
    json["distance_to_nearest_arm"] = done.distance_to_nearest;
    json["expected_error_cm"] = kCmPerM * done.expected_error_m;
    json["uncertainty"] = {{"mean", done.uncertainty}, {"largest", done.largest_uncertainty}};
    json["of_family"] = done.is_of_family();
    json["trained_weights"] = done.has_trained_weights;
    json["tells_enough"] = !done.tells_too_little();
    json["valves"] = limber::to_json(done.model.identified_valves());
    return json;
  }

  std::string to_text(const Adaptation& done, const ArmDescription& arm) const {
    std::string text = fmt::format("{}: fitted to {:.0f} s, of which the arm moved in {:.0f}", out_,
                                   done.seconds, done.moving_s);
    if (done.held_back_s > 0.0) {
      text += fmt::format(
          "; tip error over the last {:.0f} s, held back, open loop: {:.2f} cm, of the family's "
          "middle {:.2f}",
          done.held_back_s,
          kCmPerM * (done.has_trained_weights ? done.trained_error_m : done.fitted_error_m),
          kCmPerM * done.middle_error_m);
    }
    text += fmt::format(
        "\nthe arm lies {:.2f} from the family's middle (its own arms about 1), {:.2f} from the "
        "nearest; {:.0f} % of the family's spread are left (at most {:.0f} % in a direction)",
        done.distance, done.distance_to_nearest, 100.0 * done.uncertainty,
        100.0 * done.largest_uncertainty);
    if (!done.traits.empty() && done.is_of_family()) {
      const std::string differences = differences_text(done.traits);
      text +=
          differences.empty()
              ? fmt::format("\nin all that this tells of its physics it is as {} says", arm.name)
              : fmt::format("\nit moves like arms with: {} (in brackets what {} says)", differences,
                            arm.name);
    }
    if (done.tells_too_little()) {
      text += done.moved_too_little()
                  ? "\nwarning: the recording moved too little to tell which arm it is; limber "
                    "collect --schedule identify records a minute that does"
                  : "\nwarning: of what arms of the family differ by, the recording leaves one "
                    "thing open; more seconds of other motions may tell it";
    }
    if (done.has_trained_weights) {
      text += fmt::format(
          "\nthe family does not contain this arm: weights were trained as well ({:.2f} cm instead "
          "of {:.2f})",
          kCmPerM * done.trained_error_m, kCmPerM * done.fitted_error_m);
    } else if (!done.is_of_family()) {
      text +=
          "\nwarning: the family does not contain this arm; more motions of it, given to limber "
          "train --from, make a model of its own";
    }
    text += "\n" + limber::to_text(done.model.identified_valves(), arm.command.unit, arm.dimension);
    return text;
  }

  std::string arm_ = "three_segment";
  std::string family_file_;
  std::vector<std::string> recordings_;
  std::string weights_ = "auto";
  std::string out_;
  AdaptationSettings settings_;
};

}  // namespace

std::unique_ptr<Verb> make_adapt_verb() {
  return std::make_unique<AdaptVerb>();
}

}  // namespace limber
