#pragma once

#include <string>

#include "model_tensors.hpp"

namespace limber {

inline constexpr const char* kFamilyTensors = "family.";  // their names begin so

/// A family's part of a model file, and which of its arms the model is of (docs/formats.md).
void add_family(Safetensors& content, const CompensationModel& model);
void read_family_into(CompensationModel& model, const Safetensors& content, TensorReader& tensors,
                      const std::string& where);

}  // namespace limber
