# How limber's targets are made: one place for language level, warnings and sanitizers.

set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# Everything that our own code, and only our own code, is compiled with.
add_library(limber_private_settings INTERFACE)
target_compile_options(limber_private_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
  # GCC 12 sees overlapping copies in std::string's own operator+ at -O2 and above (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${LIMBER_WARNINGS_AS_ERRORS}>:-Werror>)
# What users run: an overrun of the stack or of a buffer whose size is known ends the program, it lies
# anywhere in memory, and its tables of addresses are read-only once it has started. What that costs:
# docs/log/2026-11-27-hardening.md.
include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX)
target_compile_options(limber_private_settings INTERFACE
  "$<$<CONFIG:Release>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2;-fstack-protector-strong>")
target_link_options(limber_private_settings INTERFACE "$<$<CONFIG:Release>:LINKER:-z,relro,-z,now>")
if(LIMBER_SANITIZE)
  target_compile_options(limber_private_settings INTERFACE
    -fsanitize=${LIMBER_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    # gcc 12 warns of its own <regex> where it is instrumented.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(limber_private_settings INTERFACE -fsanitize=${LIMBER_SANITIZE})
endif()

# limber_add_library(<module> SOURCES … [DEPENDS …] [PRIVATE_DEPENDS …])
# A static library limber_<module>, known to others as limber::<module>, its headers
# for users in src/<module>/include/limber/<module>, those for limber's other modules in internal/ (never
# installed); the module itself sees all of src/<module>.
function(limber_add_library module)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(limber_${module} STATIC ${ARG_SOURCES})
  add_library(limber::${module} ALIAS limber_${module})
  set_target_properties(limber_${module} PROPERTIES EXPORT_NAME ${module})
  target_compile_features(limber_${module} PUBLIC cxx_std_20)
  target_include_directories(limber_${module}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
           $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/internal>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(limber_${module}
    PUBLIC ${ARG_DEPENDS}
    PRIVATE ${ARG_PRIVATE_DEPENDS} $<BUILD_INTERFACE:limber_private_settings>)
  limber_reuse_headers(limber_${module} limber_precompiled)
  set_property(GLOBAL APPEND PROPERTY LIMBER_LIBRARIES limber_${module})
endfunction()

# limber_add_test(<module> SOURCES … [DEPENDS …] [LABEL unit|system] [ALONE <filter>] [TOGETHER suite…])
# One GoogleTest program a module, <module>_test; each of its tests is known to ctest on its own. Those
# that measure the machine run alone, those of a suite that trains a network first run together.
function(limber_add_test module)
  cmake_parse_arguments(ARG "" "LABEL;TIMEOUT;ALONE" "SOURCES;DEPENDS;TOGETHER" ${ARGN})
  if(NOT ARG_LABEL)
    set(ARG_LABEL unit)
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_executable(${module}_test ${ARG_SOURCES})
  set_target_properties(${module}_test PROPERTIES
    UNITY_BUILD OFF                   # tests name their helpers alike
    POSITION_INDEPENDENT_CODE OFF)    # the flags of the headers they reuse
  target_compile_features(${module}_test PRIVATE cxx_std_20)
  # Headers shared by tests; and, from the root, the private ones of the module that is tested.
  target_include_directories(${module}_test PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}
    ${PROJECT_SOURCE_DIR}/src/${module})
  target_compile_definitions(${module}_test PRIVATE
    LIMBER_SOURCE_DIR="${PROJECT_SOURCE_DIR}" LIMBER_TEST_DATA_DIR="${PROJECT_SOURCE_DIR}/tests/data"
    LIMBER_PYTHON="${LIMBER_PYTHON}")
  target_link_libraries(${module}_test PRIVATE
    ${ARG_DEPENDS} GTest::gmock GTest::gtest_main limber_private_settings)
  limber_reuse_headers(${module}_test limber_test_precompiled)
  list(TRANSFORM ARG_TOGETHER APPEND ".*")
  foreach(suite IN LISTS ARG_TOGETHER)
    add_test(NAME ${suite} COMMAND ${module}_test --gtest_filter=${suite})
    set_tests_properties(${suite} PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT})
  endforeach()
  list(JOIN ARG_TOGETHER ":" others)
  if(ARG_ALONE)
    string(JOIN ":" others ${others} "${ARG_ALONE}")
    gtest_discover_tests(${module}_test DISCOVERY_TIMEOUT 60 TEST_FILTER "${ARG_ALONE}"
      TEST_LIST ${module}_tests_alone
      PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT} RUN_SERIAL ON)
  endif()
  gtest_discover_tests(${module}_test DISCOVERY_TIMEOUT 60 TEST_FILTER "-${others}"
    PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT})
endfunction()
