#include <cmath>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/common/utf8.hpp"
#include "limber/planning/forest.hpp"

namespace limber {

namespace {

constexpr const char* kSchema = "limber/forest/3";
constexpr float kFarthest = 1e4F;  // [m, rad] of a tip; an arm's reach is a few metres

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw InputError(where + ": " + what);
}

// One row a node.
template <class Matrix>
TensorOf<typename Matrix::Scalar> rows_of(const Matrix& columns) {
  return {{std::size_t(columns.cols()), std::size_t(columns.rows())},
          {columns.data(), columns.data() + columns.size()}};
}

/// A file's parts, by name.
class ForestReader {
 public:
  explicit ForestReader(const fs::path& path)
      : where_(path.string()), content_(parse_safetensors(read_file(path), where_)) {
    if (text("schema") != kSchema) {
      refuse(where_, fmt::format("schema '{}'; expected {}: --build-forest grows it again",
                                 shortened(text("schema")), kSchema));
    }
  }

  std::string text(const std::string& name) const {
    const auto found = content_.metadata.find(name);
    refuse_if(found == content_.metadata.end(), "{}: metadata {} is missing; is this a forest?",
              where_, name);
    return found->second;
  }

  std::string text_or_none(const std::string& name) const {
    return content_.metadata.count(name) > 0 ? content_.metadata.at(name) : std::string();
  }

  /// N×columns numbers, N as in the first tensor asked for.
  const Tensor& tensor(const std::string& name, std::size_t rank) {
    const Tensor& tensor = named(content_.tensors, name, rank);
    for (const float value : tensor.values) {
      refuse_if(!std::isfinite(value), "{}: tensor {} holds a number that is not finite", where_,
                name);
    }
    return tensor;
  }

  /// The same of whole numbers.
  const ShortTensor& shorts(const std::string& name, std::size_t rank) {
    return named(content_.shorts, name, rank);
  }

  const std::string& where() const { return where_; }

 private:
  template <class Number>
  const TensorOf<Number>& named(const std::map<std::string, TensorOf<Number>>& tensors,
                                const std::string& name, std::size_t rank) {
    const auto found = tensors.find(name);
    refuse_if(found == tensors.end(), "{}: tensor {} is missing", where_, name);
    const TensorOf<Number>& tensor = found->second;
    refuse_if(tensor.shape.size() != rank || tensor.values.empty() ||
                  (nodes_ != 0 && tensor.shape[0] != nodes_),
              "{}: tensor {} does not have one row for each of the forest's nodes", where_, name);
    if (tensor.shape[0] > std::size_t(Forest::kMaxNodes)) {
      refuse(where_, fmt::format("tensor {} has {} rows; expected at most {}", name,
                                 tensor.shape[0], Forest::kMaxNodes));
    }
    nodes_ = tensor.shape[0];
    return tensor;
  }

  std::string where_;
  Safetensors content_;
  std::size_t nodes_ = 0;
};

std::vector<std::int32_t> parents_of(ForestReader& reader) {
  const Tensor& stored = reader.tensor("parents", 1);
  std::vector<std::int32_t> parents;
  for (std::size_t i = 0; i < stored.values.size(); ++i) {
    const auto parent = double(stored.values[i]);
    const bool is_root = i == 0 && parent == -1.0;
    refuse_if(!is_root && (parent < 0.0 || parent >= double(i) || parent != std::floor(parent)),
              "{}: parents[{}] = {}; expected a node before it (-1 for the first alone)",
              reader.where(), i, parent);
    parents.push_back(std::int32_t(parent));
  }
  return parents;
}

}  // namespace

void write_forest(const fs::path& path, const Forest& forest) {
  Safetensors content;
  content.metadata = {{"schema", kSchema},
                      {"arm_hash", forest.key.arm_hash},
                      {"model_hash", forest.key.model_hash},
                      {"valves_hash", forest.key.valves_hash},
                      {"start_hash", forest.key.start_hash}};
  if (!forest.arm_description.empty()) {
    content.metadata["arm_description"] = forest.arm_description;
  }
  // Our reader has no whole numbers of 32 bits: a float tells all of these apart.
  content.tensors["parents"] = {{forest.parents.size()},
                                {forest.parents.begin(), forest.parents.end()}};
  content.tensors["setpoints_kpa"] = rows_of(forest.setpoints_kpa);
  content.tensors["held_tips"] = rows_of(forest.held_tips);
  content.shorts["shapes"] = rows_of(forest.shapes);
  write_file_atomically(path, safetensors_bytes(content));
}

Forest read_forest(const fs::path& path) {
  ForestReader reader(path);
  Forest forest;
  forest.key = {reader.text("arm_hash"), reader.text("model_hash"), reader.text("valves_hash"),
                reader.text("start_hash")};
  forest.arm_description = reader.text_or_none("arm_description");
  if (!forest.arm_description.empty()) {
    (void)read_arm_keys(forest.arm_description, path.string() + ": metadata arm_description");
  }
  forest.parents = parents_of(reader);
  const Tensor& setpoints = reader.tensor("setpoints_kpa", 2);
  const auto segments = Eigen::Index(setpoints.shape[1]);
  forest.setpoints_kpa = Eigen::Map<const Eigen::MatrixXf>(setpoints.values.data(), segments,
                                                           Eigen::Index(forest.size()));
  const Tensor& tips = reader.tensor("held_tips", 2);
  refuse_if(tips.shape[1] != kPoseSize,
            "{}: tensor held_tips does not have 3 columns (x_m, y_m, theta_rad)", reader.where());
  for (std::size_t i = 0; i < tips.values.size(); ++i) {
    if (std::abs(tips.values[i]) > kFarthest) {
      refuse(reader.where(), fmt::format("held_tips[{}, {}] = {}; expected at most {} (m, rad)",
                                         i / kPoseSize, i % kPoseSize, tips.values[i], kFarthest));
    }
  }
  forest.held_tips = Eigen::Map<const Eigen::Matrix3Xf>(tips.values.data(), kPoseSize,
                                                        Eigen::Index(forest.size()));
  const ShortTensor& shapes = reader.shorts("shapes", 2);
  forest.shapes = Eigen::Map<const QuantizedShapes>(shapes.values.data(),
                                                    Eigen::Index(shapes.shape[1]), forest.size());
  forest.complete();
  return forest;
}

}  // namespace limber
