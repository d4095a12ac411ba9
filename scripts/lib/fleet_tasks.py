#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What the workers of a fleet do. Every task is known by its kind and name, and by a key: a digest of
its input, its parameters and its program. What is there with the same key is not done again."""

from __future__ import annotations

import json
import os
import shutil
import socket
from pathlib import Path
from typing import Any, Callable, Dict, List, NamedTuple, Sequence, Tuple

from fleet_process import Limits, Usage, last_lines, run
from fleet_store import (
    Record,
    Store,
    digest_of,
    digest_of_file,
    localised,
    recorded,
    stamp_of,
    write_record,
)

DONE, FAILED = "done", "failed"
MOST_THREADS = 64  # that programs take


class Site(NamedTuple):
    """What all tasks of a fleet share. versions: digests of the programs, by name."""

    store: Store
    programs: str
    versions: Dict[str, str]
    limits: Limits
    parameters: Tuple[str, ...]  # options of all programs
    parameter_files: Dict[str, str]  # their contents, by the option that names them


class Recording(NamedTuple):
    name: str
    bags: Tuple[str, ...]
    options: Tuple[str, ...] = ()  # of `offline`, for this recording


class Transient(RuntimeError):
    """May end otherwise when it is tried again."""


class Context:
    """One task at work: its scratch folder, its log, and what its programs used."""

    def __init__(self, site: Site, scratch: Path) -> None:
        self.site, self.scratch = site, scratch
        self.log = scratch / "log.txt"
        self.usage: List[Usage] = []

    def program(self, name: str) -> Path:
        path = Path(self.site.programs) / name
        if not path.is_file():
            raise Transient(f"{socket.gethostname()} has no program {path}")
        if digest_of_file(path) != self.site.versions[name]:
            raise Transient(f"{socket.gethostname()} has another version of {name}")
        return path

    def local_bag(self, number: int, url: str) -> Path:
        """Bags of other folders may have the same name."""
        folder = self.scratch / f"bag_{number}"
        folder.mkdir()
        return localised(url, folder)

    def parameters(self) -> List[str]:
        """With files where this worker can read them."""
        words = list(self.site.parameters)
        for option, content in self.site.parameter_files.items():
            file = self.scratch / f"parameters_{len(words)}.yaml"
            file.write_text(content)
            words += [option, str(file)]
        return words

    def run(self, name: str, words: Sequence[Any]) -> None:
        usage = run([self.program(name), *words], self.log, self.site.limits)
        self.usage.append(usage)
        if usage.exceeded:
            raise Transient(f"{name}: {usage.exceeded}")
        if usage.status < 0 or usage.status > 128:  # of programs that catch it
            raise Transient(f"{name}: ended by signal {abs(usage.status) % 128}")
        if usage.status > 0:
            raise Refused(name, " / ".join(last_lines(self.log)))

    def figures(self) -> Dict[str, float]:
        return {
            "wall_seconds": sum(u.wall_seconds for u in self.usage),
            "cpu_seconds": sum(u.cpu_seconds for u in self.usage),
            "peak_memory_mb": max([0.0] + [u.peak_memory_mb for u in self.usage]),
        }


class Refused(RuntimeError):
    """A program says what is wrong with its input; it would say the same again."""


def all_threads() -> int:
    return min(MOST_THREADS, len(os.sched_getaffinity(0)))


def perform(
    site: Site, kind: str, name: str, key: str, work: Callable[[Context], Dict[str, Any]]
) -> Record:
    """Does the work unless that has been done. @raise Transient what is worth another attempt."""
    known = recorded(site.store, kind, name)
    if known.get("key") == key and (known["status"] == DONE or known["lasting"]):
        return dict(known, resumed=True)
    with site.store.scratch() as scratch:
        context = Context(site, scratch)
        record: Record = dict(key=key, name=name, kind=kind, worker=socket.gethostname())
        try:
            about = work(context)
            record.update(about, status=DONE, lasting=True)
        except (Refused, Transient) as error:
            reason = " ".join(str(part) for part in error.args)
            lasting = isinstance(error, Refused)
            record.update(status=FAILED, reason=reason, lasting=lasting, **context.figures())
            if context.log.is_file():
                site.store.write(f"tasks/{kind}/{name}.log", context.log.read_bytes())
            write_record(site.store, kind, name, record)
            if not lasting:
                raise
            return dict(record, resumed=False)
        record.update(context.figures())
        write_record(site.store, kind, name, record)
        return dict(record, resumed=False)


def content_of(site: Site, recording: Recording) -> List[str]:
    """Digests of its bags; those that have not changed are not read again."""
    stamps = [stamp_of(bag) for bag in recording.bags]
    known = recorded(site.store, "inputs", recording.name)
    if known.get("stamps") == stamps:
        return list(known["digests"])
    digests = []
    with site.store.scratch() as scratch:
        for bag in recording.bags:
            digests.append(digest_of_file(localised(bag, scratch)))
    write_record(site.store, "inputs", recording.name, dict(stamps=stamps, digests=digests))
    return digests


def parameter_key(site: Site, *programs: str) -> List[Any]:
    versions = [site.versions[program] for program in programs]
    return [list(site.parameters), sorted(site.parameter_files.items()), versions]


def options_key(recording: Recording) -> List[Any]:
    """With what is in the files that the options name."""
    files = [Path(word) for word in recording.options if Path(word).is_file()]
    return [list(recording.options), [digest_of_file(file) for file in files]]


def map_recording(site: Site, recording: Recording) -> Record:
    try:
        content = content_of(site, recording)
    except OSError as error:
        reason = f"{error.strerror or error}: {error.filename or ', '.join(recording.bags)}"
        return dict(
            name=recording.name, kind="map", key="", status=FAILED, reason=reason, resumed=False
        )
    key = digest_of(
        ["map", recording.name, content, *options_key(recording)]
        + parameter_key(site, "offline", "fleet_step")
    )

    def work(context: Context) -> Dict[str, Any]:
        out, summary = context.scratch / "session", context.scratch / "summary.rss"
        words: List[Any] = ["--quiet", "--threads", 1, "--out", out]
        for number, bag in enumerate(recording.bags):
            words += ["--bag", context.local_bag(number, bag)]
        context.run("offline", [*words, *context.parameters(), *recording.options])
        context.run("fleet_step", ["summarise", out, "--name", recording.name, "--out", summary])
        run_file = json.loads((out / "run.json").read_text())
        others = sorted(folder.name for folder in out.glob("session_*"))
        (out / "lock").unlink(missing_ok=True)
        site.store.publish(out, f"sessions/{recording.name}")
        site.store.publish(summary, f"summaries/{recording.name}.rss")
        return {
            "scans": run_file["scans"]["processed"],
            "metres": run_file["path_length_m"],
            "left_out": others,
        }

    return perform(site, "map", recording.name, key, work)


def find_candidates(site: Site, mapped: Sequence[Record], options: Sequence[str]) -> Record:
    names = [record["name"] for record in mapped]
    key = digest_of(
        ["candidates", [record["key"] for record in mapped], list(options)]
        + parameter_key(site, "fleet_step")
    )

    def work(context: Context) -> Dict[str, Any]:
        summaries = [site.store.fetch(f"summaries/{name}.rss", context.scratch) for name in names]
        table = context.scratch / "candidates.csv"
        words = ["candidates", *summaries, "--out", table, "--threads", all_threads()]
        context.run("fleet_step", [*words, *options, *context.parameters()])
        site.store.publish(table, "candidates.csv")
        return {}

    return perform(site, "candidates", "all", key, work)


def register_pair(site: Site, source: Record, target: Record, table: str) -> Record:
    """table: the candidates of these two sessions, with the header."""
    name = f"{source['name']}--{target['name']}"
    key = digest_of(
        ["register", source["key"], target["key"], table] + parameter_key(site, "fleet_step")
    )

    def work(context: Context) -> Dict[str, Any]:
        candidates = context.scratch / "candidates.csv"
        candidates.write_text(table)
        crossing = context.scratch / "crossing.rsc"
        words: List[Any] = ["register", "--candidates", candidates, "--out", crossing]
        for option, record in (("--source", source), ("--target", target)):
            folder = site.store.fetch(f"sessions/{record['name']}", context.scratch)
            words += [option, record["name"], folder]
        context.run("fleet_step", [*words, "--threads", 1, *context.parameters()])
        site.store.publish(crossing, f"crossings/{name}.rsc")
        return {}

    return perform(site, "register", name, key, work)


def solve_jointly(site: Site, mapped: Sequence[Record], registered: Sequence[Record]) -> Record:
    keys = [[record["name"], record["key"]] for record in [*mapped, *registered]]
    key = digest_of(["solve", keys] + parameter_key(site, "fleet_step"))

    def work(context: Context) -> Dict[str, Any]:
        def local(name: str) -> Path:
            return site.store.fetch(name, context.scratch)

        out = context.scratch / "joint"
        words: List[Any] = ["solve", *[local(f"summaries/{r['name']}.rss") for r in mapped]]
        if registered:
            words += ["--crossings", *[local(f"crossings/{r['name']}.rsc") for r in registered]]
        words += ["--out", out, "--threads", all_threads()]
        context.run("fleet_step", [*words, *context.parameters()])
        shutil.copyfile(str(context.log), str(out / "log.txt"))
        site.store.publish(out, "joint")
        return {}

    return perform(site, "solve", "all", key, work)


def export_session(site: Site, mapped: Record, keyposes: str, options: Sequence[str]) -> Record:
    """keyposes: of the joint graph, as text."""
    name = mapped["name"]
    key = digest_of(
        ["export", mapped["key"], keyposes, list(options), site.versions["export"]]
    )

    def work(context: Context) -> Dict[str, Any]:
        out, poses = context.scratch / "map", context.scratch / "keyposes.csv"
        poses.write_text(keyposes)
        session = site.store.fetch(f"sessions/{name}", context.scratch)
        words = [session, "--out", out, "--keyposes", poses, "--quiet", *options]
        context.run("export", words)
        site.store.publish(out, f"maps/{name}")
        return {}

    return perform(site, "export", name, key, work)
