#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs a system on a sequence, or takes the result of the same run from before."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any, Dict, List

import numpy as np

from benchmark_process import processors, run, tail
from benchmark_sequences import Sequence
from benchmark_systems import Programs, System, command, figures, identity
from trajectories import Trajectory, quaternion_of, read_tum, write_tum

Result = Dict[str, Any]


def load(folder: Path) -> Result:
    """Empty if there is none: result.json is the last file that a run leaves."""
    path = folder / "result.json"
    return json.loads(path.read_text()) if path.is_file() else {}


def key_of(
    system: System, sequence: Sequence, programs: Programs, limits: Dict[str, Any]
) -> List[Any]:
    return json.loads(
        json.dumps(
            [sequence.identity(), identity(system, programs), sorted(limits.items())]
            + [len(processors())]
        )
    )


def write_as_tum(source: Path, sequence: Sequence, target: Path) -> None:
    table = np.loadtxt(str(source), ndmin=2)
    if table.shape[1] != 12:
        shutil.copyfile(str(source), str(target))
        return
    stamps = read_tum(sequence.reference).stamps if sequence.reference else np.empty(0)
    if len(stamps) != len(table):
        raise SystemExit(f"error: {source}: {len(table)} poses, but {len(stamps)} in the reference")
    poses = table.reshape(-1, 3, 4)
    quaternions = np.array([quaternion_of(pose[:, :3]) for pose in poses])
    write_tum(target, Trajectory(stamps, poses[:, :, 3], quaternions))


def given(system: System, sequence: Sequence, source: Path, folder: Path) -> Result:
    """Takes a trajectory that was made elsewhere: TUM, or KITTI with the poses of the reference."""
    files = [source / f"{sequence.name}{ending}" for ending in (".tum", ".txt")]
    found = next((file for file in files if file.is_file()), None)
    if found is None:
        return {}
    folder.mkdir(parents=True, exist_ok=True)
    write_as_tum(found, sequence, folder / "trajectory.tum")
    result: Result = {"system": system.name, "status": "ok"}
    (folder / "result.json").write_text(json.dumps(result, indent=1))
    return result


def measured(
    system: System,
    sequence: Sequence,
    programs: Programs,
    folder: Path,
    limits: Dict[str, Any],
    most_disturbed: float = 1.0,
) -> Result:
    """limits: max_scans (0: all) and timeout in seconds. A run from before in which other programs
    took more than `most_disturbed` of the processors is repeated."""
    if system.is_given():
        return given(system, sequence, programs.given[system.name], folder)
    key = key_of(system, sequence, programs, limits)
    before = load(folder)
    if before.get("key") == key and before["others"] <= most_disturbed:
        return before
    if system.environment and programs.environments.python(system.environment) is None:
        return before  # what there is from another time
    print(f"{sequence.name}: {system.name}", flush=True)
    shutil.rmtree(str(folder), ignore_errors=True)
    folder.mkdir(parents=True)
    words = command(system, sequence, programs, folder, limits["max_scans"])
    outcome = run(words, folder / "log.txt", limits["timeout"])
    result: Result = {"key": key, "system": system.name, **outcome._asdict()}
    if outcome.status == "ok":
        result.update(figures(system, folder))
    else:
        result["log"] = tail(folder / "log.txt")
    (folder / "result.json").write_text(json.dumps(result, indent=1))
    return result
