#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs one program within limits of memory and time, and takes it along when its worker dies."""

from __future__ import annotations

import ctypes
import os
import signal
import subprocess
import time
from pathlib import Path
from typing import Any, List, NamedTuple, Sequence

POLL_SECONDS = 0.1
PR_SET_PDEATHSIG = 1  # linux/prctl.h


class Limits(NamedTuple):
    """0: none."""

    memory_mb: float = 0.0
    seconds: float = 0.0


class Usage(NamedTuple):
    """status: of the process, negative for a signal. exceeded: the limit that ended it, if any."""

    status: int
    exceeded: str
    wall_seconds: float
    cpu_seconds: float
    peak_memory_mb: float


def live_with_parent() -> None:
    """A worker that is killed leaves no program behind, which would go on writing; and what is typed
    in a terminal is for the fleet, which ends its programs."""
    os.setpgrp()
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def resident_mb(process: int) -> float:
    try:
        pages = int(Path(f"/proc/{process}/statm").read_text().split()[1])
    except (OSError, IndexError):
        return 0.0
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


def run(command: Sequence[Any], log: Path, limits: Limits) -> Usage:
    start = time.monotonic()
    exceeded = ""
    with open(str(log), "ab") as file:
        process = subprocess.Popen(
            [str(word) for word in command],
            stdin=subprocess.DEVNULL,
            stdout=file,
            stderr=subprocess.STDOUT,
            preexec_fn=live_with_parent,
        )
        done, status, usage = os.wait4(process.pid, os.WNOHANG)
        while not done:
            time.sleep(POLL_SECONDS)
            if limits.seconds and time.monotonic() - start > limits.seconds:
                exceeded = f"it took more than {limits.seconds / 60:g} min"
            if limits.memory_mb and resident_mb(process.pid) > limits.memory_mb:
                exceeded = f"it took more than {limits.memory_mb / 1000:g} GB of memory"
            if exceeded:
                process.kill()
            done, status, usage = os.wait4(process.pid, 0 if exceeded else os.WNOHANG)
    code = -os.WTERMSIG(status) if os.WIFSIGNALED(status) else os.WEXITSTATUS(status)
    process.returncode = code
    cpu = usage.ru_utime + usage.ru_stime
    return Usage(code, exceeded, time.monotonic() - start, cpu, usage.ru_maxrss / 1e3)


def last_lines(log: Path, lines: int = 3) -> List[str]:
    if not log.is_file():
        return []
    return [line for line in log.read_text(errors="replace").splitlines() if line.strip()][-lines:]
