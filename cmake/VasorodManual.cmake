# Manual pages from the programs' own --help (help2man), made with the default target and installed.
# Without help2man there are none, and CMake says so.
find_program(HELP2MAN help2man)
if(NOT HELP2MAN)
  message(STATUS "No help2man: the manual pages are left out (Debian: help2man)")
  return()
endif()
set(VASOROD_MANUAL_FOLDER ${CMAKE_BINARY_DIR}/man)
add_custom_target(manual ALL)
foreach(program vasorod vasorod-fem vasorod-plan)
  if(NOT TARGET ${program})
    continue()
  endif()
  set(stamp ${CMAKE_BINARY_DIR}/man/${program}.1)
  add_custom_command(OUTPUT ${stamp}
    COMMAND ${CMAKE_SOURCE_DIR}/packaging/man/make_manual.sh $<TARGET_FILE:${program}>
      ${VASOROD_MANUAL_FOLDER}
    DEPENDS ${program} ${CMAKE_SOURCE_DIR}/packaging/man/make_manual.sh
      ${CMAKE_SOURCE_DIR}/packaging/man/${program}.h2m
    COMMENT "Manual pages of ${program}" VERBATIM)
  add_custom_target(manual_${program} DEPENDS ${stamp})
  add_dependencies(manual manual_${program})
endforeach()
install(DIRECTORY ${VASOROD_MANUAL_FOLDER}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL
  FILES_MATCHING PATTERN "*.1")
