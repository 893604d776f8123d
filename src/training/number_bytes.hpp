#pragma once

#include <string_view>

namespace limber {

/// The numbers of a matrix of floats as they lie in memory, for hashes.
template <class Matrix>
std::string_view number_bytes(const Matrix& matrix) {
  return {reinterpret_cast<const char*>(matrix.data()),
          static_cast<std::size_t>(matrix.size()) * sizeof(typename Matrix::Scalar)};
}

}  // namespace limber
