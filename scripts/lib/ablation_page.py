#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The combinations of parts as one Markdown page."""

from __future__ import annotations

from statistics import median
from typing import Any, Dict, List, NamedTuple

Cell = Dict[str, Any]

METHOD = """\
ATE in metres. Each drive is mapped twice, with our odometry and with that of the preset `paper`
(including its down-sampling, information and splitting of maps). Loops and graph then run on these
maps in all combinations: *information* sampled or the identity, for odometry and loops; *loops* with
the parameters of recognition, association, acceptance and back-end of the default or of the preset;
*retroactive* search on or off; robust *kernel*, with the default scale. **Bold**: default; *italics*:
preset `paper`; °: best of a drive.
"""


class Part(NamedTuple):
    """A switch, its value as it is, and the value that it is compared with."""

    key: str
    ours: str
    other: str


PARTS = (
    Part("odometry", "ours", "paper"),
    Part("information", "sampled", "identity"),
    Part("loops", "ours", "paper"),
    Part("retroactive", "on", "off"),
)
KERNELS = ("none", "huber", "cauchy", "geman_mcclure")
DEFAULT = {**{part.key: part.ours for part in PARTS}, "kernel": "cauchy"}
PAPER = {**DEFAULT, "odometry": "paper", "loops": "paper", "kernel": "none"}
KEYS = tuple(DEFAULT)


def is_like(cell: Cell, values: Dict[str, str]) -> bool:
    return all(cell[key] == value for key, value in values.items())


def find(cells: List[Cell], values: Dict[str, str]) -> Cell:
    return next(cell for cell in cells if is_like(cell, values))


def text(value: Any, digits: int = 3) -> str:
    return "–" if value is None else f"{value:.{digits}f}"


def matrix(results: Dict[str, Any]) -> List[str]:
    """One row for each combination, one column for each drive."""
    names = list(results)
    lines = ["| " + " | ".join([*KEYS, *names]) + " |"]
    lines.append("|---" * len(KEYS) + "|---:" * len(names) + "|")
    best = {name: min(round(c["ate_m"], 3) for c in results[name]["cells"]) for name in names}
    for cell in results[names[0]]["cells"]:
        values = {key: cell[key] for key in KEYS}
        mark = "**" if values == DEFAULT else "*" if values == PAPER else ""
        numbers = []
        for name in names:
            ate = find(results[name]["cells"], values)["ate_m"]
            numbers.append(mark + text(ate) + mark + ("°" if round(ate, 3) == best[name] else ""))
        lines.append("| " + " | ".join([*values.values(), *numbers]) + " |")
    return lines


def what_parts_bring(results: Dict[str, Any]) -> List[str]:
    """The default with one part exchanged; and the median over everything else."""
    lines = ["| part exchanged | " + " | ".join(results) + " | median factor, all others varied |"]
    lines.append("|---" + "|---:" * (len(results) + 1) + "|")
    default = [find(r["cells"], DEFAULT)["ate_m"] for r in results.values()]
    lines.append("| none: the default | " + " | ".join(map(text, default)) + " | |")
    for part in PARTS:
        ates = [
            find(r["cells"], {**DEFAULT, part.key: part.other})["ate_m"] for r in results.values()
        ]
        factors = [
            find(r["cells"], {**{key: c[key] for key in KEYS}, part.key: part.other})["ate_m"]
            / c["ate_m"]
            for r in results.values()
            for c in r["cells"]
            if c[part.key] == part.ours
        ]
        row = f"| {part.key}: {part.other} | " + " | ".join(map(text, ates))
        lines.append(f"{row} | {median(factors):.2f} |")
    for kernel in KERNELS:
        if kernel == DEFAULT["kernel"]:
            continue
        ates = [find(r["cells"], {**DEFAULT, "kernel": kernel})["ate_m"] for r in results.values()]
        lines.append(f"| kernel: {kernel} | " + " | ".join(map(text, ates)) + " | |")
    return lines


def scales(results: Dict[str, Any]) -> List[str]:
    with_scales = {name: r for name, r in results.items() if r["kernel_scales"]}
    if not with_scales:
        return []
    steps = sorted({cell["kernel_scale"] for r in with_scales.values() for cell in r["kernel_scales"]})
    lines = ["## Scale of the kernel", "", SCALES, ""]
    header = ["drive", "odometry", "kernel", *(f"{step:.3g}" for step in steps)]
    lines += ["| " + " | ".join(header) + " |", "|---" * 3 + "|---:" * len(steps) + "|"]
    for name, result in with_scales.items():
        for odometry in ("ours", "paper"):
            for kernel in KERNELS[1:]:
                row = [
                    find(result["kernel_scales"],
                         {"odometry": odometry, "kernel": kernel, "kernel_scale": step})["ate_m"]
                    for step in steps
                ]
                lines.append(f"| {name} | {odometry} | {kernel} | " + " | ".join(map(text, row)) + " |")
    lines += ["", "Residuals √(eᵀΛe) of the active loops with the default kernel, median / 90th percentile / largest:"]
    lines += ["", "| drive | odometry | before the optimisation | after | smallest weight |"]
    lines += ["|---|---|---:|---:|---:|"]
    for name, result in results.items():
        for odometry in ("ours", "paper"):
            loops = find(result["cells"], {**DEFAULT, "odometry": odometry})["constraints"]
            cells = [
                " / ".join(text(value, 1) for value in loops[key])
                for key in ("residual_before", "residual_after")
            ]
            weight = text(loops["smallest_weight"], 2)
            lines.append(f"| {name} | {odometry} | {cells[0]} | {cells[1]} | {weight} |")
    return [*lines, ""]


SCALES = """\
ATE in metres with the kernel's scale in the unit of √(eᵀΛe). Λ is the curvature of the objective, not
an inverse covariance: a residual of 1 is not one standard deviation, and a scale found with one number
of points or voxel size does not hold for another."""


def markdown(results: Dict[str, Any]) -> str:
    lines = ["# What each part brings", "", METHOD, "![ATE of all combinations](ablation.png)", ""]
    lines += ["## One part exchanged", "", *what_parts_bring(results), ""]
    lines += scales(results)
    lines += ["## All combinations", "", *matrix(results), "", "## Drives", ""]
    lines += [f"- {name}: {result['origin']}" for name, result in results.items()]
    return "\n".join(lines) + "\n"
