#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "limber/common/json.hpp"

namespace limber {

class YamlReader;

/// What was found, for programs and for people.
struct Finding {
  Json json;
  std::string text;
};

/// What an arm file says, in the plane or in space.
Finding inspect_arm(const YamlReader& root);

}  // namespace limber
