# Fails when a file of the core includes a header of ROS, or of the half of this project that knows
# ROS.
set(ros_header "#include *[<\"](ros|tf2?|tf2_ros|nodelet|pluginlib|rosbag|topic_tools|[a-z_]+_msgs|std_srvs|pcl_ros|pcl_conversions|dynamic_reconfigure|revisit_slam/ros)/")
foreach(folder ${FOLDERS})
  file(GLOB_RECURSE files ${SOURCE_DIR}/include/revisit_slam/${folder}/* ${SOURCE_DIR}/src/${folder}/*)
  foreach(file ${files})
    file(STRINGS ${file} includes REGEX ${ros_header})
    if(includes)
      message(FATAL_ERROR "The core must not include ROS: ${file}: ${includes}")
    endif()
  endforeach()
endforeach()
