#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""GTSAM on pose graphs in g2o's format. Run by compare_graphs in a virtual environment with GTSAM.

try solves a graph in all ways and says what each took; solve does it once in one way and measures;
judge takes the poses of several results and evaluates the same costs for each, with GTSAM.
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path
from typing import Any, Dict, Iterable, Iterator, List, NamedTuple, Sequence, Tuple

import gtsam
import numpy as np

METHODS = ("Gauss-Newton", "Levenberg-Marquardt")
ORDERINGS = ("COLAMD", "METIS")
# GTSAM's own tolerances, relative and absolute, and those of optimize_graph.
TOLERANCES = {"loose": (1e-5, 1e-5), "tight": (1e-7, 0.0)}
# How often each way is tried; the faster counts.
TRIES = 2
# Of the prior that holds the first node, in metres and radians. It moves nothing and costs nothing.
FIXED = 1e-6
# GTSAM has rotation before translation.
SWAPPED = [3, 4, 5, 0, 1, 2]
UPPER = np.triu_indices(6)


class Graph(NamedTuple):
    factors: gtsam.NonlinearFactorGraph
    poses: gtsam.Values


class Edge(NamedTuple):
    """As in the file: the information is that of g2o's errors."""

    first: int
    second: int
    pose: gtsam.Pose3
    information: np.ndarray


class Way(NamedTuple):
    method: str
    ordering: str
    tolerance: str


def pose_of(words: Sequence[str]) -> gtsam.Pose3:
    """x y z qx qy qz qw; the quaternion, often rounded in files, is made a unit one."""
    numbers = np.array(words, dtype=float)
    x, y, z, w = numbers[3:] / np.linalg.norm(numbers[3:])
    return gtsam.Pose3(gtsam.Rot3.Quaternion(w, x, y, z), numbers[:3])


def information_of(words: Sequence[str]) -> np.ndarray:
    """Of translation and vector part of the quaternion, as g2o has it."""
    upper = np.zeros((6, 6))
    upper[UPPER] = np.array(words, dtype=float)
    return upper + np.triu(upper, 1).T


def of_logarithm(g2o_information: np.ndarray) -> np.ndarray:
    """The same for small errors [rotation vector, translation]: that vector part is half of it."""
    scale = np.array([1.0, 1.0, 1.0, 0.5, 0.5, 0.5])
    return (scale[:, None] * g2o_information * scale)[np.ix_(SWAPPED, SWAPPED)]


def lines_of(path: Path) -> Iterator[List[str]]:
    with open(str(path)) as file:
        for line in file:
            yield line.split()


def read_poses(path: Path) -> gtsam.Values:
    poses = gtsam.Values()
    for words in lines_of(path):
        if words and words[0] == "VERTEX_SE3:QUAT":
            poses.insert(int(words[1]), pose_of(words[2:9]))
    return poses


def edges_of(path: Path) -> Iterator[Edge]:
    for words in lines_of(path):
        if words and words[0] == "EDGE_SE3:QUAT":
            ends = int(words[1]), int(words[2])
            yield Edge(*ends, pose_of(words[3:10]), information_of(words[10:31]))


def read_graph(path: Path) -> Graph:
    factors = gtsam.NonlinearFactorGraph()
    for edge in edges_of(path):
        noise = gtsam.noiseModel.Gaussian.Information(of_logarithm(edge.information))
        factors.add(gtsam.BetweenFactorPose3(edge.first, edge.second, edge.pose, noise))
    return Graph(factors, read_poses(path))


def with_fixed_start(graph: Graph) -> gtsam.NonlinearFactorGraph:
    factors = gtsam.NonlinearFactorGraph(graph.factors)
    first = min(graph.poses.keys())
    noise = gtsam.noiseModel.Isotropic.Sigma(6, FIXED)
    factors.add(gtsam.PriorFactorPose3(first, graph.poses.atPose3(first), noise))
    return factors


def make_optimizer(way: Way, factors: gtsam.NonlinearFactorGraph, start: gtsam.Values) -> Any:
    if way.method == "Gauss-Newton":
        parameters, optimizer = gtsam.GaussNewtonParams(), gtsam.GaussNewtonOptimizer
    else:
        parameters, optimizer = gtsam.LevenbergMarquardtParams(), gtsam.LevenbergMarquardtOptimizer
    relative, absolute = TOLERANCES[way.tolerance]
    parameters.setRelativeErrorTol(relative)
    parameters.setAbsoluteErrorTol(absolute)
    parameters.setMaxIterations(100)
    parameters.setOrderingType(way.ordering)
    return optimizer(factors, start, parameters)


def solved(
    way: Way, factors: gtsam.NonlinearFactorGraph, start: gtsam.Values
) -> Tuple[gtsam.Values, Dict[str, Any]]:
    """Timed from the graph in memory to the poses, with the ordering of the nodes."""
    begin, cpu_begin = time.perf_counter(), time.process_time()
    optimizer = make_optimizer(way, factors, start)
    poses = optimizer.optimize()
    return poses, {
        "seconds": time.perf_counter() - begin,
        "cpu_seconds": time.process_time() - cpu_begin,
        "iterations": optimizer.iterations(),
        "chi2": 2.0 * optimizer.error(),
    }


def all_ways() -> List[Way]:
    return [Way(m, o, t) for m in METHODS for o in ORDERINGS for t in TOLERANCES]


def try_ways(arguments: argparse.Namespace) -> List[Dict[str, Any]]:
    graph = read_graph(arguments.graph)
    factors = with_fixed_start(graph)
    results = []
    for way in all_ways():
        try:
            runs = [solved(way, factors, graph.poses)[1] for _ in range(TRIES)]
            results.append({"way": way, **min(runs, key=lambda result: result["cpu_seconds"])})
        except RuntimeError as error:  # no step possible
            print(f"{way}: {error}", flush=True)
    return results


def peak_memory_mb() -> float:
    """Of this process alone: ru_maxrss would start at what the parent held when it forked."""
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith("VmHWM"):
            return int(line.split()[1]) * 1024 / 1e6
    raise RuntimeError("no VmHWM in /proc/self/status")


def write_poses(path: Path, poses: gtsam.Values) -> None:
    with open(str(path), "w") as file:
        for key in sorted(poses.keys()):
            pose = poses.atPose3(key)
            quaternion = pose.rotation().toQuaternion().coeffs()  # x y z w
            numbers = " ".join(f"{value:.17g}" for value in (*pose.translation(), *quaternion))
            file.write(f"VERTEX_SE3:QUAT {key} {numbers}\n")


def solve(arguments: argparse.Namespace) -> Dict[str, Any]:
    memory_before = peak_memory_mb()
    graph = read_graph(arguments.graph)
    way = Way(arguments.method, arguments.ordering, arguments.tolerance)
    poses, result = solved(way, with_fixed_start(graph), graph.poses)
    result.update(peak_memory_mb=peak_memory_mb(), memory_before_mb=memory_before)
    write_poses(arguments.poses, poses)
    return result


def g2o_chi2(edges: Iterable[Edge], poses: gtsam.Values) -> float:
    """Errors are translation and vector part of the unit quaternion of Z^-1 T_i^-1 T_j."""
    total = 0.0
    for edge in edges:
        motion = poses.atPose3(edge.first).between(poses.atPose3(edge.second))
        error = edge.pose.between(motion)
        x, y, z, w = error.rotation().toQuaternion().coeffs()
        vector = np.array([x, y, z]) * (-1.0 if w < 0.0 else 1.0)
        residual = np.concatenate([error.translation(), vector])
        total += residual @ edge.information @ residual
    return float(total)


def judge(arguments: argparse.Namespace) -> Dict[str, Any]:
    graph = read_graph(arguments.graph)
    results = []
    for path in arguments.poses:
        poses = read_poses(path)
        chi2 = 2.0 * graph.factors.error(poses)
        results.append({"chi2": chi2, "chi2_g2o": g2o_chi2(edges_of(arguments.graph), poses)})
    return {
        "nodes": graph.poses.size(),
        "edges": graph.factors.size(),
        "judged": results,
    }


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    for name in ("try", "solve", "judge"):
        command = commands.add_parser(name)
        command.add_argument("--graph", type=Path, required=True)
        command.add_argument("--out", type=Path, required=True, help="JSON file for the result")
        if name == "solve":
            command.add_argument("--poses", type=Path, required=True, help="g2o file for the poses")
            command.add_argument("--method", choices=METHODS, required=True)
            command.add_argument("--ordering", choices=ORDERINGS, required=True)
            command.add_argument("--tolerance", choices=list(TOLERANCES), required=True)
        if name == "judge":
            command.add_argument("--poses", type=Path, nargs="+", required=True)
    return parser.parse_args()


def main() -> None:
    arguments = parse_arguments()
    result = {"try": try_ways, "solve": solve, "judge": judge}[arguments.command](arguments)
    arguments.out.write_text(json.dumps(result))


if __name__ == "__main__":
    main()
