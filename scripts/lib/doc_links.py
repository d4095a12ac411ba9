#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Links between the pages of the documentation, and in the site that is made of them."""

from __future__ import annotations

import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from typing import Iterator, List, Set, Tuple
from urllib.parse import unquote, urlsplit

FENCE = re.compile(r"^(```|~~~).*?^\1", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`[^`\n]*`")
LINK = re.compile(r"\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#{1,6} +(.*?) *#* *$", re.MULTILINE)


def pages(root: Path) -> List[Path]:
    return [root / "README.md", root / "CONTRIBUTING.md", *sorted((root / "docs").glob("*.md"))]


def anchor_of(heading: str) -> str:
    """As GitHub makes it; mkdocs.yml asks for the same."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


def anchors_of(page: Path) -> Set[str]:
    anchors: Set[str] = set()
    for heading in HEADING.findall(FENCE.sub("", page.read_text())):
        anchor, number = anchor_of(heading), 0
        while (name := f"{anchor}-{number}" if number else anchor) in anchors:
            number += 1
        anchors.add(name)
    return anchors


def links_of(page: Path) -> List[str]:
    return LINK.findall(CODE.sub("", FENCE.sub("", page.read_text())))


def dead_links(root: Path) -> Iterator[str]:
    """One line for each link of a page that leads nowhere; other sites are not asked."""
    for page in pages(root):
        for link in links_of(page):
            parts = urlsplit(link)
            if parts.scheme:
                continue
            target = page.parent / unquote(parts.path) if parts.path else page
            name = page.relative_to(root)
            if not target.exists():
                yield f"{name}: {link}: there is no such file"
            elif parts.fragment and parts.fragment not in anchors_of(target):
                yield f"{name}: {link}: there is no such heading"


class SitePage(HTMLParser):
    """What a page of the site links to, and what can be linked to in it."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.links: List[str] = []
        self.ids: Set[str] = {""}
        self.feed(path.read_text())

    def handle_starttag(self, tag: str, attributes: List[Tuple[str, str | None]]) -> None:
        values = dict(attributes)
        self.ids.add(values.get("id") or "")
        link = values.get("href") if tag == "a" else values.get("src") if tag == "img" else None
        if link:
            self.links.append(link)


def dead_links_of_site(site: Path) -> Iterator[str]:
    read = {path.resolve(): SitePage(path) for path in sorted(site.rglob("*.html"))}
    for path, page in read.items():
        if path.name == "404.html":  # its links count from the root of a server
            continue
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if target.is_dir():
                target /= "index.html"
            name = path.relative_to(site.resolve())
            if not target.exists():
                yield f"{name}: {link}: there is no such file"
            elif target in read and unquote(parts.fragment) not in read[target].ids:
                yield f"{name}: {link}: there is no such heading"


def main() -> int:
    folder = Path(sys.argv[1])
    is_site = (folder / "index.html").exists()
    dead = list(dead_links_of_site(folder) if is_site else dead_links(folder))
    for line in dead:
        print(line, file=sys.stderr)
    return 1 if dead else 0


if __name__ == "__main__":
    sys.exit(main())
