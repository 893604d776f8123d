# Man pages and completions for bash and zsh, made from the program's own --help where Python is
# found; installed with it.
if(LIMBER_PYTHON AND NOT LIMBER_SANITIZE)
  set(command_pages "${CMAKE_BINARY_DIR}/share/command_pages")
  add_custom_command(OUTPUT "${command_pages}/made"
    COMMAND "${LIMBER_PYTHON}" "${PROJECT_SOURCE_DIR}/tools/command_pages.py"
            "$<TARGET_FILE:limber_program>" "${command_pages}"
    COMMAND "${CMAKE_COMMAND}" -E touch "${command_pages}/made"
    DEPENDS limber_program "${PROJECT_SOURCE_DIR}/tools/command_pages.py"
    COMMENT "Man pages and completions" VERBATIM)
  add_custom_target(limber_command_pages ALL DEPENDS "${command_pages}/made")
  install(DIRECTORY "${command_pages}/man1" DESTINATION ${CMAKE_INSTALL_MANDIR}
          COMPONENT runtime OPTIONAL)
  install(FILES "${command_pages}/bash/limber" COMPONENT runtime OPTIONAL
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES "${command_pages}/zsh/_limber" COMPONENT runtime OPTIONAL
          DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
endif()
