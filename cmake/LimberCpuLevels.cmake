# limber_cpu_level_sources(<variable> <stem>)
# Kernels are one source compiled for several CPU levels, <stem>_baseline.cpp, <stem>_avx2.cpp, …;
# the program picks one at run time (limber/common/cpu_level.hpp). Sets <variable> to the sources for
# this architecture and gives each its instruction set. Always optimised: kernels that do not stay in
# registers would make even the tests crawl. gcc 12 takes its own _mm512_undefined_ps() for a use
# before initialisation.
function(limber_cpu_level_sources variable stem)
  set(options -O3 -ffp-contract=off -Wno-psabi -Wno-maybe-uninitialized)
  set(sources ${stem}_baseline.cpp)
  set_source_files_properties(${stem}_baseline.cpp PROPERTIES COMPILE_OPTIONS "${options}")
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND sources ${stem}_avx2.cpp ${stem}_avx512.cpp)
    set_source_files_properties(${stem}_avx2.cpp PROPERTIES
      COMPILE_OPTIONS "${options};-mavx2;-mfma")
    set_source_files_properties(${stem}_avx512.cpp PROPERTIES
      COMPILE_OPTIONS "${options};-mavx2;-mfma;-mavx512f;-mavx512vl")
  endif()
  set_source_files_properties(${sources} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)  # other flags
  set(${variable} ${sources} PARENT_SCOPE)
endfunction()
