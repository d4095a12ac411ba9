#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs programs, one at a time, and sees what they and the rest of the machine used."""

from __future__ import annotations

import os
import signal
import subprocess
import time
from pathlib import Path
from typing import Any, List, NamedTuple, Sequence, Set


class Outcome(NamedTuple):
    """status: ok, failed or timeout. others: share of our processors that other programs took."""

    status: str
    wall_seconds: float
    cpu_seconds: float
    others: float


def processors() -> Set[int]:
    return set(os.sched_getaffinity(0))


def used_seconds() -> float:
    """Processor time that anything has used on the processors that we may use."""
    ours = {f"cpu{number}" for number in processors()}
    seconds = 0.0
    for line in Path("/proc/stat").read_text().splitlines():
        name, *ticks = line.split()
        if name in ours:
            user, nice, system, _, _, irq, softirq, steal = map(int, ticks[:8])
            seconds += user + nice + system + irq + softirq + steal
    return seconds / os.sysconf("SC_CLK_TCK")


def run(command: Sequence[Any], log: Path, timeout: float) -> Outcome:
    """Ends the program and its children after `timeout` seconds, or where it is interrupted."""
    log.parent.mkdir(parents=True, exist_ok=True)
    used, start = used_seconds(), time.monotonic()
    with open(str(log), "w") as file:
        process = subprocess.Popen(
            [str(word) for word in command],
            stdin=subprocess.DEVNULL,
            stdout=file,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        timed_out = False
        try:
            done, status, usage = os.wait4(process.pid, os.WNOHANG)
            while not done:
                time.sleep(0.1)
                if not timed_out and time.monotonic() - start > timeout:
                    os.killpg(process.pid, signal.SIGKILL)
                    timed_out = True
                done, status, usage = os.wait4(process.pid, os.WNOHANG)
        except BaseException:  # Ctrl-C, which does not reach the program's own session
            os.killpg(process.pid, signal.SIGKILL)
            raise
    process.returncode = status
    wall, cpu = time.monotonic() - start, usage.ru_utime + usage.ru_stime
    others = (used_seconds() - used - cpu) / (wall * len(processors()))
    word = "timeout" if timed_out else "ok" if status == 0 else "failed"
    return Outcome(word, wall, cpu, max(0.0, others))


def tail(log: Path, lines: int = 20) -> List[str]:
    return log.read_text(errors="replace").splitlines()[-lines:]


def run_or_stop(command: Sequence[Any], log: Path, timeout: float = 3600.0) -> None:
    outcome = run(command, log, timeout)
    if outcome.status != "ok":
        text = "\n".join(tail(log))
        raise SystemExit(f"{text}\nerror: {command[0]}: {outcome.status}; see {log}")
