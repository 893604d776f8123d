#pragma once
// For those who plan.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/network/quantized_shape.hpp"
#include "limber/planning/tip_grid.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// What a forest was grown for. A plan's shapes depend on all of it.
struct ForestKey {
  std::string arm_hash;     ///< ArmDescription::hash()
  std::string model_hash;   ///< of the model file; empty for the no-load model
  std::string valves_hash;  ///< ValveParameters::hash()
  std::string start_hash;   ///< of pressures and backbone that the arm starts with

  bool operator==(const ForestKey&) const = default;
};

/// @param model_hash  content hash of the model file; empty for the no-load model
ForestKey forest_key(const ArmDescription& arm, const std::string& model_hash,
                     const ValveParameters& valves, const ArmStart& start);

/// Motions that a model can make from one start without obstacles; a search looks for those that an
/// environment leaves free (docs/planning.md). Node 0 is the start; a node comes after its parent.
/// Constant after construction; share it freely.
struct Forest {
  ForestKey key;
  std::string arm_description;        ///< arm_keys_to_yaml(); empty in files of before it was kept
  std::vector<std::int32_t> parents;  ///< size N, −1 for the start
  Eigen::MatrixXf setpoints_kpa;      ///< n×N; motions between a node and its parent are straight
  Eigen::Matrix3Xf held_tips;         ///< (x_m, y_m, theta_rad) after the hold at a node
  QuantizedShapes shapes;             ///< 3(m−1)×N, before it (network/quantized_shape.hpp)

  // What `complete` derives from those; not in the file.
  std::vector<float> costs_kpa;  ///< size N, (2) from the start
  Pressures lowest_kpa;          ///< size n, of all nodes' set points
  Pressures highest_kpa;
  TipGrid tips;  ///< of the held tips

  int size() const { return static_cast<int>(parents.size()); }
  /// Fills in the rest from parents, set points and tips.
  void complete();

  static constexpr int kMaxNodes = 1 << 24;  ///< what a file's floats still tell apart
};

/// Whether the forest was grown for the arm (why_another_arm) and everything else of `key`.
bool is_grown_for(const Forest& forest, const ArmDescription& arm, const ForestKey& key);

/// @throws InputError if the forest was grown for another arm, other valves or another start, or
/// does not fit them. Only the caller can check the model.
void require_forest_of(const Forest& forest, const ArmDescription& arm,
                       const ValveParameters& valves, const ArmStart& start);

struct ForestSettings {
  int nodes = 200'000;  ///< 1 to Forest::kMaxNodes
  std::uint64_t seed = 1;
  int jobs = 0;  ///< threads, 0 for one per core; the forest does not depend on it
};

/// Called now and then with the number of nodes so far. False asks to stop.
using ForestCallback = std::function<bool(int nodes)>;

/// Grows a forest by the default planner's rules for exploring. Takes about 35 model queries per
/// node.
/// @return none if the callback asked to stop
/// @throws InputError if settings are out of range, or if the model diverges.
std::optional<Forest> grow_forest(const ArmDescription& arm, const MotionModel& model,
                                  const ForestKey& key, const ArmStart& start,
                                  const ForestSettings& settings = ForestSettings(),
                                  const ForestCallback& callback = {});

/// Writes a forest as a safetensors file (docs/formats.md, schema limber/forest/3), atomically.
void write_forest(const std::filesystem::path& path, const Forest& forest);

/// @throws InputError naming file and tensor if it is not a forest, or a broken one.
Forest read_forest(const std::filesystem::path& path);

}  // namespace limber
