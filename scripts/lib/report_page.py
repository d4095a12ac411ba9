#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The page of the report: HTML with its style and pictures inside, so that one file travels."""

from __future__ import annotations

import base64
import html
from pathlib import Path
from typing import Any, Dict, List, Sequence, Tuple

STYLE = """
:root { --ink: #1f2a33; --muted: #66727d; --line: #e3e8ec; --soft: #f6f8f9; --accent: #1f6f9c; }
* { box-sizing: border-box; }
body { margin: 0; background: #fff; color: var(--ink);
       font: 16px/1.55 system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; }
main { max-width: 1040px; margin: 0 auto; padding: 40px 24px 72px; }
h1 { font-size: 28px; font-weight: 600; margin: 0; letter-spacing: -0.01em; }
h2 { font-size: 19px; font-weight: 600; margin: 48px 0 12px; }
h3 { font-size: 15px; font-weight: 600; margin: 24px 0 8px; color: var(--muted); }
p.note { color: var(--muted); font-size: 14px; margin: 6px 0 0; max-width: 46em; }
.figures { display: flex; flex-wrap: wrap; gap: 1px;
           background: var(--line); border: 1px solid var(--line); border-radius: 8px;
           overflow: hidden; margin-top: 28px; }
.figures div { background: #fff; padding: 14px 16px; flex: 1 1 22%; min-width: 140px; }
.figures b { display: block; font-size: 22px; font-weight: 600;
             font-variant-numeric: tabular-nums; }
.figures span { color: var(--muted); font-size: 13.5px; }
img { display: block; width: 100%; height: auto; }
table { border-collapse: collapse; font-size: 14.5px; font-variant-numeric: tabular-nums; }
table.wide { width: 100%; }
th, td { text-align: left; padding: 5px 20px 5px 0; border-bottom: 1px solid var(--line);
         vertical-align: top; }
th { color: var(--muted); font-weight: 500; font-size: 13.5px; }
td.number, th.number { text-align: right; }
td:last-child, th:last-child { padding-right: 0; }
td.name { white-space: nowrap; }
.columns { columns: 2; column-gap: 48px; }
.columns section { break-inside: avoid; padding-top: 14px; }
.columns table { width: 100%; }
.columns h3 { margin: 0 0 4px; }
code { font: 13px/1.4 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
footer { margin-top: 56px; color: var(--muted); font-size: 13.5px; }
@media (max-width: 720px) { .columns { columns: 1; } }
@media print { h2 { break-after: avoid; } img { break-inside: avoid; } }
"""

Cells = Sequence[Any]


def number_text(value: float) -> str:
    """Six significant digits at most, thin spaces between the thousands of counts."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int):
        return f"{value:,}".replace(",", "\u202f")
    return f"{value:.6g}"


def cell_text(value: Any) -> str:
    if value is None or value == "":
        return "–"
    if isinstance(value, (bool, int, float)):
        return number_text(value)
    if isinstance(value, (list, tuple)):
        return html.escape(", ".join(cell_text(item) for item in value))
    return html.escape(str(value))


def row_html(cells: Cells, tag: str, numbers_from: int) -> str:
    parts = []
    for column, cell in enumerate(cells):
        kind = "number" if column >= numbers_from else "name"
        parts.append(f'<{tag} class="{kind}">{cell_text(cell)}</{tag}>')
    return "<tr>" + "".join(parts) + "</tr>"


def table(
    rows: Sequence[Cells], head: Cells = (), numbers_from: int = 1, wide: bool = False
) -> str:
    lines = [f'<table{" class=wide" if wide else ""}>']
    if head:
        lines.append(row_html(head, "th", numbers_from))
    lines += [row_html(cells, "td", numbers_from) for cells in rows]
    return "\n".join(lines + ["</table>"])


def readable(key: str) -> str:
    return key.replace("_", " ")


def flat_rows(values: Dict[str, Any], prefix: str = "") -> List[Tuple[str, Any]]:
    """Names as the runner's --set takes them: group/name."""
    rows: List[Tuple[str, Any]] = []
    for key, value in values.items():
        if isinstance(value, dict):
            rows += flat_rows(value, f"{prefix}{key}/")
        else:
            rows.append((f"{prefix}{key}", value))
    return rows


def grouped_tables(values: Dict[str, Any]) -> str:
    """A table for each group of nested values, and one for those in no group."""
    loose = {key: value for key, value in values.items() if not isinstance(value, dict)}
    groups = {key: value for key, value in values.items() if isinstance(value, dict) and value}
    parts = []
    if loose:
        parts.append("<section><h3>general</h3>" + table(list(loose.items())) + "</section>")
    for key, group in groups.items():
        title = f"<h3>{html.escape(readable(key))}</h3>"
        parts.append("<section>" + title + table(flat_rows(group)) + "</section>")
    return '<div class="columns">' + "\n".join(parts) + "</div>"


def figures(values: Sequence[Tuple[str, str]]) -> str:
    cells = [f"<div><b>{html.escape(v)}</b><span>{html.escape(t)}</span></div>" for t, v in values]
    return '<div class="figures">' + "\n".join(cells) + "</div>"


def image(path: Path, description: str) -> str:
    data = base64.b64encode(path.read_bytes()).decode("ascii")
    return f'<img alt="{html.escape(description)}" src="data:image/png;base64,{data}">'


def section(title: str, *parts: str) -> str:
    return f"<h2>{html.escape(title)}</h2>\n" + "\n".join(part for part in parts if part)


def note(text: str) -> str:
    return f'<p class="note">{html.escape(text)}</p>'


def page(title: str, subtitle: str, sections: Sequence[str], footer: str) -> str:
    return "\n".join(
        [
            "<!doctype html>",
            '<html lang="en"><head><meta charset="utf-8">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"<title>{html.escape(title)}</title><style>{STYLE}</style></head><body><main>",
            f"<h1>{html.escape(title)}</h1>{note(subtitle)}",
            *sections,
            f"<footer>{html.escape(footer)}</footer>",
            "</main></body></html>\n",
        ]
    )
