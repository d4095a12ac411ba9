#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The pictures of an evaluation, one function each."""

from __future__ import annotations

from typing import List, Tuple

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PatchCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from evaluation_data import Estimate
from report_pictures import BLUE, FAINT, INK, MUTED, RUST, SLATE, draw_scale_bar
from report_pictures import extent_of, plan_figure

ERRORS = LinearSegmentedColormap.from_list(
    "errors", ["#1f6f9c", "#2a9d8f", "#d9b13b", "#d9743b", "#a01f2e"]
)
SEGMENTS = (BLUE, RUST, "#d9a400", "#8d6a9f", "#2a9d8f", SLATE)
# Metres: the thickness of a slice, and how far it reaches from the middle of the cell.
SLICE, REACH = 0.4, 14.0
# Metres above the ground, below doors' tops and above cars.
WALL_HEIGHT = 2.2


def scale_bar_of(figure: Figure, axes: Axes, norm: Normalize, label: str) -> None:
    scale = plt.cm.ScalarMappable(norm, ERRORS)
    bar = figure.colorbar(scale, ax=axes, shrink=0.6, aspect=28, pad=0.015)
    bar.outline.set_visible(False)
    bar.ax.tick_params(length=0, labelsize=9.5)
    bar.set_label(label, fontsize=10)


def error_picture(estimate: Estimate, largest: float) -> Figure:
    """The aligned trajectory coloured by its error, over the reference."""
    tracks = [estimate.positions, estimate.reference]
    figure, axes = plan_figure(extent_of(tracks, 0.05))
    axes.grid(False)
    reference = estimate.reference
    axes.plot(reference[:, 0], reference[:, 1], color=FAINT, linewidth=6, zorder=1)
    ends = np.stack([estimate.positions[:-1, :2], estimate.positions[1:, :2]], axis=1)
    norm = Normalize(0.0, max(largest, 1e-3), clip=True)
    lines = LineCollection(ends, cmap=ERRORS, norm=norm, linewidths=2.2, zorder=2)
    lines.set_array(0.5 * (estimate.error[:-1] + estimate.error[1:]))
    axes.add_collection(lines)
    rmse = estimate.summary["ate"]["rmse_m"]
    axes.set_title(f"{estimate.name}: ATE {rmse:.3f} m", loc="left", fontsize=12)
    draw_scale_bar(axes)
    scale_bar_of(figure, axes, norm, "error of position after alignment (m)")
    return figure


def cells_picture(estimate: Estimate, cell_size: float, limits: Tuple[float, float]) -> Figure:
    """Cells that were visited again, coloured by how far apart their maps are."""
    track = estimate.positions if estimate.reference is None else estimate.reference
    centres = np.array([[*cell.centre, 0.0] for cell in estimate.cells])
    figure, axes = plan_figure(extent_of([track, centres], 0.06))
    axes.grid(False)
    norm = Normalize(*limits, clip=True)
    half = 0.5 * cell_size
    squares = [Rectangle(cell.centre - half, cell_size, cell_size) for cell in estimate.cells]
    patches = PatchCollection(squares, cmap=ERRORS, norm=norm, alpha=0.85, edgecolors="white")
    patches.set_array(np.array([cell.rms for cell in estimate.cells]))
    axes.add_collection(patches)
    axes.plot(track[:, 0], track[:, 1], color=INK, linewidth=1.0)
    for rank, cell in enumerate(estimate.worst_cells):
        axes.annotate(str(rank + 1), cell.centre, ha="center", va="center", fontsize=11,
                      fontweight="bold", color="white")
    c = estimate.summary["consistency"]
    axes.set_title(
        f"{estimate.name}: {len(estimate.cells)} places visited again, RMS of "
        f"{c['of_pairs']['count']} pairs of maps {c['of_pairs']['mean_rms_m']:.3f} ± "
        f"{c['of_pairs']['standard_deviation_m']:.3f} m, "
        f"{100 * c['paired_share']:.1f} % of points paired",
        loc="left",
        fontsize=11,
    )
    draw_scale_bar(axes)
    scale_bar_of(figure, axes, norm, "RMS distance between the maps of a place (m)")
    return figure


def ground_height(maps: List[np.ndarray]) -> float:
    """Of the points near the middle: low, but not the lowest stray."""
    everything = np.vstack(maps)
    near = everything[np.hypot(everything[:, 0], everything[:, 1]) < 12.0]
    return float(np.percentile(near[:, 2] if len(near) else everything[:, 2], 10))


def draw_slice(axes: Axes, maps: List[np.ndarray], across: int, middle: float,
               shown: Tuple[int, int]) -> None:
    for segment, points in enumerate(maps):
        inside = np.abs(points[:, across] - middle) < 0.5 * SLICE
        axes.plot(points[inside, shown[0]], points[inside, shown[1]], ".", markersize=3.4,
                  color=SEGMENTS[segment % len(SEGMENTS)], alpha=0.75, markeredgewidth=0,
                  label=f"pass {segment + 1}", zorder=3 + segment)
    axes.set_aspect("equal")
    axes.tick_params(labelsize=8.5)


def draw_upright(axes: Axes, maps: List[np.ndarray], across: int, ground: float) -> None:
    draw_slice(axes, maps, across, 0.0, (1 - across, 2))
    axes.set_xlim(-REACH, REACH)
    axes.set_ylim(ground - 1.5, ground + 7.5)
    axes.set_title("upright, " + ("along x" if across else "along y"), loc="left", fontsize=10.5)


def section_picture(estimate: Estimate) -> Figure:
    """For each of the worst cells a level slice through the walls and two upright ones."""
    count = len(estimate.worst)
    figure = plt.figure(figsize=(13, 6.2 * count), constrained_layout=True)
    grid = figure.add_gridspec(2 * count, 2, width_ratios=[1.0, 1.1])
    for rank, (maps, cell) in enumerate(zip(estimate.worst, estimate.worst_cells)):
        ground = ground_height(maps)
        level = figure.add_subplot(grid[2 * rank : 2 * rank + 2, 0])
        draw_slice(level, maps, 2, ground + WALL_HEIGHT, (0, 1))
        level.set_xlim(-REACH, REACH)
        level.set_ylim(-REACH, REACH)
        level.set_title(
            f"{rank + 1}: cell {cell.index[0]}, {cell.index[1]}, RMS {cell.rms:.3f} m; from above",
            loc="left",
            fontsize=10.5,
        )
        level.set_xlabel(
            f"metres; slices are {SLICE:g} m thick, this one {WALL_HEIGHT:g} m above the ground",
            color=MUTED,
            fontsize=9,
        )
        for across in (0, 1):
            draw_upright(figure.add_subplot(grid[2 * rank + across, 1]), maps, across, ground)
        level.legend(loc="upper right", markerscale=4, fontsize=9)
    figure.suptitle(
        f"{estimate.name}: where the maps of different passes agree least",
        x=0.01,
        ha="left",
        fontsize=12,
    )
    return figure
