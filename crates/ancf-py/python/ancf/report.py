"""A page about a result."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from ancf import _ancf

if TYPE_CHECKING:
    import os

    from ancf.result import Result


class Report:
    """A page with bodies that move and charts; it needs no network. A notebook shows it."""

    def __init__(self, html: str) -> None:
        """The page of a text."""
        self.html = html
        """The whole page."""

    @classmethod
    def of(cls, result: Result, title: str | None = None) -> Report:
        """The page of a result."""
        frames = [float(value) for value in result.frames]
        return cls(_ancf.report(result.states, result.columns, result.data, frames, result.summary, title))

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write it to a file."""
        Path(path).write_text(self.html, encoding="utf-8")

    def _repr_html_(self) -> str:
        # In a frame of its own, so that its scripts and styles and those of the notebook do not meet.
        return (
            '<iframe sandbox="allow-scripts allow-downloads" width="100%" height="640" style="border: 0" '
            f'srcdoc="{escape(self.html)}"></iframe>'
        )

    def __repr__(self) -> str:
        return f"Report({len(self.html) / 1e6:.1f} MB)"
