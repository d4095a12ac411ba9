#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs a system on a sequence, or takes the result of the same run from before."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any, Dict, List

from benchmark_process import processors, run, tail
from benchmark_sequences import Sequence
from benchmark_systems import Programs, System, command, figures, identity

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
    key = key_of(system, sequence, programs, limits)
    before = load(folder)
    if before.get("key") == key and before["others"] <= most_disturbed:
        return before
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
