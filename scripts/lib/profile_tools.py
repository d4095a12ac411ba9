# SPDX-License-Identifier: MIT
"""What perf and valgrind say of a run, as numbers."""

from __future__ import annotations

import re
from typing import Dict, List, NamedTuple, Optional, Tuple

# Of each stage the functions that do all of its work, as they begin in the tools' output. What one of
# them calls is its own; none calls another.
STAGES: Dict[str, Tuple[str, ...]] = {
    "reading the bag": ("rosbag::MessageInstance::write", "void rosbag::Bag::readMessageDataIntoStream"),
    "messages to points": ("revisit_slam::ScanReader::read(revisit_slam::RawMessage",),
    "preprocess": ("revisit_slam::preprocess(",),
    "downsample": ("revisit_slam::Odometry::downsample(",),
    "register": ("revisit_slam::Registration::align(",),
    "gather": ("revisit_slam::InformationEstimator::gather(",),
    "update map": ("revisit_slam::Odometry::commit(",),
    "information": ("revisit_slam::InformationEstimator::estimate(",),
    "submaps": ("revisit_slam::MapHierarchy::insert(", "revisit_slam::MapHierarchy::closeAll("),
    "detail": ("revisit_slam::DetailMap::insert(",),
    "occupancy": ("revisit_slam::OccupancyBuilder::insert(", "revisit_slam::OccupancyBuilder::drive(",
                  "revisit_slam::OccupancyBuilder::close("),
    "loops": ("revisit_slam::LoopClosing::add(", "revisit_slam::LoopClosing::correct("),
    "graph": ("revisit_slam::BackEnd::add(",),
    "files at the end": ("revisit_slam::OfflineRun::writeResults(",),
}


class Share(NamedTuple):
    function: str
    value: float


def short_name(function: str) -> str:
    """Without templates' arguments, parameters and the library; what is left is found in the sources.
    A loop over chunks, which may run in parallel, has the name of the function that it is in."""
    function = re.sub(r" \[[^\]]*\]$", "", function.strip())
    loop = re.search(r"Chunks::forEach<revisit_slam::((?:\(anonymous namespace\)::)?[\w:]+)\(", function)
    if loop:
        return loop.group(1).replace("(anonymous namespace)::", "")
    depth, kept = 0, []
    for character in function:
        depth += character == "<"
        if depth == 0:
            kept.append(character)
        depth -= character == ">"
    name = re.sub(r"^void ", "", "".join(kept)).replace("revisit_slam::", "").replace("(anonymous namespace)::", "")
    return name.split("(")[0].strip() or function


def functions_of_perf(report: str) -> List[Share]:
    """Lines "12.34%  symbol" of `perf report --no-children --stdio -g none --sort symbol`, as percent."""
    shares = []
    for line in report.splitlines():
        match = re.match(r"\s*([\d.]+)%\s+\[[.k]\]\s+(.*?\S)(?:\s+-\s+-)?\s*$", line)
        if match:
            shares.append(Share(match.group(2), float(match.group(1))))
    return shares


def functions_of_callgrind(annotated: str) -> List[Share]:
    """Of `callgrind_annotate`: instructions of each function, as it sorts them."""
    shares = []
    for line in annotated.splitlines():
        match = re.match(r"\s*([\d,]+) \(\s*[\d.]+%\)\s+[^:]*?:(.*)", line)
        if match:
            shares.append(Share(match.group(2), float(match.group(1).replace(",", ""))))
    return shares


def total_of_callgrind(annotated: str) -> float:
    match = re.search(r"([\d,]+) \(100\.0%\)\s+PROGRAM TOTALS", annotated)
    if match is None:
        raise ValueError("callgrind_annotate gave no totals")
    return float(match.group(1).replace(",", ""))


def stages_of_callgrind(inclusive: str) -> Dict[str, float]:
    """Instructions of each stage, of `callgrind_annotate --inclusive=yes`, where what a function calls
    within itself has a line of its own, with '2 behind the name."""
    functions = [share for share in functions_of_callgrind(inclusive) if "'2" not in share.function]
    return {stage: sum(share.value for share in functions if share.function.startswith(names))
            for stage, names in STAGES.items()}


def allocations_of_dhat(log: str) -> Optional[Tuple[int, int]]:
    """Bytes and blocks that were taken in all."""
    match = re.search(r"Total:\s+([\d,]+) bytes in ([\d,]+) blocks", log)
    if match is None:
        return None
    taken, blocks = (int(number.replace(",", "")) for number in match.groups())
    return taken, blocks


def table(header: List[str], rows: List[List[str]]) -> str:
    """Markdown; all columns but the first to the right."""
    lines = ["| " + " | ".join(header) + " |", "|---" + "|---:" * (len(header) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])
