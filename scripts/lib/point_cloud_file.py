#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Point coordinates from PCD files, ascii or binary."""

from __future__ import annotations

from pathlib import Path
from typing import BinaryIO, Dict, List

import numpy as np

NUMBER_KINDS = {"F": "f", "I": "i", "U": "u"}


def read_header(file: BinaryIO) -> Dict[str, List[str]]:
    header: Dict[str, List[str]] = {}
    while "DATA" not in header:
        line = file.readline()
        if not line:
            raise ValueError("not a PCD file: no DATA line")
        words = line.decode("ascii", "replace").split()
        if words and not words[0].startswith("#"):
            header[words[0]] = words[1:]
    return header


def point_layout(header: Dict[str, List[str]]) -> np.dtype:
    counts = [int(text) for text in header.get("COUNT", ["1"] * len(header["FIELDS"]))]
    fields = []
    for number, name in enumerate(header["FIELDS"]):
        kind = "<" + NUMBER_KINDS[header["TYPE"][number]] + header["SIZE"][number]
        # Padding fields are all called "_".
        fields.append((name if name in "xyz" else f"{name}{number}", kind, (counts[number],)))
    return np.dtype(fields)


def read_binary(path: Path, offset: int, header: Dict[str, List[str]], step: int) -> np.ndarray:
    """Mapped, so that only what is kept is held in memory."""
    count = int(header["POINTS"][0])
    cloud = np.memmap(str(path), point_layout(header), "r", offset, shape=(count,))[::step]
    return np.column_stack([cloud[axis][:, 0].astype(np.float32) for axis in "xyz"])


def read_ascii(file: BinaryIO, header: Dict[str, List[str]], step: int) -> np.ndarray:
    columns = [header["FIELDS"].index(axis) for axis in "xyz"]
    table = np.loadtxt(file, dtype=np.float32, usecols=columns, ndmin=2)
    return table[::step]


def read_pcd(path: Path, at_most: int) -> np.ndarray:
    """x, y, z of every n-th point, so that about `at_most` remain, without what is not finite."""
    with open(str(path), "rb") as file:
        header = read_header(file)
        count = int(header["POINTS"][0])
        if count == 0:
            return np.zeros((0, 3), np.float32)
        step = max(1, count // at_most)
        if header["DATA"] == ["binary"]:
            points = read_binary(path, file.tell(), header, step)
        elif header["DATA"] == ["ascii"]:
            points = read_ascii(file, header, step)
        else:
            raise ValueError(f"PCD data of kind {' '.join(header['DATA'])} is not supported")
    return points[np.isfinite(points).all(axis=1)]
