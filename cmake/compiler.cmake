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
