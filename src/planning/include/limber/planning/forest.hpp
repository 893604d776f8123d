#pragma once
// For those who plan.

#include <cstddef>
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
#include "limber/world/environment.hpp"

namespace limber {

/// Poses of tips, and the cost to get there, in square cells, to find those near a point quickly.
/// Constant after construction.
class TipGrid {
 public:
  struct Tip {
    float x_m;
    float y_m;
    float theta_rad;
    float cost_kpa;
    std::int32_t node;
  };

  TipGrid() = default;
  /// @param tips       3×N, (x_m, y_m, theta_rad) of node 0 … N − 1, finite
  /// @param costs_kpa  size N
  TipGrid(const Eigen::Matrix3Xf& tips, const std::vector<float>& costs_kpa);

  /// Calls visit(tip) for every tip at most `radius_m` from a point (apart from rounding), in the
  /// order of cells, and in a cell in the order of nodes.
  template <class Visit>
  void visit_near(const Eigen::Vector2f& point_m, float radius_m, Visit&& visit) const {
    if (tips_.empty()) {
      return;
    }
    const int first_column = column(point_m.x() - radius_m);
    const int last_column = column(point_m.x() + radius_m);
    const int last_row = row(point_m.y() + radius_m);
    for (int r = row(point_m.y() - radius_m); r <= last_row; ++r) {
      const std::size_t end = begins_[cell(last_column, r) + 1];
      for (std::size_t i = begins_[cell(first_column, r)]; i < end; ++i) {
        const Tip& tip = tips_[i];
        const float dx = tip.x_m - point_m.x();
        const float dy = tip.y_m - point_m.y();
        if (dx * dx + dy * dy <= radius_m * radius_m) {
          visit(tip);
        }
      }
    }
  }

 private:
  int column(float x_m) const { return cell_index(x_m - low_m_.x(), columns_); }
  int row(float y_m) const { return cell_index(y_m - low_m_.y(), rows_); }
  int cell_index(float distance_m, int count) const;
  std::size_t cell(int column, int row) const {
    return std::size_t(row) * std::size_t(columns_) + std::size_t(column);
  }

  Eigen::Vector2f low_m_ = Eigen::Vector2f::Zero();
  float cell_m_ = 1.0F;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::size_t> begins_;  // of a cell's tips, a row's cells side by side; and the end
  std::vector<Tip> tips_;
};

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

  int size() const { return int(parents.size()); }
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
/// @throws InputError if settings are out of range, of an arm in space, or if the model diverges.
std::optional<Forest> grow_forest(const ArmDescription& arm, const MotionModel& model,
                                  const ForestKey& key, const ArmStart& start,
                                  const ForestSettings& settings = ForestSettings(),
                                  const ForestCallback& callback = {});

/// Writes a forest as a safetensors file (docs/formats.md, schema limber/forest/3), atomically.
void write_forest(const std::filesystem::path& path, const Forest& forest);

/// @throws InputError naming file and tensor if it is not a forest, or a broken one.
Forest read_forest(const std::filesystem::path& path);

}  // namespace limber
