# The libraries' headers, parsed once for all modules and once for all tests: half of the time that a
# test's source takes goes into reading them.

option(LIMBER_PRECOMPILED_HEADERS "Parse the libraries' headers once, for a faster build from nothing" OFF)
if(LIMBER_PRECOMPILED_HEADERS)
  # What GCC 12 inlines from a precompiled header is no system header to it any more: it warns of its
  # own strings (GCC bug 105651), depending on the length of a folder's name.
  target_compile_options(limber_private_settings INTERFACE
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-use-after-free>")
endif()

set(limber_library_headers
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers>
  <numeric> <optional> <span> <string> <string_view> <utility> <vector>
  <Eigen/Core> <Eigen/Cholesky> <fmt/format.h> <fmt/ranges.h> <nlohmann/json.hpp>)

# limber_precompile(<target> HEADERS … LINKS …): something for others to reuse.
function(limber_precompile target)
  cmake_parse_arguments(ARG "" "" "HEADERS;LINKS" ${ARGN})
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/${target}.cpp" CONTENT "// Nothing: ${target} is its headers.\n")
  add_library(${target} OBJECT "${CMAKE_BINARY_DIR}/${target}.cpp")
  target_compile_features(${target} PRIVATE cxx_std_20)
  target_link_libraries(${target} PRIVATE ${ARG_LINKS} limber_private_settings)
  target_precompile_headers(${target} PRIVATE ${ARG_HEADERS})
endfunction()

if(LIMBER_PRECOMPILED_HEADERS)
  limber_precompile(limber_precompiled
    HEADERS ${limber_library_headers}
    LINKS Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json)
endif()

# limber_reuse_headers(<target> <precompiled>)
function(limber_reuse_headers target precompiled)
  if(LIMBER_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${precompiled})
  endif()
endfunction()
