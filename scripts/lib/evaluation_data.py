#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What the program `evaluate` leaves in a folder."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional

import numpy as np


class Cell(NamedTuple):
    """A revisited place: the centre of its cell in metres, and the RMS of its maps in metres."""

    index: tuple
    centre: np.ndarray
    rms: float


class Estimate(NamedTuple):
    """positions (n, 3), moved onto the reference where there is one.

    reference (n, 3) and error (n), metres: None without a reference. worst: one entry a cell, the
    largest RMS first, each the maps (n, 3) of its segments in the frame of the cell.
    """

    name: str
    summary: Dict[str, Any]
    positions: np.ndarray
    reference: Optional[np.ndarray]
    error: Optional[np.ndarray]
    cells: List[Cell]
    worst: List[List[np.ndarray]]
    worst_cells: List[Cell]


def read_table(path: Path) -> np.ndarray:
    return np.loadtxt(str(path), delimiter=",", skiprows=1, ndmin=2)


def read_cells(consistency: Dict[str, Any]) -> List[Cell]:
    return [
        Cell(tuple(cell["index"]), np.array(cell["centre_m"]), cell["rms_m"])
        for cell in consistency.get("cells", [])
    ]


def split_maps(table: np.ndarray) -> List[List[np.ndarray]]:
    """Rows of cell, segment, x, y, z."""
    if table.size == 0:
        return []
    cells = []
    for cell in range(int(table[:, 0].max()) + 1):
        rows = table[table[:, 0] == cell]
        segments = range(int(rows[:, 1].max()) + 1) if len(rows) else []
        cells.append([rows[rows[:, 1] == segment, 2:5] for segment in segments])
    return cells


def read_estimate(folder: Path, summary: Dict[str, Any]) -> Estimate:
    name = summary["name"]
    poses = read_table(folder / f"poses_{name}.csv")
    judged = "ate" in summary
    cells = read_cells(summary.get("consistency", {}))
    by_index = {cell.index: cell for cell in cells}
    maps_path = folder / f"worst_cells_{name}.csv"
    worst = summary.get("consistency", {}).get("worst", [])
    return Estimate(
        name=name,
        summary=summary,
        positions=poses[:, 1:4],
        reference=poses[:, 4:7] if judged else None,
        error=poses[:, 7] if judged else None,
        cells=cells,
        worst=split_maps(read_table(maps_path)) if worst else [],
        worst_cells=[by_index[tuple(index)] for index in worst],
    )


def read_evaluation(folder: Path) -> Dict[str, Any]:
    """parameters, and estimates: a list of Estimate."""
    summary = json.loads((folder / "evaluation.json").read_text())
    estimates = [read_estimate(folder, estimate) for estimate in summary["estimates"]]
    return {"parameters": summary["parameters"], "estimates": estimates}
