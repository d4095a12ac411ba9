include(${CMAKE_CURRENT_LIST_DIR}/core_dependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/revisit_slam_core-targets.cmake)
