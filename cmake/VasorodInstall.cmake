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
