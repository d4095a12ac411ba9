#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The stages of a fleet on the workers of Dask: map, find candidates, register, solve, export."""

from __future__ import annotations

import csv
import io
import time
from typing import Any, Callable, Dict, List, NamedTuple, Sequence, Tuple

import fleet_tasks as tasks
from fleet_progress import Progress
from fleet_store import Record, digest_of
from fleet_tasks import DONE, FAILED, Recording, Site

Work = Tuple[str, Callable[..., Record], Tuple[Any, ...]]  # name, function, arguments


class Outcome(NamedTuple):
    """Records of all tasks, by stage in the order of the stages."""

    records: Dict[str, List[Record]]
    seconds: Dict[str, float]

    def done(self, stage: str) -> List[Record]:
        return [record for record in self.records.get(stage, []) if record["status"] == DONE]


class Fleet:
    def __init__(self, client: Any, site: Site, retries: int, progress: Progress) -> None:
        self.client, self.site, self.retries, self.progress = client, site, retries, progress
        self.outcome = Outcome({}, {})

    def stage(self, stage: str, works: Sequence[Work]) -> List[Record]:
        """All of them, in parallel. A task that fails is reported, and the others go on."""
        from distributed import as_completed

        begin = time.monotonic()
        self.progress.begin(stage, len(works))
        futures = {}
        for name, function, arguments in works:
            key = f"{stage}-{name}-{digest_of([time.time_ns(), name])[:16]}"
            future = self.client.submit(
                function, self.site, *arguments, key=key, pure=False, retries=self.retries
            )
            futures[future] = name
        records: Dict[str, Record] = {}
        for future in as_completed(futures):
            name = futures[future]
            records[name] = self.result(stage, name, future)
            record = records[name]
            if record["status"] == FAILED:
                self.progress.say(f"{stage} {name} failed: {record['reason']}")
            self.progress.advance(record["status"] == FAILED, record.get("resumed", False))
            future.release()
        ordered = [records[name] for name, _, _ in works]
        self.outcome.records[stage] = ordered
        self.outcome.seconds[stage] = time.monotonic() - begin
        return ordered

    def result(self, stage: str, name: str, future: Any) -> Record:
        error = future.exception()
        if error is None:
            return future.result()
        if type(error).__name__ == "KilledWorker":
            reason = "its workers died, each time that it was tried"
        else:
            reason = str(error) or type(error).__name__
        reason += f" (tried {self.retries + 1} times)"
        return dict(name=name, kind=stage, status=FAILED, reason=reason, resumed=False)

    def run(
        self,
        recordings: Sequence[Recording],
        candidate_options: Sequence[str],
        export_options: Sequence[str],
    ) -> Outcome:
        self.stage("map", [(r.name, tasks.map_recording, (r,)) for r in recordings])
        mapped = self.outcome.done("map")
        if not mapped:
            return self.outcome
        if not self.join(mapped, candidate_options):
            return self.outcome
        self.export(mapped, export_options)
        return self.outcome

    def join(self, mapped: List[Record], candidate_options: Sequence[str]) -> bool:
        if len(mapped) > 1:
            self.stage(
                "candidates", [("all", tasks.find_candidates, (mapped, tuple(candidate_options)))]
            )
            if not self.outcome.done("candidates"):
                return False
            self.stage("register", self.pairs(mapped))
        registered = self.outcome.done("register")
        self.stage("solve", [("all", tasks.solve_jointly, (mapped, registered))])
        return bool(self.outcome.done("solve"))

    def pairs(self, mapped: List[Record]) -> List[Work]:
        """One task for every two sessions that have candidates."""
        by_name = {record["name"]: record for record in mapped}
        text = (self.site.store.read("candidates.csv") or b"").decode()
        lines = text.splitlines(keepends=True)
        tables: Dict[Tuple[str, str], str] = {}
        for line in lines[1:]:
            source, _, target, _ = line.split(",", 3)
            tables[source, target] = tables.get((source, target), lines[0]) + line
        return [
            (f"{source}--{target}", tasks.register_pair, (by_name[source], by_name[target], table))
            for (source, target), table in sorted(tables.items())
        ]

    def export(self, mapped: List[Record], options: Sequence[str]) -> None:
        works: List[Work] = []
        for record in mapped:
            name = record["name"]
            keyposes = (self.site.store.read(f"joint/keyposes/{name}.csv") or b"").decode()
            works.append((name, tasks.export_session, (record, keyposes, tuple(options))))
        self.stage("export", works)


def table_of(site: Site, name: str) -> List[Dict[str, str]]:
    data = site.store.read(name)
    return list(csv.DictReader(io.StringIO(data.decode()))) if data else []
