#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/csv_reader.hpp"
#include "limber/common/error.hpp"
#include "limber/sim/driver_server.hpp"

namespace limber {

namespace {

using Kind = ServerFaultKind;

constexpr std::array<std::pair<const char*, Kind>, 18> kKinds = {{
    {"late", Kind::late},
    {"repeat", Kind::repeat},
    {"old", Kind::old},
    {"half", Kind::half},
    {"huge", Kind::huge},
    {"nan", Kind::nan},
    {"size", Kind::size},
    {"clock", Kind::clock},
    {"die", Kind::die},
    {"hang", Kind::hang},
    {"flood", Kind::flood},
    {"hello", Kind::hello},
    {"over", Kind::over},
    {"stuck", Kind::stuck},
    {"jump", Kind::jump},
    {"sealed", Kind::sealed},
    {"rise", Kind::rise},
    {"release", Kind::release},
}};

}  // namespace

const char* to_string(ServerFaultKind kind) {
  return std::find_if(kKinds.begin(), kKinds.end(), [&](const auto& k) { return k.second == kind; })
      ->first;
}

ServerFault parse_server_fault(const std::string& text) {
  constexpr double kMaxFrame = 1e6;
  const std::size_t at = text.find('@');
  const std::string name = text.substr(0, at);
  const auto* found =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const auto& k) { return name == k.first; });
  double frame = -1.0;
  if (at == std::string::npos || found == kKinds.end() ||
      !parse_number(text.substr(at + 1), frame) || frame < 0.0 || frame > kMaxFrame ||
      frame != static_cast<int>(frame)) {
    std::vector<const char*> names;
    for (const auto& kind : kKinds) {
      names.push_back(kind.first);
    }
    throw InputError(
        fmt::format("--fault {}: expected KIND@FRAME, as in die@12; kinds: {}; frames count from 0",
                    text, fmt::join(names, ", ")));
  }
  return {found->second, static_cast<int>(frame)};
}

}  // namespace limber
