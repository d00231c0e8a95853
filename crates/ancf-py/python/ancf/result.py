"""Results of an analysis."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ancf.graphics.animation import Animations
from ancf.graphics.curves import CurvePlots
from ancf.graphics.stage import Scenes
from ancf.report import Report

if TYPE_CHECKING:
    import os


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
        outcome = self.summary.get("outcome", {}).get("kind", "")
        names = ", ".join(self.probes)
        return (
            f"Result({self.kind}, {outcome}, {len(self)} rows, {len(self.columns)} columns, probes: {names})"
        )
