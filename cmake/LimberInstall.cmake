# Install, export and packaging: find_package(limber) gives limber::common … limber::experiment.

include(CMakePackageConfigHelpers)
get_property(libraries GLOBAL PROPERTY LIMBER_LIBRARIES)
install(TARGETS ${libraries} EXPORT limberTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS limber_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
foreach(module IN LISTS LIMBER_MODULES)
  if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/src/${module}/include")  # not every module has one
    install(DIRECTORY src/${module}/include/limber DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  endif()
endforeach()
install(DIRECTORY arms environments DESTINATION ${CMAKE_INSTALL_DATADIR}/limber)
install(FILES LICENSE README.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(EXPORT limberTargets NAMESPACE limber:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/limber)
configure_package_config_file(cmake/limberConfig.cmake.in "${CMAKE_BINARY_DIR}/limberConfig.cmake"
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/limber)
write_basic_package_version_file("${CMAKE_BINARY_DIR}/limberConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/limberConfig.cmake" "${CMAKE_BINARY_DIR}/limberConfigVersion.cmake"
              cmake/LimberImportedTargets.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/limber)

set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The limber developers")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What the library's headers include, for those who build on it.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev, libfmt-dev, libhdf5-dev, libmujoco-dev, \
librandom123-dev, libtbb-dev, libxxhash-dev, libyaml-cpp-dev, nlohmann-json3-dev")
if(LIMBER_BUILD_PYTHON)
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3-numpy")
endif()
include(CPack)
