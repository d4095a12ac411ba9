#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The results as one Markdown page."""

from __future__ import annotations

from typing import Any, Callable, Dict, List, NamedTuple, Optional, Tuple

import paper_tables
from benchmark_datasets import averages
from benchmark_systems import SYSTEMS, System

Result = Dict[str, Any]
OURS = SYSTEMS[0].name
VARIANTS = [system.name for system in SYSTEMS if system.arguments]


class Column(NamedTuple):
    """key: in a result. lower_is_better: None for what is no merit in itself."""

    title: str
    key: str
    digits: int
    lower_is_better: Optional[bool] = True


COLUMNS = (
    Column("ATE [m]", "ate_m", 3),
    Column("RPE [%]", "rpe_percent", 2),
    Column("consistency [m]", "consistency_m", 3),
    Column("pooled [m]", "pooled_consistency_m", 3),
    Column("thickness [m]", "thickness_m", 3),
    Column("level [m]", "level_m", 2, None),
    Column("scan, median [ms]", "median_ms", 1),
    Column("p99 [ms]", "p99_ms", 1),
    Column("max [ms]", "max_ms", 1),
    Column("CPU of a scan [ms]", "cpu_ms_per_scan", 1),
    Column("peak memory [MB]", "peak_memory_mb", 0),
    Column("loops", "loops", 0, None),
    Column("disturbed [%]", "others", 0, None),
)

# What sensor and measure allow.
OF_TRUTH = ("consistency_m", "pooled_consistency_m", "thickness_m")

METHOD = """\
Everything runs one after the other on the same cores, each run in a process of its own, with each
system's defaults (GenZ-ICP and MAD-ICP with deskewing, as the others). Poses are those of `base_link` at the instant to which a system deskews: that
of the scan's last point, for CT-ICP its first, for GenZ-ICP and LOAM (no deskewing) the middle. Retro-SLAM is the implementation of the paper's own authors.

- Peers are driven as their own pipelines drive them, from one reader that gives points and point
  times. Their time and CPU leave out reading the bag and loading Python packages; ours leaves out
  reading the bag's bytes only.
- Bags are read as fast as the system processes scans. A scan's time is that of the call that
  processes it. The
  peers close loops within that call; revisit_slam does it in the background, so that its loops
  show in the CPU time, and in p99 and maximum only where the runner, faster than the sensor, has
  to wait for them. CPU: that of all threads over the whole run including its end, divided by the scans.
- Disturbed: the share of the processors that other programs took during the run; where it is high,
  wall times are too, and CPU times somewhat.
- Peak memory is that of the whole process; before the first scan the peers' Python takes the part
  in parentheses.
- ATE: RMSE of the positions after rigid alignment. RPE: relative translation error over 100 to
  800 m. Consistency: RMS distance of neighbouring points between two passes of a place, mean over
  the pairs of passes (± standard deviation), as in the paper. Ours: pooled, one RMS for all pairs
  of a place; thickness, of surfaces that several passes show. Level, of a drive without a truth
  that returns: height of its end above its first pass; see `docs/evaluation.md`. Loops of
  Retro-SLAM and revisit_slam are pairs of submaps, those of KISS-SLAM pairs of local maps: their
  numbers are not comparable.
"""


NamesOf = Callable[[Dict[str, Result]], List[str]]
Columns = Tuple[Column, ...]
BEST_OF = ("ate_m", "rpe_percent", "consistency_m", "thickness_m", "cpu_ms_per_scan")
BEST_OF += ("peak_memory_mb",)


def number(value: Any, digits: int) -> str:
    return "–" if value is None else f"{value:.{digits}f}"


def cell(result: Result, column: Column) -> str:
    value = result.get(column.key)
    if column.key == "others":
        return "" if value is None else f"{100 * value:.0f}"
    text = number(value, column.digits)
    if column.key == "peak_memory_mb" and "memory_before_first_scan_mb" in result:
        text += f" ({result['memory_before_first_scan_mb']:.0f})"
    if column.key == "consistency_m" and "consistency_sd_m" in result:
        text += f" ± {result['consistency_sd_m']:.3f}"
    return text


def systems_of(results: Dict[str, Result]) -> List[System]:
    """In the order of the tables; those whose trajectories were given come last."""
    known = [system for system in SYSTEMS if system.name in results]
    names = {system.name for system in known}
    return known + [System(n, f"{n} (given)") for n in sorted(results) if n not in names]


def peers_of(results: Dict[str, Result]) -> List[str]:
    return [system.name for system in systems_of(results) if not system.is_ours()]


def table(results: Dict[str, Result], truth: Result) -> List[str]:
    """truth: what the true trajectory reaches; its consistency is what sensor and measure allow."""
    shown = [c for c in COLUMNS if any(r.get(c.key) is not None for r in results.values())]
    lines = ["| | " + " | ".join(column.title for column in shown) + " |"]
    lines.append("|---|" + "---:|" * len(shown))
    for system in systems_of(results):
        result = results[system.name]
        cells = [cell(result, column) for column in shown]
        if result["status"] != "ok":
            cells[0] = f"{result['status']} after {result.get('wall_seconds', 0.0):.0f} s"
        lines.append(f"| {system.title} | " + " | ".join(cells) + " |")
    if truth.get("consistency_m") is not None and any(c.key == "consistency_m" for c in shown):
        cells = [cell(truth, c) if c.key in OF_TRUTH else "" for c in shown]
        lines.append("| *true trajectory* | " + " | ".join(cells) + " |")
    return lines


def better(results: Dict[str, Result], names: List[str], column: Column) -> List[Tuple[str, float]]:
    """Those that do better than revisit_slam, the best first; the printed digits decide."""
    ours = results.get(OURS, {}).get(column.key)
    values = {name: results[name].get(column.key) for name in names if name in results}
    if ours is None or not column.lower_is_better:
        return []
    rounded = {n: round(v, column.digits) for n, v in values.items() if v is not None}
    lower = [(n, v) for n, v in rounded.items() if v < round(ours, column.digits)]
    return sorted(lower, key=lambda item: item[1])


def losses(sequences: Dict[str, Any], names_of: NamesOf, columns: Columns) -> List[str]:
    """names_of: the systems of a drive's results that ours is compared with."""
    lines = []
    for sequence, described in sequences.items():
        results = described["results"]
        for column in columns:
            ahead = [
                f"{name} {number(value, column.digits)}"
                for name, value in better(results, names_of(results), column)
            ]
            if ahead:
                ours = number(results[OURS][column.key], column.digits)
                lines.append(f"- {sequence}, {column.title}: {', '.join(ahead)}; ours {ours}")
    return lines or ["Nowhere in these runs."]


def best(results: Dict[str, Result], column: Column) -> str:
    """Of ours as it is and the peers; the printed digits decide."""
    names = [name for name in (OURS, *peers_of(results)) if name in results]
    values = {n: results[n].get(column.key) for n in names}
    rounded = {n: round(v, column.digits) for n, v in values.items() if v is not None}
    if not rounded:
        return "–"
    lowest = min(rounded.values())
    winners = ", ".join(name for name, value in rounded.items() if value == lowest)
    return f"{winners} {number(lowest, column.digits)}"


def winners(sequences: Dict[str, Any]) -> List[str]:
    """Who is best on each drive."""
    shown = [c for c in COLUMNS if c.lower_is_better and c.key in BEST_OF]
    lines = ["| | " + " | ".join(c.title for c in shown) + " |", "|---" * (len(shown) + 1) + "|"]
    for name, sequence in sequences.items():
        cells = [best(sequence["results"], column) for column in shown]
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return lines


def missing(sequences: Dict[str, Any], not_run: List[str]) -> List[str]:
    lines = [f"- {name}: nothing was run" for name in not_run]
    for name, sequence in sequences.items():
        results = sequence["results"]
        absent = [s.name for s in SYSTEMS if s.name not in results]
        if absent:
            lines.append(f"- {name}: not run: {', '.join(absent)}")
        for system, result in results.items():
            if result["status"] != "ok":
                log = result.get("log") or ["no output"]
                lines.append(f"- {name}: {system}: {result['status']}: `{log[-1][:200]}`")
    return lines


def used(facts: Dict[str, Any], results: Dict[str, Result]) -> str:
    """Says so where the runs saw only the beginning of the drive."""
    counts = {r["scans"] for r in results.values() if "scans" in r}
    if not facts or counts <= {facts["scans"]}:
        return ""
    return f" Scans used: {', '.join(str(count) for count in sorted(counts))}."


def drive(facts: Dict[str, Any]) -> str:
    if not facts:
        return ""
    revisits = ", ".join(f"{kind} {seconds:.0f} s" for kind, seconds in facts["revisits"].items())
    return (
        f"{facts['length']:.0f} m, {facts['seconds']:.0f} s, {facts['scans']} scans of "
        f"{facts['points'] / facts['scans']:.0f} points; revisits: {revisits or 'none'}."
    )


def disturbance(results: Dict[str, Result]) -> List[str]:
    if max(result.get("others", 0.0) for result in results.values()) <= 0.1:
        return []
    return ["Some of these runs were disturbed: compare CPU times rather than wall times.", ""]


def section(name: str, sequence: Dict[str, Any]) -> List[str]:
    origin = sequence["origin"]
    described = f"`{origin}`" if origin.startswith("simulate ") else origin
    results = sequence["results"]
    text = f"{described}. {drive(sequence['facts'])}".strip() + used(sequence["facts"], results)
    rows = table(results, sequence["truth"])
    return [f"## {name}", "", text, "", *rows, "", *disturbance(results)]


def flat(parameters: Dict[str, Any], prefix: str = "") -> List[str]:
    words = []
    for key, value in parameters.items():
        if isinstance(value, dict):
            words += flat(value, f"{prefix}{key}/")
        else:
            words.append(f"{prefix}{key}={value}")
    return words


def parameters(sequences: Dict[str, Any]) -> List[str]:
    """Versions and parameters of each system, from the first sequence that it ran on."""
    lines = ["## Versions and parameters", ""]
    for system in SYSTEMS:
        runs = [s["results"].get(system.name, {}) for s in sequences.values()]
        run = next((r for r in runs if "parameters" in r), None)
        if run is None:
            continue
        versions = ", ".join(f"{package} {version}" for package, version in run["versions"].items())
        lines.append(f"- {system.name}: {versions}; ")
        if system.arguments:
            lines[-1] += "as revisit_slam but `" + " ".join(system.arguments) + "`"
        else:
            lines[-1] += "`" + " ".join(flat(run["parameters"])) + "`"
    return lines


def average_tables(sequences: Dict[str, Any]) -> List[str]:
    """The paper's tables, as far as there are recordings, with rows of what was measured here."""
    names = list(dict.fromkeys(n for s in sequences.values() for n in s["results"]))
    means, counts = averages(sequences, names)
    lines: List[str] = []
    for paper in (*paper_tables.TABLES, others(counts)):
        columns = tuple(column for column in paper.columns if column in counts)
        if not columns:
            continue
        rows = paper_tables.markdown(paper, columns)
        for system in systems_of(dict.fromkeys(names, {})):
            cells = [mean_text(means.get(system.name, {}).get(column)) for column in columns]
            rows.append(f"| {system.title}, measured here | " + " | ".join(cells) + " |")
        rows.append("| recordings averaged | " + " | ".join(str(counts[c]) for c in columns) + " |")
        lines += [*rows, ""]
    if lines:
        lines = ["## Averages over recordings", "", AVERAGES, "", *lines]
    return lines


AVERAGES = """\
ATE [m] / RPE [%]. The first rows are the paper's, the last its ablations; –: failed, or not run on
all recordings of the place."""


def others(counts: Dict[str, int]) -> paper_tables.Table:
    """Places that the paper has no results of."""
    known = {column for table in paper_tables.TABLES for column in table.columns}
    return paper_tables.Table("others", tuple(p for p in counts if p not in known), {})


def mean_text(mean: Optional[Tuple[float, Optional[float]]]) -> str:
    return "–" if mean is None else f"{number(mean[0], 2)} / {number(mean[1], 2)}"


def markdown(report: Dict[str, Any]) -> str:
    sequences = report["sequences"]
    lines = ["# Benchmark", "", "```", report["command"], "```", "", f"{report['machine']}.", ""]
    lines += [METHOD, "## Who is best", "", *winners(sequences), ""]
    lines += average_tables(sequences) if report["average"] else []
    for name, sequence in sequences.items():
        lines += section(name, sequence)
    lines += ["## Where a peer is better", "", *losses(sequences, peers_of, COLUMNS), ""]
    lines += ["## Where a variant is better", ""]
    lines += losses(sequences, lambda _: VARIANTS, COLUMNS[:3])
    lines += ["", "## Missing", "", *(missing(sequences, report["not_run"]) or ["Nothing."])]
    lines.append("")
    return "\n".join(lines + parameters(sequences)) + "\n"
