# Optional libraries that `limber bench` is compared with: a loadable module each, made where the
# library is found, never linked into the program or the installed package. Sanitizers would see the
# libraries' own threads, so such builds go without.
option(LIMBER_BUILD_PEERS "Build the peers of limber bench whose libraries are found" ON)

# limber_add_peer(<name> INCLUDES … LIBRARIES …)
# src/lab/speed/<name>_peer.cpp as lib/limber/peers/limber_<name>_peer.so in the build folder.
function(limber_add_peer name)
  cmake_parse_arguments(ARG "" "" "INCLUDES;LIBRARIES" ${ARGN})
  add_library(limber_${name}_peer MODULE ${PROJECT_SOURCE_DIR}/src/lab/speed/${name}_peer.cpp)
  set_target_properties(limber_${name}_peer PROPERTIES PREFIX ""
    LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib/limber/peers")
  target_compile_features(limber_${name}_peer PRIVATE cxx_std_20)
  target_include_directories(limber_${name}_peer SYSTEM PRIVATE ${ARG_INCLUDES})
  target_link_libraries(limber_${name}_peer PRIVATE ${ARG_LIBRARIES} limber_private_settings)
  add_dependencies(limber_lab limber_${name}_peer)
endfunction()

if(LIMBER_BUILD_PEERS AND NOT LIMBER_SANITIZE)
  # oneDNN's own CMake package wants OpenCL's development files, which the CPU engine does not need.
  find_package(OpenMP QUIET COMPONENTS CXX)
  find_path(LIMBER_ONEDNN_INCLUDE_DIR oneapi/dnnl/dnnl.hpp)
  find_library(LIMBER_ONEDNN_LIBRARY dnnl)
  if(OpenMP_CXX_FOUND AND LIMBER_ONEDNN_INCLUDE_DIR AND LIMBER_ONEDNN_LIBRARY)
    file(STRINGS "${LIMBER_ONEDNN_INCLUDE_DIR}/oneapi/dnnl/dnnl_version.h" onednn_major
      REGEX "define DNNL_VERSION_MAJOR 2$")
    if(onednn_major)
      limber_add_peer(onednn INCLUDES ${LIMBER_ONEDNN_INCLUDE_DIR}
        LIBRARIES ${LIMBER_ONEDNN_LIBRARY} OpenMP::OpenMP_CXX)
    endif()
  endif()
  find_path(LIMBER_LIBXSMM_INCLUDE_DIR libxsmm.h)
  find_library(LIMBER_LIBXSMM_LIBRARY xsmm)
  find_library(LIMBER_LIBXSMM_NOBLAS_LIBRARY xsmmnoblas)
  if(LIMBER_LIBXSMM_INCLUDE_DIR AND LIMBER_LIBXSMM_LIBRARY AND LIMBER_LIBXSMM_NOBLAS_LIBRARY)
    limber_add_peer(libxsmm INCLUDES ${LIMBER_LIBXSMM_INCLUDE_DIR}
      LIBRARIES ${LIMBER_LIBXSMM_LIBRARY} ${LIMBER_LIBXSMM_NOBLAS_LIBRARY} pthread m)
  endif()
  find_path(LIMBER_TORCH_INCLUDE_DIR ATen/ATen.h)
  find_library(LIMBER_TORCH_LIBRARY torch_cpu)
  find_library(LIMBER_C10_LIBRARY c10)
  if(LIMBER_TORCH_INCLUDE_DIR AND LIMBER_TORCH_LIBRARY AND LIMBER_C10_LIBRARY)
    limber_add_peer(torch INCLUDES ${LIMBER_TORCH_INCLUDE_DIR}
      LIBRARIES ${LIMBER_TORCH_LIBRARY} ${LIMBER_C10_LIBRARY})
  endif()
endif()
