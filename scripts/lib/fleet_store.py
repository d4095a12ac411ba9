#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Where recordings come from and results go: a shared folder, or anything that fsspec reaches."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import tempfile
import uuid
from pathlib import Path
from typing import Any, Dict, List, Optional

BLOCK = 1 << 22


def is_remote(url: str) -> bool:
    return "://" in url


def filesystem(url: str) -> Any:
    import fsspec

    return fsspec.core.url_to_fs(url)


def digest_of_file(path: Path) -> str:
    total = hashlib.sha256()
    with open(str(path), "rb") as file:
        for block in iter(lambda: file.read(BLOCK), b""):
            total.update(block)
    return total.hexdigest()


def digest_of(value: Any) -> str:
    """Of whatever JSON can say."""
    return hashlib.sha256(json.dumps(value, sort_keys=True).encode()).hexdigest()


def stamp_of(url: str) -> List[Any]:
    """What changes when a file does, without reading it."""
    if not is_remote(url):
        file = Path(url).stat()
        return [url, file.st_size, file.st_mtime_ns]
    fs, path = filesystem(url)
    about = fs.info(path)
    changed = about.get("ETag") or about.get("mtime") or about.get("LastModified") or ""
    return [url, about["size"], str(changed)]


def localised(url: str, folder: Path) -> Path:
    """A file, copied into the folder where it is remote."""
    if not is_remote(url):
        return Path(url)
    fs, path = filesystem(url)
    local = folder / Path(path).name
    fs.get_file(path, str(local))
    return local


class Scratch:
    """A folder of one task, removed when it ends."""

    def __init__(self, parent: Optional[Path]) -> None:
        if parent:
            parent.mkdir(parents=True, exist_ok=True)
        self.path = Path(tempfile.mkdtemp(prefix="fleet_", dir=str(parent) if parent else None))

    def __enter__(self) -> Path:
        return self.path

    def __exit__(self, *_: Any) -> None:
        shutil.rmtree(str(self.path), ignore_errors=True)


class Store:
    """The results of a fleet. Names are relative paths; what is published is there as a whole."""

    def __init__(self, url: str) -> None:
        self.url = url if is_remote(url) else str(Path(url).resolve())
        self.remote = is_remote(url)

    def __reduce__(self) -> Any:
        return (Store, (self.url,))

    def _where(self, name: str) -> str:
        return f"{self.url.rstrip('/')}/{name}"

    def scratch(self) -> Scratch:
        """Beside the results, so that publishing is renaming; elsewhere where these are remote."""
        return Scratch(None if self.remote else Path(self._where(".parts")))

    def clear_scratch(self) -> None:
        if not self.remote:
            shutil.rmtree(self._where(".parts"), ignore_errors=True)

    def read(self, name: str) -> Optional[bytes]:
        """None if there is none."""
        try:
            if not self.remote:
                return Path(self._where(name)).read_bytes()
            fs, path = filesystem(self._where(name))
            return bytes(fs.cat_file(path))
        except FileNotFoundError:
            return None

    def write(self, name: str, data: bytes) -> None:
        if self.remote:
            fs, path = filesystem(self._where(name))
            fs.makedirs(path.rsplit("/", 1)[0], exist_ok=True)
            fs.pipe_file(path, data)
            return
        path = Path(self._where(name))
        path.parent.mkdir(parents=True, exist_ok=True)
        part = path.with_name(f".{path.name}.{uuid.uuid4().hex}")
        part.write_bytes(data)
        os.replace(str(part), str(path))

    def publish(self, local: Path, name: str) -> None:
        """A file or folder of a scratch folder, in the place of what was there."""
        if self.remote:
            fs, path = filesystem(self._where(name))
            if fs.exists(path):
                fs.rm(path, recursive=True)
            for file in [local] if local.is_file() else sorted(local.rglob("*")):
                if file.is_file():
                    end = "" if local.is_file() else "/" + str(file.relative_to(local))
                    fs.makedirs((path + end).rsplit("/", 1)[0], exist_ok=True)
                    fs.put_file(str(file), path + end)
            return
        path = Path(self._where(name))
        path.parent.mkdir(parents=True, exist_ok=True)
        if local.is_file():
            os.replace(str(local), str(path))
            return
        if path.exists():  # moved away first: a folder cannot be replaced at once
            os.replace(str(path), str(local.parent / f"old_{uuid.uuid4().hex}"))
        try:
            os.rename(str(local), str(path))
        except OSError:  # another worker had the same task, and was faster
            if not path.is_dir():
                raise

    def fetch(self, name: str, scratch: Path) -> Path:
        """A local copy of a published file or folder; the thing itself where it is local."""
        if not self.remote:
            return Path(self._where(name))
        fs, path = filesystem(self._where(name))
        local = scratch / "fetched" / name
        local.parent.mkdir(parents=True, exist_ok=True)
        if fs.isdir(path):
            for file in fs.find(path):
                target = local / os.path.relpath(file, path)
                target.parent.mkdir(parents=True, exist_ok=True)
                fs.get_file(file, str(target))
        else:
            fs.get_file(path, str(local))
        return local


# What is remembered of a task: tasks/KIND/NAME.json, written when all else is there.
Record = Dict[str, Any]


def record_name(kind: str, name: str) -> str:
    return f"tasks/{kind}/{name}.json"


def recorded(store: Store, kind: str, name: str) -> Record:
    data = store.read(record_name(kind, name))
    return json.loads(data) if data else {}


def write_record(store: Store, kind: str, name: str, record: Record) -> None:
    store.write(record_name(kind, name), json.dumps(record, indent=1, sort_keys=True).encode())
