#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Count the test cases that ctest left in a build tree and print them as the last line."""

from __future__ import annotations

import argparse
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import NamedTuple, Tuple


class Count(NamedTuple):
    """Outcome of test cases."""

    passed: int = 0
    failed: int = 0
    skipped: int = 0

    def plus(self, other: "Count") -> "Count":
        return Count(*(a + b for a, b in zip(self, other)))

    def __str__(self) -> str:
        text = f"{self.passed} passed, {self.failed} failed"
        return f"{text}, {self.skipped} skipped" if self.skipped else text


def outcome(case: ElementTree.Element) -> Count:
    if case.find("failure") is not None or case.find("error") is not None:
        return Count(failed=1)
    not_run = case.get("status") == "notrun" or case.get("result") in ("skipped", "suppressed")
    if not_run or case.find("skipped") is not None:
        return Count(skipped=1)
    return Count(passed=1)


def count_file(path: Path) -> Count:
    """A result file that cannot be read is a failure: its program died while writing it.

    rostest wraps every <test> in a case of its own, beside the file in which the test program
    reports its cases. A wrapper tells something new only when it failed.
    """
    try:
        root = ElementTree.parse(str(path)).getroot()
    except (ElementTree.ParseError, OSError):
        return Count(failed=1)
    total = Count()
    for case in root.iter("testcase"):
        total = total.plus(outcome(case))
    if path.name.startswith("rostest-"):
        return Count(failed=total.failed)
    return total


def count_results(results: Path) -> Tuple[Count, int]:
    """All cases below a folder, and the number of files with a failure."""
    total, failed_files = Count(), 0
    for path in sorted(results.rglob("*.xml")):
        count = count_file(path)
        total = total.plus(count)
        failed_files += count.failed > 0
    return total, failed_files


def failed_programs(build: Path) -> int:
    log = build / "Testing" / "Temporary" / "LastTestsFailed.log"
    return len(log.read_text().splitlines()) if log.is_file() else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path, help="build tree")
    build = parser.parse_args().build

    total, failed_files = count_results(build / "test_results")
    silent = failed_programs(build) - failed_files
    if silent > 0:
        print(f"{silent} failed test programs left no failing result: each counts as one failure")
        total = total.plus(Count(failed=silent))
    if total.passed + total.failed == 0:
        print("no test case ran")
    print(total)
    return 1 if total.failed or not total.passed else 0


if __name__ == "__main__":
    sys.exit(main())
