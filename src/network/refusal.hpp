#pragma once

#include <string>

#include <Eigen/Core>

#include "limber/common/error.hpp"

namespace limber {

/// A model's file holds something else than it must. @param where  the file, and the field in it
[[noreturn]] inline void refuse(const std::string& where, const std::string& what) {
  throw InputError(where + ": " + what);
}

/// So many finite numbers. @param name  of the tensor
void require_vector(const std::string& where, const std::string& name,
                    const Eigen::VectorXf& values, Eigen::Index size);

/// @param name  of the tensor
void require_finite(const std::string& where, const std::string& name,
                    const Eigen::Ref<const Eigen::MatrixXf>& values);

}  // namespace limber
