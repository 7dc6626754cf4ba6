# Compiler settings and the two helpers every CMakeLists.txt of the project uses.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

find_program(FACET_CCACHE ccache)
if(FACET_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # It keeps nothing of what is compiled with a precompiled header unless it may.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${FACET_CCACHE})
endif()

add_library(facet_options INTERFACE)
# No fused multiply-add and no value-changing optimisation: results are equal on every back end and machine.
target_compile_options(facet_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  -Werror -ffp-contract=off -fno-math-errno -fno-trapping-math)
if(FACET_SANITIZE)
  target_compile_options(facet_options INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(facet_options INTERFACE -fsanitize=address,undefined)
endif()

# facet_optimise_lightly(<target>): for what spends its time on files, text and other libraries, which -O3 makes no
# faster but takes up to seven times as long to compile where templates are many.
function(facet_optimise_lightly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# facet_library(<folder> [SOURCES ...] [LINKS ...]): the library facet_<folder>; header-only without SOURCES.
function(facet_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  if(ARG_SOURCES)
    add_library(facet_${name} STATIC ${ARG_SOURCES})
    set(scope PUBLIC)
  else()
    add_library(facet_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(facet_${name} ${scope} ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(facet_${name} ${scope} ${ARG_LINKS})
  if(ARG_SOURCES)
    target_link_libraries(facet_${name} PRIVATE $<BUILD_INTERFACE:facet_options>)
  endif()
endfunction()

# facet_test(<name> SOURCES ... LINKS ... [LABELS fast|slow|data|gpu ...]): one GoogleTest program; labels default to fast.
function(facet_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;LABELS" ${ARGN})
  if(NOT ARG_LABELS)
    set(ARG_LABELS fast)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} facet_options GTest::gtest GTest::gtest_main)
  facet_optimise_lightly(${name})
  target_precompile_headers(${name} REUSE_FROM facet_test_headers)
  gtest_discover_tests(${name} PROPERTIES LABELS "${ARG_LABELS}" DISCOVERY_TIMEOUT 60 TIMEOUT 600)
endfunction()
