#include "limber/network/gap_bounds.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"
#include "limber/common/json.hpp"
#include "refusal.hpp"

namespace limber {

namespace {

void require_range(const Eigen::VectorXf& low, const Eigen::VectorXf& high, const char* name,
                   const std::string& where) {
  for (Eigen::Index i = 0; i < low.size(); ++i) {
    if (low[i] > high[i]) {
      throw InputError(
          fmt::format("{}: tensor bounds.{}.min[{}] is {}; expected at most {}.max, {}", where,
                      name, i, low[i], name, high[i]));
    }
  }
}

/// The recordings in a model's record of its training, "a.h5 HASH, b.h5 HASH", as flags.
std::string data_flags(const CompensationModel& model) {
  const auto found = model.training.find("data");
  const std::string record = found != model.training.end() ? found->second : "";
  std::string flags;
  for (std::size_t begin = 0; begin < record.size();) {
    const std::size_t end = std::min(record.find(", ", begin), record.size());
    const std::string entry = record.substr(begin, end - begin);
    flags += " --data " + entry.substr(0, entry.rfind(' '));
    begin = end + 2;
  }
  return flags.empty() ? " --data RECORDING" : flags;
}

}  // namespace

void validate(const GapBounds& bounds, Dimension dimension, int point_count,
              const std::string& where) {
  const int gaps = point_count - 1;
  require_vector(where, "bounds.length.min", bounds.min_length_m, gaps);
  require_vector(where, "bounds.length.max", bounds.max_length_m, gaps);
  require_vector(where, "bounds.turn.min", bounds.min_turn_rad, gaps);
  require_vector(where, "bounds.turn.max", bounds.max_turn_rad, gaps);
  require_vector(where, "bounds.bend.max", bounds.max_bend_rad,
                 dimension == Dimension::space ? gaps : 0);
  require_range(bounds.min_length_m, bounds.max_length_m, "length", where);
  require_range(bounds.min_turn_rad, bounds.max_turn_rad, "turn", where);
  for (int i = 0; i < gaps; ++i) {
    if (!(bounds.min_length_m[i] > 0.0F)) {
      throw InputError(fmt::format("{}: tensor bounds.length.min[{}] is {}; expected metres, > 0",
                                   where, i, bounds.min_length_m[i]));
    }
    if (dimension == Dimension::space && !(bounds.max_bend_rad[i] > 0.0F)) {
      throw InputError(fmt::format("{}: tensor bounds.bend.max[{}] is {}; expected radians, > 0",
                                   where, i, bounds.max_bend_rad[i]));
    }
  }
}

GapBounds joined(const GapBounds& a, const GapBounds& b) {
  return {a.min_length_m.cwiseMin(b.min_length_m), a.max_length_m.cwiseMax(b.max_length_m),
          a.min_turn_rad.cwiseMin(b.min_turn_rad), a.max_turn_rad.cwiseMax(b.max_turn_rad),
          a.max_bend_rad.cwiseMax(b.max_bend_rad)};
}

void require_bounded(const CompensationModel& model, const std::string& file) {
  if (!model.bounds) {
    throw InputError(fmt::format(
        "{0}: the model has no bounds on its gaps' lengths and turns, so that its predictions can "
        "run away in long motions; an earlier limber trained it. Add them, in seconds and without "
        "training, from the recordings that it learnt from: limber train --from {0} --epochs 0{1} "
        "--out bounded.safetensors",
        file, data_flags(model)));
  }
}

Json to_json(const GapBounds& bounds) {
  const auto list = [](const Eigen::VectorXf& values) {
    return std::vector<float>(values.begin(), values.end());
  };
  Json json = {{"min_length_m", list(bounds.min_length_m)},
               {"max_length_m", list(bounds.max_length_m)},
               {"min_turn_rad", list(bounds.min_turn_rad)},
               {"max_turn_rad", list(bounds.max_turn_rad)}};
  if (bounds.max_bend_rad.size() > 0) {
    json["max_bend_rad"] = list(bounds.max_bend_rad);
  }
  return json;
}

std::string to_text(const GapBounds& bounds) {
  if (bounds.max_bend_rad.size() > 0) {
    return fmt::format(
        "bounds: gaps stay {:.1f} to {:.1f} mm long, bend by up to {:.3f} rad and twist by {:.3f} "
        "to {:.3f} rad",
        1e3F * bounds.min_length_m.minCoeff(), 1e3F * bounds.max_length_m.maxCoeff(),
        bounds.max_bend_rad.maxCoeff(), bounds.min_turn_rad.minCoeff(),
        bounds.max_turn_rad.maxCoeff());
  }
  return fmt::format("bounds: gaps stay {:.1f} to {:.1f} mm long and turn by {:.3f} to {:.3f} rad",
                     1e3F * bounds.min_length_m.minCoeff(), 1e3F * bounds.max_length_m.maxCoeff(),
                     bounds.min_turn_rad.minCoeff(), bounds.max_turn_rad.maxCoeff());
}

}  // namespace limber
