# Which module links which, one line per module, for tools/module_picture.py.

set(module_links "")
foreach(module IN LISTS LIMBER_MODULES)
  get_target_property(links limber_${module} LINK_LIBRARIES)
  string(REGEX MATCHALL "limber::[a-z_]+" links "${links}")
  list(TRANSFORM links REPLACE "limber::" "")
  list(JOIN links " " links)
  string(APPEND module_links "${module}: ${links}\n")
endforeach()
file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/module_links.txt" CONTENT "${module_links}" @ONLY)
