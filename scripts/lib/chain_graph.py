#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes the pose graph of a long simulated drive with few loops. Run by compare_graphs.

The drive goes around blocks of streets at random, about a metre from node to node. Loops join nodes
that lie near each other and are far apart in time. All edges have informations of their own,
anisotropic and correlated, and errors drawn from these; the poses are those of the odometry.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Dict, List, NamedTuple, TextIO, Tuple

import numpy as np

BLOCK, BLOCKS = 100, 6
# A loop joins nodes in the same square of this edge, at least so many nodes apart.
SQUARE, APART = 5.0, 500
# Standard deviations of translation and rotation vector, in metres and radians, of an edge.
ODOMETRY = np.array([0.02, 0.01, 0.01, 2e-4, 2e-4, 5e-4])
LOOP = np.array([0.06, 0.06, 0.04, 2e-3, 2e-3, 1e-3])
# Variances along random directions of these, relative to them.
SPREAD = (0.2, 2.0)


class Poses(NamedTuple):
    """Positions (n, 3) and unit quaternions x y z w (n, 4)."""

    positions: np.ndarray
    rotations: np.ndarray


class Edges(NamedTuple):
    """From nodes to nodes: measured motion, and information of [translation; rotation vector]."""

    first: np.ndarray
    second: np.ndarray
    motion: Poses
    informations: np.ndarray


def multiply(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    u, v, s, t = a[..., :3], b[..., :3], a[..., 3:], b[..., 3:]
    scalar = s * t - np.sum(u * v, axis=-1, keepdims=True)
    return np.concatenate([s * v + t * u + np.cross(u, v), scalar], axis=-1)


def conjugate(q: np.ndarray) -> np.ndarray:
    return q * np.array([-1.0, -1.0, -1.0, 1.0])


def rotate(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    twice = 2.0 * np.cross(q[..., :3], v)
    return v + q[..., 3:] * twice + np.cross(q[..., :3], twice)


def turn(vector: np.ndarray) -> np.ndarray:
    """The quaternion of a rotation vector."""
    angle = np.linalg.norm(vector, axis=-1, keepdims=True)
    return np.concatenate([0.5 * np.sinc(angle / (2 * np.pi)) * vector, np.cos(angle / 2)], axis=-1)


def about(axis: int, angles: np.ndarray) -> np.ndarray:
    return turn(angles[:, None] * np.eye(3)[axis])


def compose(a: Poses, b: Poses) -> Poses:
    rotated = rotate(a.rotations, b.positions)
    return Poses(a.positions + rotated, multiply(a.rotations, b.rotations))


def between(a: Poses, b: Poses) -> Poses:
    back = conjugate(a.rotations)
    return Poses(rotate(back, b.positions - a.positions), multiply(back, b.rotations))


def at(poses: Poses, which: np.ndarray) -> Poses:
    return Poses(poses.positions[which], poses.rotations[which])


def smooth(values: np.ndarray, width: int) -> np.ndarray:
    """Moving average; as many values less `width` - 1."""
    sums = np.cumsum(np.concatenate([np.zeros((1, values.shape[1])), values]), axis=0)
    return (sums[width:] - sums[:-width]) / width


def streets(nodes: int, random: np.random.Generator) -> np.ndarray:
    """Places a metre apart along streets; turns at crossings, never back."""
    crossing, heading = np.array([BLOCKS // 2, BLOCKS // 2]), np.array([1, 0])
    way: List[np.ndarray] = []
    for _ in range(nodes // BLOCK + 1):
        left = np.array([-heading[1], heading[0]])
        open_ways = [h for h in (heading, heading, left, -left) if inside(crossing + h)]
        heading = open_ways[random.integers(len(open_ways))]
        metres = np.arange(BLOCK)[:, None]
        way.append(BLOCK * crossing + metres * heading)
        crossing = crossing + heading
    return np.concatenate(way)[:nodes].astype(float)


def inside(crossing: np.ndarray) -> bool:
    return bool(np.all((crossing >= 0) & (crossing <= BLOCKS)))


def drive(nodes: int, random: np.random.Generator) -> Poses:
    """Rounded corners, other lines at each pass, hills that are the same at each pass."""
    corner, drift = 11, 201
    plane = smooth(streets(nodes + corner, random), corner)
    aside = np.sqrt(drift) * smooth(random.normal(size=(nodes + drift, 2)), drift)
    plane = plane + aside[: len(plane)]
    height = 5.0 * np.sin(plane[:, :1] / 150.0) + 3.0 * np.cos(plane[:, 1:] / 190.0)
    positions = np.concatenate([plane, height], axis=1)
    steps = np.diff(positions, axis=0)
    yaw = np.arctan2(steps[:, 1], steps[:, 0])
    pitch = -np.arctan2(steps[:, 2], np.linalg.norm(steps[:, :2], axis=1))
    return Poses(positions[:nodes], multiply(about(2, yaw), about(1, pitch))[:nodes])


def loop_ends(poses: Poses, loops: int, random: np.random.Generator) -> Tuple[np.ndarray, ...]:
    squares: Dict[Tuple[int, ...], List[int]] = {}
    for node, place in enumerate(np.floor(poses.positions[:, :2] / SQUARE).astype(int)):
        squares.setdefault(tuple(place), []).append(node)
    groups = list(squares.values())
    pairs = set()
    for _ in range(1000 * loops):
        nodes = groups[random.integers(len(groups))]
        first, second = sorted(random.choice(nodes, 2))
        if second - first >= APART:
            pairs.add((first, second))
        if len(pairs) == loops:
            return tuple(np.array(sorted(pairs)).T)
    raise SystemExit(f"error: fewer than {loops} loops in a drive of {len(poses.positions)} nodes")


def measured(
    poses: Poses,
    ends: Tuple[np.ndarray, ...],
    deviations: np.ndarray,
    random: np.random.Generator,
) -> Edges:
    """The true motion times Exp(n), the error n from the inverse of the information."""
    first, second = ends
    count = len(first)
    directions = np.linalg.qr(random.normal(size=(count, 6, 6)))[0]
    low, high = (float(np.log(variance)) for variance in SPREAD)
    variances = np.exp(random.uniform(low, high, size=(count, 6)))
    root = deviations[:, None] * directions * np.sqrt(variances)[:, None, :]
    inverse_root = directions / deviations[:, None] / np.sqrt(variances)[:, None, :]
    errors = np.einsum("nij,nj->ni", root, random.normal(size=(count, 6)))
    noise = Poses(errors[:, :3], turn(errors[:, 3:]))
    motion = compose(between(at(poses, first), at(poses, second)), noise)
    return Edges(first, second, motion, inverse_root @ inverse_root.transpose(0, 2, 1))


def dead_reckoning(start: Poses, odometry: Edges) -> Poses:
    poses = [at(start, np.array(0))]
    for number in range(len(odometry.first)):
        position, rotation = compose(poses[-1], at(odometry.motion, np.array(number)))
        poses.append(Poses(position, rotation / np.linalg.norm(rotation)))
    return Poses(*(np.array(column) for column in zip(*poses)))


def text_of(poses: Poses, number: int) -> str:
    numbers = (*poses.positions[number], *poses.rotations[number])
    return " ".join(f"{value:.17g}" for value in numbers)


def write_edges(file: TextIO, edges: Edges) -> None:
    """g2o's errors have half the rotation vector, so that its information counts four times."""
    scale = np.array([1.0, 1.0, 1.0, 2.0, 2.0, 2.0])
    upper = np.triu_indices(6)
    for number, information in enumerate(edges.informations):
        ends = f"{edges.first[number]} {edges.second[number]}"
        weights = " ".join(f"{v:.12g}" for v in (scale[:, None] * information * scale)[upper])
        file.write(f"EDGE_SE3:QUAT {ends} {text_of(edges.motion, number)} {weights}\n")


def write_chain(path: Path, nodes: int, loops: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    truth = drive(nodes, random)
    steps = np.arange(nodes - 1), np.arange(1, nodes)
    odometry = measured(truth, steps, ODOMETRY, random)
    closures = measured(truth, loop_ends(truth, loops, random), LOOP, random)
    start = dead_reckoning(truth, odometry)
    with open(str(path), "w") as file:
        for number in range(nodes):
            file.write(f"VERTEX_SE3:QUAT {number} {text_of(start, number)}\n")
        write_edges(file, odometry)
        write_edges(file, closures)


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, required=True, help="g2o file")
    parser.add_argument("--nodes", type=int, required=True)
    parser.add_argument("--loops", type=int, required=True)
    parser.add_argument("--seed", type=int, required=True)
    return parser.parse_args()


def main() -> None:
    arguments = parse_arguments()
    write_chain(arguments.out, arguments.nodes, arguments.loops, arguments.seed)


if __name__ == "__main__":
    main()
