#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/training/cross_validation.hpp"

namespace limber {

namespace {

/// Without what it is worth.
WayTried way_at(const JsonReader& row) {
  constexpr int kMaxUnits = 4096;
  WayTried way;
  way.epochs = row.at("epochs").integer(1, kMaxEpochs);
  for (const JsonReader& layer : row.at("hidden_units").elements("units of each hidden layer")) {
    way.hidden_units.push_back(layer.integer(1, kMaxUnits));
  }
  const JsonReader optimiser = row.at("optimiser");
  const std::string name = optimiser.text();
  for (const Optimiser known : {Optimiser::adam, Optimiser::soap}) {
    if (name == to_string(known)) {
      way.optimiser = known;
      return way;
    }
  }
  optimiser.refuse_found("expected adam or soap");
}

}  // namespace

Json to_json(const CrossValidation& found) {
  Json json = {{"identity", found.identity},
               {"folds", found.folds},
               {"epochs", found.epochs()},
               {"hidden_units", found.best().hidden_units},
               {"optimiser", to_string(found.best().optimiser)},
               {"tried", Json::array()},
               {"prediction_error", nullptr},
               {"tube", nullptr},
               {"widest_where", found.widest_where}};
  for (const WayTried& tried : found.tried) {
    json["tried"].push_back({{"epochs", tried.epochs},
                             {"hidden_units", tried.hidden_units},
                             {"optimiser", to_string(tried.optimiser)},
                             {"folds", tried.folds},
                             {"one_step_cm", json_number(tried.one_step_cm)},
                             {"window_32_cm", json_number(tried.window_32_cm)},
                             {"window_600_cm", json_number(tried.window_600_cm)}});
  }
  if (found.prediction_error) {
    json["prediction_error"] = Json::parse(prediction_error_to_metadata(*found.prediction_error));
  }
  if (found.tube) {
    json["tube"] = Json::parse(tube_to_metadata(*found.tube));
  }
  return json;
}

CrossValidation read_cross_validation(const std::string& text, const std::string& where) {
  const nlohmann::json json = parse_json_object(text, where);
  const JsonReader root(json, where, "");
  CrossValidation found;
  found.identity = root.at("identity").text();
  found.folds = root.at("folds").integer(1, kFolds);
  const WayTried wanted = way_at(root);
  found.chosen = -1;
  for (const JsonReader& row : root.at("tried").elements("a list of runs")) {
    const auto error_at = [&](const char* key) {
      const JsonReader field = row.at(key);
      return field.is_null() ? std::numeric_limits<double>::infinity() : field.number(0.0);
    };
    WayTried way = way_at(row);
    if (way == wanted) {
      found.chosen = int(found.tried.size());
    }
    way.folds = row.at("folds").integer(1, kFolds);
    way.one_step_cm = error_at("one_step_cm");
    way.window_32_cm = error_at("window_32_cm");
    way.window_600_cm = error_at("window_600_cm");
    found.tried.push_back(std::move(way));
  }
  if (found.chosen < 0) {
    root.at("optimiser").refuse("this was not tried; remove the file and train again");
  }
  if (const JsonReader error = root.at("prediction_error"); !error.is_null()) {
    found.prediction_error = read_prediction_error(
        YamlReader::from_text(error.value().dump(), where + ": prediction_error"));
  }
  found.widest_where = root.at("widest_where").text();
  if (const JsonReader tube = root.at("tube"); !tube.is_null()) {
    found.tube = read_tube(YamlReader::from_text(tube.value().dump(), where + ": tube"));
  }
  return found;
}

std::string to_text(const CrossValidation& found) {
  const auto in_cm = [](double error_cm) {
    return error_cm > 0.0 ? fmt::format("{:.2f}", error_cm) : std::string("not measured");
  };
  std::string text = fmt::format(
      "on {} parts that the networks had not seen (one step, 32, up to 600 frames)", found.folds);
  for (std::size_t i = 0; i < found.tried.size(); ++i) {
    const WayTried& tried = found.tried[i];
    text += fmt::format("{} {} epochs of {} by {}{}", i == 0 ? ":" : ";", tried.epochs,
                        fmt::join(tried.hidden_units, "-"), to_string(tried.optimiser),
                        tried.folds < found.folds && std::isfinite(tried.score_cm())
                            ? " (worse on the first part)"
                            : "");
    text += std::isfinite(tried.score_cm())
                ? fmt::format(": {}, {}, {} cm", in_cm(tried.one_step_cm),
                              in_cm(tried.window_32_cm), in_cm(tried.window_600_cm))
                : ": diverged";
    text += int(i) == found.chosen ? ", chosen" : "";
  }
  return text;
}

}  // namespace limber
