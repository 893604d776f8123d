#pragma once

#include <string>
#include <vector>

#include "verb.hpp"

namespace limber {

/// What `limber train --from M --epochs 0` is told.
struct BoundModelRequest {
  std::string arm;
  std::string from;
  std::vector<std::string> data;
  std::vector<std::string> old_data;
  std::string out;
};

/// Gives the model `from` the bounds of (20) that these recordings have, and writes it to `out`;
/// nothing else in it changes. Bounds that it had are widened. Gives the exit code.
/// @throws InputError if a file is missing, broken or of another arm.
int add_bounds_to_model(const BoundModelRequest& request, const CommonFlags& flags);

}  // namespace limber
