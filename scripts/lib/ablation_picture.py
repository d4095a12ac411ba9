#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The combinations of parts as a picture: a map of ATE for each drive."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.colors import LogNorm  # noqa: E402

from ablation_page import DEFAULT, KERNELS, PAPER, find  # noqa: E402

# Rows: odometry and information. Columns: loops, retroactive search and kernel.
ROWS = [(o, i) for o in ("ours", "paper") for i in ("sampled", "identity")]
COLUMNS = [(lo, r, k) for lo in ("ours", "paper") for r in ("on", "off") for k in KERNELS]


def values_of(row: Any, column: Any) -> Dict[str, str]:
    keys = ("odometry", "information", "loops", "retroactive", "kernel")
    return dict(zip(keys, (*row, *column)))


def draw(results: Dict[str, Any], path: Path) -> None:
    figure, all_axes = plt.subplots(
        len(results), 1, figsize=(12, 2.6 * len(results) + 1.2), squeeze=False,
        constrained_layout=True,
    )
    for axes, (name, result) in zip(all_axes[:, 0], results.items()):
        ate = np.array(
            [[find(result["cells"], values_of(r, c))["ate_m"] for c in COLUMNS] for r in ROWS]
        )
        image = axes.imshow(ate, norm=LogNorm(ate.min(), ate.max()), cmap="viridis_r", aspect="auto")
        for y, row in enumerate(ROWS):
            for x, column in enumerate(COLUMNS):
                values = values_of(row, column)
                chosen = values in (DEFAULT, PAPER)
                dark = image.norm(ate[y, x]) > 0.55
                axes.text(x, y, f"{ate[y, x]:.3f}", ha="center", va="center", fontsize=8,
                          fontweight="bold" if chosen else "normal",
                          color="white" if dark else "black")
                if chosen:
                    axes.add_patch(plt.Rectangle((x - 0.5, y - 0.5), 1, 1, fill=False,
                                                 edgecolor="red", linewidth=2))
        axes.set_yticks(range(len(ROWS)), [f"odometry {o}, {i}" for o, i in ROWS], fontsize=8)
        axes.set_xticks(range(len(COLUMNS)), [k.replace("_", "\n") for _, _, k in COLUMNS],
                        fontsize=7)
        for start, (loops, retroactive) in enumerate(
            (lo, r) for lo in ("ours", "paper") for r in ("on", "off")
        ):
            axes.axvline(4 * start - 0.5, color="white", linewidth=3)
            axes.text(4 * start + 1.5, -0.75, f"loops {loops}, retroactive {retroactive}",
                      ha="center", fontsize=8)
        axes.set_title(f"{name}: ATE [m]", loc="left", fontsize=10, pad=24)
    figure.suptitle("Red: the default, and the preset `paper`", fontsize=9)
    figure.savefig(str(path), dpi=110)
    plt.close(figure)
