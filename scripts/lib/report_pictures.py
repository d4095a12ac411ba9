#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The pictures of the report, one function each."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Dict, List, NamedTuple, Optional, Tuple

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.axes import Axes  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap, Normalize  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402
from matplotlib.transforms import blended_transform_factory  # noqa: E402

INK, MUTED, FAINT, PAPER = "#1f2a33", "#66727d", "#d9dfe4", "#ffffff"
BLUE, RUST, SLATE = "#1f6f9c", "#c8553d", "#8a97a3"
COLOURS = {"trajectory": BLUE, "odometry": RUST, "reference": SLATE}
STAGES = (
    "#2f4858",
    "#33658a",
    "#5b9aa0",
    "#9bc1a3",
    "#e3c770",
    "#e09f5a",
    "#c8553d",
    "#8d6a9f",
    "#5c677d",
    "#b8a1a1",
)
HEIGHTS = LinearSegmentedColormap.from_list(
    "heights", ["#23395b", "#1f6f9c", "#2a9d8f", "#7d9f35", "#d98e04", "#b5341c"]
)

plt.rcParams.update(
    {
        "figure.facecolor": PAPER,
        "savefig.facecolor": PAPER,
        "font.family": "DejaVu Sans",
        "font.size": 10.5,
        "text.color": INK,
        "axes.labelcolor": INK,
        "axes.edgecolor": FAINT,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "axes.axisbelow": True,
        "grid.color": "#eceff2",
        "grid.linewidth": 0.8,
        "xtick.color": MUTED,
        "ytick.color": MUTED,
        "legend.frameon": False,
        "lines.linewidth": 1.7,
        "lines.solid_capstyle": "round",
        "agg.path.chunksize": 20000,
    }
)


class Track(NamedTuple):
    """A line to draw: positions (n, 3), in metres, in the frame of the picture."""

    name: str
    positions: np.ndarray
    distance: np.ndarray


class Loop(NamedTuple):
    """A loop constraint to draw: the positions of both ends, (2, 3)."""

    ends: np.ndarray
    origin: str
    active: bool


class Error(NamedTuple):
    """Distance from the reference over the distance driven."""

    name: str
    distance: np.ndarray
    error: np.ndarray
    ate: float


def colour_of(name: str) -> str:
    return COLOURS.get(name, BLUE)


def line_style(name: str) -> Dict[str, object]:
    if name == "reference":
        return {"color": SLATE, "linewidth": 4.0, "alpha": 0.5, "zorder": 2}
    width, order = (1.9, 4) if name == "trajectory" else (1.5, 3)
    return {"color": colour_of(name), "linewidth": width, "zorder": order}


def round_length(length: float) -> float:
    """The largest of 1, 2, 5 times a power of ten that is not above `length`."""
    power = 10.0 ** np.floor(np.log10(max(length, 1e-6)))
    return float(max(step * power for step in (1, 2, 5) if step * power <= length * 1.0001))


def text_of(length: float) -> str:
    return f"{length / 1000:g} km" if length >= 1000 else f"{length:g} m"


def draw_scale_bar(axes: Axes) -> None:
    """In a strip below the drawing, so that it covers nothing."""
    left, right = axes.get_xlim()
    length = round_length((right - left) / 5)
    place = blended_transform_factory(axes.transData, axes.transAxes)
    style = {"color": INK, "linewidth": 2.2, "solid_capstyle": "butt", "clip_on": False}
    axes.plot([left, left + length], [-0.025, -0.025], transform=place, **style)
    offset = (right - left) * 0.012
    axes.text(
        left + length + offset,
        -0.025,
        text_of(length),
        transform=place,
        va="center",
        fontsize=10,
        color=INK,
    )


def plan_figure(extent: Tuple[np.ndarray, np.ndarray], width: float = 10.0) -> Tuple[Figure, Axes]:
    """Equal axes without ticks, as high as what is shown needs within reason."""
    low, high = extent
    size = np.maximum(high - low, 1.0)
    height = float(np.clip(width * size[1] / size[0], 3.2, 9.5))
    figure, axes = plt.subplots(figsize=(width, height + 0.5), constrained_layout=True)
    axes.set_aspect("equal")
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    axes.set_xticks([])
    axes.set_yticks([])
    for spine in axes.spines.values():
        spine.set_visible(False)
    return figure, axes


def extent_of(positions: List[np.ndarray], margin: float) -> Tuple[np.ndarray, np.ndarray]:
    everything = np.vstack([p[:, :2] for p in positions])
    low, high = everything.min(axis=0), everything.max(axis=0)
    pad = max(margin * float((high - low).max()), 1.0)
    return low - pad, high + pad


def mark_ends(axes: Axes, positions: np.ndarray, background: str = PAPER) -> None:
    """Circle at the start, square at the end, smaller so that a closed loop shows both."""
    edge = {"markeredgecolor": INK, "markeredgewidth": 1.6, "linestyle": "none", "zorder": 6}
    axes.plot(
        *positions[0, :2], "o", markersize=10, markerfacecolor=background, label="start", **edge
    )
    axes.plot(*positions[-1, :2], "s", markersize=5, markerfacecolor=INK, label="end", **edge)


def legend_above(axes: Axes, markerscale: float = 1.0) -> None:
    handles, labels = axes.get_legend_handles_labels()
    axes.legend(
        handles,
        labels,
        loc="lower left",
        bbox_to_anchor=(0.0, 1.0),
        ncol=len(labels),
        borderaxespad=0.0,
        handlelength=1.6,
        columnspacing=1.6,
        markerscale=markerscale,
    )


def draw_loops(axes: Axes, loops: List[Loop]) -> None:
    colours = {"appearance": "#2a9d8f", "retroactive": "#d98e04"}
    named = set()
    for loop in loops:
        name = f"{loop.origin} loop" if loop.active else "loop left out"
        axes.plot(
            loop.ends[:, 0],
            loop.ends[:, 1],
            color=colours.get(loop.origin, INK) if loop.active else FAINT,
            marker="o",
            markersize=3.5,
            linewidth=1.4,
            zorder=6,
            label="_" + name if name in named else name,
        )
        named.add(name)


def trajectory_picture(tracks: List[Track], loops: List[Loop]) -> Figure:
    figure, axes = plan_figure(extent_of([track.positions for track in tracks], 0.04))
    for track in tracks:
        axes.plot(
            track.positions[:, 0], track.positions[:, 1], label=track.name, **line_style(track.name)
        )
    estimates = [track for track in tracks if track.name != "reference"]
    draw_loops(axes, loops)
    mark_ends(axes, estimates[-1].positions)
    draw_scale_bar(axes)
    legend_above(axes)
    return figure


def over_distance(height: float = 3.4) -> Tuple[Figure, Axes]:
    figure, axes = plt.subplots(figsize=(10, height), constrained_layout=True)
    axes.set_xlabel("distance driven (m)")
    axes.margins(x=0.01)
    return figure, axes


def height_picture(tracks: List[Track]) -> Figure:
    figure, axes = over_distance()
    for track in tracks:
        axes.plot(track.distance, track.positions[:, 2], label=track.name, **line_style(track.name))
    axes.set_ylabel("height (m)")
    low, high = axes.get_ylim()
    if high - low < 1.0:  # a flat drive shall look flat
        axes.set_ylim((low + high) / 2 - 0.5, (low + high) / 2 + 0.5)
    legend_above(axes)
    return figure


def error_picture(errors: List[Error]) -> Figure:
    figure, axes = over_distance()
    for error in errors:
        colour = colour_of(error.name)
        axes.plot(error.distance, error.error, color=colour, label=error.name)
        axes.axhline(
            error.ate,
            color=colour,
            linewidth=1.0,
            linestyle=(0, (4, 3)),
            label=f"its RMSE, {error.ate:.3f} m",
        )
    axes.set_ylabel("position error (m)")
    axes.set_ylim(bottom=0)
    legend_above(axes)
    return figure


def choose_cell(points: np.ndarray, low: np.ndarray, high: np.ndarray) -> float:
    """Fine as the picture allows, but not so fine that a surface falls apart into dots.

    Of points strewn with a mean of n to a cell, the share of the occupied cells with one point
    falls with n: 0.4 is n = 1.6, where one cell in five stays empty.
    """
    cell = float((high - low).max()) / 1400.0
    for _ in range(40):
        index = ((points[:, :2] - low) / cell).astype(np.int64)
        columns = int(index[:, 0].max()) + 1
        count = np.bincount(index[:, 1] * columns + index[:, 0])
        if (count == 1).sum() < 0.4 * (count > 0).sum():
            break
        cell *= 1.1
    return cell


def rasterise(
    points: np.ndarray, low: np.ndarray, cell: float, shape: Tuple[int, int]
) -> Tuple[np.ndarray, np.ndarray]:
    """Number of points and greatest height of each cell, rows from south to north."""
    index = ((points[:, :2] - low) / cell).astype(np.int64)
    flat = index[:, 1] * shape[1] + index[:, 0]
    count = np.bincount(flat, minlength=shape[0] * shape[1])
    height = np.full(shape[0] * shape[1], -np.inf, np.float32)
    np.maximum.at(height, flat, points[:, 2])
    return count.reshape(shape), height.reshape(shape)


def toned(count: np.ndarray, height: np.ndarray, norm: Normalize) -> np.ndarray:
    """Colour by height, fading to the paper where points are few: walls stand out of ground."""
    occupied = count > 0
    level = np.log1p(count / max(float(np.median(count[occupied])), 1.0))
    strength = 0.35 + 0.65 * np.clip(level / np.percentile(level[occupied], 97), 0, 1)
    strength = np.where(occupied, strength, 0.0)[..., None]
    colour = HEIGHTS(norm(np.where(occupied, height, norm.vmin)))[..., :3]
    return strength * colour + (1.0 - strength)


def map_extent(points: np.ndarray, track: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Without the farthest thousandth of the points: stray returns would shrink the rest."""
    low = np.minimum(np.percentile(points[:, :2], 0.1, axis=0), track[:, :2].min(axis=0))
    high = np.maximum(np.percentile(points[:, :2], 99.9, axis=0), track[:, :2].max(axis=0))
    return low - 2.0, high + 2.0


def height_bar(figure: Figure, axes: Axes, norm: Normalize) -> None:
    scale = plt.cm.ScalarMappable(norm, HEIGHTS)
    bar = figure.colorbar(scale, ax=axes, shrink=0.5, aspect=28, pad=0.015)
    bar.outline.set_visible(False)
    bar.ax.tick_params(length=0, labelsize=9.5)
    bar.set_label("height (m)", fontsize=10)


def map_picture(points: np.ndarray, track: np.ndarray) -> Figure:
    low, high = map_extent(points, track)
    points = points[np.all((points[:, :2] >= low) & (points[:, :2] < high), axis=1)]
    cell = choose_cell(points, low, high)
    columns, rows = (np.ceil((high - low) / cell)).astype(int)
    count, height = rasterise(points, low, cell, (rows, columns))
    shown = height[count > 0]
    bottom, top = np.percentile(shown, [2, 98])
    norm = Normalize(bottom, max(top, bottom + 1.0), clip=True)
    figure, axes = plan_figure((low, high), width=11.0)
    axes.grid(False)
    bounds = (low[0], low[0] + columns * cell, low[1], low[1] + rows * cell)
    axes.imshow(toned(count, height, norm), origin="lower", extent=bounds, interpolation="bilinear")
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    axes.plot(track[:, 0], track[:, 1], color=PAPER, linewidth=3.4, alpha=0.8)
    axes.plot(track[:, 0], track[:, 1], color=INK, linewidth=1.3, label="trajectory")
    mark_ends(axes, track)
    draw_scale_bar(axes)
    legend_above(axes)
    height_bar(figure, axes, norm)
    return figure


def revisit_picture(panels: List[Tuple[str, np.ndarray, np.ndarray]]) -> Figure:
    """Each panel: its title, and the points of the first and the second pass."""
    figure, column = plt.subplots(
        len(panels), 1, figsize=(10, 2.4 * len(panels)), constrained_layout=True, squeeze=False
    )
    for axes, (title, first, second) in zip(column[:, 0], panels):
        for points, colour, name in ((first, BLUE, "first pass"), (second, RUST, "second pass")):
            axes.scatter(*points.T, s=2.2, color=colour, linewidths=0, label=name)
        axes.set_aspect("equal")
        axes.invert_xaxis()  # left is left
        axes.set_title(title, fontsize=10.5, color=INK, loc="right")
        axes.set_ylabel("height (m)")
    column[-1][0].set_xlabel("metres to the left")
    legend_above(column[0][0], markerscale=4.0)
    return figure


class StageTimes(NamedTuple):
    """Milliseconds of each scan: total, and by stage where the stages are known."""

    stamps: np.ndarray
    total: np.ndarray
    stages: Dict[str, np.ndarray]


def read_pgm(path: Path) -> np.ndarray:
    """Binary PGM of 8 bits, rows from the top."""
    data = path.read_bytes()
    header = re.match(rb"P5\s+(?:#[^\n]*\n\s*)*(\d+)\s+(\d+)\s+255\s", data)
    if header is None:
        raise ValueError(f"{path} is no binary PGM of 8 bits")
    width, height = int(header[1]), int(header[2])
    return np.frombuffer(data, np.uint8, width * height, header.end()).reshape(height, width)


def grid_picture(grid: np.ndarray) -> Figure:
    height = float(np.clip(10.0 * grid.shape[0] / grid.shape[1], 3.2, 9.5))
    figure, axes = plt.subplots(figsize=(10.0, height), constrained_layout=True)
    axes.imshow(grid, cmap="gray", vmin=0, vmax=255, interpolation="antialiased")
    axes.set_axis_off()
    return figure


def binned(values: np.ndarray, bins: int, greatest: bool = False) -> np.ndarray:
    parts = np.array_split(values, bins)
    return np.array([part.max() if greatest else part.mean() for part in parts])


def scan_period_ms(stamps: np.ndarray) -> Optional[float]:
    return 1e3 * float(np.median(np.diff(stamps))) if len(stamps) > 2 else None


def draw_period(axes: Axes, stamps: np.ndarray) -> None:
    """As long as it does not flatten everything else."""
    period, top = scan_period_ms(stamps), axes.get_ylim()[1]
    if period and period < 2.5 * top:
        axes.set_ylim(0, max(top, 1.05 * period))
        axes.axhline(
            period,
            color=INK,
            linewidth=1.0,
            linestyle=(0, (4, 3)),
            label=f"time between scans, {period:.0f} ms",
        )


def limit_spikes(axes: Axes, total: np.ndarray) -> None:
    """Single slow scans leave the plot, and are named, where they would flatten all others."""
    usual, slowest = 2.0 * float(np.percentile(total, 99)), float(total.max())
    if slowest <= 1.5 * usual:
        return
    axes.set_ylim(0, usual)
    axes.annotate(
        f"slower scans, beyond the plot: {int((total > usual).sum())}; the slowest took {slowest:.0f} ms",
        (1.0, 1.01),
        xycoords="axes fraction",
        ha="right",
        va="bottom",
        fontsize=9.5,
        color=MUTED,
    )


def largest_stages(times: StageTimes) -> Dict[str, np.ndarray]:
    """In the order of the file; what there is no colour for is summed up as "other"."""
    stages = {name: values for name, values in times.stages.items() if values.sum() > 0}
    ranked = sorted(stages, key=lambda name: -stages[name].sum())
    kept = ranked if len(ranked) <= len(STAGES) else ranked[: len(STAGES) - 1]
    shown = {name: values for name, values in stages.items() if name in kept}
    rest = times.total - sum(shown.values()) if shown else times.total
    if rest.mean() > 0.01 * times.total.mean():
        shown["other"] = np.maximum(rest, 0.0)
    return shown


def stage_picture(times: StageTimes) -> Figure:
    """Stacked means over short stretches of the drive, with the slowest scan of each stretch."""
    bins = min(len(times.total), 200)
    figure, axes = plt.subplots(figsize=(10, 4.0), constrained_layout=True)
    scans = np.linspace(0, len(times.total) - 1, bins)
    stages = largest_stages(times)
    colours = [
        SLATE if name == "other" else STAGES[i % len(STAGES)] for i, name in enumerate(stages)
    ]
    if stages:
        axes.stackplot(
            scans,
            [binned(values, bins) for values in stages.values()],
            colors=colours,
            labels=list(stages),
            linewidth=0,
        )
    if len(times.total) > bins:
        axes.plot(
            scans,
            binned(times.total, bins, greatest=True),
            color=MUTED,
            linewidth=0.8,
            label="slowest scan",
        )
    axes.set_ylim(0, None)
    limit_spikes(axes, times.total)
    draw_period(axes, times.stamps)
    axes.set_xlabel("scan")
    axes.set_ylabel("time (ms)")
    axes.margins(x=0)
    handles, labels = axes.get_legend_handles_labels()
    axes.legend(handles[::-1], labels[::-1], loc="center left", bbox_to_anchor=(1.01, 0.5))
    return figure
