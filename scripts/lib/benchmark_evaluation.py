#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Accuracy and consistency of the runs on one sequence."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict

from benchmark_sequences import Sequence
from trajectories import judge, read_tum

Judgement = Dict[str, Any]


def evaluated(
    sequence: Sequence, estimates: Dict[str, Path], folder: Path, evaluator: Path
) -> Dict[str, Judgement]:
    """By name of the estimate; empty where there is no ground truth."""
    if sequence.reference is None:
        return {}
    reference = read_tum(sequence.reference)
    judgements = {}
    for name, path in estimates.items():
        errors = judge(read_tum(path), reference)
        judgements[name] = {
            "ate_m": errors.ate,
            "end_point_error_m": errors.end_point,
            "poses_beyond_reference": errors.left_out,
        }
    return judgements
