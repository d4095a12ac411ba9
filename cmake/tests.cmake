# One gtest program per folder of test/, rostests in test/nodelets. `tests` builds them all.
if(NOT CATKIN_ENABLE_TESTING)
  return()
endif()
enable_testing()

# A test that includes a header with "simulation" or "simulated" in its path needs the simulator.
function(revisit_slam_gtest folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS test/${folder}/*_test.cpp)
  set(libraries ${ARGN})
  foreach(source ${sources})
    file(STRINGS ${source} simulated REGEX "^#include \".*simulat(ion|ed)")
    if(simulated AND REVISIT_SLAM_SIMULATION)
      list(APPEND libraries revisit_slam_simulation)
    elseif(simulated)
      list(REMOVE_ITEM sources ${source})
    endif()
  endforeach()
  if(NOT sources)
    return()
  endif()
  catkin_add_gtest(${folder}_test ${sources} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  revisit_slam_target_options(${folder}_test)
  if(folder STREQUAL util)  # the first one
    revisit_slam_precompiled_headers(util_test <gtest/gtest.h> <tbb/parallel_for.h> <tbb/task_arena.h>)
  else()
    revisit_slam_precompiled_headers(${folder}_test REUSE_FROM util_test)
  endif()
  target_include_directories(${folder}_test PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/test)
  target_link_libraries(${folder}_test ${libraries} gtest_main)
endfunction()

foreach(folder ${REVISIT_SLAM_CORE_FOLDERS} simulation)
  revisit_slam_gtest(${folder} revisit_slam_core)
endforeach()
revisit_slam_gtest(ros revisit_slam_ros)
revisit_slam_gtest(apps revisit_slam_ros nlohmann_json::nlohmann_json)
target_compile_definitions(apps_test PRIVATE REVISIT_SLAM_CONVERT_PROGRAM="$<TARGET_FILE:convert_dataset>"
                                             REVISIT_SLAM_EVALUATE_PROGRAM="$<TARGET_FILE:evaluate>"
                                             REVISIT_SLAM_EXPORT_PROGRAM="$<TARGET_FILE:export>"
                                             REVISIT_SLAM_MERGE_PROGRAM="$<TARGET_FILE:merge>"
                                             REVISIT_SLAM_EXAMPLE_PROGRAM="$<TARGET_FILE:map_scans>"
                                             REVISIT_SLAM_DOCTOR_PROGRAM="$<TARGET_FILE:doctor>"
                                             REVISIT_SLAM_OFFLINE_PROGRAM="$<TARGET_FILE:offline>")
add_dependencies(apps_test convert_dataset doctor evaluate export map_scans merge offline)

# test/nodelets/NAME.test starts the program made of test/nodelets/NAME/*_test.cpp with a master of
# its own.
find_package(rostest REQUIRED)
function(revisit_slam_rostest name)
  file(GLOB sources CONFIGURE_DEPENDS test/nodelets/${name}/*_test.cpp)
  add_rostest_gtest(${name}_rostest test/nodelets/${name}.test ${sources} test/support/ros_test_main.cpp)
  revisit_slam_target_options(${name}_rostest)
  revisit_slam_precompiled_headers(${name}_rostest REUSE_FROM util_test)
  target_include_directories(${name}_rostest PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/test)
  target_compile_definitions(${name}_rostest PRIVATE
    REVISIT_SLAM_OFFLINE_PROGRAM="$<TARGET_FILE:offline>")
  target_link_libraries(${name}_rostest revisit_slam_ros nlohmann_json::nlohmann_json)
  add_dependencies(${name}_rostest revisit_slam_nodelets offline doctor)
endfunction()
revisit_slam_rostest(odometry_nodelet)
revisit_slam_rostest(live_equals_offline)
revisit_slam_rostest(processes)
revisit_slam_rostest(replay)
revisit_slam_rostest(drivers)
if(REVISIT_SLAM_SIMULATION)
  revisit_slam_rostest(slam)
  target_compile_definitions(slam_rostest PRIVATE REVISIT_SLAM_SIMULATE_PROGRAM="$<TARGET_FILE:simulate>")
  add_dependencies(slam_rostest simulate)
endif()

# Python alone: links of the documentation, and what the scripts are made of.
add_test(NAME scripts COMMAND /usr/bin/python3 -m unittest discover -s ${CMAKE_CURRENT_SOURCE_DIR}/test/scripts -p *_test.py)
add_test(NAME beginner COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/scripts/check_beginner)
# Skipped where clang-format or clang-tidy is another version than the one that formats.
add_test(NAME format COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/scripts/lint --format)
add_test(NAME tidy COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/scripts/lint --tidy)
# Skipped, with the reason, where Dask or the simulator is missing.
add_test(NAME fleet COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/scripts/check_fleet)
set_tests_properties(fleet PROPERTIES SKIP_RETURN_CODE 77)
if(REVISIT_SLAM_SIMULATION)
  add_test(NAME soak COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/scripts/soak --minutes 3 --rate 60)
endif()
