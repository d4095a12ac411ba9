#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Which recordings a fleet is made of: bags, globs of bags, or a YAML list with options of each."""

from __future__ import annotations

import glob
import re
from pathlib import Path
from typing import Any, List

import yaml

from fleet_store import filesystem, is_remote
from fleet_tasks import Recording

KEYS = {"name", "bag", "options"}


def expanded(pattern: str, base: Path) -> List[str]:
    """Of a glob the files, in order; what matches nothing stays, to be reported as missing."""
    if is_remote(pattern):
        fs, path = filesystem(pattern)
        scheme = pattern.split("://", 1)[0]
        return sorted(f"{scheme}://{found}" for found in fs.glob(path)) or [pattern]
    path = str(base / pattern)
    return sorted(glob.glob(path)) or [path]


def name_of(bag: str) -> str:
    stem = Path(bag).name
    stem = stem[:-4] if stem.endswith(".bag") else stem
    return re.sub(r"[^A-Za-z0-9._-]", "_", stem)


def entry_of(entry: Any, base: Path, where: str) -> List[Recording]:
    if isinstance(entry, str):
        return [Recording(name_of(bag), (bag,)) for bag in expanded(entry, base)]
    if not isinstance(entry, dict) or "bag" not in entry or set(entry) - KEYS:
        raise SystemExit(f"error: {where}: give a bag, or 'bag' with {', '.join(sorted(KEYS))}")
    given = entry["bag"] if isinstance(entry["bag"], list) else [entry["bag"]]
    bags = [bag for pattern in given for bag in expanded(str(pattern), base)]
    options = tuple(str(word) for word in entry.get("options", []))
    return [Recording(str(entry.get("name", name_of(bags[0]))), tuple(bags), options)]


def read_list(path: Path) -> List[Recording]:
    content = yaml.safe_load(path.read_text())
    entries = content.get("recordings") if isinstance(content, dict) else None
    if not isinstance(entries, list):
        raise SystemExit(f"error: {path}: there is no list 'recordings'")
    found: List[Recording] = []
    for number, entry in enumerate(entries, 1):
        found += entry_of(entry, path.parent, f"{path}: recording {number}")
    return found


def recordings(given: List[str]) -> List[Recording]:
    """In the order given. The name of each is a folder and part of file names."""
    found: List[Recording] = []
    for word in given:
        if word.endswith((".yaml", ".yml")):
            found += read_list(Path(word))
        else:
            found += entry_of(word, Path.cwd(), word)
    names = [recording.name for recording in found]
    for name in names:
        if names.count(name) > 1:
            raise SystemExit(f"error: two recordings have the name {name}: name them in a YAML file")
        if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]*", name) or "--" in name:
            raise SystemExit(f"error: '{name}' is no name: letters, digits, '.', '_' and single '-'")
    return found
