#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The tables of the paper (Gupta, Trekel, Wiesmann, Stachniss), as it prints them.

ATE in metres and RPE in per cent; None: the system failed. The last two rows of each are its
ablations.
"""

from __future__ import annotations

from typing import Dict, List, NamedTuple, Optional, Tuple

Cell = Optional[Tuple[float, float]]
NO_INFORMATION, NO_FEEDBACK = "— without information", "— without retroactive loops"
SYSTEMS = ("MULLS", "CT-ICP", "PIN-SLAM", "KISS-SLAM", "the paper's system")
ABLATIONS = (NO_INFORMATION, NO_FEEDBACK)


class Table(NamedTuple):
    """columns: the places, by the names that `--dataset` gives to the averages of recordings."""

    title: str
    columns: Tuple[str, ...]
    rows: Dict[str, List[Cell]]


def cells(text: str) -> List[Cell]:
    """From "ATE/RPE ATE/RPE -"."""
    found: List[Cell] = []
    for word in text.split():
        ate, _, rpe = word.partition("/")
        found.append((float(ate), float(rpe)) if rpe else None)
    return found


TABLES = (
    Table(
        "HeLiPR",
        ("Bridge Aeva", "Bridge Avia", "Bridge Ouster")
        + ("Roundabout Aeva", "Roundabout Avia", "Roundabout Ouster")
        + ("Town Aeva", "Town Avia", "Town Ouster"),
        {
            "MULLS": cells(
                "356.06/9.17 321.87/4.06 52.65/0.68 19.08/1.43 16.39/1.06 2.65/0.24 "
                "39.82/2.85 14.93/1.35 4.45/0.27"
            ),
            "CT-ICP": cells(
                "- 41.47/0.36 - 10.04/0.72 3.36/0.25 1.81/0.16 65.29/1.37 63.72/2.02 -"
            ),
            "PIN-SLAM": cells(
                "- 365.72/2.15 19.23/0.13 - 7.02/0.51 1.47/0.11 41.19/1.03 11.40/0.64 2.55/0.12"
            ),
            "KISS-SLAM": cells(
                "98.61/1.57 148.88/1.82 19.47/0.28 6.06/0.47 3.84/0.23 1.18/0.17 "
                "14.44/0.85 12.01/0.46 1.99/0.21"
            ),
            "the paper's system": cells(
                "16.83/0.47 20.17/0.25 14.18/0.22 4.67/0.46 3.34/0.23 1.21/0.18 "
                "10.50/0.47 7.57/0.38 1.89/0.20"
            ),
            NO_INFORMATION: cells(
                "107.34/1.46 27.03/0.39 18.18/0.29 6.01/0.44 3.93/0.25 1.31/0.20 "
                "11.78/0.83 8.70/0.59 1.94/0.22"
            ),
            NO_FEEDBACK: cells(
                "16.37/0.47 21.33/0.25 13.80/0.21 4.43/0.39 3.89/0.22 1.14/0.18 "
                "13.47/0.48 8.31/0.38 1.75/0.20"
            ),
        },
    ),
    Table(
        "Apollo, MulRan",
        ("BTS", "CP", "H237", "MAVE", "SB", "KAIST", "Riverside", "Sejong"),
        {
            "MULLS": cells(
                "104.14/0.27 47.03/0.90 354.21/0.39 182.59/0.16 - 34.21/0.60 66.60/2.27 "
                "1082.55/2.53"
            ),
            "CT-ICP": cells(
                "10.81/0.27 0.97/0.30 258.87/0.62 61.39/0.33 667.28/1.60 2.76/0.50 8.37/0.58 -"
            ),
            "PIN-SLAM": cells(
                "6.10/0.24 0.64/0.16 97.11/1.66 7.06/0.20 2.23/0.25 2.42/0.32 7.55/0.46 "
                "782.96/7.68"
            ),
            "KISS-SLAM": cells(
                "3.74/0.23 0.80/0.22 30.16/0.40 9.08/0.26 2.51/0.25 2.96/0.33 8.34/0.41 "
                "178.35/0.25"
            ),
            "the paper's system": cells(
                "4.22/0.22 0.81/0.19 26.50/0.29 6.17/0.19 1.61/0.17 2.67/0.32 7.22/0.35 "
                "169.14/0.28"
            ),
            NO_INFORMATION: cells(
                "9.45/0.23 1.02/0.22 88.25/0.32 19.38/0.19 22.13/0.45 2.79/0.31 10.04/0.63 "
                "173.44/0.28"
            ),
            NO_FEEDBACK: cells(
                "3.83/0.22 - 27.31/0.30 5.33/0.20 1.94/0.19 2.64/0.32 7.25/0.35 169.16/0.28"
            ),
        },
    ),
    Table(
        "Newer College",
        ("01 short", "02 long"),
        {
            "MULLS": cells("0.47/0.17 8.47/4633.62"),
            "CT-ICP": cells("0.63/0.42 25.06/3.01"),
            "PIN-SLAM": cells("0.42/0.33 0.31/0.22"),
            "KISS-SLAM": cells("0.30/0.26 1.58/2.14"),
            "the paper's system": cells("0.34/0.38 0.42/0.46"),
            NO_INFORMATION: cells("0.36/0.43 0.42/0.48"),
            NO_FEEDBACK: cells("0.34/0.38 0.42/0.46"),
        },
    ),
)


def text_of(cell: Cell) -> str:
    return "–" if cell is None else f"{cell[0]:.2f} / {cell[1]:.2f}"


def markdown(table: Table, shown: Tuple[str, ...] = ()) -> List[str]:
    """The table with the columns `shown`, by default all of them."""
    columns = [column for column in table.columns if not shown or column in shown]
    lines = ["| " + " | ".join([table.title, *columns]) + " |", "|---" * (len(columns) + 1) + "|"]
    for name, row in table.rows.items():
        title = f"**{name}**" if name == SYSTEMS[-1] else name
        values = dict(zip(table.columns, row))
        lines.append("| " + " | ".join([title, *(text_of(values[c]) for c in columns)]) + " |")
    return lines
