# limber campaign under mpirun or srun: lib/limber/limber_mpi.so, which the program loads where it is
# started as a rank. So the program does not depend on MPI, and is built without it. On a cluster,
# `cmake --install build/release --component mpi` puts it beside the installed program.
option(LIMBER_MPI "Build limber campaign's ranks where MPI is found" ON)
if(LIMBER_MPI AND LIMBER_BUILD_PROGRAM AND NOT LIMBER_SANITIZE)
  set(MPI_CXX_SKIP_MPICXX ON)  # its C++ classes, which the standard dropped
  find_package(MPI QUIET COMPONENTS CXX)
  if(MPI_CXX_FOUND)
    add_library(limber_mpi MODULE ${PROJECT_SOURCE_DIR}/src/lab/campaign/mpi_ranks.cpp)
    set_target_properties(limber_mpi PROPERTIES PREFIX ""
      LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib/limber")
    target_compile_features(limber_mpi PRIVATE cxx_std_20)
    target_include_directories(limber_mpi PRIVATE ${PROJECT_SOURCE_DIR}/src/lab/internal)
    target_link_libraries(limber_mpi PRIVATE MPI::MPI_CXX Threads::Threads limber_private_settings)
    add_dependencies(limber_lab limber_mpi)
    install(TARGETS limber_mpi LIBRARY DESTINATION lib/limber COMPONENT mpi EXCLUDE_FROM_ALL)
  endif()
endif()
