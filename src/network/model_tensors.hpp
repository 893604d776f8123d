#pragma once

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Core>

#include "limber/common/refuse_if.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/network/compensation_model.hpp"
#include "refusal.hpp"

namespace limber {

using RowMajorMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

inline Tensor matrix_tensor(const Eigen::MatrixXf& matrix) {
  const RowMajorMatrix rows = matrix;
  return {{std::size_t(matrix.rows()), std::size_t(matrix.cols())},
          {rows.data(), rows.data() + rows.size()}};
}

inline std::string text_at(const Safetensors& content, const std::string& key,
                           const std::string& where) {
  const auto found = content.metadata.find(key);
  refuse_if(found == content.metadata.end(), "{}: no metadata key {}", where, key);
  return found->second;
}

// The file's tensors, each to be read once; a tensor that was not read is a mistake.
class TensorReader {
 public:
  TensorReader(Safetensors& content, const std::string& where) : content_(content), where_(where) {}

  bool has(const std::string& name) const { return content_.tensors.count(name) > 0; }

  Eigen::MatrixXf matrix(const std::string& name) {
    const Tensor tensor = take(name, 2, "[out, in]");
    return Eigen::Map<const RowMajorMatrix>(tensor.values.data(), Eigen::Index(tensor.shape[0]),
                                            Eigen::Index(tensor.shape[1]));
  }

  Eigen::VectorXf vector(const std::string& name) {
    const Tensor tensor = take(name, 1, "[size]");
    return Eigen::Map<const Eigen::VectorXf>(tensor.values.data(), Eigen::Index(tensor.shape[0]));
  }

  // At least one layer.
  std::vector<Layer> layers(const std::string& prefix) {
    std::vector<Layer> layers;
    do {
      const std::string name = fmt::format("{}{}", prefix, layers.size());
      layers.push_back({matrix(name + ".weight"), vector(name + ".bias")});
    } while (has(fmt::format("{}{}.weight", prefix, layers.size())));
    return layers;
  }

  bool has_any(const std::string& prefix) const {
    const auto next = content_.tensors.lower_bound(prefix);
    return next != content_.tensors.end() && next->first.rfind(prefix, 0) == 0;
  }

  void require_all_taken() const {
    if (!content_.tensors.empty() || !content_.shorts.empty()) {
      refuse(where_, fmt::format("tensor {} does not belong in a model file",
                                 content_.tensors.empty() ? content_.shorts.begin()->first
                                                          : content_.tensors.begin()->first));
    }
  }

 private:
  Tensor take(const std::string& name, std::size_t dimensions, const char* expected) {
    const auto found = content_.tensors.find(name);
    refuse_if(found == content_.tensors.end(), "{}: no tensor {}", where_, name);
    if (found->second.shape.size() != dimensions) {
      refuse(where_, fmt::format("tensor {} has {} dimensions; expected {}", name,
                                 found->second.shape.size(), expected));
    }
    Tensor tensor = std::move(found->second);
    content_.tensors.erase(found);
    return tensor;
  }

  Safetensors& content_;
  const std::string& where_;
};

}  // namespace limber
