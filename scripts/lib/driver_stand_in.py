#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""In the place of a LiDAR and its driver: a room seen from a sensor that sways, ten times a second."""

import argparse
import sys

import numpy as np
import rosbag
import rospy
from sensor_msgs.msg import PointCloud2, PointField

TOPIC = "/velodyne_points"
BEAMS, COLUMNS = 16, 900
WALLS = np.array([9.0, 6.0, 1.5])  # m from the middle of the room to its walls, floor and ceiling


def directions():
    azimuth = np.linspace(np.pi, -np.pi, COLUMNS, endpoint=False)
    elevation = np.radians(np.linspace(-15.0, 15.0, BEAMS))
    azimuth, elevation = np.meshgrid(azimuth, elevation, indexing="ij")
    flat = np.cos(elevation)
    return np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth), np.sin(elevation)],
                    axis=-1).reshape(-1, 3)


def scan(number, stamp):
    """As velodyne_pointcloud sends it: times before the header stamp."""
    rays = directions()
    origin = np.array([2.0 * np.sin(0.05 * number), 1.0 * np.sin(0.03 * number), 0.0])
    with np.errstate(divide="ignore", invalid="ignore"):
        ranges = np.min((np.sign(rays) * WALLS - origin) / rays, axis=1, initial=np.inf,
                        where=np.abs(rays) > 1e-9)
    points = np.zeros(len(rays), dtype=[("x", "<f4"), ("y", "<f4"), ("z", "<f4"),
                                        ("intensity", "<f4"), ("ring", "<u2"), ("time", "<f4")])
    for axis, name in enumerate("xyz"):
        points[name] = ranges * rays[:, axis]
    points["ring"] = np.tile(np.arange(BEAMS), COLUMNS)
    points["time"] = np.repeat(np.linspace(-0.1, 0.0, COLUMNS, endpoint=False), BEAMS)
    message = PointCloud2(height=1, width=len(points), point_step=points.itemsize,
                          row_step=points.nbytes, is_dense=True, data=points.tobytes())
    message.header.frame_id = "lidar"
    message.header.stamp = stamp
    types = {"<f4": PointField.FLOAT32, "<u2": PointField.UINT16}
    message.fields = [PointField(name, offset, types[kind.str], 1)
                      for name, (kind, offset) in points.dtype.fields.items()]
    return message


def make(path, count=40):
    start = 1_700_000_000.0
    with rosbag.Bag(path, "w") as bag:
        for number in range(count):
            stamp = rospy.Time.from_sec(start + 0.1 * number)
            bag.write(TOPIC, scan(number, stamp), stamp)


def record_with_zero_stamps(path, out):
    with rosbag.Bag(path) as bag, rosbag.Bag(out, "w") as zeroed:
        for topic, message, arrival in bag.read_messages():
            message.header.stamp = rospy.Time()
            zeroed.write(topic, message, arrival)


def publish(path):
    with rosbag.Bag(path) as bag:
        messages = [message for _, message, _ in bag.read_messages()]
    rospy.init_node("driver", anonymous=True)
    publisher = rospy.Publisher(TOPIC, PointCloud2, queue_size=10)
    there_and_back = messages + messages[-2:0:-1]
    number = 0
    while not rospy.is_shutdown():
        message = there_and_back[number % len(there_and_back)]
        message.header.stamp = rospy.Time.now()
        publisher.publish(message)
        number += 1
        rospy.sleep(0.1)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("bag")
    parser.add_argument("--make", action="store_true", help="write the bag, and end")
    parser.add_argument("--record-with-zero-stamps", metavar="OUT", help="likewise from the bag")
    arguments = parser.parse_args(rospy.myargv()[1:])
    if arguments.make:
        make(arguments.bag)
    elif arguments.record_with_zero_stamps:
        record_with_zero_stamps(arguments.bag, arguments.record_with_zero_stamps)
    else:
        try:
            publish(arguments.bag)
        except rospy.ROSInterruptException:
            pass


if __name__ == "__main__":
    sys.exit(main())
