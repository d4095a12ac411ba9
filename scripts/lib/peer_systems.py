#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The peers behind one face, each driven as its own command-line pipeline drives it.

prepare turns points and times into what process takes, which is not measured; finish does what the pipeline does after the last scan; poses are
T_odom_sensor (n, 4, 4) of every scan; loops is the number of accepted closures, None if it closes
none; parameters are those in force.
"""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from peer_bag import PeerScan


class Peer:
    """stamped_at: the instant of a scan at which its pose is valid, 0 the first point, 1 the last."""

    packages: Tuple[str, ...] = ()
    loops: Optional[int] = None
    stamped_at = 1.0

    def prepare(self, scan: PeerScan) -> Tuple[Any, ...]:
        return scan.points, scan.times

    def finish(self) -> None:
        pass


class KissIcp(Peer):
    packages = ("kiss-icp",)

    def __init__(self) -> None:
        from kiss_icp.config import load_config
        from kiss_icp.kiss_icp import KissICP

        self._config = load_config(None)
        self._odometry = KissICP(self._config)
        self._poses: List[np.ndarray] = []

    def process(self, points: np.ndarray, times: np.ndarray) -> None:
        self._odometry.register_frame(points, times)
        self._poses.append(self._odometry.last_pose.copy())

    def poses(self) -> np.ndarray:
        return np.array(self._poses)

    def parameters(self) -> Dict[str, Any]:
        return self._config.model_dump()


class KissSlam(Peer):
    packages = ("kiss-slam", "kiss-icp", "map-closures", "open3d")

    def __init__(self) -> None:
        from kiss_slam.config import load_config
        from kiss_slam.slam import KissSLAM

        self._config = load_config(None)
        self._slam = KissSLAM(self._config)
        self._poses = np.empty((0, 4, 4))

    def process(self, points: np.ndarray, times: np.ndarray) -> None:
        self._slam.process_scan(points, times)

    def finish(self) -> None:
        self._slam.generate_new_node()
        self._slam.local_map_graph.erase_last_local_map()
        poses, _ = self._slam.fine_grained_optimization()
        self._poses = np.array(poses)

    def poses(self) -> np.ndarray:
        return self._poses

    @property
    def loops(self) -> int:
        return len(self._slam.get_closures())

    def parameters(self) -> Dict[str, Any]:
        return self._config.model_dump()


class RetroSlam(Peer):
    packages = ("retro-slam", "kiss-icp", "map-closures")

    def __init__(self) -> None:
        from retro_slam.config import load_config
        from retro_slam.slam import RetroSLAM

        self._config = load_config(None)
        self._slam = RetroSLAM(self._config)

    def process(self, points: np.ndarray, times: np.ndarray) -> None:
        self._slam.process_scan(points, times)

    def finish(self) -> None:
        self._slam.exit()

    def poses(self) -> np.ndarray:
        return self._slam.poses

    @property
    def loops(self) -> int:
        return len(self._slam.loop_closures)

    def parameters(self) -> Dict[str, Any]:
        return self._config.model_dump()


class GenzIcp(Peer):
    packages = ("genz-icp",)
    stamped_at = 0.5  # it deskews to the middle of the scan: measured as for CtIcp

    def __init__(self) -> None:
        from genz_icp.config import load_config
        from genz_icp.genz_icp import GenZICP

        self._config = load_config(None)
        self._config.data.deskew = True  # as the others do by default
        self._odometry = GenZICP(self._config)
        self._poses: List[np.ndarray] = []

    def prepare(self, scan: PeerScan) -> Tuple[Any, ...]:
        if not len(scan.times):
            return scan.points, scan.times
        return scan.points, (scan.times - scan.times.min()) / np.ptp(scan.times)  # 0 to 1

    def process(self, points: np.ndarray, times: np.ndarray) -> None:
        self._odometry.register_frame(points, times)
        self._poses.append(np.array(self._odometry.last_pose))

    def poses(self) -> np.ndarray:
        return np.array(self._poses)

    def parameters(self) -> Dict[str, Any]:
        return self._config.model_dump()


class Evalio(Peer):
    """A pipeline of evalio with its default parameters but `changed`. Scans are numbered by a clock of their own,
    ten a second, as evalio wants stamps; a scan without times has all points at its start."""

    packages = ("evalio",)
    pipeline = ""
    changed: Dict[str, Any] = {}
    PERIOD = 100_000_000  # ns

    def __init__(self) -> None:
        import evalio.pipelines
        self._pipeline = getattr(evalio.pipelines, self.pipeline)()
        self._parameters = {**self._pipeline.default_params(), **self.changed}
        self._pipeline.set_params(self._parameters)
        self._scans = 0
        self._poses: Dict[int, np.ndarray] = {}

    def _initialise(self, rows: int, columns: int) -> None:
        from evalio.types import SE3, LidarParams

        lidar = LidarParams(num_rows=rows, num_columns=columns, min_range=0.5, max_range=100.0)
        self._pipeline.set_lidar_params(lidar)
        self._pipeline.set_imu_T_lidar(SE3.identity())
        self._pipeline.initialize()

    def prepare(self, scan: PeerScan) -> Tuple[Any, ...]:
        from evalio.types import Duration, LidarMeasurement, Point, Stamp

        times = scan.times if len(scan.times) else np.zeros(len(scan.points))
        spread = np.ptp(times)
        share = (times - times.min()) / spread if spread > 0.0 else times
        nanoseconds = (share * (self.PERIOD - 1)).astype(np.int64)
        points, nanoseconds = self.arrange(scan, nanoseconds)
        measurement = LidarMeasurement(Stamp.from_nsec((self._scans + 1) * self.PERIOD))
        measurement.points = [
            Point(x=x, y=y, z=z, t=Duration.from_nsec(t))
            for (x, y, z), t in zip(points.tolist(), nanoseconds.tolist())
        ]
        self._scans += 1
        return (measurement,)

    def arrange(self, scan: PeerScan, nanoseconds: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
        """The points in the order that the pipeline wants, and their times."""
        if self._scans == 0:
            self._initialise(64, 1024)
        return scan.points, nanoseconds

    def process(self, scan: Any) -> None:
        self._pipeline.add_lidar(scan)
        for stamp, pose in self._pipeline.saved_estimates():
            number = int(round(stamp.to_nsec() / self.PERIOD)) - 1
            self._poses[number] = np.array(pose.to_mat())

    def poses(self) -> np.ndarray:
        """Of every scan; one that the pipeline left out stays where the scan before was."""
        poses = [np.eye(4)]
        for number in range(self._scans):
            poses.append(self._poses.get(number, poses[-1]))
        return np.array(poses[1:])

    def parameters(self) -> Dict[str, Any]:
        return self._parameters


class CtIcp(Evalio):
    pipeline = "CTICP"
    # Measured on a simulated drive: elsewhere its poses are ten times farther from the truth.
    stamped_at = 0.0


class MadIcp(Evalio):
    pipeline = "MadICP"
    # Deskewing as the others do by default; results that do not depend on the time of day.
    changed = {"deskew": True, "realtime": False}


class Organised(Evalio):
    """Wants every ring as a row, with a place for each firing; places without a point are zero."""

    _columns = 0

    def arrange(self, scan: PeerScan, nanoseconds: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
        if scan.rings is None or not len(scan.times):
            raise SystemExit(f"{self.pipeline} needs rings and times of the points")
        firings, column = np.unique(scan.times, return_inverse=True)
        if self._scans == 0:
            self._rows, self._columns = int(scan.rings.max()) + 1, len(firings)
            self._initialise(self._rows, self._columns)
        place = scan.rings * self._columns + np.minimum(column, self._columns - 1)
        points = np.zeros((self._rows * self._columns, 3))
        times = np.zeros(len(points), dtype=np.int64)
        points[place], times[place] = scan.points, nanoseconds
        return points, times


class Form(Organised):
    pipeline = "FORM"


class Loam(Organised):
    pipeline = "LOAM"
    stamped_at = 0.5  # it does not deskew


PEERS = {
    "kiss-icp": KissIcp,
    "kiss-slam": KissSlam,
    "retro-slam": RetroSlam,
    "genz-icp": GenzIcp,
    "ct-icp": CtIcp,
    "mad-icp": MadIcp,
    "form": Form,
    "loam": Loam,
}
