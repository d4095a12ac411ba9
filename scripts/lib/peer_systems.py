#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The peers behind one face, each driven as its own command-line pipeline drives it.

process takes one scan; finish does what the pipeline does after the last scan; poses are
T_odom_sensor (n, 4, 4) of every scan; loops is the number of accepted closures, None if it closes
none; parameters are those in force.
"""

from __future__ import annotations

from typing import Any, Dict, List, Optional

import numpy as np


class KissIcp:
    packages = ("kiss-icp",)
    loops: Optional[int] = None

    def __init__(self) -> None:
        from kiss_icp.config import load_config
        from kiss_icp.kiss_icp import KissICP

        self._config = load_config(None)
        self._odometry = KissICP(self._config)
        self._poses: List[np.ndarray] = []

    def process(self, points: np.ndarray, times: np.ndarray) -> None:
        self._odometry.register_frame(points, times)
        self._poses.append(self._odometry.last_pose.copy())

    def finish(self) -> None:
        pass

    def poses(self) -> np.ndarray:
        return np.array(self._poses)

    def parameters(self) -> Dict[str, Any]:
        return self._config.model_dump()


class KissSlam:
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


class RetroSlam:
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


PEERS = {"kiss-icp": KissIcp, "kiss-slam": KissSlam, "retro-slam": RetroSlam}
