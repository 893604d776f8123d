#include "limber/network/prediction_error.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/units.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {

namespace {

constexpr int kMaxRuns = 1'000'000'000;

}  // namespace

double conformal_quantile(std::vector<double> values, double share) {
  assert(!values.empty());
  // Exact shares such as 20·0.95 must not be rounded up by their last bit.
  constexpr double kRounding = 1e-9;
  const auto count = double(values.size());
  const double rank = std::min(std::ceil((count + 1.0) * share - kRounding), count);
  const auto at = values.begin() + std::ptrdiff_t(rank) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

void validate(const PredictionError& error, const std::string& where) {
  const auto refuse = [&](const char* name, double value, const char* expected) {
    throw InputError(
        fmt::format("{}: prediction_error.{} is {}; expected {}", where, name, value, expected));
  };
  if (error.runs < 1) {
    refuse("runs", error.runs, "at least 1");
  }
  if (!std::isfinite(error.run_s) || error.run_s <= 0.0) {
    refuse("run_s", error.run_s, "a time in seconds, > 0");
  }
  for (const auto& [name, value] :
       {std::pair{"largest_position_m", error.max_position_m},
        std::pair{"off_path_m", error.off_path_m},
        std::pair{"end_position_m", error.end_position_m},
        std::pair{"end_orientation_rad", error.end_orientation_rad.value_or(0.0)}}) {
    if (!std::isfinite(value) || value < 0.0) {
      refuse(name, value, "a finite number, ≥ 0");
    }
  }
}

std::string prediction_error_to_metadata(const PredictionError& error) {
  Json json({{"runs", error.runs},
             {"run_s", error.run_s},
             {"largest_position_m", error.max_position_m},
             {"off_path_m", error.off_path_m},
             {"end_position_m", error.end_position_m}});
  if (error.end_orientation_rad) {
    json["end_orientation_rad"] = *error.end_orientation_rad;
  }
  return json.dump();
}

PredictionError read_prediction_error(const YamlReader& root) {
  root.refuse_unknown_keys({"runs", "run_s", "largest_position_m", "off_path_m", "end_position_m",
                            "end_orientation_rad"});
  PredictionError error;
  error.runs = root.at("runs").integer("a number of runs", 1, kMaxRuns);
  error.run_s = root.at("run_s").positive("a time in seconds");
  error.max_position_m = root.at("largest_position_m").number("a distance in metres", 0.0);
  error.off_path_m = root.at("off_path_m").number("a distance in metres", 0.0);
  error.end_position_m = root.at("end_position_m").number("a distance in metres", 0.0);
  constexpr const char* kHeading = "end_orientation_rad";
  error.end_orientation_rad.reset();
  if (root.has(kHeading)) {
    error.end_orientation_rad = root.at(kHeading).number("an angle in radians", 0.0);
  }
  return error;
}

Json to_json(const PredictionError& error) {
  return {{"runs", error.runs},
          {"run_s", error.run_s},
          {"largest_cm_p95", kCmPerM * error.max_position_m},
          {"off_path_cm_p95", kCmPerM * error.off_path_m},
          {"end_cm_p95", kCmPerM * error.end_position_m},
          {"end_rad_p95", json_number(error.end_orientation_rad)}};
}

std::string to_text(const PredictionError& error) {
  return fmt::format(
      "error on {} unseen runs of {:.3g} s, {:.0f} %{}: {:.2f} cm anywhere on the arm, {:.2f} cm "
      "off the predicted path, {:.2f} cm{} at the tip's end",
      error.runs, error.run_s, 100.0 * PredictionError::kShare,
      error.runs < PredictionError::kMinRuns ? " guessed from their median" : "",
      kCmPerM * error.max_position_m, kCmPerM * error.off_path_m, kCmPerM * error.end_position_m,
      error.end_orientation_rad ? fmt::format(" and {:.3f} rad", *error.end_orientation_rad) : "");
}

}  // namespace limber
