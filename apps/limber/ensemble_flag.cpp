#include "ensemble_flag.hpp"

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/network/arm_family.hpp"

namespace limber {

void EnsembleFlag::add_to(CLI::App& app) {
  app.add_option("--ensemble", answer_,
                 "What predicts where the model is an ensemble of N networks (train --ensemble): "
                 "first: the one that validated best; mean: the mean of all, nearer to the arm, "
                 "but N times as many computations per query. By default what the model's tube was "
                 "calibrated with, or first")
      ->check(CLI::IsMember({"first", "mean"}));
}

CompensationModel EnsembleFlag::read(const std::string& model_file) const {
  require_model(model_file);
  CompensationModel model = read_model_of_one_arm(model_file);
  if (asks_for_mean() && model.member_count() == 1) {
    throw InputError(
        fmt::format("--ensemble mean: {} holds one network, so there is no mean; leave --ensemble "
                    "out, or make an ensemble with limber train --ensemble N",
                    model_file));
  }
  if (!answer_.empty()) {
    model.answer = asks_for_mean() ? EnsembleAnswer::mean : EnsembleAnswer::first;
  }
  return model;
}

void EnsembleFlag::require_model(const std::string& model_file) const {
  if (asks_for_mean() && model_file.empty()) {
    throw InputError(
        "--ensemble mean: the no-load model is no ensemble; give --model with a file of limber "
        "train --ensemble N, or leave --ensemble out");
  }
}

CompensationModel read_model_of_plan(const std::string& model_file, const Plan& plan,
                                     const std::string& plan_file) {
  CompensationModel model = read_model_of_one_arm(model_file);
  if (plan.ensemble.empty()) {
    model.answer = EnsembleAnswer::first;
    return model;
  }
  if (model.member_count() == 1) {
    throw InputError(
        fmt::format("{}: made with the mean of an ensemble; {} holds one "
                    "network. Give the model that the plan was made with",
                    plan_file, model_file));
  }
  model.answer = EnsembleAnswer::mean;
  return model;
}

std::string forest_model_hash(const std::string& model_file, const CompensationModel* model) {
  if (model_file.empty()) {
    return "";
  }
  const std::string hash = content_hash(read_file(model_file));
  const bool mean = model != nullptr && model->answer == EnsembleAnswer::mean;
  return mean ? hash + " mean" : hash;
}

}  // namespace limber
