#pragma once

#include <map>
#include <string>
#include <string_view>

namespace limber {

/// web/dist inside the program: "/index.html", "/assets/studio.js" → bytes.
const std::map<std::string, std::string_view>& page_bytes();

}  // namespace limber
