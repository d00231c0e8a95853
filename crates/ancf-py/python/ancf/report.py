"""Reports of results as HTML pages."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from ancf import _ancf

if TYPE_CHECKING:
    import os

    from ancf.record.result_data import ResultData


class Report:
    """A page with an animated scene and charts. It needs no network and shows itself in a notebook."""

    def __init__(self, html: str) -> None:
        """Store the text of the page."""
        self.html = html
        """Text of the page."""

    @classmethod
    def of(cls, result: ResultData, title: str | None = None) -> Report:
        """Create the page of a result."""
        frames = [float(value) for value in result.frames]
        return cls(_ancf.report(result.states, result.columns, result.data, frames, result.summary, title))

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write the page to a file."""
        Path(path).write_text(self.html, encoding="utf-8")

    def _repr_html_(self) -> str:
        # A frame isolates the scripts and styles of the page from those of the notebook.
        return (
            '<iframe sandbox="allow-scripts allow-downloads" width="100%" height="640" style="border: 0" '
            f'srcdoc="{escape(self.html)}"></iframe>'
        )

    def __repr__(self) -> str:
        return f"Report({len(self.html) / 1e6:.1f} MB)"
