#include "limber/network/arm_family.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/printable.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/units.hpp"
#include "limber/network/arm_gain.hpp"
#include "refusal.hpp"

namespace limber {

namespace {

constexpr const char* kTubeErrorKey = "tube_error_cm";
constexpr std::size_t kMaxTraitName = 40;

/// Makes the hidden layers those of arm e, or of the family again.
void change_arm(CompensationModel& model, const Eigen::VectorXf& e, bool to_arm) {
  const Eigen::VectorXf shift = model.family->shifts * e;
  const Eigen::MatrixXf& log_gains = model.family->log_gains;
  const Eigen::VectorXf of_middle = log_gains.col(0);
  const Eigen::VectorXf of_arm = of_middle + log_gains.rightCols(e.size()) * e;
  const Eigen::ArrayXf log_gain =
      of_arm.unaryExpr(&log_arm_gain<float>) - of_middle.unaryExpr(&log_arm_gain<float>);
  const Eigen::ArrayXf gain = (to_arm ? log_gain : -log_gain).exp();
  Eigen::Index row = 0;
  for (std::size_t i = 0; i + 1 < model.layers.size(); ++i) {
    auto& [weight, bias] = model.layers[i];
    const auto own = gain.segment(row, bias.size());
    const auto own_shift = shift.segment(row, bias.size()).array();
    weight.array().colwise() *= own;
    bias = to_arm ? (own * (bias.array() + own_shift)).matrix().eval()
                  : (own * bias.array() - own_shift).matrix().eval();
    row += bias.size();
  }
}

/// @param columns  how many the tensor should have, in words where there is a choice
void validate(const Eigen::MatrixXf& tensor, const char* name, Eigen::Index units, bool fits,
              const std::string& columns, const std::string& where) {
  refuse_if(!fits || tensor.rows() != units,
            "{}: tensor {} is {} by {}; expected {}, the units of the hidden layers, by {}", where,
            name, tensor.rows(), tensor.cols(), units, columns);
  require_finite(where, name, tensor);
}

bool is_trait_name(const std::string& name) {
  return !name.empty() && name.size() <= kMaxTraitName &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

void validate(const PhysicalTrait& trait, int size, const std::string& where) {
  if (!is_trait_name(trait.name)) {
    refuse(where, fmt::format("metadata family_traits: {}; expected names of at most {} small "
                              "letters, digits and _",
                              printable(in_one_line(trait.name)), kMaxTraitName));
  }
  const std::string what = "family.traits, " + trait.name;
  require_finite(where, what, trait.slope);
  require_finite(where, what, trait.along);
  refuse_if(trait.slope.size() != size || trait.along.size() != size ||
                !std::isfinite(trait.of_file + trait.middle) ||
                !(trait.left > 0.0F && std::isfinite(trait.left)),
            "{}: tensor {}: {}, {}, {}, a slope of {} numbers and a direction of {}; "
            "expected three finite numbers, the last above 0, and {} numbers each",
            where, what, trait.of_file, trait.middle, trait.left, trait.slope.size(),
            trait.along.size(), size);
}

}  // namespace

Eigen::Index hidden_units(const std::vector<Layer>& layers) {
  Eigen::Index units = 0;
  for (std::size_t i = 0; i + 1 < layers.size(); ++i) {
    units += layers[i].bias.size();  // not yet checked against the weights of a file
  }
  return units;
}

void validate(const ArmFamily& family, const std::vector<Layer>& layers, const std::string& where) {
  const Eigen::Index units = hidden_units(layers);
  const int size = family.size();
  validate(family.shifts, "family.columns", units, size >= 1 && size <= ArmFamily::kMaxSize,
           fmt::format("1 to {}", ArmFamily::kMaxSize), where);
  validate(family.log_gains, "family.gains", units, family.log_gains.cols() == 1 + size,
           fmt::format("{}", 1 + size), where);
  refuse_if(family.arms.rows() != family.size() || family.arms.cols() < 1,
            "{}: tensor family.arms is {} by {}; expected {}, the columns of "
            "family.columns, by at least 1",
            where, family.arms.rows(), family.arms.cols(), family.size());
  require_finite(where, "family.arms", family.arms);
  for (const PhysicalTrait& trait : family.traits) {
    validate(trait, family.size(), where);
  }
}

void validate(const FamilyMember& member, const ArmFamily& family, const std::string& where) {
  refuse_if(member.e.size() != family.size() || member.covariance.rows() != family.size() ||
                member.covariance.cols() != family.size(),
            "{}: tensors family.e and family.covariance have {} and {} by {} "
            "numbers; expected {} and its square",
            where, member.e.size(), member.covariance.rows(), member.covariance.cols(),
            family.size());
  require_finite(where, "family.e", member.e);
  require_finite(where, "family.covariance", member.covariance);
}

bool is_family(const CompensationModel& model) {
  return model.family && !model.member_of_family;
}

CompensationModel model_of_arm(CompensationModel model, const FamilyMember& member) {
  model = family_of(std::move(model));
  change_arm(model, member.e, true);
  model.member_of_family = member;
  return model;
}

CompensationModel model_after_run(const CompensationModel& before, const FamilyMember& now) {
  CompensationModel model = model_of_arm(before, now);
  model.prediction_error = before.prediction_error;
  return model;
}

CompensationModel model_of_followed_arm(CompensationModel model, const Eigen::VectorXf& e) {
  const Eigen::Index size = model.member_of_family ? model.member_of_family->e.size() : 0;
  refuse_if(size == 0 || e.size() != size,
            "{} numbers that say which arm of its family this is; the model has {}", e.size(),
            size);
  FamilyMember member = *model.member_of_family;
  member.e = e;
  return model_of_arm(std::move(model), member);
}

CompensationModel family_of(CompensationModel model) {
  if (model.member_of_family) {
    change_arm(model, model.member_of_family->e, false);
    model.member_of_family.reset();
    model.prediction_error.reset();
    model.tube.reset();
  }
  return model;
}

Tube scaled(Tube tube, double times) {
  for (double& scale_m : tube.plate_scale_m) {
    scale_m *= times;
  }
  tube.end_scale_m *= times;
  tube.end_heading_scale_rad *= times;
  return tube;
}

double noted_error_m(const CompensationModel& family, const std::string& key) {
  const auto found = family.training.find(key);
  const std::optional<double> error_cm =
      found == family.training.end() ? std::nullopt : number_in<double>(found->second);
  return error_cm ? *error_cm / kCmPerM : std::numeric_limits<double>::quiet_NaN();
}

double expected_error_of_tube_m(const CompensationModel& family) {
  return noted_error_m(family, kTubeErrorKey);
}

void note_expected_error_of_tube(CompensationModel& family, double error_m) {
  family.training[kTubeErrorKey] = fmt::format("{}", kCmPerM * error_m);
}

void require_family(const CompensationModel& model, const std::string& where) {
  refuse_if(!model.family,
            "{}: a network of one arm; expected a family's, which limber train --family or limber "
            "family makes",
            where);
}

void require_one_arm(const CompensationModel& model, const std::string& where) {
  if (is_family(model)) {
    throw InputError(fmt::format(
        "{}: a family of {} arms, and of none of them alone. Record a minute of the arm, virtual "
        "or real (limber collect --schedule identify --out MINUTE.h5), then: limber adapt --model "
        "{} --recording MINUTE.h5 --out MINE.safetensors",
        where, model.family->arms.cols(), where));
  }
}

CompensationModel read_model_of_one_arm(const fs::path& path) {
  CompensationModel model = read_model(path);
  require_one_arm(model, path.string());
  return model;
}

CompensationModel read_model_of_one_arm(const fs::path& path, const ArmDescription& arm) {
  CompensationModel model = read_model_of_one_arm(path);
  require_model_of(model, arm, path.string());
  return model;
}

}  // namespace limber
