#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The peers' virtual environments and the description of the machine."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
from pathlib import Path
from typing import Dict, Iterator, Optional, Tuple

from benchmark_process import processors, run

# One for packages that agree with each other.
ENVIRONMENTS: Dict[str, Tuple[str, ...]] = {
    "bonn": (
        "kiss-icp==1.3.0",
        "kiss-slam==0.0.2",
        "retro-slam==0.0.1",
        "map-closures==2.2.0",
        "open3d==0.20.0",
        "numpy==2.2.6",
        "rosbags==0.11.9",
    ),
    "genz": ("genz-icp==0.3.2", "numpy==2.2.6", "rosbags==0.11.9"),
    "evalio": ("evalio==0.6.1", "numpy==2.2.6", "rosbags==0.11.9"),
}
# The versions that all peers have packages for, the best tried first.
PYTHONS = ((3, 11), (3, 12), (3, 10))


class NotInstalled(SystemExit):
    """An environment that cannot be made here, and why."""


def candidates(wanted: str) -> Iterator[str]:
    found = shutil.which(f"python{wanted}")
    if found:
        yield found
    for folder in sorted(Path.home().glob(f".pyenv/versions/{wanted}.*"), reverse=True):
        yield str(folder / "bin" / "python3")
    yield "python3"


def version_of(python: str) -> str:
    code = "import sys, venv, ensurepip; print('%d.%d' % sys.version_info[:2])"
    try:
        return subprocess.check_output(
            [python, "-c", code], stderr=subprocess.DEVNULL, universal_newlines=True
        ).strip()
    except (OSError, subprocess.CalledProcessError):
        return ""


def suitable_python() -> str:
    for wanted in ("{}.{}".format(*version) for version in PYTHONS):
        for python in candidates(wanted):
            if version_of(python) == wanted:
                return python
    names = ", ".join("{}.{}".format(*version) for version in PYTHONS)
    raise NotInstalled(f"error: the peers need Python {names} with venv; give it with --python")


def make_environment(folder: Path, python: str, name: str = "bonn") -> Path:
    """The environment's Python; it is made anew when the requirements change."""
    folder = folder / name
    inside, note = folder / "bin" / "python", folder / "requirements"
    wanted = "\n".join(ENVIRONMENTS[name])
    if inside.exists() and note.is_file() and note.read_text() == wanted:
        return inside
    python = python or suitable_python()
    print(f"installing {', '.join(ENVIRONMENTS[name])} in {folder}", flush=True)
    log = folder.parent / f"{name}.log"
    for command in (
        [python, "-m", "venv", "--clear", folder],
        [inside, "-m", "pip", "install", "--quiet", *ENVIRONMENTS[name]],
    ):
        if run(command, log, 3600.0).status != "ok":
            raise NotInstalled(f"error: {' '.join(map(str, command))} failed; see {log}")
    note.write_text(wanted)
    return inside


class Environments:
    """Each is made when its first system runs; one that fails is tried once."""

    def __init__(self, folder: Path, python: str) -> None:
        self._folder, self._python = folder, python
        self._made: Dict[str, Path] = {}
        self._failed: Dict[str, str] = {}

    def python(self, name: str) -> Optional[Path]:
        """None if it cannot be made."""
        if name not in self._made and name not in self._failed:
            try:
                self._made[name] = make_environment(self._folder, self._python, name)
            except NotInstalled as error:
                print(f"no environment {name}: {error}", flush=True)
                self._failed[name] = str(error)
        return self._made.get(name)

    def reason(self, name: str) -> str:
        return self._failed.get(name, "")


def machine() -> str:
    model = platform.processor() or "unknown processor"
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
            break
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    used, all_of_them = len(processors()), os.cpu_count()
    return (
        f"{model}, {used} of {all_of_them} cores used, {memory:.0f} GiB, "
        f"Linux {platform.release().split('-')[0]}"
    )
