"""Results of an analysis."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ancf.pictures import Pictures
from ancf.record import Array, Record

if TYPE_CHECKING:
    import os
    from collections.abc import Sequence

    import pandas as pd
    import xarray as xr

    from ancf._ancf import States
    from ancf.report import Report


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
        *,
        units: dict[str, str] | None = None,
        frames: Array | None = None,
        frame_rows: np.typing.NDArray[np.int64] | None = None,
    ) -> None:
        """Results of an analysis of a `kind` of a model."""
        super().__init__(columns, data, states)
        self.kind = kind
        """Kind of the analysis: `dynamics`, `statics`, `path`, `modes` or `buckling`."""
        self.summary = summary
        """The run in a few numbers: outcome, steps, iterations, coordinates, units of the solver, ..."""
        self.model = model
        """The model, as plain data."""
        self.units = {} if units is None else units
        """Units of the columns by their names, if the model names its `units`; `1` of pure numbers."""
        count = len(states)
        self.frames: Array = data[:count, 0] if frames is None else frames
        """Time, load factor or number of the mode of each state that is kept, which are what fields and pictures
        have: after `ancf.run` those of all rows, after `ancf.load` of some."""
        self.frame_rows = np.arange(count) if frame_rows is None else frame_rows
        """Number of the row of each of the `frames`; -1 of one between rows, which `output.every` left out."""

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
        """All columns as a table, by time, load factor or number of the mode; `attrs["units"]` has their units."""
        import pandas as pd

        table: pd.DataFrame = pd.DataFrame(self.data, columns=self.columns, copy=False).set_index(
            self.columns[0]
        )
        if self.units:
            table.attrs["units"] = dict(self.units)
        return table

    def to_xarray(self, fields: Sequence[str] = (), parts: int = 1) -> xr.Dataset:
        """All columns as variables over time, load factor or mode, and such `fields` as are wanted over stations.

        Coordinates `body` and `s` tell the stations apart. Where states were kept of some rows only, fields are over
        `frame`, their time, load factor or mode. Attributes `units` have the units that the model names.
        """
        import xarray as xr

        row = self.columns[0]
        data: xr.Dataset = xr.Dataset(
            {name: (row, self[name], self._attributes(self.units.get(name))) for name in self.columns[1:]},
            coords={row: (row, self[row], self._attributes(self.units.get(row)))},
            attrs={"analysis": self.kind},
        )
        if not fields:
            return data
        bodies, lengths = zip(*self.stations(parts), strict=True)
        length = self._attributes(self.field_units.get("position"))
        data = data.assign_coords(body=("station", list(bodies)), s=("station", np.array(lengths), length))
        over = row if np.array_equal(self.frame_rows, np.arange(len(self))) else "frame"
        if over == "frame":
            data = data.assign_coords(frame=("frame", self.frames, self._attributes(self.units.get(row))))
        for name in fields:
            numbers = self.field(name, parts=parts).reshape(len(self.frames), len(bodies), -1)
            unit = None if self.kind in {"modes", "buckling"} else self.field_units.get(name)
            data[name] = ((over, "station", COMPONENTS.get(name, "axis")), numbers, self._attributes(unit))
        return data

    @property
    def field_units(self) -> dict[str, str]:
        """Units of fields and of the components of section forces, if the model names its `units`."""
        names = self.model.get("units")
        if not names:
            return {}
        length, time, force = names["length"], names["time"], names["force"]
        own = dict.fromkeys(("position", "displacement"), length)
        own |= {"velocity": f"{length}/{time}", "acceleration": f"{length}/{time}²", "time": time}
        return (
            own
            | dict.fromkeys(("N", "Qy", "Qz"), force)
            | dict.fromkeys(("T", "My", "Mz"), f"{force} {length}")
        )

    @staticmethod
    def _attributes(unit: str | None) -> dict[str, str]:
        return {} if unit is None else {"units": unit}

    def report(self, path: str | os.PathLike[str] | None = None, *, title: str | None = None) -> Report:
        """Make a page with the motion in space and charts of all columns, as `ancf report` does: one HTML file.

        What is returned shows itself in a notebook. Long runs are thinned so that the page stays below some 30 MB.

        Parameters
        ----------
        path
            The file to write, if any.
        title
            The heading, by default the title of the model.

        Raises
        ------
        ValueError
            If states were not kept, or positions only: see `states` of `ancf.run`.

        """
        from ancf.report import Report

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


COMPONENTS = {"directors": "entry", "section_forces": "component"}
"""Names of the last dimension of fields that are no vectors."""
