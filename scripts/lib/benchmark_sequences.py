#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The drives of the benchmark: bags with their ground truths, given or simulated."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

from benchmark_process import run_or_stop

SEED = 7
# Arguments of `simulate` for a drive along a recorded route.
ALONG_ROUTE = ("--world", "town", "--sensor", "spinning-64", "--route")
# Name, arguments of `simulate`; about a kilometre each, 10 scans a second.
SIMULATED: Tuple[Tuple[str, Tuple[str, ...]], ...] = (
    ("town", ("--world", "town", "--route", "loop", "--length", "1000", "--sensor", "spinning-64")),
    (
        "bridge",
        ("--world", "bridge", "--route", "out-and-back", "--length", "1000")
        + ("--sensor", "spinning-64"),
    ),
    (
        "campus-rosette",
        ("--world", "campus", "--route", "tour", "--length", "800", "--motion", "handheld")
        + ("--sensor", "rosette"),
    ),
    (
        "campus-narrow",
        ("--world", "campus", "--route", "loop", "--length", "500", "--motion", "handheld")
        + ("--sensor", "narrow"),
    ),
)


class Sequence(NamedTuple):
    """reference: TUM file of T_map_base, if there is one. origin: how the bag came about. base: the
    frame whose poses are judged; empty: the sensor's own. azimuth: point times are made of the
    directions of the points, as the bag has none. group: of recordings that are averaged. returns:
    to where it was, on the same level; all passes are compared, however far apart in height."""

    name: str
    bag: Path
    reference: Optional[Path]
    topic: Optional[str]
    origin: str
    base: str = "base_link"
    azimuth: bool = False
    group: str = ""
    returns: bool = False

    def identity(self) -> List[Any]:
        """What a result depends on."""
        file = self.bag.stat()
        return [self.name, file.st_size, file.st_mtime, self.topic, self.base, self.azimuth]

    def settings(self) -> List[str]:
        """How our programs read it."""
        words = [] if self.base == "base_link" else ["--set", f"frames/base={self.base}"]
        return words + (["--set", "input/time_field=azimuth"] if self.azimuth else [])


def reference_beside(bag: Path) -> Optional[Path]:
    """DRIVE.gt.tum beside DRIVE.bag, as `simulate` writes it."""
    reference = bag.with_suffix(".gt.tum")
    return reference if reference.is_file() else None


def given(text: str) -> Sequence:
    """NAME=BAG or NAME=BAG,GROUND_TRUTH"""
    name, _, files = text.partition("=")
    bag, _, reference = files.partition(",")
    if not name or not Path(bag).is_file():
        raise SystemExit(f"error: --bag {text}: give NAME=BAG or NAME=BAG,GROUND_TRUTH.tum")
    truth = Path(reference) if reference else reference_beside(Path(bag))
    if truth and not truth.is_file():
        raise SystemExit(f"error: --bag {text}: no file {truth}")
    return Sequence(name, Path(bag), truth, None, "Given bag")


# Name, file, ground truth, whether times are made of directions, whether it returns.
RECORDED = (
    ("kitti-raw", "kitti_raw_0001/kitti_raw_0001.bag", "ground_truth.tum", False, False),
    ("kitti-raw-azimuth", "kitti_raw_0001/kitti_raw_0001.bag", "ground_truth.tum", True, False),
    ("car-park", "vlp16_car_park/vlp16_car_park.bag", None, False, True),
)


def recorded(data: Path) -> List[Sequence]:
    """The real drives that are in the folder of test data."""
    found = []
    for name, file, truth, azimuth, returns in RECORDED:
        bag = data / file
        if bag.is_file():
            reference = bag.with_name(truth) if truth else None
            times = "azimuth times" if azimuth else "no point times"
            drive = Sequence(name, bag, reference, "/velodyne_points", f"Recorded, {times}")
            found.append(drive._replace(base="", azimuth=azimuth, returns=returns))
    if not found:
        raise SystemExit(f"error: --recorded {data}: none of {', '.join(r[1] for r in RECORDED)}")
    return found


def named(route: Path) -> str:
    """Of the drive along it: kitti07 for kitti_07.txt."""
    return route.stem.replace("_", "")


def names(routes: List[Path]) -> List[str]:
    """Of all simulated drives."""
    return [*map(named, routes), *dict(SIMULATED)]


def simulated_as(name: str, words: List[str], folder: Path, program: Path) -> Sequence:
    """The bag is made unless the same command has made it before."""
    command = " ".join(words)
    bag, note = folder / f"{name}.bag", folder / f"{name}.command"
    if not (bag.is_file() and note.is_file() and note.read_text() == command):
        print(f"{name}: simulating", flush=True)
        folder.mkdir(parents=True, exist_ok=True)
        note.unlink(missing_ok=True)
        run_or_stop([program, "--out", bag, "--quiet", *words], folder / f"{name}.log")
        note.write_text(command)
    return Sequence(name, bag, reference_beside(bag), None, f"simulate {command}")


def simulated(name: str, folder: Path, program: Path, routes: List[Path]) -> Sequence:
    route = {named(route): route for route in routes}.get(name)
    words = [*ALONG_ROUTE, str(route)] if route else list(dict(SIMULATED)[name])
    sequence = simulated_as(name, [*words, "--seed", str(SEED)], folder, program)
    # Without the folder of this machine's route.
    origin = sequence.origin.replace(str(route), route.name) if route else sequence.origin
    return sequence._replace(origin=origin)


def facts(sequence: Sequence) -> Dict[str, Any]:
    """What `simulate` says of the drive: scans, points, length, revisits by kind in seconds."""
    path = sequence.bag.with_suffix(".json")
    if not path.is_file():
        return {}
    drive = json.loads(path.read_text())
    revisits: Dict[str, float] = {}
    for revisit in drive["revisits"]:
        seconds = 1e-9 * (revisit["later"][1] - revisit["later"][0])
        revisits[revisit["kind"]] = revisits.get(revisit["kind"], 0.0) + seconds
    result = {key: drive[key] for key in ("scans", "points", "length")}
    return {**result, "seconds": 1e-9 * (drive["end"] - drive["start"]), "revisits": revisits}
