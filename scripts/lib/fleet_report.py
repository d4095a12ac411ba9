#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The report of a fleet: a page, two pictures of the joint map, and all numbers."""

from __future__ import annotations

import io
import json
from collections import Counter
from typing import Any, Dict, List, NamedTuple, Sequence

import numpy as np

from fleet_plan import Outcome, table_of
from fleet_tasks import FAILED, Site

STAGES = ("map", "candidates", "register", "solve", "export")


class Drive(NamedTuple):
    """A session in the joint graph. positions: of its keyposes (n, 3). errors: for each, how far its
    loops to other sessions are from the graph, in metres; NaN where it has none."""

    name: str
    group: str
    positions: np.ndarray
    errors: np.ndarray
    loops: int
    partners: int


def drives_of(site: Site) -> List[Drive]:
    tables = {row["session"]: row for row in table_of(site, "joint/sessions.csv")}
    ends: Dict[str, Dict[int, List[float]]] = {name: {} for name in tables}
    for row in table_of(site, "joint/loops.csv"):
        if row["state"] != "active":
            continue
        for end in ("source", "target"):
            submap = int(row[f"{end}_submap"])
            ends[row[end]].setdefault(submap, []).append(float(row["translation_error"]))
    drives = []
    for name, row in tables.items():
        poses = table_of(site, f"joint/keyposes/{name}.csv")
        positions = np.array([[float(pose[axis]) for axis in "xyz"] for pose in poses])
        errors = np.full(len(poses), np.nan)
        for submap, values in ends[name].items():
            errors[submap] = np.mean(values)
        loops, partners = int(row["loops"]), int(row["sessions"])
        drives.append(Drive(name, row["map"], positions, errors, loops, partners))
    return drives


def largest_map(drives: Sequence[Drive]) -> str:
    """The name of its first session; of equally large ones that of the first."""
    return Counter(drive.group for drive in drives).most_common(1)[0][0] if drives else ""


def save(figure: Any, site: Site, name: str) -> None:
    data = io.BytesIO()
    figure.savefig(data, format="png", dpi=150)
    site.store.write(name, data.getvalue())


def draw(site: Site, drives: Sequence[Drive]) -> None:
    """What is in the largest map: coloured by session, and by the error against neighbours."""
    from report_pictures import draw_scale_bar, extent_of, plan_figure, plt

    extent = extent_of([drive.positions for drive in drives], 0.04)
    figure, axes = plan_figure(extent)
    colours = plt.get_cmap("tab20")
    for number, drive in enumerate(drives):
        x, y = drive.positions[:, 0], drive.positions[:, 1]
        label = drive.name if len(drives) <= 20 else None
        axes.plot(x, y, color=colours(number % 20), linewidth=1.6, alpha=0.8, label=label)
    if len(drives) <= 20:
        axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), fontsize=8)
    draw_scale_bar(axes)
    save(figure, site, "report_sessions.png")
    plt.close(figure)

    figure, axes = plan_figure(extent)
    everything = np.concatenate([drive.errors for drive in drives])
    known = everything[np.isfinite(everything)]
    top = float(np.quantile(known, 0.98)) if len(known) else 1.0
    for drive in drives:
        axes.plot(drive.positions[:, 0], drive.positions[:, 1], color="#c8ccd2", linewidth=1.0)
    points = np.vstack([drive.positions for drive in drives])
    is_known = np.isfinite(everything)
    dots = axes.scatter(
        points[is_known, 0],
        points[is_known, 1],
        c=everything[is_known],
        cmap="viridis",
        vmin=0.0,
        vmax=max(top, 1e-3),
        s=14,
        zorder=3,
    )
    figure.colorbar(dots, ax=axes, shrink=0.6, label="loops to other sessions, off by (m)")
    draw_scale_bar(axes)
    save(figure, site, "report_error.png")
    plt.close(figure)


def verdict(drive: Drive, group: str) -> str:
    if drive.group == group:
        plural = "" if drive.partners == 1 else "s"
        return f"joined by {drive.loops} loops with {drive.partners} session{plural}"
    return "isolated" if drive.partners == 0 else f"in the map of {drive.group}"


def session_rows(outcome: Outcome, drives: Sequence[Drive]) -> List[str]:
    by_name = {drive.name: drive for drive in drives}
    group = largest_map(drives)
    exported = {record["name"]: record for record in outcome.records.get("export", [])}
    rows = []
    for record in outcome.records["map"]:
        name = record["name"]
        if record["status"] == FAILED:
            rows.append(f"| {name} | failed: {record['reason']} | | | | |")
            continue
        drive = by_name.get(name)
        state = verdict(drive, group) if drive else "not joined"
        known = drive.errors[np.isfinite(drive.errors)] if drive else np.array([])
        error = f"{np.mean(known):.3f}, {np.max(known):.3f}" if len(known) else ""
        export = exported.get(name, {})
        if export.get("status") == FAILED:
            state += f"; export failed: {export['reason']}"
        if record["left_out"]:
            state += f"; its stamps went back: {', '.join(record['left_out'])} left out"
        rows.append(
            f"| {name} | {state} | {record['scans']} | {record['metres']:.0f} | {error} | "
            f"{record['cpu_seconds']:.0f} |"
        )
    return rows


def figures_of(outcome: Outcome, slots: int) -> Dict[str, Any]:
    """Times of this run, and the work of all tasks, now or before."""
    mapped = outcome.done("map")
    tasks = [record for records in outcome.records.values() for record in records]
    fresh = [record for record in tasks if not record.get("resumed")]
    busy = sum(record.get("wall_seconds", 0.0) for record in fresh)
    seconds = sum(outcome.seconds.values())
    return {
        "slots": slots,
        "seconds": seconds,
        "seconds_by_stage": outcome.seconds,
        "recordings": len(outcome.records["map"]),
        "failed": sum(record["status"] == FAILED for record in tasks),
        "scans": sum(record["scans"] for record in mapped),
        "kilometres": sum(record["metres"] for record in mapped) / 1e3,
        "tasks_resumed": len(tasks) - len(fresh),
        "cpu_seconds": sum(record.get("cpu_seconds", 0.0) for record in tasks),
        "busy_share": busy / (seconds * slots) if seconds > 0 else 0.0,
        "peak_memory_mb": max([0.0] + [record.get("peak_memory_mb", 0.0) for record in tasks]),
    }


def stage_rows(outcome: Outcome) -> List[str]:
    rows = []
    for stage in STAGES:
        records = outcome.records.get(stage)
        if records is None:
            continue
        failed = sum(record["status"] == FAILED for record in records)
        resumed = sum(bool(record.get("resumed")) for record in records)
        cpu = sum(record.get("cpu_seconds", 0.0) for record in records)
        memory = max([0.0] + [record.get("peak_memory_mb", 0.0) for record in records])
        rows.append(
            f"| {stage} | {len(records)} | {failed} | {resumed} | {outcome.seconds[stage]:.1f} | "
            f"{cpu:.1f} | {memory:.0f} |"
        )
    return rows


def failures(outcome: Outcome) -> List[str]:
    lines = [
        f"- {stage} {record['name']}: {record['reason']}"
        for stage in STAGES
        for record in outcome.records.get(stage, [])
        if record["status"] == FAILED
    ]
    return ["", "## Failed", "", *lines] if lines else []


def page(outcome: Outcome, drives: Sequence[Drive], slots: int) -> str:
    about = figures_of(outcome, slots)
    joined = [drive for drive in drives if drive.group == largest_map(drives)]
    pictures = ["![Sessions](report_sessions.png)", "", "![Error](report_error.png)", ""]
    hours = max(about["seconds"], 1e-9) / 3600.0
    lines = [
        "# Fleet",
        "",
        f"{about['recordings']} recordings, {about['kilometres']:.1f} km, {about['scans']} scans; "
        f"{len(joined)} sessions in one map, in the frame of {largest_map(drives) or 'none'}.",
        "",
        *(pictures if joined else []),
        "The second picture: how far loops to other sessions are from where the graph has them, mean at "
        "each keypose.",
        "",
        "## Sessions",
        "",
        "| session | | scans | m | off from neighbours, mean, max (m) | CPU (s) |",
        "|---|---|---:|---:|---:|---:|",
        *session_rows(outcome, drives),
        *failures(outcome),
        "",
        "## Work",
        "",
        "| stage | tasks | failed | were there | wall (s) | CPU (s) | most memory (MB) |",
        "|---|---:|---:|---:|---:|---:|---:|",
        *stage_rows(outcome),
        "",
        f"{slots} worker slots, {about['seconds']:.1f} s: {about['kilometres'] / hours:.1f} km and "
        f"{about['scans'] / hours:.0f} scans an hour; the slots were busy for "
        f"{100.0 * about['busy_share']:.0f} % of the time. CPU and memory are those of the programs; "
        "of tasks that were there, from when they were done.",
        "",
    ]
    return "\n".join(lines)


def write_report(site: Site, outcome: Outcome, slots: int) -> None:
    drives = drives_of(site) if outcome.done("solve") else []
    joined = [drive for drive in drives if drive.group == largest_map(drives)]
    if joined:
        draw(site, joined)
    site.store.write("report.md", page(outcome, drives, slots).encode())
    numbers = {**figures_of(outcome, slots), "tasks": outcome.records}
    site.store.write("report.json", json.dumps(numbers, indent=1, sort_keys=True).encode())
