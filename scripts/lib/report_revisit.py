# SPDX-License-Identifier: MIT
"""A cut across a street that was driven through twice: as the odometry has it, and in the map."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Dict, Iterator, List, NamedTuple, Optional, Tuple

import numpy as np

from point_cloud_file import read_pcd
from trajectories import Trajectory, rotation_matrix

HALF_THICKNESS, HALF_WIDTH, LOWEST, HIGHEST = 0.6, 18.0, -3.0, 9.0  # m, of the cut
FEWEST = 150  # points of either pass


class Cut(NamedTuple):
    """(metres to the left, metres up) of the points of the first and the second pass."""

    first: np.ndarray
    second: np.ndarray
    second_by_odometry: Optional[np.ndarray]
    moved: float  # m, what the loops have moved the second pass against the first
    submaps: Tuple[int, int]


def transform(position: np.ndarray, quaternion: np.ndarray) -> np.ndarray:
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rotation_matrix(quaternion), position
    return pose


def pose_at(track: Trajectory, stamp: float) -> np.ndarray:
    nearest = int(np.abs(track.stamps - stamp).argmin())
    return transform(track.positions[nearest], track.quaternions[nearest])


def apply(pose: np.ndarray, points: np.ndarray) -> np.ndarray:
    return points @ pose[:3, :3].T + pose[:3, 3]


def rows_of(path: Path) -> List[Dict[str, str]]:
    with open(str(path), newline="") as file:
        return list(csv.DictReader(file))


class Submaps:
    """Those of one session: where the map has them, and where the odometry had them."""

    def __init__(self, folder: Path, tracks: Dict[str, Trajectory]) -> None:
        rows = rows_of(folder / "submaps/submaps.csv")
        ends = [float(row["stamp"]) for row in rows[1:]] + [np.inf]
        self._folder, self._tracks = folder, tracks
        self._times = {int(r["submap"]): (float(r["stamp"]), e) for r, e in zip(rows, ends)}

    def pose(self, submap: int, track: str) -> np.ndarray:
        return pose_at(self._tracks[track], self._times[submap][0])

    def path(self, submap: int) -> np.ndarray:
        """Corrected positions of its scans."""
        track, (begin, end) = self._tracks["trajectory"], self._times[submap]
        return track.positions[(track.stamps >= begin - 1e-3) & (track.stamps < end - 1e-3)]

    def points(self, submap: int) -> np.ndarray:
        """In its own frame."""
        return read_pcd(self._folder / f"submaps/{submap:06d}.pcd", 10_000_000)


def place_of(first: np.ndarray, second: np.ndarray) -> Optional[np.ndarray]:
    """The frame of the cut, x ahead and z up, where two paths are nearest; T_map_cut."""
    gaps = np.linalg.norm(first[:, None, :2] - second[None, :, :2], axis=2)
    here = int(np.unravel_index(gaps.argmin(), gaps.shape)[0])
    ahead = first[min(here + 3, len(first) - 1)] - first[max(here - 3, 0)]
    if gaps.min() > HALF_WIDTH or np.linalg.norm(ahead[:2]) < 0.1:
        return None
    forward = np.array([*ahead[:2], 0.0]) / np.linalg.norm(ahead[:2])
    frame = np.eye(4)
    frame[:3, :3] = np.column_stack([forward, np.cross([0, 0, 1], forward), [0, 0, 1]])
    frame[:3, 3] = first[here]
    return frame


def cut_of(points: np.ndarray) -> np.ndarray:
    x, y, z = points.T
    kept = (np.abs(x) < HALF_THICKNESS) & (np.abs(y) < HALF_WIDTH) & (z > LOWEST) & (z < HIGHEST)
    return points[kept][:, 1:]


def changes(folder: Path, submaps: Submaps, by_odometry: bool) -> Iterator[Tuple[float, int, int]]:
    """Of each loop: what it was moved by, and its submaps."""
    for row in rows_of(folder / "loop_closures.csv"):
        if row["state"] != "active":
            continue
        first, second = sorted((int(row["target_submap"]), int(row["source_submap"])))
        difference = 0.0
        if by_odometry:
            before, after = (np.linalg.inv(submaps.pose(first, track)) @ submaps.pose(second, track)
                             for track in ("odometry", "trajectory"))
            difference = float(np.linalg.norm(before[:3, 3] - after[:3, 3]))
        yield difference, first, second


def most_corrected_cut(folder: Path, tracks: Dict[str, Trajectory]) -> Optional[Cut]:
    """At the loop that has moved the second pass most, of those that show enough; none: no loop does."""
    needed = ("submaps/submaps.csv", "loop_closures.csv")
    if "trajectory" not in tracks or not all((folder / name).is_file() for name in needed):
        return None
    if any(int(row["session"]) > 0 for row in rows_of(folder / needed[0])):
        return None  # stamps of several sessions tell nothing of their frames
    submaps, by_odometry = Submaps(folder, tracks), "odometry" in tracks
    for moved, first, second in sorted(changes(folder, submaps, by_odometry), reverse=True)[:20]:
        T_map_cut = place_of(submaps.path(first), submaps.path(second))
        if T_map_cut is None:
            continue
        T_cut_map = np.linalg.inv(T_map_cut)
        T_map_first, T_map_second = (submaps.pose(s, "trajectory") for s in (first, second))
        points = submaps.points(second)
        cut_first = cut_of(apply(T_cut_map @ T_map_first, submaps.points(first)))
        cut_second = cut_of(apply(T_cut_map @ T_map_second, points))
        if min(len(cut_first), len(cut_second)) < FEWEST:
            continue
        before = None
        if by_odometry:
            T_first_second = np.linalg.inv(submaps.pose(first, "odometry")) @ submaps.pose(second, "odometry")
            before = cut_of(apply(T_cut_map @ T_map_first @ T_first_second, points))
        return Cut(cut_first, cut_second, before, moved, (first, second))
    return None
