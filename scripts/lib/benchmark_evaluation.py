#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Accuracy and consistency of the runs on one sequence, by the program `evaluate`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, List, Optional

import numpy as np

from benchmark_process import run_or_stop
from benchmark_sequences import Sequence
from benchmark_systems import digest
from trajectories import STAMP_TOLERANCE, judge, read_tum

Judgement = Dict[str, Any]
# Of a short drive that comes back on the same level: it may be back after some seconds, and passes
# are not of different floors, however far apart an estimate has them.
RETURNING = ("consistency/min_time_between=15", "consistency/max_height_difference=1000")


def beginning(reference: Path, estimates: List[Path], used: Path) -> Path:
    """The reference as far as the estimates go: what no run saw is no revisit."""
    end = max(read_tum(path).stamps[-1] for path in estimates) + STAMP_TOLERANCE
    lines = reference.read_text().splitlines(True)
    kept = [line for line in lines if line.startswith("#") or float(line.split()[0]) <= end]
    used.write_text("".join(kept))
    return used


def evaluation_file(
    sequence: Sequence, estimates: Dict[str, Path], folder: Path, evaluator: Path
) -> Path:
    """Made unless it is there already for the same trajectories and program."""
    path, note = folder / "evaluation.json", folder / "key"
    key = json.dumps([sequence.identity(), sorted(estimates), digest(evaluator)])
    key += digest(*(estimates[name] for name in sorted(estimates)))
    if not (path.is_file() and note.is_file() and note.read_text() == key):
        print(f"{sequence.name}: evaluating", flush=True)
        words: List[Any] = [evaluator, "--quiet", "--bag", sequence.bag, "--out", folder]
        words += ["--topic", sequence.topic] if sequence.topic else []
        words += sequence.settings()
        for setting in RETURNING if sequence.returns else ():
            words += ["--set", setting]
        words += ["--reference", sequence.reference] if sequence.reference else []
        for name, estimate in estimates.items():
            words += ["--estimate", f"{name}={estimate}"]
        note.unlink(missing_ok=True)
        run_or_stop(words, folder.parent / "evaluation.log")
        note.write_text(key)
    return path


def judgement(estimate: Dict[str, Any]) -> Judgement:
    result: Judgement = {}
    if "ate" in estimate:
        result["ate_m"] = estimate["ate"]["rmse_m"]
        result["rpe_percent"] = estimate["rpe"]["translation_percent"]
    if "consistency" in estimate:
        consistency = estimate["consistency"]
        of_pairs, of_cells = consistency["of_pairs"], consistency["of_cells"]
        result["consistency_m"] = of_pairs["mean_rms_m"]
        result["consistency_sd_m"] = of_pairs["standard_deviation_m"]
        result["consistency_pairs"] = of_pairs["count"]
        result["pooled_consistency_m"] = of_cells["mean_rms_m"]
        result["thickness_m"] = consistency["thickness_m"]
        result["consistency_paired_share"] = consistency["paired_share"]
        result["consistency_cells"] = len(consistency["cells"])
    return result


def level(path: Path) -> Optional[float]:
    """Of a drive that returns, m: height of its end above where it passed nearest, half a minute
    or more before."""
    estimate = read_tum(path)
    before = estimate.positions[estimate.stamps < estimate.stamps[-1] - 30.0]
    if len(before) == 0:
        return None
    end = estimate.positions[-1]
    nearest = before[np.argmin(np.linalg.norm(before[:, :2] - end[:2], axis=1))]
    return float(end[2] - nearest[2])


def accuracy_alone(sequence: Sequence, estimates: Dict[str, Path]) -> Dict[str, Judgement]:
    """Where there is no `evaluate`."""
    if sequence.reference is None:
        return {}
    reference = read_tum(sequence.reference)
    return {
        name: {"ate_m": judge(read_tum(path), reference).ate} for name, path in estimates.items()
    }


def evaluated(
    sequence: Sequence, estimates: Dict[str, Path], folder: Path, evaluator: Path
) -> Dict[str, Judgement]:
    """By name of the estimate."""
    if not estimates or not evaluator.is_file():
        return accuracy_alone(sequence, estimates)
    path = evaluation_file(sequence, estimates, folder / "evaluation", evaluator)
    judged = {e["name"]: judgement(e) for e in json.loads(path.read_text())["estimates"]}
    if sequence.returns:
        for name, estimate in estimates.items():
            judged[name]["level_m"] = level(estimate)
    return judged
