# The simulator, which casts its rays with Embree 3. Mapping does not need it: without Embree the
# library, the program `simulate` and the tests on simulated drives are left out.
include(CMakeDependentOption)
find_package(embree 3 QUIET)
cmake_dependent_option(REVISIT_SLAM_SIMULATION "Build the simulator" ON embree_FOUND OFF)
if(NOT REVISIT_SLAM_SIMULATION)
  if(embree_FOUND)
    set(reason "REVISIT_SLAM_SIMULATION is off")
  else()
    set(reason "no Embree 3 was found")
  endif()
  message(STATUS "Without the simulator (${reason}): no `simulate`, no tests on simulated drives")
  return()
endif()

file(GLOB simulation_sources CONFIGURE_DEPENDS src/simulation/*.cpp)
add_library(revisit_slam_simulation STATIC ${simulation_sources})
revisit_slam_target_options(revisit_slam_simulation)
target_link_libraries(revisit_slam_simulation PUBLIC revisit_slam_core embree)
