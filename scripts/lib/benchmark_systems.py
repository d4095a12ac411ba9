#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What is compared: this package with and without its parts, and its peers."""

from __future__ import annotations

import csv
import hashlib
import json
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from benchmark_environment import ENVIRONMENTS, Environments
from benchmark_sequences import Sequence

DRIVER = Path(__file__).resolve().parent / "peer_run.py"
DRIVER_FILES = ("peer_run.py", "peer_systems.py", "peer_bag.py", "kiss_icp_peer.py")


class System(NamedTuple):
    """arguments: of the offline runner; None for a peer, whose defaults are used. environment: of a
    peer; empty: its trajectories are given, made elsewhere."""

    name: str
    title: str
    arguments: Optional[Tuple[str, ...]] = None
    environment: str = ""

    def is_ours(self) -> bool:
        return self.arguments is not None

    def is_given(self) -> bool:
        return self.arguments is None and not self.environment


def without(setting: str) -> Tuple[str, ...]:
    return ("--set", f"{setting}=false")


SYSTEMS = (
    System("revisit_slam", "**revisit_slam**", ()),
    System("no-information", "— identity information", without("information/enabled")),
    System("no-feedback", "— no retroactive loops", without("retroactive/enabled")),
    System("odometry", "— odometry alone", without("loops/enabled")),
    System("paper", "— the paper's method (`--preset paper`)", ("--preset", "paper")),
    System("retro-slam", "Retro-SLAM (the paper authors' own)", None, "bonn"),
    System("kiss-slam", "KISS-SLAM", None, "bonn"),
    System("kiss-icp", "KISS-ICP (odometry)", None, "bonn"),
    System("genz-icp", "GenZ-ICP (odometry)", None, "genz"),
    System("ct-icp", "CT-ICP (odometry)", None, "evalio"),
    System("mad-icp", "MAD-ICP (odometry)", None, "evalio"),
    System("form", "FORM (odometry)", None, "evalio"),
    System("loam", "LOAM (odometry)", None, "evalio"),
)


def system_named(name: str) -> System:
    return next(system for system in SYSTEMS if system.name == name)


class Programs(NamedTuple):
    """offline: the runner of this package. environments: of the peers. given: by the name of a
    system, a folder with a trajectory SEQUENCE.tum or .txt (KITTI) of each sequence."""

    offline: Path
    environments: Environments
    given: Dict[str, Path] = {}


def command(
    system: System, sequence: Sequence, programs: Programs, out: Path, max_scans: int
) -> List[Any]:
    if system.arguments is None:
        python = programs.environments.python(system.environment)
        words = [python, DRIVER, system.name, "--bag", sequence.bag, "--out", out]
        words += ["--base", sequence.base]
        words += ["--azimuth"] if sequence.azimuth else []
    else:
        words = [programs.offline, "--quiet", "--bag", sequence.bag, "--out", out]
        words += [*system.arguments, *sequence.settings()]
    if sequence.topic:
        words += ["--topic", sequence.topic]
    return words + (["--max-scans", max_scans] if max_scans else [])


def digest(*files: Path) -> str:
    total = hashlib.sha256()
    for file in files:
        total.update(file.read_bytes())
    return total.hexdigest()[:16]


def identity(system: System, programs: Programs) -> List[Any]:
    """Version and parameters of a system: what its result depends on beside the sequence."""
    if system.is_given():
        return [system.name]
    if system.arguments is None:
        files = [DRIVER.with_name(name) for name in DRIVER_FILES]
        return [system.name, *ENVIRONMENTS[system.environment], digest(*files)]
    return [system.name, *system.arguments, digest(programs.offline)]


def statistics(wall_ms: List[float]) -> Dict[str, float]:
    return {
        "median_ms": float(np.median(wall_ms)),
        "p99_ms": float(np.percentile(wall_ms, 99)),
        "max_ms": float(np.max(wall_ms)),
    }


def our_figures(out: Path) -> Dict[str, Any]:
    run = json.loads((out / "run.json").read_text())
    with open(str(out / "scan_times.csv"), newline="") as file:
        wall_ms = [float(row["total_ms"]) for row in csv.DictReader(file)]
    loops = run["loops"]
    active = {name: count for name, count in loops.items() if name.endswith(" active")}
    return {
        "versions": {"revisit_slam": run["version"]},
        "parameters": run["parameters"],
        "scans": run["scans"]["processed"],
        **statistics(wall_ms),
        "finish_seconds": run["finish_seconds"],
        "cpu_ms_per_scan": 1e3 * run["cpu_seconds_per_scan"],
        "peak_memory_mb": run["peak_memory_mb"],
        "loops": sum(active.values()),
        "loops_by_kind": loops,
    }


def peer_figures(out: Path) -> Dict[str, Any]:
    run = json.loads((out / "peer.json").read_text())
    kept = ("versions", "python", "parameters", "scans", "finish_seconds", "peak_memory_mb")
    return {
        **{key: run[key] for key in (*kept, "memory_before_first_scan_mb", "loops")},
        **statistics(run["wall_ms"]),
        "cpu_ms_per_scan": 1e3 * run["cpu_seconds"] / run["scans"],
    }


def figures(system: System, out: Path) -> Dict[str, Any]:
    """What a run that ended well says of itself."""
    return our_figures(out) if system.is_ours() else peer_figures(out)


def trajectory(out: Path) -> Path:
    """Of a run: after the graph, where there is one."""
    corrected = out / "trajectory.tum"
    return corrected if corrected.is_file() else out / "odometry.tum"
