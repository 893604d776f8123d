#include "family_tensors.hpp"

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/ranges.h>

#include "limber/common/refuse_if.hpp"
#include "limber/network/arm_family.hpp"

namespace limber {

namespace {

constexpr const char* kFamilyKey = "family";
constexpr const char* kTraitsKey = "family_traits";
constexpr Eigen::Index kTraitColumns = 3;  // before slope and direction

/// A row each: of the arm's file, of the middle, what is left, slope, direction.
void add_traits(Safetensors& content, const std::vector<PhysicalTrait>& traits) {
  Eigen::MatrixXf rows(std::ssize(traits), kTraitColumns + 2 * traits.front().slope.size());
  std::vector<std::string> names;
  for (const PhysicalTrait& trait : traits) {
    rows.row(std::ssize(names)) << trait.of_file, trait.middle, trait.left, trait.slope.transpose(),
        trait.along.transpose();
    names.push_back(trait.name);
  }
  content.tensors[std::string(kFamilyTensors) + "traits"] = matrix_tensor(rows);
  content.metadata[kTraitsKey] = fmt::format("{}", fmt::join(names, ","));
}

std::vector<PhysicalTrait> read_traits(const Safetensors& content, TensorReader& tensors,
                                       const std::string& where) {
  const std::string tensor = std::string(kFamilyTensors) + "traits";
  if (!tensors.has(tensor)) {
    return {};
  }
  const Eigen::MatrixXf rows = tensors.matrix(tensor);
  std::istringstream names(text_at(content, kTraitsKey, where));
  std::vector<PhysicalTrait> traits;
  for (std::string name; std::getline(names, name, ',');) {
    traits.emplace_back().name = name;
  }
  const Eigen::Index size = (rows.cols() - kTraitColumns) / 2;
  refuse_if(std::ssize(traits) != rows.rows() || size < 1,
            "{}: tensor {} is {} by {}, and metadata {} has {} names; expected a row "
            "for each, of {} numbers, a slope and a direction",
            where, tensor, rows.rows(), rows.cols(), kTraitsKey, traits.size(), kTraitColumns);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    PhysicalTrait& trait = traits[i];
    trait.of_file = rows(i, 0);
    trait.middle = rows(i, 1);
    trait.left = rows(i, 2);
    trait.slope = rows.row(i).segment(kTraitColumns, size).transpose();
    trait.along = rows.row(i).tail(rows.cols() - kTraitColumns - size).transpose();
  }
  return traits;
}

}  // namespace

void add_family(Safetensors& content, const CompensationModel& model) {
  const std::string prefix = kFamilyTensors;
  content.tensors[prefix + "columns"] = matrix_tensor(model.family->shifts);
  content.tensors[prefix + "gains"] = matrix_tensor(model.family->log_gains);
  content.tensors[prefix + "arms"] = matrix_tensor(model.family->arms);
  if (!model.family->traits.empty()) {
    add_traits(content, model.family->traits);
  }
  if (model.member_of_family) {
    const FamilyMember& member = *model.member_of_family;
    content.metadata[kFamilyKey] = member.family_hash;
    content.metadata["e"] = fmt::format("[{}]", fmt::join(member.e, ", "));
    content.tensors[prefix + "e"] = vector_tensor(member.e);
    content.tensors[prefix + "covariance"] = matrix_tensor(member.covariance);
  }
}

void read_family_into(CompensationModel& model, const Safetensors& content, TensorReader& tensors,
                      const std::string& where) {
  const std::string prefix = kFamilyTensors;
  Eigen::MatrixXf shifts = tensors.matrix(prefix + "columns");
  Eigen::MatrixXf log_gains;
  if (tensors.has(prefix + "gains")) {
    log_gains = tensors.matrix(prefix + "gains");
  } else {  // an earlier family: e was read by the first layer alone
    refuse_if(shifts.cols() > ArmFamily::kMaxSize,
              "{}: tensor {}columns has {} columns; expected 1 to {}", where, prefix, shifts.cols(),
              ArmFamily::kMaxSize);
    const Eigen::Index units = hidden_units(model.layers);
    if (shifts.rows() == model.layers.front().weight.rows()) {
      shifts.conservativeResizeLike(Eigen::MatrixXf::Zero(units, shifts.cols()));
    }
    log_gains.setZero(units, 1 + shifts.cols());
  }
  model.family = {std::move(shifts), std::move(log_gains), tensors.matrix(prefix + "arms"),
                  read_traits(content, tensors, where)};
  if (tensors.has(prefix + "e")) {
    const auto hash = content.metadata.find(kFamilyKey);
    model.member_of_family = {hash == content.metadata.end() ? "" : hash->second,
                              tensors.vector(prefix + "e"), tensors.matrix(prefix + "covariance")};
  }
}

}  // namespace limber
