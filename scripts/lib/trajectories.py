#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Trajectories in TUM files, and how far one is from another."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple, Tuple

import numpy as np

# Stamps that were rounded when they were written may lie just outside the reference.
STAMP_TOLERANCE = 0.001


class Trajectory(NamedTuple):
    """Poses over time: stamps (n), positions (n, 3), unit quaternions x y z w (n, 4)."""

    stamps: np.ndarray
    positions: np.ndarray
    quaternions: np.ndarray

    def select(self, mask: np.ndarray) -> "Trajectory":
        return Trajectory(self.stamps[mask], self.positions[mask], self.quaternions[mask])


class Errors(NamedTuple):
    """A trajectory judged against a reference, at the stamps that both cover.

    ate: RMSE of the positions in metres after rigid alignment without scale.
    end_point: distance in metres between the last positions once the *first poses* coincide: what
        the drift of the whole drive has become where it ends.
    aligned: the positions, moved onto the reference.
    per_pose: distance of each aligned position in metres.
    """

    ate: float
    end_point: float
    path_length: float
    reference_path_length: float
    stamps: np.ndarray
    aligned: np.ndarray
    reference: np.ndarray
    per_pose: np.ndarray
    left_out: int
    rotation: np.ndarray
    translation: np.ndarray


def read_tum(path: Path) -> Trajectory:
    table = np.loadtxt(str(path), ndmin=2)
    if table.size == 0:
        raise ValueError(f"{path} holds no pose")
    if table.shape[1] != 8:
        raise ValueError(f"{path}: expected 8 columns, found {table.shape[1]}")
    quaternions = table[:, 4:8] / np.linalg.norm(table[:, 4:8], axis=1, keepdims=True)
    return Trajectory(table[:, 0], table[:, 1:4], quaternions)


def write_tum(path: Path, trajectory: Trajectory) -> None:
    with open(str(path), "w") as file:
        for stamp, position, quaternion in zip(*trajectory):
            numbers = " ".join(f"{value:.9f}" for value in (*position, *quaternion))
            file.write(f"{stamp:.9f} {numbers}\n")


def rotation_matrix(quaternion: np.ndarray) -> np.ndarray:
    x, y, z, w = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def quaternion_of(rotation: np.ndarray) -> np.ndarray:
    """x y z w, as the dominant eigenvector of a symmetric 4x4 matrix: no special cases."""
    r = rotation
    k = np.array(
        [
            [r[0, 0] - r[1, 1] - r[2, 2], 0, 0, 0],
            [r[0, 1] + r[1, 0], r[1, 1] - r[0, 0] - r[2, 2], 0, 0],
            [r[0, 2] + r[2, 0], r[1, 2] + r[2, 1], r[2, 2] - r[0, 0] - r[1, 1], 0],
            [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1], np.trace(r)],
        ]
    )
    quaternion = np.linalg.eigh(k)[1][:, -1]
    return quaternion if quaternion[3] >= 0 else -quaternion


def slerp(a: np.ndarray, b: np.ndarray, fraction: np.ndarray) -> np.ndarray:
    b = np.where(np.sum(a * b, axis=1, keepdims=True) < 0, -b, b)
    angle = np.arccos(np.clip(np.sum(a * b, axis=1, keepdims=True), -1, 1))
    fraction = fraction[:, None]
    small = angle < 1e-8
    sine = np.where(small, 1.0, np.sin(angle))
    weight_a = np.where(small, 1 - fraction, np.sin((1 - fraction) * angle) / sine)
    weight_b = np.where(small, fraction, np.sin(fraction * angle) / sine)
    mixed = weight_a * a + weight_b * b
    return mixed / np.linalg.norm(mixed, axis=1, keepdims=True)


def interpolate(trajectory: Trajectory, stamps: np.ndarray) -> Trajectory:
    """Poses at other stamps, all within the trajectory."""
    if len(trajectory.stamps) == 1:
        one = np.zeros(len(stamps), dtype=int)
        return Trajectory(stamps, trajectory.positions[one], trajectory.quaternions[one])
    after = np.clip(np.searchsorted(trajectory.stamps, stamps), 1, len(trajectory.stamps) - 1)
    before = after - 1
    span = trajectory.stamps[after] - trajectory.stamps[before]
    fraction = np.clip((stamps - trajectory.stamps[before]) / np.maximum(span, 1e-12), 0, 1)
    first, second = trajectory.positions[before], trajectory.positions[after]
    positions = first + fraction[:, None] * (second - first)
    rotations = slerp(trajectory.quaternions[before], trajectory.quaternions[after], fraction)
    return Trajectory(stamps, positions, rotations)


def align(points: np.ndarray, onto: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Rotation R and translation t that minimise |R p + t - q|^2 (Umeyama 1991, without scale)."""
    centre, onto_centre = points.mean(axis=0), onto.mean(axis=0)
    u, _, vt = np.linalg.svd((onto - onto_centre).T @ (points - centre))
    handedness = np.diag([1.0, 1.0, np.sign(np.linalg.det(u @ vt))])
    rotation = u @ handedness @ vt
    return rotation, onto_centre - rotation @ centre


def carried(trajectory: Trajectory, position: np.ndarray) -> Trajectory:
    """The trajectory of what is mounted at `position` in the moving frame, without rotation."""
    arms = np.array(
        [rotation_matrix(quaternion) @ position for quaternion in trajectory.quaternions]
    )
    return trajectory._replace(positions=trajectory.positions + arms)


def path_length(positions: np.ndarray) -> float:
    return float(np.linalg.norm(np.diff(positions, axis=0), axis=1).sum())


def distance_along(positions: np.ndarray) -> np.ndarray:
    steps = np.linalg.norm(np.diff(positions, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


def end_point_error(estimate: Trajectory, reference: Trajectory) -> float:
    """Both trajectories have the same stamps; see Errors.end_point."""
    rotation = (
        rotation_matrix(reference.quaternions[0]) @ rotation_matrix(estimate.quaternions[0]).T
    )
    travelled = rotation @ (estimate.positions[-1] - estimate.positions[0])
    return float(np.linalg.norm(travelled - (reference.positions[-1] - reference.positions[0])))


def judge(estimate: Trajectory, reference: Trajectory) -> Errors:
    """The reference is interpolated at the estimate's own stamps; poses beyond it are left out.

    The path length is that of the whole estimate, and of the whole reference.
    """
    covered = (estimate.stamps >= reference.stamps[0] - STAMP_TOLERANCE) & (
        estimate.stamps <= reference.stamps[-1] + STAMP_TOLERANCE
    )
    if covered.sum() < 3:
        raise ValueError("fewer than three poses lie within the time of the reference")
    judged = estimate.select(covered)
    truth = interpolate(reference, judged.stamps)
    rotation, translation = align(judged.positions, truth.positions)
    aligned = judged.positions @ rotation.T + translation
    per_pose = np.linalg.norm(aligned - truth.positions, axis=1)
    return Errors(
        ate=float(np.sqrt(np.mean(per_pose**2))),
        end_point=end_point_error(judged, truth),
        path_length=path_length(estimate.positions),
        reference_path_length=path_length(reference.positions),
        stamps=judged.stamps,
        aligned=aligned,
        reference=truth.positions,
        per_pose=per_pose,
        left_out=int((~covered).sum()),
        rotation=rotation,
        translation=translation,
    )
