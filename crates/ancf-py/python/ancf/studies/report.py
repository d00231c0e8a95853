"""Results of a study."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ancf.display.tables import Table, representation, titled
from ancf.graphics.style import grid, style
from ancf.record.suggestion import unknown_name
from ancf.studies.convergence import convergence
from ancf.studies.sensitivity import sensitivity

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    import pandas as pd
    from matplotlib.axes import Axes

MAX_SHOWN = 20
"""Maximum number of cases in the representation of a study."""


class Study:
    """Table of a study with one row per case, and its evaluation."""

    def __init__(
        self,
        table: pd.DataFrame,
        parameters: Sequence[str],
        objectives: Sequence[str],
        file: Path | None = None,
    ) -> None:
        """Store a table with the names of its parameters and objectives, and its file."""
        self.table = table
        """Columns `case`, parameters, objectives, `outcome`, `message`, `steps`, `iterations`, `seconds`, `key`."""
        self.parameters = list(parameters)
        """Columns of the parameters: their paths."""
        self.objectives = list(objectives)
        """Columns of the objectives: their names."""
        self.file = file

    @property
    def finished(self) -> pd.DataFrame:
        """Rows of finished cases."""
        rows: pd.DataFrame = self.table[self.table["outcome"] == "finished"]
        return rows

    @property
    def warned(self) -> pd.DataFrame:
        """Rows of finished cases with warnings or missing objectives. The column `message` has them."""
        rows: pd.DataFrame = self.finished[self.finished["message"].notna()]
        return rows

    @property
    def failed(self) -> pd.DataFrame:
        """Rows of failed and invalid cases. The column `message` has the reason."""
        rows: pd.DataFrame = self.table[self.table["outcome"].isin(["failed", "invalid"])]
        return rows

    def convergence(
        self, parameter: str, objective: str, where: Mapping[str, Any] | None = None
    ) -> pd.DataFrame:
        """Estimate the order of convergence of an objective; see `ancf.studies.convergence.convergence`.

        `where` selects values of the other parameters, if they vary.
        """
        self._known(parameter, objective)
        rows = self.finished
        for path, value in (where or {}).items():
            self._known(path)
            rows = rows[rows[path] == value]
        return convergence(rows, parameter, objective, [p for p in self.parameters if p != parameter])

    def sensitivity(self, objective: str) -> pd.DataFrame:
        """Estimate the sensitivity of an objective; see `ancf.studies.sensitivity.sensitivity`."""
        self._known(objective)
        return sensitivity(self.finished, self.parameters, objective)

    def plot(self, objective: str | None = None, parameter: str | None = None) -> list[Axes]:
        """Plot one or all objectives over one or all parameters: a dot for each case, a line for a single parameter."""
        import matplotlib.pyplot as plt

        down = self.objectives if objective is None else [objective]
        across = self.parameters if parameter is None else [parameter]
        self._known(*down, *across)
        rows = self.finished
        with style():
            size = (1 + 3 * len(across), 0.5 + 2.2 * len(down))
            _, axes = plt.subplots(
                len(down), len(across), squeeze=False, sharex="col", sharey="row", figsize=size
            )
            for (i, j), ax in np.ndenumerate(axes):
                chosen = rows.sort_values(across[j])
                is_curve = chosen[across[j]].is_unique and len(self.parameters) == 1
                ax.plot(chosen[across[j]], chosen[down[i]], "o-" if is_curve else "o")
                grid(ax)
                if i == len(down) - 1:
                    ax.set_xlabel(across[j])
                if j == 0:
                    ax.set_ylabel(down[i])
        return list(axes.flat)

    def _known(self, *columns: str) -> None:
        for column in columns:
            if column not in self.table.columns:
                raise KeyError(unknown_name("column", column, [*self.parameters, *self.objectives]))

    def __len__(self) -> int:
        """Return the number of cases."""
        return len(self.table)

    def __repr__(self) -> str:
        lines = [f"Study: {self._counts()}", self._shown().text("  "), self._omitted()]
        return "\n".join(line for line in lines if line)

    def _repr_html_(self) -> str:
        note = f'<p class="faint">{self._omitted()}</p>' if self._omitted() else ""
        return representation([titled("Study", self._counts()), self._shown().html(), note])

    def _counts(self) -> str:
        """Return the number of cases by their outcome."""
        return ", ".join(f"{n} {outcome}" for outcome, n in self.table["outcome"].value_counts().items())

    def _shown(self) -> Table:
        """Return the first cases with parameters, objectives, outcome and messages."""
        rows = self.table.head(MAX_SHOWN)
        notes = ["outcome", *(["message"] if rows["message"].notna().any() else [])]
        shown = ["case", *self.parameters, *self.objectives, *notes]
        cells = [[cell(value) for value in row] for row in rows[shown].itertuples(index=False)]
        return Table(shown, cells, names=0, notes=len(notes))

    def _omitted(self) -> str:
        more = len(self) - MAX_SHOWN
        return f"{more} more case{'s' * (more > 1)} in Study.table" if more > 0 else ""


def cell(value: object) -> str:
    """Return the text of a value of a table. Missing values are empty."""
    if value is None or value != value:
        return ""
    return f"{value:.6g}" if isinstance(value, float | np.floating) else str(value)
