# What nearly every file includes is parsed once. Off where it does not pay or does not work: with a
# compiler cache, in fuzz targets, with compilers other than GCC (not measured there).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_CXX_COMPILER_LAUNCHER
    AND NOT VASOROD_FUZZ)
  set(precompile ON)
else()
  set(precompile OFF)
endif()
option(VASOROD_PRECOMPILED "Parse the headers that nearly every file includes once" ${precompile})

# vasorod_precompiled_headers(<name> [OPTION ...] HEADERS ...): a target whose precompiled headers
# others use, those compiled with the same options.
function(vasorod_precompiled_headers name)
  cmake_parse_arguments(ARG "" "" "OPTIONS;LINKS;HEADERS" ${ARGN})
  file(WRITE ${CMAKE_BINARY_DIR}/${name}.cpp "// holds precompiled headers\n")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/${name}.cpp)
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_compile_options(${name} PRIVATE ${ARG_OPTIONS})
  target_link_libraries(${name} PRIVATE Eigen3::Eigen vasorod_warnings ${ARG_LINKS})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()

# vasorod_use_precompiled(<target> <links> <of>): those of <of>, or of <of>_rounding where <links>
# name CGAL, whose users round as asked.
function(vasorod_use_precompiled target links of)
  if(NOT VASOROD_PRECOMPILED OR "OpenMP::OpenMP_CXX" IN_LIST links)
    return()
  endif()
  if("CGAL::CGAL" IN_LIST links)
    set(of ${of}_rounding)
  endif()
  if(TARGET ${of})
    target_precompile_headers(${target} REUSE_FROM ${of})
  endif()
endfunction()

if(VASOROD_PRECOMPILED)
  # With them GCC 12 calls the overlap that is not there (see -Wno-restrict) an overflow too.
  target_compile_options(vasorod_warnings INTERFACE
    $<${gcc_12}:-Wno-stringop-overflow> $<${gcc_12}:-Wno-array-bounds>)
  set(headers <Eigen/Core> <Eigen/Geometry> <Eigen/SparseCore> <algorithm> <array> <cmath>
    <filesystem> <functional> <map> <optional> <set> <string> <vector>)
  vasorod_precompiled_headers(vasorod_precompiled HEADERS ${headers})
  vasorod_precompiled_headers(vasorod_precompiled_rounding OPTIONS -frounding-math
    HEADERS ${headers})
  if(VASOROD_PYTHON) # as the libraries that use them
    set_target_properties(vasorod_precompiled vasorod_precompiled_rounding PROPERTIES
      POSITION_INDEPENDENT_CODE ON)
  endif()
  if(VASOROD_TESTS)
    vasorod_precompiled_headers(vasorod_precompiled_tests LINKS GTest::gtest
      HEADERS ${headers} <Eigen/Dense> <fstream> <gtest/gtest.h> <random>)
  endif()
endif()
