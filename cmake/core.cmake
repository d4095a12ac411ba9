# The ROS-free half. Nothing here links catkin, and check_layers fails the build when a ROS header is
# included all the same (Debian keeps ROS headers in /usr/include, where any target sees them).
include(cmake/core_dependencies.cmake)
include(cmake/cli11.cmake)

# From the ground up: a module includes itself and those before it.
set(REVISIT_SLAM_CORE_FOLDERS util types geometry input icp priors odometry information occupancy mapping pose_graph loops io
    datasets evaluation session localization slam)
set(core_sources)
foreach(folder ${REVISIT_SLAM_CORE_FOLDERS})
  file(GLOB_RECURSE folder_sources CONFIGURE_DEPENDS src/${folder}/*.cpp)
  list(APPEND core_sources ${folder_sources})
endforeach()

# Programs carry the presets in cfg/ with them: they run wherever they are.
file(GLOB preset_files CONFIGURE_DEPENDS cfg/*.yaml)
set(PRESETS "")
foreach(preset_file ${preset_files})
  get_filename_component(preset ${preset_file} NAME_WE)
  file(READ ${preset_file} preset_text)
  string(APPEND PRESETS "    {\"${preset}\", R\"yaml(${preset_text})yaml\"},\n")
endforeach()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${preset_files})
configure_file(src/io/presets.cpp.in presets.cpp @ONLY)
list(APPEND core_sources ${CMAKE_CURRENT_BINARY_DIR}/presets.cpp)

add_library(revisit_slam_core STATIC ${core_sources})
revisit_slam_target_options(revisit_slam_core)
revisit_slam_precompiled_headers(revisit_slam_core <tbb/parallel_for.h> <tbb/task_arena.h>)
target_include_directories(revisit_slam_core PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
                                                    $<INSTALL_INTERFACE:include>)
target_include_directories(revisit_slam_core SYSTEM PUBLIC ${PCL_INCLUDE_DIRS} ${OCTOMAP_INCLUDE_DIRS})
target_compile_definitions(revisit_slam_core PRIVATE REVISIT_SLAM_VERSION="${PROJECT_VERSION}")
# The BLAS that is found first factorises. Debian's Ceres brings ATLAS; the system's choice, OpenBLAS where
# it is installed, comes before it and is faster. As one flag, as CMake moves libraries.
set(SYSTEM_BLAS "-Wl,--push-state,--no-as-needed,-lblas,--pop-state")
target_link_libraries(revisit_slam_core
  PUBLIC Eigen3::Eigen TBB::tbb tsl::robin_map Threads::Threads opencv_core
  PRIVATE ${SYSTEM_BLAS} opencv_features2d ${CERES_LIBRARIES} gomp ${PCL_COMMON_LIBRARIES} ${PCL_IO_LIBRARIES}
          ${OCTOMAP_LIBRARIES} yaml-cpp nlohmann_json::nlohmann_json ZLIB::ZLIB
          ${GEOGRAPHICLIB_LIBRARY})

# find_package(revisit_slam_core) and revisit_slam::revisit_slam_core, of an installation (docs/api.md).
set(CORE_CMAKE_FOLDER share/revisit_slam_core/cmake)
install(TARGETS revisit_slam_core EXPORT revisit_slam_core ARCHIVE DESTINATION lib)
install(EXPORT revisit_slam_core NAMESPACE revisit_slam:: DESTINATION ${CORE_CMAKE_FOLDER}
        FILE revisit_slam_core-targets.cmake)
install(FILES cmake/revisit_slam_core-config.cmake cmake/core_dependencies.cmake DESTINATION ${CORE_CMAKE_FOLDER})

# What docs/api.md shows.
add_executable(map_scans examples/map_scans.cpp)
revisit_slam_target_options(map_scans)
target_link_libraries(map_scans PRIVATE revisit_slam_core)

add_custom_target(check_layers ALL
  COMMAND ${CMAKE_COMMAND} "-DLAYERS=${REVISIT_SLAM_CORE_FOLDERS};simulation;ros;nodelets;apps"
          -DSOURCE_DIR=${CMAKE_CURRENT_SOURCE_DIR} -P ${CMAKE_CURRENT_SOURCE_DIR}/cmake/check_layers.cmake
  VERBATIM)
add_dependencies(revisit_slam_core check_layers)
