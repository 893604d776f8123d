# Targets for the libraries whose own CMake packages are missing or awkward on Debian 12.
# Used by our build and by the installed package, so that both see the same targets.

# MuJoCo's own package wants qhull's development files, which a user of the shared library does not need.
if(NOT TARGET limber_import::mujoco)
  find_path(LIMBER_MUJOCO_INCLUDE_DIR mujoco/mujoco.h REQUIRED)
  find_library(LIMBER_MUJOCO_LIBRARY mujoco REQUIRED)
  add_library(limber_import::mujoco UNKNOWN IMPORTED)
  set_target_properties(limber_import::mujoco PROPERTIES
    IMPORTED_LOCATION "${LIMBER_MUJOCO_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${LIMBER_MUJOCO_INCLUDE_DIR}")
endif()

# HDF5's find module sets variables, not a target, in CMake 3.25 when it goes through the compiler wrapper.
if(NOT TARGET limber_import::hdf5)
  add_library(limber_import::hdf5 INTERFACE IMPORTED)
  set_target_properties(limber_import::hdf5 PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${HDF5_INCLUDE_DIRS}"
    INTERFACE_LINK_LIBRARIES "${HDF5_CXX_LIBRARIES}")
endif()

# ONNX, for `limber export --onnx`: optional. Its own package names a protobuf target that only
# find_package(Protobuf) makes; the messages need these two libraries alone.
if(NOT TARGET limber_import::onnx)
  find_path(LIMBER_ONNX_INCLUDE_DIR onnx/onnx_pb.h)
  find_library(LIMBER_ONNX_LIBRARY onnx_proto)
  find_path(LIMBER_PROTOBUF_INCLUDE_DIR google/protobuf/message.h)
  find_library(LIMBER_PROTOBUF_LIBRARY protobuf)
  if(LIMBER_ONNX_INCLUDE_DIR AND LIMBER_ONNX_LIBRARY AND LIMBER_PROTOBUF_INCLUDE_DIR AND LIMBER_PROTOBUF_LIBRARY)
    add_library(limber_import::onnx UNKNOWN IMPORTED)
    set_target_properties(limber_import::onnx PROPERTIES
      IMPORTED_LOCATION "${LIMBER_ONNX_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${LIMBER_ONNX_INCLUDE_DIR};${LIMBER_PROTOBUF_INCLUDE_DIR}"
      INTERFACE_COMPILE_DEFINITIONS "ONNX_NAMESPACE=onnx;ONNX_ML=1"
      INTERFACE_LINK_LIBRARIES "${LIMBER_PROTOBUF_LIBRARY}")
  endif()
endif()

# Philox counter-based random numbers and xxHash: headers only.
if(NOT TARGET limber_import::headers)
  find_path(LIMBER_RANDOM123_INCLUDE_DIR Random123/philox.h REQUIRED)
  find_path(LIMBER_XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
  add_library(limber_import::headers INTERFACE IMPORTED)
  set_target_properties(limber_import::headers PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${LIMBER_RANDOM123_INCLUDE_DIR};${LIMBER_XXHASH_INCLUDE_DIR}")
endif()

# OMPL, optional. Its own package sets variables, not a target, and names Boost libraries that only
# need to be there for parts of it that limber does not use.
if(LIMBER_OMPL AND NOT TARGET limber_import::ompl)
  find_path(LIMBER_OMPL_INCLUDE_DIR ompl/control/SpaceInformation.h PATH_SUFFIXES ompl-1.5 ompl-1.6 ompl)
  find_library(LIMBER_OMPL_LIBRARY ompl)
  if(LIMBER_OMPL_INCLUDE_DIR AND LIMBER_OMPL_LIBRARY)
    add_library(limber_import::ompl UNKNOWN IMPORTED)
    set_target_properties(limber_import::ompl PROPERTIES
      IMPORTED_LOCATION "${LIMBER_OMPL_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${LIMBER_OMPL_INCLUDE_DIR}"
      INTERFACE_LINK_LIBRARIES Eigen3::Eigen)
  else()
    message(STATUS "OMPL not found: planners ompl:… are left out")
    set(LIMBER_OMPL OFF)
  endif()
endif()
