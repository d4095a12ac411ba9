# The half that knows ROS: conversions, nodelets, programs.
find_package(catkin REQUIRED COMPONENTS
  diagnostic_msgs dynamic_reconfigure geometry_msgs message_generation nav_msgs nodelet pluginlib rosbag roscpp
  sensor_msgs std_msgs std_srvs tf2_msgs tf2_ros topic_tools visualization_msgs)

add_message_files(FILES LocalizationStatus.msg)
add_service_files(FILES SaveMap.srv LoadMap.srv DisableLoop.srv)
generate_messages(DEPENDENCIES geometry_msgs std_msgs)
generate_dynamic_reconfigure_options(cfg/LiveOdometry.cfg cfg/LiveInformation.cfg
  cfg/LiveRecognition.cfg cfg/LiveLoops.cfg cfg/LiveRetroactive.cfg cfg/LiveBackEnd.cfg)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES revisit_slam_nodelets
  CATKIN_DEPENDS diagnostic_msgs dynamic_reconfigure geometry_msgs message_runtime nav_msgs nodelet
                 rosbag roscpp sensor_msgs std_msgs std_srvs tf2_ros visualization_msgs)

file(GLOB_RECURSE ros_sources CONFIGURE_DEPENDS src/ros/*.cpp)
add_library(revisit_slam_ros STATIC ${ros_sources})
revisit_slam_target_options(revisit_slam_ros)
revisit_slam_precompiled_headers(revisit_slam_ros <ros/ros.h>)
target_include_directories(revisit_slam_ros SYSTEM PUBLIC ${catkin_INCLUDE_DIRS})
target_link_libraries(revisit_slam_ros PUBLIC revisit_slam_core ${catkin_LIBRARIES})
add_dependencies(revisit_slam_ros ${catkin_EXPORTED_TARGETS} ${PROJECT_NAME}_gencfg
                 ${PROJECT_NAME}_generate_messages_cpp)

# With octomap_msgs (Debian has no package of it) the occupancy is published as an octree too.
find_package(octomap_msgs QUIET)
if(octomap_msgs_FOUND)
  target_compile_definitions(revisit_slam_ros PUBLIC REVISIT_SLAM_OCTOMAP_MSGS)
  target_include_directories(revisit_slam_ros SYSTEM PUBLIC ${octomap_msgs_INCLUDE_DIRS})
else()
  message(STATUS "Without the topic `octomap`: no octomap_msgs was found")
endif()

file(GLOB nodelet_sources CONFIGURE_DEPENDS src/nodelets/*.cpp)
add_library(revisit_slam_nodelets SHARED ${nodelet_sources})
revisit_slam_target_options(revisit_slam_nodelets)
revisit_slam_precompiled_headers(revisit_slam_nodelets REUSE_FROM revisit_slam_ros)
target_link_libraries(revisit_slam_nodelets PRIVATE revisit_slam_ros)

# `revisit_slam_program(name LIBRARIES)`; the parts of a program are in src/apps/NAME/.
function(revisit_slam_program name)
  file(GLOB parts CONFIGURE_DEPENDS src/apps/${name}/*.cpp)
  add_executable(${name} src/apps/${name}.cpp ${parts})
  revisit_slam_target_options(${name})
  target_link_libraries(${name} PRIVATE ${ARGN} CLI11::CLI11 nlohmann_json::nlohmann_json)
  install(TARGETS ${name} RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
endfunction()
revisit_slam_program(offline revisit_slam_ros)
revisit_slam_program(doctor revisit_slam_ros)
revisit_slam_program(export revisit_slam_core)
revisit_slam_program(merge revisit_slam_core)
revisit_slam_program(fleet_step revisit_slam_core)
revisit_slam_program(optimize_graph revisit_slam_ros)
revisit_slam_program(benchmark_information revisit_slam_ros)
revisit_slam_program(convert_dataset revisit_slam_ros)
revisit_slam_program(evaluate revisit_slam_ros)
revisit_slam_program(benchmark_ablation revisit_slam_ros)
revisit_slam_program(benchmark_loops revisit_slam_ros)
revisit_slam_program(benchmark_places revisit_slam_ros)
if(REVISIT_SLAM_SIMULATION)
  revisit_slam_program(simulate revisit_slam_ros revisit_slam_simulation)
endif()

install(TARGETS revisit_slam_nodelets LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
install(DIRECTORY include/revisit_slam/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
install(DIRECTORY launch rviz cfg DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
install(FILES nodelet_plugins.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
install(DIRECTORY scripts/lib DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}
        FILES_MATCHING PATTERN "*.py")
install(PROGRAMS scripts/report scripts/play_bag scripts/convert_ros2_bag scripts/compare_odometry scripts/compare_places
        scripts/evaluate_pictures
        scripts/benchmark scripts/ablation scripts/compare_graphs scripts/fleet
        DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
