# shellcheck shell=bash disable=SC2034
# SPDX-License-Identifier: MIT
# Debian packages that revisit_slam needs, without recommendations. Sourced by scripts/setup.

BUILD_PACKAGES=(
  g++ make cmake catkin
  ros-message-generation ros-message-runtime ros-std-msgs ros-geometry-msgs
  libsensor-msgs-dev libnav-msgs-dev libvisualization-msgs-dev libdiagnostic-msgs-dev libstd-srvs-dev
  libroscpp-dev libnodeletlib-dev pluginlib-dev libtf2-ros-dev libtf2-msgs-dev librosbag-dev
  libtopic-tools-dev
  libpcl-dev
  libdynamic-reconfigure-config-init-mutex-dev python3-dynamic-reconfigure
  libceres-dev liboctomap-dev libopencv-dev
  libtbb-dev robin-map-dev libembree-dev libcli11-dev libyaml-cpp-dev
  nlohmann-json3-dev libopenblas0-serial libgeographiclib-dev
)

RUN_PACKAGES=(
  libnodeletlib-tools python3-roslaunch rosbash python3-genpy python3-std-srvs
  python3-rosbag python3-rostopic python3-rosnode python3-rosservice python3-rosmsg python3-tf2-ros
  tf2-tools python3-sensor-msgs python3-nav-msgs python3-visualization-msgs python3-diagnostic-msgs
  python3-matplotlib python3-numpy python3-yaml python3-venv
)

TEST_PACKAGES=(
  python3-rostest librostest-dev libgtest-dev python3-geometry-msgs python3-std-msgs
  clang-format clang-tidy git
)

# Of scripts/fleet alone. The tests need them, too.
FLEET_PACKAGES=(python3-distributed python3-fsspec)

# Of scripts/fuzz alone.
FUZZ_PACKAGES=(clang-14 libclang-rt-14-dev libomp-14-dev llvm-14)

# Of scripts/package alone.
PACKAGING_PACKAGES=(debhelper dpkg-dev)

# Of scripts/docs alone.
DOCS_PACKAGES=(mkdocs mkdocs-material)
