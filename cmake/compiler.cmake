# Warnings and instruction set of our own targets; -ffp-contract=off keeps results the same whether
# or not the processor multiplies and adds in one step.
set(REVISIT_SLAM_SANITIZE "" CACHE STRING "Sanitizers that all is compiled with: address,undefined or thread (scripts/sanitize)")
if(REVISIT_SLAM_SANITIZE)
  add_compile_options(-fsanitize=${REVISIT_SLAM_SANITIZE} -fno-omit-frame-pointer -O1 -g1)
  add_link_options(-fsanitize=${REVISIT_SLAM_SANITIZE})
  if(REVISIT_SLAM_SANITIZE MATCHES undefined)  # what it finds ends the program
    add_compile_options(-fno-sanitize-recover=undefined)
  endif()
endif()

function(revisit_slam_target_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -ffp-contract=off)
  if(REVISIT_SLAM_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(REVISIT_SLAM_NATIVE)
    target_compile_options(${target} PUBLIC -march=native)
  endif()
endfunction()

# Headers that most sources include, parsed once for each set of flags: a test takes 6.3 s to compile instead of
# 9.3 s. OFF shows whether each source includes what it uses.
option(REVISIT_SLAM_PRECOMPILED_HEADERS "Parse the headers of libraries once for all sources" ON)
set(REVISIT_SLAM_COMMON_HEADERS <algorithm> <cmath> <functional> <map> <memory> <optional> <sstream> <string> <variant>
    <vector> <Eigen/Core> <Eigen/Geometry>)

# revisit_slam_precompiled_headers(TARGET HEADER...), or (TARGET REUSE_FROM OTHER) with the flags of another target.
function(revisit_slam_precompiled_headers target)
  if(NOT REVISIT_SLAM_PRECOMPILED_HEADERS)
    return()
  endif()
  if(ARGV1 STREQUAL REUSE_FROM)
    target_precompile_headers(${target} REUSE_FROM ${ARGV2})
  else()
    target_precompile_headers(${target} PRIVATE ${REVISIT_SLAM_COMMON_HEADERS} ${ARGN})
  endif()
endfunction()
