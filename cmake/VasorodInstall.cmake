# Installs the program, the libraries, the public headers and the package files for
# find_package(vasorod).
include(CMakePackageConfigHelpers)
get_property(libraries GLOBAL PROPERTY VASOROD_LIBRARIES)
install(TARGETS ${libraries} EXPORT vasorodTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/hybrid/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/vasorod)
install(EXPORT vasorodTargets NAMESPACE vasorod:: DESTINATION ${package_folder})
configure_package_config_file(${CMAKE_SOURCE_DIR}/cmake/vasorodConfig.cmake.in
  ${CMAKE_BINARY_DIR}/vasorodConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/vasorodConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/vasorodConfig.cmake ${CMAKE_BINARY_DIR}/vasorodConfigVersion.cmake
  ${CMAKE_SOURCE_DIR}/cmake/FindCHOLMOD.cmake ${CMAKE_SOURCE_DIR}/cmake/FindOpenBLAS.cmake
  DESTINATION ${package_folder})

# Scenes that run as they are, with the surfaces that they name, in the folders that they have here;
# the schemas for editors.
set(shared ${CMAKE_INSTALL_DATADIR}/vasorod)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/meshes/infant DESTINATION ${shared}/meshes
  FILES_MATCHING PATTERN "*.vtp")
install(DIRECTORY ${CMAKE_SOURCE_DIR}/benchmarks/cases/glenn
  DESTINATION ${shared}/benchmarks/cases FILES_MATCHING PATTERN "infant*.yaml")
install(FILES ${CMAKE_SOURCE_DIR}/examples/scene.yaml DESTINATION ${shared}/examples)
install(FILES ${CMAKE_SOURCE_DIR}/schema/scene.schema.json
  ${CMAKE_SOURCE_DIR}/schema/result.schema.json DESTINATION ${shared}/schema)
install(FILES ${CMAKE_SOURCE_DIR}/CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})

# One completion for all programs: bash looks for a file of the command's name.
foreach(program vasorod vasorod-fem vasorod-plan)
  if(TARGET ${program})
    install(FILES ${CMAKE_SOURCE_DIR}/packaging/completion/vasorod.bash
      DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ${program})
  endif()
endforeach()
