# What the Debian packages are made of: limber.spdx (SPDX 2.3) and the licences of what lies inside them,
# from the table below, the versions that dpkg and web/package.json say, and the notices that come with them.

# The date that everything made of this source bears: SOURCE_DATE_EPOCH, or the last commit's.
set(limber_epoch "$ENV{SOURCE_DATE_EPOCH}")
if(limber_epoch STREQUAL "")
  execute_process(COMMAND git -C "${PROJECT_SOURCE_DIR}" log -1 --format=%ct
    OUTPUT_VARIABLE limber_epoch OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT limber_epoch MATCHES "^[0-9]+$")
  set(limber_epoch 315532800)  # 1980: sources without a history
endif()
file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/CPackDate.cmake" CONTENT "set(ENV{SOURCE_DATE_EPOCH} @limber_epoch@)\n"
     @ONLY)
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_BINARY_DIR}/CPackDate.cmake")

set(limber_bill "")
file(READ LICENSE limber_licences)
file(READ web/dist/licences.txt notices)
string(APPEND limber_licences "\n\n${notices}")

function(limber_bill_package id name version licence purl)
  string(APPEND limber_bill "\nPackageName: ${name}\nSPDXID: SPDXRef-${id}\nPackageVersion: ${version}\n"
    "PackageDownloadLocation: NOASSERTION\nFilesAnalyzed: false\nPackageLicenseConcluded: ${licence}\n"
    "PackageLicenseDeclared: ${licence}\nPackageCopyrightText: NOASSERTION\n"
    "ExternalRef: PACKAGE-MANAGER purl ${purl}\n")
  set(limber_bill "${limber_bill}" PARENT_SCOPE)
endfunction()

# limber_part(<package> <licence> <of…> [INSIDE] [LINKED]): a Debian package that others of ours hold
# compiled code or a copy of (INSIDE), or load when they start (LINKED). npm/NAME: a package of the page.
function(limber_part package licence)
  cmake_parse_arguments(ARG "INSIDE;LINKED" "" "" ${ARGN})
  string(REGEX REPLACE "[^A-Za-z0-9.-]" "-" id "${package}")
  if(package MATCHES "^npm/(.*)")
    file(READ web/package.json json)
    string(JSON version GET "${json}" dependencies ${CMAKE_MATCH_1})
    set(purl "pkg:${package}@${version}")
  else()
    execute_process(COMMAND dpkg-query --show --showformat=\${Version} ${package}
      OUTPUT_VARIABLE version ERROR_QUIET RESULT_VARIABLE missing)
    if(missing)
      set(version NOASSERTION)
    endif()
    string(REPLACE "+" "%2B" escaped "pkg:deb/debian/${package}@${version}")
    set(purl "${escaped}")
    set(notices "/usr/share/doc/${package}/copyright")
    if(ARG_INSIDE AND EXISTS "${notices}")
      file(READ "${notices}" text)
      string(APPEND limber_licences "\n\nParts of ${package} are inside, under what its package says:\n\n${text}")
    endif()
  endif()
  limber_bill_package(${id} ${package} ${version} "${licence}" "${purl}")
  foreach(whole IN LISTS ARG_UNPARSED_ARGUMENTS)
    if(ARG_INSIDE)
      string(APPEND limber_bill "Relationship: SPDXRef-${whole} CONTAINS SPDXRef-${id}\n")
    endif()
    if(ARG_LINKED AND NOT whole STREQUAL "limber-dev")  # archives load nothing
      string(APPEND limber_bill "Relationship: SPDXRef-${whole} DYNAMIC_LINK SPDXRef-${id}\n")
    endif()
  endforeach()
  set(limber_bill "${limber_bill}" PARENT_SCOPE)
  set(limber_licences "${limber_licences}" PARENT_SCOPE)
endfunction()

set(made limber limber-dev)
if(LIMBER_BUILD_PYTHON)
  list(APPEND made python3-limber)
endif()
foreach(package IN LISTS made)
  limber_bill_package(${package} ${package} ${PROJECT_VERSION} BSD-3-Clause
    "pkg:deb/limber/${package}@${PROJECT_VERSION}")
  string(APPEND limber_bill "Relationship: SPDXRef-DOCUMENT DESCRIBES SPDXRef-${package}\n")
endforeach()

limber_part(libcli11-dev BSD-3-Clause limber INSIDE)
limber_part(libcpp-httplib-dev MIT limber INSIDE LINKED)
limber_part(libbrotli-dev MIT limber INSIDE)  # these three: headers that the one above includes
limber_part(libssl-dev Apache-2.0 limber INSIDE)
limber_part(zlib1g-dev Zlib limber INSIDE)
limber_part(libeigen3-dev MPL-2.0 ${made} INSIDE)
limber_part(libfmt-dev MIT ${made} INSIDE LINKED)
limber_part(libhdf5-dev BSD-3-Clause ${made} INSIDE LINKED)
limber_part(libmujoco-dev Apache-2.0 ${made} LINKED)
if(TARGET limber_import::onnx)
  limber_part(libonnx-dev Apache-2.0 ${made} INSIDE LINKED)
  limber_part(libprotobuf-dev BSD-3-Clause ${made} INSIDE LINKED)
endif()
if(TARGET limber_import::ompl)
  limber_part(libompl-dev BSD-3-Clause ${made} INSIDE LINKED)
  limber_part(libboost-dev BSL-1.0 ${made} INSIDE)  # whose headers OMPL's include
endif()
limber_part(librandom123-dev BSD-3-Clause ${made} INSIDE)
limber_part(libtbb-dev Apache-2.0 ${made} INSIDE LINKED)
limber_part(libutfcpp-dev BSL-1.0 ${made} INSIDE)
limber_part(libxxhash-dev BSD-2-Clause ${made} INSIDE)
limber_part(libyaml-cpp-dev MIT ${made} INSIDE LINKED)
limber_part(nlohmann-json3-dev MIT ${made} INSIDE)
if(LIMBER_BUILD_PYTHON)
  limber_part(pybind11-dev BSD-3-Clause python3-limber INSIDE)
  limber_part(libpython3-dev PSF-2.0 python3-limber INSIDE)
endif()
limber_part(npm/three MIT ${made} INSIDE)
limber_part(npm/uplot MIT ${made} INSIDE)
limber_part(libstdc++6 "GPL-3.0-or-later WITH GCC-exception-3.1" ${made} LINKED)
limber_part(libc6 LGPL-2.1-or-later ${made} LINKED)

set(ENV{SOURCE_DATE_EPOCH} ${limber_epoch})
string(TIMESTAMP created "%Y-%m-%dT%H:%M:%SZ" UTC)
string(UUID uuid NAMESPACE 6ba7b812-9dad-11d1-80b4-00c04fd430c8 NAME "${limber_bill}" TYPE SHA1)  # of OIDs
string(PREPEND limber_bill "SPDXVersion: SPDX-2.3\nDataLicense: CC0-1.0\nSPDXID: SPDXRef-DOCUMENT\n"
  "DocumentName: limber-${PROJECT_VERSION}\nDocumentNamespace: urn:uuid:${uuid}\n"
  "Creator: Organization: The limber developers\nCreated: ${created}\n")
file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/limber.spdx" CONTENT "@limber_bill@" @ONLY)
file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/copyright" CONTENT "@limber_licences@" @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/limber.spdx" DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
foreach(package_component IN ITEMS limber=runtime limber-dev=dev python3-limber=python)
  string(REGEX MATCH "(.*)=(.*)" _ ${package_component})
  install(FILES "${CMAKE_BINARY_DIR}/copyright" DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CMAKE_MATCH_1}
          COMPONENT ${CMAKE_MATCH_2})
endforeach()
