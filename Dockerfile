# syntax=docker/dockerfile:1
# revisit_slam in a container: docs/install.md
FROM debian:12-slim AS build
WORKDIR /revisit_slam
# The list of packages alone first: it changes less often than the sources.
COPY scripts scripts
RUN apt-get update && scripts/setup --no-build
COPY . .
RUN scripts/package

FROM debian:12-slim
COPY --from=build /revisit_slam/build/package/*.deb /tmp/
RUN apt-get update && apt-get install -y --no-install-recommends /tmp/*.deb && rm -rf /tmp/*.deb /var/lib/apt/lists/*
ENV ROS_HOSTNAME=localhost ROS_MASTER_URI=http://localhost:11311
WORKDIR /data
CMD ["roslaunch", "revisit_slam", "slam.launch"]
