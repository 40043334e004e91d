# One target for each folder, with exactly the links of docs/architecture.md.
#
#   quarry_library(engine_base SOURCES a.cpp b.cpp LINKS fmt::fmt)
#   quarry_test(engine_base_test SOURCES ... LINKS quarry::engine_base)
#
# The presets compile up to eight sources of a target as one (a unity build): headers and templates cost once, not eight
# times. A source whose own names meet those of another is given under ALONE instead of SOURCES.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}")

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

add_library(quarry_options INTERFACE)
target_include_directories(quarry_options INTERFACE "${CMAKE_SOURCE_DIR}")
# Contraction breaks exact predicates: cross(u, u) becomes nonzero. It stays off for every target.
target_compile_options(quarry_options INTERFACE -ffp-contract=off -Wall -Wextra -Wconversion -Wshadow)
if(QUARRY_WARNINGS_AS_ERRORS)
  target_compile_options(quarry_options INTERFACE -Werror)
endif()
target_compile_definitions(quarry_options INTERFACE
  $<$<BOOL:${QUARRY_CHECK_CLAIMS}>:QUARRY_CHECK_CLAIMS=1>)

# The standard library's headers, fmt's and (for tests) GoogleTest's are a third of what there is to compile: they are read
# once for all libraries and once for all tests. Sources still include what they use: the preset `clang`, which clang-tidy
# reads, is without. OFF as well with a compiler cache, which would miss more often.
option(QUARRY_PRECOMPILED "Precompile the headers that nearly all sources include" OFF)
set(QUARRY_COMMON_HEADERS <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <limits> <map> <memory> <numbers>
                          <numeric> <optional> <random> <set> <span> <string> <string_view> <utility> <vector> <fmt/format.h>)

function(quarry_precompiled name)
  cmake_parse_arguments(ARG "" "" "HEADERS;LINKS;FLAGS" ${ARGN})
  file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/${name}.cpp" CONTENT "")
  add_library(${name} OBJECT "${CMAKE_BINARY_DIR}/${name}.cpp")
  target_link_libraries(${name} PRIVATE quarry_options fmt::fmt ${ARG_LINKS})
  target_compile_options(${name} PRIVATE ${ARG_FLAGS})
  target_precompile_headers(${name} PRIVATE ${QUARRY_COMMON_HEADERS} ${ARG_HEADERS})
endfunction()

if(QUARRY_PRECOMPILED)
  quarry_precompiled(quarry_precompiled_library)
  quarry_precompiled(quarry_precompiled_command FLAGS ${QUARRY_LIGHT_FLAGS})
  if(QUARRY_TESTS)
    find_package(GTest REQUIRED)
    quarry_precompiled(quarry_precompiled_test HEADERS <gtest/gtest.h> LINKS GTest::gtest FLAGS ${QUARRY_LIGHT_FLAGS})
  endif()
endif()

# quarry_uses_precompiled(TARGET KIND): KIND is library, command or test.
function(quarry_uses_precompiled name kind)
  if(QUARRY_PRECOMPILED)
    target_link_libraries(${name} PRIVATE fmt::fmt) # for the macros that the headers were precompiled with
    target_precompile_headers(${name} REUSE_FROM quarry_precompiled_${kind})
  endif()
endfunction()

# QUARRY_LIGHT_FLAGS: for sources whose own speed does not matter, tests and what reads the command line. They are half of
# what there is to compile.
macro(quarry_parse options)
  cmake_parse_arguments(ARG "" "${options}" "SOURCES;ALONE;LINKS" ${ARGN})
  set_source_files_properties(${ARG_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  list(APPEND ARG_SOURCES ${ARG_ALONE})
endmacro()

# A folder's library: headers only when no source is given.
function(quarry_library name)
  quarry_parse("" ${ARGN})
  if(ARG_SOURCES)
    add_library(quarry_${name} STATIC ${ARG_SOURCES})
    target_link_libraries(quarry_${name} PUBLIC quarry_options ${ARG_LINKS})
    quarry_uses_precompiled(quarry_${name} library)
  else()
    add_library(quarry_${name} INTERFACE)
    target_link_libraries(quarry_${name} INTERFACE quarry_options ${ARG_LINKS})
  endif()
  add_library(quarry::${name} ALIAS quarry_${name})
endfunction()

# One test program; each of its tests is known to ctest by its own name. LABEL says when it runs:
#   unit     (default) quick; also under the address and undefined behaviour sanitizers
#   threads  the same, and those whose names have `Thread` in them under the thread sanitizer too
#   jobs     whole jobs and long sweeps: in the release build only
# The target tests_LABEL builds the programs of one label.
function(quarry_test name)
  quarry_parse("TIMEOUT;LABEL" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  if(NOT ARG_LABEL)
    set(ARG_LABEL unit)
  elseif(NOT ARG_LABEL MATCHES "^(unit|threads|jobs)$")
    message(FATAL_ERROR "${name}: LABEL is unit, threads or jobs, not ${ARG_LABEL}")
  endif()
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
  target_link_libraries(${name} PRIVATE quarry_options ${ARG_LINKS} GTest::gtest_main)
  target_compile_options(${name} PRIVATE ${QUARRY_LIGHT_FLAGS})
  quarry_uses_precompiled(${name} test)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 WORKING_DIRECTORY "${CMAKE_SOURCE_DIR}"
                       PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS ${ARG_LABEL})
  if(NOT TARGET tests_${ARG_LABEL})
    add_custom_target(tests_${ARG_LABEL})
  endif()
  add_dependencies(tests_${ARG_LABEL} ${name})
endfunction()
