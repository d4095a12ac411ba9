#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The recordings of public datasets, as drives of the benchmark."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Dict, Iterator, List, NamedTuple, Optional, Tuple

from benchmark_process import run_or_stop
from benchmark_sequences import Sequence, reference_beside

DEEPEST = 5  # folders below the one that is given
APOLLO_PLACES = {
    "baylandstoseafood": "BTS",
    "columbiapark": "CP",
    "highway237": "H237",
    "mathildaave": "MAVE",
    "sanjosedowntown": "SJD",
    "sunnyvalebigloop": "SB",
}


class Recording(NamedTuple):
    """reader: the name that `convert_dataset` knows. name: of the sequence. place: what is averaged
    with others, by the name that the paper's tables have."""

    reader: str
    folder: Path
    name: str
    place: str


def folders(top: Path) -> Iterator[Path]:
    """The folder and those below it, in order, without those of scans themselves."""
    level = [top]
    for _ in range(DEEPEST + 1):
        yield from level
        level = [
            child
            for folder in level
            for child in sorted(folder.iterdir())
            if child.is_dir() and not any(folder.glob("*.bin")) and not any(folder.glob("*.pcd"))
        ]


def without_number(name: str) -> str:
    return re.sub(r"[ _-]*\d+$", "", name)


def helipr(folder: Path) -> List[Recording]:
    """HeLiPR: a folder with LiDAR/SENSOR for each of its sensors."""
    return [
        Recording(
            f"helipr-{sensor.lower()}",
            folder,
            f"{folder.name.lower()}-{sensor.lower()}",
            f"{without_number(folder.name)} {sensor}",
        )
        for sensor in ("Aeva", "Avia", "Ouster")
        if (folder / "LiDAR" / sensor).is_dir()
    ]


def mulran(folder: Path) -> List[Recording]:
    if not any((folder / scans).is_dir() for scans in ("Ouster", "sensor_data/Ouster")):
        return []
    return [Recording("mulran", folder, folder.name.lower(), without_number(folder.name))]


def apollo(folder: Path) -> List[Recording]:
    """Apollo-SouthBay: SPLIT/PLACE/DATE, in some splits with numbered parts, of pcds/ and poses/."""
    if not ((folder / "pcds").is_dir() and (folder / "poses" / "gt_poses.txt").is_file()):
        return []
    parts = folder.parts
    known = [i for i, part in enumerate(parts) if part.lower() in APOLLO_PLACES]
    if not known:
        return [Recording("apollo", folder, folder.name, folder.name)]
    place = APOLLO_PLACES[parts[known[-1]].lower()]
    name = "-".join([place, parts[known[-1] - 1], *parts[known[-1] + 1 :]]).lower()
    return [Recording("apollo", folder, name, place)]


def newer_college(folder: Path) -> List[Recording]:
    scans = ("raw_format/ouster_scan", "ouster_scan")
    if folder.name == "raw_format" or not any((folder / name).is_dir() for name in scans):
        return []
    number = re.match(r"(\d+)_(short|long)", folder.name)
    place = f"{number.group(1)} {number.group(2)}" if number else folder.name
    return [Recording("newer-college", folder, place.replace(" ", "-"), place)]


def kitti(folder: Path) -> List[Recording]:
    if not ((folder / "velodyne").is_dir() and (folder / "times.txt").is_file()):
        return []
    return [Recording("kitti-odometry", folder, f"kitti{folder.name}", f"KITTI {folder.name}")]


DATASETS = {
    "helipr": helipr,
    "mulran": mulran,
    "apollo": apollo,
    "newer_college": newer_college,
    "kitti": kitti,
}


def recordings(dataset: str, top: Path) -> List[Recording]:
    if dataset not in DATASETS:
        raise SystemExit(f"error: --dataset {dataset}: choose from {', '.join(DATASETS)}")
    if not top.is_dir():
        raise SystemExit(f"error: --dataset {dataset}: no folder {top}")
    found = [recording for folder in folders(top) for recording in DATASETS[dataset](folder)]
    if not found:
        raise SystemExit(f"error: --dataset {dataset}: no recording of it in {top}")
    names = [recording.name for recording in found]
    if len(set(names)) < len(names):
        raise SystemExit(f"error: --dataset {dataset}: two recordings of one name in {top}")
    return found


def sequence_of(recording: Recording, bags: Path, converter: Path, max_scans: int) -> Sequence:
    """As a bag with its ground truth, made unless it is there."""
    bag, note = bags / f"{recording.name}.bag", bags / f"{recording.name}.dataset"
    key = f"{recording.reader} {recording.folder} {max_scans}"
    if not (bag.is_file() and note.is_file() and note.read_text() == key):
        print(f"{recording.name}: converting", flush=True)
        bags.mkdir(parents=True, exist_ok=True)
        note.unlink(missing_ok=True)
        words = [converter, recording.reader, recording.folder, "--out", bag, "--quiet"]
        words += ["--max-scans", max_scans] if max_scans else []
        run_or_stop(words, bags / f"{recording.name}.log")
        note.write_text(key)
    origin = f"{recording.reader}, {recording.place}"
    truth = reference_beside(bag)
    return Sequence(recording.name, bag, truth, None, origin, base="", group=recording.place)


Averages = Dict[str, Dict[str, Tuple[float, Optional[float]]]]


def averages(sequences: Dict[str, Dict[str, object]], systems: List[str]) -> Tuple[Averages, Dict]:
    """By system and place: mean ATE and RPE over the recordings of the place, missing where the
    system failed on one or has not run on all; and the number of recordings of each place."""
    members: Dict[str, List[Dict]] = {}
    for described in sequences.values():
        if described["group"]:
            members.setdefault(described["group"], []).append(described["results"])
    result: Averages = {}
    for system in systems:
        for place, recorded in members.items():
            runs = [results.get(system, {}) for results in recorded]
            ates = [run.get("ate_m") for run in runs]
            rpes = [run.get("rpe_percent") for run in runs]  # none of less than 100 m
            if None not in ates:
                rpe = None if None in rpes else sum(rpes) / len(rpes)
                result.setdefault(system, {})[place] = (sum(ates) / len(ates), rpe)
    return result, {place: len(recorded) for place, recorded in members.items()}
