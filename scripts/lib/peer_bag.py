#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The scans of a bag, read alike for all peers, and where the sensor sits on the platform."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, Iterator, NamedTuple, Optional, Tuple

import numpy as np

from kiss_icp_peer import azimuth_times, choose_topic, read_scan_with_rings, time_unit
from trajectories import rotation_matrix


class PeerScan(NamedTuple):
    """stamp: instant of the last point in seconds, to which the peers deskew.

    points: (n, 3) metres in the sensor's frame. times: (n), rising with time, in any unit; empty
    if the bag has none. duration: seconds from the first to the last point. rings: (n), if known.
    """

    stamp: float
    points: np.ndarray
    times: np.ndarray
    duration: float
    rings: Optional[np.ndarray] = None


def scans(reader: Any, topic: Optional[str], azimuth: bool = False) -> Iterator[PeerScan]:
    """azimuth: of a sensor whose bag has no times, and whose stamps are those of the last points."""
    topic = choose_topic(reader, topic)
    connections = [c for c in reader.connections if c.topic == topic]
    for connection, _, raw in reader.messages(connections=connections):
        message = reader.deserialize(raw, connection.msgtype)
        points, times, seconds_to_last, rings = read_scan_with_rings(message)
        header = message.header.stamp
        stamp = header.sec + header.nanosec * 1e-9 + seconds_to_last
        points = points.astype(np.float64)
        if times is None:
            times = azimuth_times(points) if azimuth else np.empty(0)
        duration = float(np.ptp(times)) * time_unit(times) if len(times) and not azimuth else 0.0
        yield PeerScan(stamp, points, times, duration, rings)


def sensor_frame(reader: Any, topic: Optional[str]) -> str:
    topic = choose_topic(reader, topic)
    connections = [c for c in reader.connections if c.topic == topic]
    connection, _, raw = next(reader.messages(connections=connections))
    return str(reader.deserialize(raw, connection.msgtype).header.frame_id)


def static_transforms(reader: Any) -> Dict[str, Tuple[str, np.ndarray]]:
    """Child frame to parent frame and T_parent_child."""
    found: Dict[str, Tuple[str, np.ndarray]] = {}
    connections = [c for c in reader.connections if c.topic == "/tf_static"]
    if not connections:  # of none the reader would give the messages of all
        return found
    for connection, _, raw in reader.messages(connections=connections):
        for stamped in reader.deserialize(raw, connection.msgtype).transforms:
            q, t = stamped.transform.rotation, stamped.transform.translation
            pose = np.eye(4)
            pose[:3, :3] = rotation_matrix(np.array([q.x, q.y, q.z, q.w]))
            pose[:3, 3] = (t.x, t.y, t.z)
            found[stamped.child_frame_id] = (stamped.header.frame_id, pose)
    return found


def extrinsics(reader: Any, topic: Optional[str], base: str) -> np.ndarray:
    """T_base_sensor; the identity, so that poses are the sensor's own, if the bag has no path."""
    frame, T_frame_sensor = sensor_frame(reader, topic), np.eye(4)
    transforms = static_transforms(reader)
    for _ in range(len(transforms) + 1):
        if frame == base:
            return T_frame_sensor
        if frame not in transforms:
            break
        frame, T_parent_frame = transforms[frame]
        T_frame_sensor = T_parent_frame @ T_frame_sensor
    return np.eye(4)


def open_bag(path: Path) -> Any:
    from rosbags.highlevel import AnyReader

    return AnyReader([path])
