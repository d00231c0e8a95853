"""Results of an analysis."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ancf.display.numbers import format_number, with_unit
from ancf.display.numbers_table import numbers_table
from ancf.display.tables import Table, collapsible, joined, representation, titled
from ancf.graphics.animation import Animations
from ancf.graphics.curves import CurvePlots
from ancf.graphics.space.stage import Scenes
from ancf.report import Report

if TYPE_CHECKING:
    import os

COUNTS = ("steps", "iterations", "coordinates", "multipliers")
"""Numbers of a summary."""


class Result(CurvePlots, Animations, Scenes):
    """Results of an analysis as NumPy arrays: one row for each instant, equilibrium, mode or critical load.

    Columns, probes, reactions and energies are views of one array, `data`. Fields are computed from the states on
    demand. All numbers are in the units of the model.
    """

    def report(self, path: str | os.PathLike[str] | None = None, *, title: str | None = None) -> Report:
        """Create a page with the motion in space and charts of all columns, as `ancf report` does: one HTML file.

        The returned object shows itself in a notebook. Long runs are thinned to a page of at most about 30 MB.

        Parameters
        ----------
        path
            File to write, if any.
        title
            Heading; by default the title of the model.

        Raises
        ------
        ValueError
            If states were not kept, or positions only: see `states` of `ancf.run`.

        """
        report = Report.of(self, title)
        if path is not None:
            report.write(path)
        return report

    def __repr__(self) -> str:
        warnings = self.summary.get("warnings", [])
        parts = [
            self.kind,
            self._outcome(),
            f"{len(self)} rows",
            f"{len(self.columns)} columns",
            *([f"probes: {joined(list(self.probes))}"] if self.probes else []),
            *([f"{len(warnings)} warning{'s' * (len(warnings) > 1)}"] if warnings else []),
        ]
        return f"Result({', '.join(part for part in parts if part)})"

    def _repr_html_(self) -> str:
        columns = {name: self[name] for name in self.columns}
        units = self.units
        title = str(self.model.get("title") or "")
        names = f"columns ({len(columns)}): first, last, minimum and maximum"
        table = collapsible(names, numbers_table(columns, units).html(), is_open=False)
        return representation(
            [titled("Result", title), Table(("", ""), self._facts(), names=2).html(), table]
        )

    def _outcome(self) -> str:
        return str(self.summary.get("outcome", {}).get("kind", ""))

    def _facts(self) -> list[list[str]]:
        """Return outcome, size and names of a result in a table."""
        outcome = self.summary.get("outcome", {})
        reason = f": {outcome['reason']}" if outcome.get("reason") else ""
        rows = [["analysis", f"{self.kind}, {self._outcome()}{reason}"]]
        if len(self):
            first = self.columns[0]
            ends = " ... ".join(format_number(x) for x in (self.data[0, 0], self.data[-1, 0]))
            rows.append(["rows", f"{len(self)}, {first} = {with_unit(ends, self.units.get(first), ' ')}"])
        counts = [f"{self.summary[key]} {key}" for key in COUNTS if self.summary.get(key)]
        rows += [["solver", ", ".join(counts)]] if counts else []
        for name, views in (("probes", self.probes), ("reactions", self.reactions), ("joints", self.joints)):
            rows += [[name, joined(list(views), 100)]] if views else []
        return rows + [["warning", text] for text in self.summary.get("warnings", [])]
