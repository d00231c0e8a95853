"""Results of an analysis."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ancf.pictures import Pictures
from ancf.record import Array, Record

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pandas as pd
    import xarray as xr

    from ancf._ancf import States


class Result(Pictures, Record):
    """What an analysis computed: rows in time, of equilibria, modes or critical loads, as NumPy arrays.

    Columns, probes, reactions and energies are views of one array, `data`; fields are computed from the
    states when asked for. All numbers are in the units of the model.
    """

    def __init__(
        self,
        columns: list[str],
        data: Array,
        states: States,
        kind: str,
        summary: dict[str, Any],
        model: dict[str, Any],
    ) -> None:
        """Results of an analysis of a `kind` of a model."""
        super().__init__(columns, data, states)
        self.kind = kind
        """Kind of the analysis: `dynamics`, `statics`, `path`, `modes` or `buckling`."""
        self.summary = summary
        """The run in a few numbers: outcome, steps, iterations, coordinates, units of the solver, ..."""
        self.model = model
        """The model, as plain data."""

    def __len__(self) -> int:
        """Number of rows."""
        return len(self.data)

    @property
    def time(self) -> Array:
        """Time of each row of a motion."""
        return self._first("t", "time")

    @property
    def load(self) -> Array:
        """Load factor of each equilibrium."""
        return self._first("load", "load factor")

    @property
    def frequencies(self) -> Array:
        """Natural frequencies, cycles per time; not a number where the state is unstable."""
        return self._first("frequency", "frequency")

    @property
    def factors(self) -> Array:
        """Critical load factors."""
        return self._first("factor", "critical load factor")

    @property
    def shapes(self) -> Array:
        """Shapes of modes or of buckling, `[mode, station, 3]`, with xᵀ M x = 1."""
        return self.shape_at()

    def shape_at(self, body: str | None = None, parts: int = 1) -> Array:
        """Shapes of modes or of buckling at the stations that `field` would have."""
        if self.kind not in {"modes", "buckling"}:
            msg = f"a result of {self.kind} has no shapes"
            raise AttributeError(msg)
        return self.field("velocity", body, parts)

    def _first(self, column: str, what: str) -> Array:
        if column not in self:
            msg = f"a result of {self.kind} has no {what}"
            raise AttributeError(msg)
        return self[column]

    def to_pandas(self) -> pd.DataFrame:
        """All columns as a table, by time, load factor or number of the mode."""
        import pandas as pd

        table: pd.DataFrame = pd.DataFrame(self.data, columns=self.columns, copy=False).set_index(
            self.columns[0]
        )
        return table

    def to_xarray(self, fields: Sequence[str] = (), parts: int = 1) -> xr.Dataset:
        """All columns as variables over time, load factor or mode, and such `fields` as are wanted over stations.

        Coordinates `body` and `s` tell the stations apart.
        """
        import xarray as xr

        row = self.columns[0]
        data: xr.Dataset = xr.Dataset(
            {name: (row, self[name]) for name in self.columns[1:]},
            coords={row: self[row]},
            attrs={"analysis": self.kind},
        )
        if not fields:
            return data
        bodies, lengths = zip(*self.stations(parts), strict=True)
        data = data.assign_coords(body=("station", list(bodies)), s=("station", np.array(lengths)))
        for name in fields:
            numbers = self.field(name, parts=parts).reshape(len(self), len(bodies), -1)
            data[name] = ((row, "station", COMPONENTS.get(name, "axis")), numbers)
        return data

    def __repr__(self) -> str:
        outcome = self.summary.get("outcome", {}).get("kind", "")
        names = ", ".join(self.probes)
        return (
            f"Result({self.kind}, {outcome}, {len(self)} rows, {len(self.columns)} columns, probes: {names})"
        )


COMPONENTS = {"directors": "entry", "section_forces": "component"}
"""Names of the last dimension of fields that are no vectors."""
