#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""One display of how far a fleet is: a line that stays on a terminal, lines every ten per cent elsewhere."""

from __future__ import annotations

import sys
import time


class Progress:
    def __init__(self, quiet: bool) -> None:
        self.quiet, self.terminal = quiet, sys.stderr.isatty()
        self.start = time.monotonic()

    def begin(self, stage: str, total: int) -> None:
        self.stage, self.total, self.done, self.failed, self.resumed = stage, total, 0, 0, 0
        self.began, self.said = time.monotonic(), -1
        self.draw()

    def advance(self, failed: bool, resumed: bool) -> None:
        self.done += 1
        self.failed += failed
        self.resumed += resumed
        self.draw()

    def text(self) -> str:
        fresh = self.done - self.resumed
        words = f"{self.stage:<12} {self.done}/{self.total}"
        if self.resumed:
            words += f", {self.resumed} were there"
        if self.failed:
            words += f", {self.failed} failed"
        if fresh and self.done < self.total:
            left = (time.monotonic() - self.began) / fresh * (self.total - self.done)
            words += f", {left:.0f} s left"
        return words

    def draw(self) -> None:
        tenth = 10 * self.done // max(1, self.total)
        if self.quiet or (not self.terminal and tenth == self.said):
            return
        self.said = tenth
        if self.terminal:
            bar = "#" * (30 * self.done // max(1, self.total))
            sys.stderr.write(f"\r\033[K[{bar:<30}] {self.text()}")
            if self.done == self.total:
                sys.stderr.write("\n")
        else:
            sys.stderr.write(self.text() + "\n")
        sys.stderr.flush()

    def say(self, line: str) -> None:
        """A line of its own that does not tear the bar."""
        if self.terminal and not self.quiet:
            sys.stderr.write("\r\033[K")
        sys.stderr.write(line + "\n")
        sys.stderr.flush()
