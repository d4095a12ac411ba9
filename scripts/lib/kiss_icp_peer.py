#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""KISS-ICP on the scans of a bag. Run by compare_odometry in the peers' virtual environment.

decode writes the scans of one topic to a folder, one file each; run registers them and measures.
They are separate processes so that reading the bag leaves no trace in time or memory.
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from trajectories import Trajectory, quaternion_of, write_tum

POINT_CLOUD = "sensor_msgs/msg/PointCloud2"
TIME_FIELDS = ("t", "time", "timestamp", "timestamps", "time_stamp", "offset_time", "time_offset")
SECONDS = (1.0, 1e-3, 1e-6, 1e-9)
NUMBER_TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 8: "f8"}


def choose_topic(reader: Any, topic: Optional[str]) -> str:
    clouds = sorted(name for name, info in reader.topics.items() if info.msgtype == POINT_CLOUD)
    if topic is None and len(clouds) == 1:
        return clouds[0]
    if topic not in clouds:
        raise SystemExit(f"choose --topic among {', '.join(clouds) or 'none'}; asked for {topic}")
    return str(topic)


def message_fields(message: Any) -> np.ndarray:
    order = ">" if message.is_bigendian else "<"
    fields = [field for field in message.fields if field.datatype in NUMBER_TYPES]
    layout = np.dtype(
        {
            "names": [field.name for field in fields],
            "formats": [order + NUMBER_TYPES[field.datatype] for field in fields],
            "offsets": [field.offset for field in fields],
            "itemsize": message.point_step,
        }
    )
    rows = np.frombuffer(message.data, np.uint8).reshape(message.height, message.row_step)
    used = np.ascontiguousarray(rows[:, : message.width * message.point_step])
    return used.reshape(-1).view(layout)


def time_unit(times: np.ndarray) -> float:
    """The unit, in seconds, that makes a sweep last between 5 ms and 2 s: at most one does."""
    spread = float(times.max() - times.min())
    for unit in SECONDS:
        if 0.005 < spread * unit <= 2.0:
            return unit
    raise SystemExit(f"a sweep of {spread} in no known unit: use --deskew off or azimuth")


def read_scan(message: Any) -> Tuple[np.ndarray, Optional[np.ndarray], float]:
    """Points that are measurements, their times, and the seconds from header to last point."""
    return read_scan_with_rings(message)[:3]


def read_scan_with_rings(
    message: Any,
) -> Tuple[np.ndarray, Optional[np.ndarray], float, Optional[np.ndarray]]:
    """The same and the rings of the points, if the message has them."""
    cloud = message_fields(message)
    points = np.column_stack([cloud[axis].astype(np.float32) for axis in "xyz"])
    keep = np.isfinite(points).all(axis=1) & points.any(axis=1)
    rings = cloud["ring"][keep].astype(np.int64) if "ring" in cloud.dtype.names else None
    name = next((name for name in TIME_FIELDS if name in cloud.dtype.names), None)
    if name is None or not keep.any():
        return points[keep], None, 0.0, rings
    times = cloud[name][keep].astype(np.float64)
    if times.max() == times.min():
        return points[keep], None, 0.0, rings
    unit = time_unit(times)
    last = float(times.max()) * unit
    if last > 1e8:  # since 1970, not since the header
        last -= message.header.stamp.sec + message.header.stamp.nanosec * 1e-9
    return points[keep], times, last, rings


def decode(arguments: argparse.Namespace) -> None:
    from rosbags.highlevel import AnyReader

    arguments.cache.mkdir(parents=True, exist_ok=True)
    index: Dict[str, Any] = {"key": arguments.key, "stamps": [], "seconds_to_last_point": []}
    with AnyReader([arguments.bag]) as reader:
        topic = choose_topic(reader, arguments.topic)
        connections = [c for c in reader.connections if c.topic == topic]
        for connection, _, raw in reader.messages(connections=connections):
            if len(index["stamps"]) == arguments.max_scans:
                break
            message = reader.deserialize(raw, connection.msgtype)
            points, times, last = read_scan(message)
            number = len(index["stamps"])
            np.save(arguments.cache / f"points_{number:06d}.npy", points)
            if times is not None:
                np.save(arguments.cache / f"times_{number:06d}.npy", times)
            stamp = message.header.stamp
            index["stamps"].append(stamp.sec + stamp.nanosec * 1e-9)
            index["seconds_to_last_point"].append(last)
            index["has_times"] = index.get("has_times", True) and times is not None
    index["topic"] = topic
    (arguments.cache / "index.json").write_text(json.dumps(index))


def azimuth_times(points: np.ndarray) -> np.ndarray:
    """Of a sensor that turns clockwise seen from above and starts its sweep behind: 0 to 1."""
    return 0.5 * (1.0 - np.arctan2(points[:, 1], points[:, 0]) / np.pi)


def load_scan(cache: Path, number: int, deskew: str) -> Tuple[np.ndarray, np.ndarray]:
    points = np.load(cache / f"points_{number:06d}.npy").astype(np.float64)
    if deskew == "azimuth":
        return points, azimuth_times(points)
    if deskew == "field":
        return points, np.load(cache / f"times_{number:06d}.npy")
    return points, np.array([])


def peak_memory_mb() -> float:
    """Of this process alone: ru_maxrss would start at what the parent held when it forked."""
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith("VmHWM"):
            return int(line.split()[1]) / 1024.0
    raise RuntimeError("no VmHWM in /proc/self/status")


class ConversionTimer:
    """Counts the time that the Python binding spends on copying points into C++ vectors."""

    def __init__(self) -> None:
        from kiss_icp.pybind import kiss_icp_pybind

        self._convert = kiss_icp_pybind._Vector3dVector
        self.seconds = 0.0
        kiss_icp_pybind._Vector3dVector = self

    def __call__(self, points: np.ndarray) -> Any:
        start = time.perf_counter()
        converted = self._convert(points)
        self.seconds += time.perf_counter() - start
        return converted


def make_odometry(arguments: argparse.Namespace) -> Any:
    from kiss_icp.config import load_config
    from kiss_icp.kiss_icp import KissICP

    config = load_config(None)
    config.data.max_range = arguments.max_range
    config.data.min_range = 0.0
    config.data.deskew = arguments.deskew != "off"
    config.mapping.voxel_size = arguments.voxel_size
    config.registration.max_num_threads = arguments.threads
    return KissICP(config)


def run(arguments: argparse.Namespace) -> None:
    odometry = make_odometry(arguments)
    conversion = ConversionTimer()
    index = json.loads((arguments.cache / "index.json").read_text())
    wall: List[float] = []
    cpu: List[float] = []
    converting: List[float] = []
    poses: List[np.ndarray] = []
    memory_before = peak_memory_mb()
    for number in range(len(index["stamps"])):
        points, times = load_scan(arguments.cache, number, arguments.deskew)
        conversion.seconds = 0.0
        cpu_start, start = time.process_time(), time.perf_counter()
        odometry.register_frame(points, times)
        wall.append(time.perf_counter() - start)
        cpu.append(time.process_time() - cpu_start)
        converting.append(conversion.seconds)
        poses.append(odometry.last_pose.copy())
    write_result(arguments, index, poses, wall, cpu, converting, memory_before)


def pose_stamps(index: Dict[str, Any], arguments: argparse.Namespace) -> np.ndarray:
    """Deskewing moves the points to the last one's instant; else the header's is all there is."""
    stamps = np.array(index["stamps"])
    if arguments.deskew == "field":
        return stamps + np.array(index["seconds_to_last_point"])
    if arguments.deskew == "azimuth" and len(stamps) > 1:
        fraction = {"last": 0.0, "middle": 0.5, "first": 1.0}[arguments.header_stamp]
        return stamps + fraction * float(np.median(np.diff(stamps)))
    return stamps


def write_result(
    arguments: argparse.Namespace,
    index: Dict[str, Any],
    poses: List[np.ndarray],
    wall: List[float],
    cpu: List[float],
    converting: List[float],
    memory_before: float,
) -> None:
    arguments.out.mkdir(parents=True, exist_ok=True)
    matrices = np.array(poses)
    quaternions = np.array([quaternion_of(matrix[:3, :3]) for matrix in matrices])
    stamps = pose_stamps(index, arguments)
    write_tum(arguments.out / "odometry.tum", Trajectory(stamps, matrices[:, :3, 3], quaternions))
    result = {
        "wall_ms": [1e3 * seconds for seconds in wall],
        "cpu_seconds_per_scan": float(np.mean(cpu)),
        "conversion_ms": float(np.median(converting) * 1e3),
        "peak_memory_mb": peak_memory_mb(),
        "memory_before_first_scan_mb": memory_before,
    }
    (arguments.out / "result.json").write_text(json.dumps(result))


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    reading = commands.add_parser("decode")
    reading.add_argument("--bag", type=Path, required=True)
    reading.add_argument("--topic")
    reading.add_argument("--cache", type=Path, required=True)
    reading.add_argument("--key", required=True)
    reading.add_argument("--max-scans", type=int, default=-1)
    running = commands.add_parser("run")
    running.add_argument("--cache", type=Path, required=True)
    running.add_argument("--out", type=Path, required=True)
    running.add_argument("--threads", type=int, required=True)
    running.add_argument("--deskew", choices=("off", "azimuth", "field"), required=True)
    running.add_argument("--header-stamp", choices=("first", "middle", "last"), default="last")
    running.add_argument("--max-range", type=float, default=100.0)
    running.add_argument("--voxel-size", type=float, default=1.0)
    return parser.parse_args()


def main() -> None:
    arguments = parse_arguments()
    {"decode": decode, "run": run}[arguments.command](arguments)


if __name__ == "__main__":
    main()
