"""Small tables as text and as HTML, and pages of a notebook."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from html import escape

CLASS = "ancf-repr"
"""Class of the elements of all HTML representations."""

STYLE = f"""<style>
.{CLASS} {{ font-size: 13px; line-height: 1.5; max-width: 70em; overflow-x: auto; }}
.{CLASS} p {{ margin: 0 0 4px; }}
.{CLASS} table {{ color: inherit; font-size: inherit; border-collapse: collapse; margin: 2px 0 6px; }}
.{CLASS} th, .{CLASS} td {{ border: 0; padding: 1px 14px 1px 0; text-align: left; vertical-align: top; }}
.{CLASS} th {{ font-weight: 600; }}
.{CLASS} thead th {{ border-bottom: 1px solid rgba(128, 128, 128, 0.5); opacity: 0.75; }}
.{CLASS} .number {{ text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }}
.{CLASS} .faint {{ opacity: 0.7; }}
.{CLASS} summary {{ cursor: pointer; }}
.{CLASS} details > table {{ margin-left: 14px; }}
</style>"""
"""Style of all HTML representations. Colours are those of the notebook, light or dark."""


@dataclass(frozen=True)
class Table:
    """Table of texts. The first `names` and the last `notes` columns are aligned as texts, the others as numbers."""

    header: Sequence[str]
    rows: Sequence[Sequence[str]]
    names: int = 1
    notes: int = 0

    def text(self, indent: str = "") -> str:
        """Return aligned lines, without a header if it is empty."""
        rows = [self.header, *self.rows] if any(self.header) else list(self.rows)
        widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
        return "\n".join(indent + self._line(row, widths) for row in rows)

    def _line(self, row: Sequence[str], widths: Sequence[int]) -> str:
        cells = [
            cell.rjust(width) if self._is_number(i) else cell.ljust(width)
            for i, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        return "  ".join(cells).rstrip()

    def _is_number(self, column: int) -> bool:
        return self.names <= column < len(self.header) - self.notes

    def html(self) -> str:
        """Return the table as HTML. Texts are escaped."""
        head = f"<thead>{self._row('th', self.header)}</thead>" if any(self.header) else ""
        rows = "".join(self._row("td", row) for row in self.rows)
        return f"<table>{head}<tbody>{rows}</tbody></table>"

    def _row(self, tag: str, cells: Sequence[str]) -> str:
        kinds = [' class="number"' if self._is_number(i) else "" for i in range(len(cells))]
        inner = "".join(
            f"<{tag}{kind}>{escape(cell)}</{tag}>" for kind, cell in zip(kinds, cells, strict=True)
        )
        return f"<tr>{inner}</tr>"


def titled(kind: str, title: str = "") -> str:
    """Return the heading of a representation as HTML."""
    own = f' <span class="faint">{escape(title)}</span>' if title else ""
    return f"<p><strong>{escape(kind)}</strong>{own}</p>"


def collapsible(title: str, inner: str, *, is_open: bool) -> str:
    """Return a part of a representation that can be collapsed. `inner` is HTML."""
    return f"<details{' open' if is_open else ''}><summary>{escape(title)}</summary>{inner}</details>"


def representation(parts: Iterable[str]) -> str:
    """Return the HTML representation of an object from its parts, which are HTML."""
    return f'<div class="{CLASS}">{STYLE}{"".join(parts)}</div>'


def joined(names: Sequence[str], width: int = 60) -> str:
    """Return names separated by commas. The middle of a long list is omitted."""
    text = ", ".join(names)
    if len(text) <= width or len(names) < 4:
        return text
    shown = 1
    while shown < len(names) - 2 and len(", ".join([*names[: shown + 1], "...", names[-1]])) <= width:
        shown += 1
    return ", ".join([*names[:shown], "...", names[-1]])
