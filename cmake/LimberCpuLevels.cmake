# limber_cpu_level_sources(<variable> <stem> <type>…)
# Kernels are one header, <stem>_impl.hpp, compiled for several CPU levels; the program picks one at run
# time (limber/common/cpu_level.hpp). The header holds a table k<Type> in an unnamed namespace; the
# sources made here, <stem>_baseline.cpp, <stem>_avx2.cpp, …, give it to others as kBaseline<Type>,
# kAvx2<Type>, …. Sets <variable> to those for this architecture and gives each its instruction set.
# Always optimised: kernels that do not stay in registers would make even the tests crawl. gcc 12 takes
# its own _mm512_undefined_ps() for a use before initialisation.
function(limber_cpu_level_sources variable stem)
  set(options -O3 -ffp-contract=off -Wno-psabi $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  set(instructions_of_avx2 -mavx2 -mfma)
  set(instructions_of_avx512 -mavx2 -mfma -mavx512f -mavx512vl)
  set(levels baseline)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND levels avx2 avx512)
  endif()
  set(sources)
  foreach(level IN LISTS levels)
    string(SUBSTRING ${level} 0 1 first)
    string(SUBSTRING ${level} 1 -1 rest)
    string(TOUPPER ${first} first)
    set(tables "")
    foreach(type IN LISTS ARGN)
      string(REGEX REPLACE "<.*" "" name "${type}")
      string(APPEND tables "extern const ${type} k${first}${rest}${name};\n"
        "constexpr ${type} k${first}${rest}${name} = k${name};\n")
    endforeach()
    set(source "${CMAKE_CURRENT_BINARY_DIR}/${stem}_${level}.cpp")
    configure_file("${PROJECT_SOURCE_DIR}/cmake/cpu_level.cpp.in" "${source}" @ONLY)
    set(own_options ${options} ${instructions_of_${level}})
    set_source_files_properties("${source}" PROPERTIES
      COMPILE_OPTIONS "${own_options}" SKIP_PRECOMPILE_HEADERS ON)  # other flags
    list(APPEND sources "${source}")
  endforeach()
  set(${variable} ${sources} PARENT_SCOPE)
endfunction()
