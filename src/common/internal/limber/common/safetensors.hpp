#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace limber {

/// A tensor, last index fastest.
template <class Number>
struct TensorOf {
  std::vector<std::size_t> shape;
  std::vector<Number> values;
};
using Tensor = TensorOf<float>;
using ShortTensor = TensorOf<std::int16_t>;

/// Of a vector of numbers, Eigen's too.
inline Tensor vector_tensor(const auto& vector) {
  return {{std::size_t(vector.size())}, {vector.begin(), vector.end()}};
}

/// What a safetensors file holds: tensors by name, and strings about them.
struct Safetensors {
  std::map<std::string, Tensor> tensors;      ///< F32
  std::map<std::string, ShortTensor> shorts;  ///< I16
  std::map<std::string, std::string> metadata;
};

/// The file's bytes: 8 bytes of header length (little endian), the JSON header padded with spaces
/// to a multiple of 8, then the tensors one after another.
std::string safetensors_bytes(const Safetensors& content);

/// Parses what `safetensors_bytes` or any other writer of the format made; F32 and I16 tensors
/// only.
/// @throws InputError beginning with `where`, naming the tensor or the part of the header.
Safetensors parse_safetensors(std::string_view bytes, const std::string& where);

}  // namespace limber
