# One way to declare a library, a test and a program: a folder's CMakeLists.txt is then a few lines.

# The warnings and the compiler's own options that every one of our targets is compiled with.
add_library(vasorod_warnings INTERFACE)
set(gcc_12 $<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>)
target_compile_options(vasorod_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
  # GCC 12 sees an overlap in "literal" + std::string that is not there (GCC bug 105651).
  $<${gcc_12}:-Wno-restrict>
  # What a designated initializer leaves out keeps its default.
  -Wno-missing-field-initializers)
# GCC collects its garbage from 500 MB on, not from 128 MB: a tenth less time, a tenth more memory.
target_compile_options(vasorod_warnings INTERFACE
  "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=500000>")
if(VASOROD_WARNINGS_AS_ERRORS)
  target_compile_options(vasorod_warnings INTERFACE -Werror)
endif()
if(VASOROD_SANITIZE)
  set(sanitizers -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all)
  add_compile_options(${sanitizers} -fno-omit-frame-pointer)
  add_link_options(${sanitizers})
endif()
if(VASOROD_FUZZ)
  # The readers are checked for addresses and undefined behaviour. Geometry and solvers only tell
  # libFuzzer which branches an input took, not what was compared there, so that more scenes are
  # solved in the same time; the tests under VASOROD_SANITIZE check them.
  set(VASOROD_FUZZ_CHECKS -fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow
    -fno-sanitize-recover=all -fno-omit-frame-pointer -O2)
  set(VASOROD_FUZZ_READERS data surface_file mask scene result)
  add_link_options(-fsanitize=address,undefined)
endif()
if(VASOROD_PYTHON)
  # Functions of a shared library (vasorod_library) are called and inlined as a program's are.
  add_compile_options(-fno-semantic-interposition)
endif()
# Eigen and the Lie-group kernels are only fast when inlined; -fno-math-errno keeps IEEE results and
# lets sqrt inline.
add_compile_options(-fno-math-errno)

# vasorod_library(<folder> [NOT_INSTALLED] SOURCES ... LINKS ... [PRIVATE_LINKS ...]): library
# vasorod::<folder>. NOT_INSTALLED: a part of its program alone.
function(vasorod_library name)
  cmake_parse_arguments(ARG "NOT_INSTALLED" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(vasorod_${name} STATIC ${ARG_SOURCES})
  add_library(vasorod::${name} ALIAS vasorod_${name})
  set_target_properties(vasorod_${name} PROPERTIES EXPORT_NAME ${name})
  if(VASOROD_PYTHON)
    # A Python module is a shared library.
    set_target_properties(vasorod_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
  target_include_directories(vasorod_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/hybrid>
    $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/hybrid/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(vasorod_${name} PUBLIC cxx_std_20)
  target_link_libraries(vasorod_${name} PUBLIC ${ARG_LINKS}
    PRIVATE $<BUILD_INTERFACE:vasorod_warnings> ${ARG_PRIVATE_LINKS})
  if(VASOROD_FUZZ AND name IN_LIST VASOROD_FUZZ_READERS)
    target_compile_options(vasorod_${name} PRIVATE ${VASOROD_FUZZ_CHECKS})
  elseif(VASOROD_FUZZ)
    target_compile_options(vasorod_${name} PRIVATE
      -fsanitize=fuzzer-no-link -fno-sanitize-coverage=trace-cmp -O2)
  endif()
  vasorod_use_precompiled(vasorod_${name} "${ARG_LINKS};${ARG_PRIVATE_LINKS}" vasorod_precompiled)
  if(NOT ARG_NOT_INSTALLED)
    set_property(GLOBAL APPEND PROPERTY VASOROD_LIBRARIES vasorod_${name})
  endif()
endfunction()

# vasorod_test(<folder> SOURCES ... LINKS ... [TIMEOUT seconds]): the program test_<folder>; ctest
# knows each case.
function(vasorod_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LINKS" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES})
  target_link_libraries(test_${name} PRIVATE
    ${ARG_LINKS} vasorod_warnings GTest::gtest GTest::gtest_main)
  target_include_directories(test_${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  target_compile_definitions(test_${name} PRIVATE VASOROD_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  vasorod_use_precompiled(test_${name} "${ARG_LINKS}" vasorod_precompiled_tests)
  if(VASOROD_REAL_ANATOMY)
    set(filter "*")
  else()
    set(filter "-*RealAnatomy*")
  endif()
  if(ARG_TIMEOUT)
    set(timeout TIMEOUT ${ARG_TIMEOUT})
  endif()
  gtest_discover_tests(test_${name} TEST_PREFIX ${name}. TEST_FILTER ${filter}
    DISCOVERY_TIMEOUT 300 NO_PRETTY_VALUES PROPERTIES LABELS ${name} ${timeout})
endfunction()
