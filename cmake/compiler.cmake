# Warnings and instruction set of our own targets; -ffp-contract=off keeps results the same whether
# or not the processor multiplies and adds in one step.
function(revisit_slam_target_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -ffp-contract=off)
  if(REVISIT_SLAM_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(REVISIT_SLAM_NATIVE)
    target_compile_options(${target} PUBLIC -march=native)
  endif()
endfunction()
