#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""One peer on one bag. Run by scripts/benchmark in the peers' virtual environment.

Writes trajectory.tum (T_map_base of every scan at its last point) and peer.json. Time and CPU are
those of the peer's own calls: reading the bag is left out.
"""

from __future__ import annotations

import argparse
import json
import resource
import sys
import time
from importlib.metadata import version
from itertools import islice
from pathlib import Path
from typing import Any, Callable, Dict, Iterator, List

import numpy as np

from kiss_icp_peer import peak_memory_mb
from peer_bag import extrinsics, open_bag, scans
from peer_systems import PEERS
from trajectories import Trajectory, quaternion_of, write_tum


def cpu_seconds() -> float:
    """Of all threads and finished children, user and system."""
    usages = map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(usage.ru_utime + usage.ru_stime for usage in usages)


class Meter:
    """Wall seconds of each step of the peer, and the CPU time spent outside of reading."""

    def __init__(self) -> None:
        self.wall: List[float] = []
        self._cpu_start = cpu_seconds()
        self._reading = 0.0

    def measure(self, step: Callable[[], None]) -> None:
        start = time.perf_counter()
        step()
        self.wall.append(time.perf_counter() - start)

    def reading(self, source: Iterator[Any]) -> Iterator[Any]:
        """The scans, the time of this thread between them taken off."""
        while True:
            start = time.thread_time()
            scan = next(source, None)
            self._reading += time.thread_time() - start
            if scan is None:
                return
            yield scan

    def cpu(self) -> float:
        return cpu_seconds() - self._cpu_start - self._reading


def prepared(reader: Any, peer: Any, arguments: argparse.Namespace) -> Iterator[Any]:
    """Scans, and what the peer takes of each."""
    random = np.random.default_rng(arguments.jitter_seed)
    for scan in scans(reader, arguments.topic, arguments.azimuth):
        if arguments.jitter > 0.0:
            noise = random.uniform(-arguments.jitter, arguments.jitter, scan.points.shape)
            scan = scan._replace(points=scan.points + noise)
        yield scan, peer.prepare(scan)


def run(peer: Any, arguments: argparse.Namespace) -> Dict[str, Any]:
    memory_before, stamps = peak_memory_mb(), []
    with open_bag(arguments.bag) as reader:
        T_base_sensor = extrinsics(reader, arguments.topic, arguments.base)
        meter = Meter()
        source = islice(prepared(reader, peer, arguments), arguments.max_scans or None)
        for scan, prepared_scan in meter.reading(source):
            meter.measure(lambda: peer.process(*prepared_scan))
            stamps.append(scan.stamp - (1.0 - peer.stamped_at) * scan.duration)
            if len(stamps) % 100 == 0:
                print(f"{len(stamps)} scans", flush=True)
        meter.measure(peer.finish)
    write_trajectory(arguments.out / "trajectory.tum", stamps, peer.poses(), T_base_sensor)
    return {
        "versions": {package: version(package) for package in ("rosbags", *peer.packages)},
        "python": sys.version.split()[0],
        "parameters": peer.parameters(),
        "scans": len(stamps),
        "wall_ms": [1e3 * seconds for seconds in meter.wall[:-1]],
        "finish_seconds": meter.wall[-1],
        "cpu_seconds": meter.cpu(),
        "peak_memory_mb": peak_memory_mb(),
        "memory_before_first_scan_mb": memory_before,
        "loops": peer.loops,
    }


def write_trajectory(
    path: Path, stamps: List[float], T_odom_sensor: np.ndarray, T_base_sensor: np.ndarray
) -> None:
    if len(T_odom_sensor) != len(stamps):
        raise SystemExit(f"{len(stamps)} scans, but {len(T_odom_sensor)} poses")
    poses = T_base_sensor @ T_odom_sensor @ np.linalg.inv(T_base_sensor)
    quaternions = np.array([quaternion_of(pose[:3, :3]) for pose in poses])
    write_tum(path, Trajectory(np.array(stamps), poses[:, :3, 3], quaternions))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("peer", choices=sorted(PEERS))
    parser.add_argument("--bag", type=Path, required=True)
    parser.add_argument("--topic")
    parser.add_argument("--base", default="base_link", help="of the poses; empty: the sensor")
    parser.add_argument("--azimuth", action="store_true", help="times from directions")
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--max-scans", type=int, default=0)
    parser.add_argument("--jitter", type=float, default=0.0, help="m, on each coordinate")
    parser.add_argument("--jitter-seed", type=int, default=1)
    arguments = parser.parse_args()
    result = run(PEERS[arguments.peer](), arguments)
    (arguments.out / "peer.json").write_text(json.dumps(result))


if __name__ == "__main__":
    main()
