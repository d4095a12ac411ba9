# SPDX-License-Identifier: MIT
"""write_ros2_bag.py FOLDER mcap|sqlite3: five clouds, IMU, Livox, and a message that nobody reads. Needs rosbags."""

import sys
from pathlib import Path

import numpy as np
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

POINT = "uint32 offset_time\nfloat32 x\nfloat32 y\nfloat32 z\nuint8 reflectivity\nuint8 tag\nuint8 line\n"
LIVOX = ("std_msgs/Header header\nuint64 timebase\nuint32 point_num\nuint8 lidar_id\nuint8[3] rsvd\n"
         "livox_ros_driver2/CustomPoint[] points\n")
START, PERIOD = 1_700_000_000_000_000_000, 100_000_000  # ns

store = get_typestore(Stores.ROS2_HUMBLE)
for name, text in (("CustomPoint", POINT), ("CustomMsg", LIVOX)):
    store.register(get_types_from_msg(text, f"livox_ros_driver2/msg/{name}"))
types = store.types


def header(time):
    stamp = types["builtin_interfaces/msg/Time"](sec=time // 10**9, nanosec=time % 10**9)
    return types["std_msgs/msg/Header"](stamp=stamp, frame_id="lidar")


def cloud(time):
    points = (np.random.default_rng(time).random((500, 3)) * 20 - 10).astype("<f4")
    field = types["sensor_msgs/msg/PointField"]
    return types["sensor_msgs/msg/PointCloud2"](
        header=header(time), height=1, width=500,
        fields=[field(name=name, offset=4 * i, datatype=7, count=1) for i, name in enumerate("xyz")],
        is_bigendian=False, point_step=12, row_step=6000, data=points.view(np.uint8).reshape(-1), is_dense=True)


def livox(time):
    point = types["livox_ros_driver2/msg/CustomPoint"]
    points = [point(offset_time=i, x=1.0 + i, y=2.0, z=3.0, reflectivity=1, tag=0, line=0) for i in range(20)]
    return types["livox_ros_driver2/msg/CustomMsg"](
        header=header(time), timebase=time, point_num=len(points), lidar_id=0, rsvd=np.zeros(3, np.uint8), points=points)


def imu(time):
    vector, none = types["geometry_msgs/msg/Vector3"], np.zeros(9)
    return types["sensor_msgs/msg/Imu"](
        header=header(time), orientation=types["geometry_msgs/msg/Quaternion"](x=0.0, y=0.0, z=0.0, w=1.0),
        orientation_covariance=none, angular_velocity=vector(x=0.0, y=0.0, z=0.5), angular_velocity_covariance=none,
        linear_acceleration=vector(x=0.0, y=0.0, z=9.8), linear_acceleration_covariance=none)


def main():
    with Writer(Path(sys.argv[1]), version=9, storage_plugin=StoragePlugin[sys.argv[2].upper()]) as writer:
        topics = {"/points": cloud, "/livox": livox, "/imu": imu,
                  "/chatter": lambda time: types["std_msgs/msg/String"](data=str(time))}
        for topic, make in topics.items():
            name = make(START).__msgtype__
            connection = writer.add_connection(topic, name, typestore=store)
            for i in range(5):
                time = START + i * PERIOD
                writer.write(connection, time, store.serialize_cdr(make(time), name))


main()
