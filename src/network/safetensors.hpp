#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace limber {

/// A tensor of 32-bit floats, last index fastest.
struct Tensor {
  std::vector<std::size_t> shape;
  std::vector<float> values;
};

/// What a safetensors file holds: tensors by name, and strings about them.
struct Safetensors {
  std::map<std::string, Tensor> tensors;
  std::map<std::string, std::string> metadata;
};

/// The file's bytes: 8 bytes of header length (little endian), the JSON header padded with spaces
/// to a multiple of 8, then the tensors one after another.
std::string safetensors_bytes(const Safetensors& content);

/// Parses what `safetensors_bytes` or any other writer of the format made; F32 tensors only.
/// @throws InputError beginning with `where`, naming the tensor or the part of the header.
Safetensors parse_safetensors(std::string_view bytes, const std::string& where);

}  // namespace limber
