# Install, export and packaging: find_package(limber) gives limber::common … limber::lab. Every
# file belongs to a component, and each is a Debian package: runtime (limber: the program and its data),
# dev (limber-dev: headers and libraries) and python (python3-limber: python/CMakeLists.txt).

include(CMakePackageConfigHelpers)
get_property(libraries GLOBAL PROPERTY LIMBER_LIBRARIES)
install(TARGETS ${libraries} EXPORT limberTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
install(TARGETS limber_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
foreach(module IN LISTS LIMBER_MODULES)
  if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/src/${module}/include")  # not every module has one
    install(DIRECTORY src/${module}/include/limber DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
            COMPONENT dev)
  endif()
endforeach()
install(DIRECTORY arms environments families DESTINATION ${CMAKE_INSTALL_DATADIR}/limber COMPONENT runtime)
install(FILES LICENSE README.md SECURITY.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(EXPORT limberTargets NAMESPACE limber:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/limber
        COMPONENT dev)
configure_package_config_file(cmake/limberConfig.cmake.in "${CMAKE_BINARY_DIR}/limberConfig.cmake"
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/limber)
write_basic_package_version_file("${CMAKE_BINARY_DIR}/limberConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/limberConfig.cmake" "${CMAKE_BINARY_DIR}/limberConfigVersion.cmake"
              cmake/LimberImportedTargets.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/limber COMPONENT dev)

include(LimberBillOfMaterials)

set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The limber developers")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL runtime dev)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME limber)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "Learn, simulate and plan the motion of soft pneumatic arms")
set(limber_same_version "limber (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME limber-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEV_DESCRIPTION "limber's headers and libraries, for find_package(limber)")
# What limberConfig.cmake looks for: what headers include, and what the libraries are linked with.
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "${limber_same_version}, libeigen3-dev, libfmt-dev, \
libhdf5-dev, libmujoco-dev, librandom123-dev, libtbb-dev, libxxhash-dev, libyaml-cpp-dev, nlohmann-json3-dev")
if(LIMBER_OMPL)
  string(APPEND CPACK_DEBIAN_DEV_PACKAGE_DEPENDS ", libompl-dev")
endif()
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "cmake, g++, libonnx-dev, libprotobuf-dev")
if(LIMBER_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-limber)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "limber as a Python module")
  # The module is one Python's, and its arms and environments are the runtime's.
  math(EXPR limber_next_python "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${limber_same_version}, \
python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), \
python3 (<< ${Python_VERSION_MAJOR}.${limber_next_python}), python3-numpy")
endif()
include(CPack)
