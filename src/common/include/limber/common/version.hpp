#pragma once
// For everyone.

namespace limber {

/// Version of the program, as given once in the project() call of CMakeLists.txt, such as "0.1.0".
const char* version();

}  // namespace limber
