"""A study that was run."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ancf.record import unknown

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    import pandas as pd
    from matplotlib.axes import Axes


class Study:
    """The table of a study, one row a case, and what can be seen in it."""

    def __init__(
        self,
        table: pd.DataFrame,
        parameters: Sequence[str],
        objectives: Sequence[str],
        file: Path | None = None,
    ) -> None:
        """A table with the names of its parameters and objectives, and the file that has it."""
        self.table = table
        """Columns `case`, parameters, objectives, `outcome`, `message`, `steps`, `iterations`, `seconds`, `key`."""
        self.parameters = list(parameters)
        """Paths of the parameters, which are columns of the table."""
        self.objectives = list(objectives)
        """Names of the objectives, which are columns of the table."""
        self.file = file

    @property
    def finished(self) -> pd.DataFrame:
        """The rows of cases that finished."""
        rows: pd.DataFrame = self.table[self.table["outcome"] == "finished"]
        return rows

    @property
    def failed(self) -> pd.DataFrame:
        """The rows of cases that failed or were invalid; why is in the column `message`."""
        rows: pd.DataFrame = self.table[self.table["outcome"].isin(["failed", "invalid"])]
        return rows

    def convergence(
        self, parameter: str, objective: str, where: Mapping[str, Any] | None = None
    ) -> pd.DataFrame:
        """How an objective converges as a parameter refines; see `ancf.studies.convergence.convergence`.

        `where` tells the values of the other parameters, if they vary.
        """
        from ancf.studies.convergence import convergence

        self._known(parameter, objective)
        rows = self.finished
        for path, value in (where or {}).items():
            self._known(path)
            rows = rows[rows[path] == value]
        return convergence(rows, parameter, objective, [p for p in self.parameters if p != parameter])

    def sensitivity(self, objective: str) -> pd.DataFrame:
        """How much an objective depends on each parameter; see `ancf.studies.sensitivity.sensitivity`."""
        from ancf.studies.sensitivity import sensitivity

        self._known(objective)
        return sensitivity(self.finished, self.parameters, objective)

    def plot(self, objective: str | None = None, parameter: str | None = None) -> list[Axes]:
        """Plot objectives over parameters, one or all; a dot a case, and lines where values come in a row."""
        import matplotlib.pyplot as plt
        import numpy as np

        from ancf.plot import grid, style

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
                raise KeyError(unknown("column", column, [*self.parameters, *self.objectives]))

    def __len__(self) -> int:
        """Number of cases."""
        return len(self.table)

    def __repr__(self) -> str:
        counts = ", ".join(f"{n} {outcome}" for outcome, n in self.table["outcome"].value_counts().items())
        return f"Study({counts}; parameters: {self.parameters}; objectives: {self.objectives})"
