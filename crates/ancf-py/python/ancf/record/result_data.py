"""Numbers of a result and their conversion to tables."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ancf.record.columns import VECTORS, Array, ComplexArray
from ancf.record.record import STATION_FIELDS, Record
from ancf.record.suggestion import unknown_name

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pandas as pd
    import xarray as xr

    from ancf._ancf import States

COMPONENT_NAMES = {
    "directors": "entry",
    "section_forces": "component",
    "strain": "tensor_component",
    "stress": "tensor_component",
    "resultants": "resultant",
    "surface_stress": "layer_component",
    "principal_stress": "principal_component",
}
"""Names of the last dimension of fields that are not vectors."""


class ResultData(Record):
    """Rows, states, summary and model of an analysis, without plots."""

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
        """Store the results of an analysis of a `kind` of a model."""
        super().__init__(columns, data, states, units=units)
        self.kind = kind
        """Kind of the analysis: `dynamics`, `statics`, `path`, `modes` or `buckling`."""
        self.summary = summary
        """Summary of the run: outcome, steps, iterations, coordinates, units of the solver, ..."""
        self.model = model
        """The model, as plain data."""
        count = len(states)
        self.frames: Array = data[:count, 0] if frames is None else frames
        """Time, load factor or number of the mode of each kept state, on which fields and plots are based. After
        `ancf.run` these are the values of all rows, after `ancf.load` of some."""
        self.frame_rows = np.arange(count) if frame_rows is None else frame_rows
        """Row of each of the `frames`. A frame between two rows, which `output.every` left out, has -1."""

    def __len__(self) -> int:
        """Return the number of rows."""
        return len(self.data)

    @property
    def time(self) -> Array:
        """Time of each row of a motion."""
        return self._first_column("t", "time")

    @property
    def load(self) -> Array:
        """Load factor of each equilibrium."""
        return self._first_column("load", "load factor")

    @property
    def frequencies(self) -> Array:
        """Natural frequencies, cycles per time. NaN where the state is unstable, 0 for aperiodic damped modes."""
        return self._first_column("frequency", "frequency")

    @property
    def damping_ratios(self) -> Array:
        """Damping ratios −Re λ/|λ| of `ancf.Modes(damped=True)`; 1 for an aperiodic decay, negative for growth."""
        return self._first_column("damping_ratio", "damping ratio")

    @property
    def errors(self) -> dict[str, float]:
        """Estimated errors by column: value + error is a better value.

        Statics has the columns of the last equilibrium, modes `frequency[1]`, ..., buckling `factor[1]`, ... Dynamics
        with `Output(errors=True)` has those of the last row. Empty for other analyses, and if the errors are not
        known. `summary["errors"]` has the class of the estimate and the largest error, `summary["motion_errors"]`
        the largest errors of the time steps and of the mesh. Errors of all rows are columns such as `tip.x_error`.
        """
        found = self.summary.get("errors") or self.summary.get("motion_errors") or {}
        return {value["column"]: value["error"] for value in found.get("values", [])}

    @property
    def factors(self) -> Array:
        """Critical load factors."""
        return self._first_column("factor", "critical load factor")

    @property
    def shapes(self) -> Array:
        """Shapes of modes or of buckling, `[mode, station, 3]`, with xᵀ M x = 1. Of damped modes the real part."""
        return self.shape_at()

    @property
    def complex_shapes(self) -> ComplexArray:
        """Complex shapes x of damped modes, `[mode, station, 3]`: the motion is Re(x e^{λt}).

        The real part is the largest of all phases, with xᵀ M x = 1. Undamped modes have no imaginary part.
        """
        return self.complex_shape_at()

    def shape_at(self, body: str | None = None, parts: int = 1) -> Array:
        """Compute shapes of modes or of buckling at the stations of `field`."""
        if not self.is_modal:
            msg = f"a result of {self.kind} has no shapes"
            raise AttributeError(msg)
        return self.field("velocity", body, parts)

    def complex_shape_at(self, body: str | None = None, parts: int = 1) -> ComplexArray:
        """Compute complex shapes of modes at the stations of `field`."""
        # States of modes have the imaginary part of the shape as accelerations.
        shapes: ComplexArray = self.shape_at(body, parts) + 1j * self.field("acceleration", body, parts)
        return shapes

    @property
    def is_modal(self) -> bool:
        """True if the rows are natural modes or buckling shapes."""
        return self.kind in {"modes", "buckling"}

    def _first_column(self, column: str, what: str) -> Array:
        if column not in self:
            msg = f"a result of {self.kind} has no {what}"
            raise AttributeError(msg)
        return self[column]

    def to_pandas(self) -> pd.DataFrame:
        """Return all columns as a table indexed by time, load factor or mode. `attrs["units"]` has their units."""
        import pandas as pd

        table: pd.DataFrame = pd.DataFrame(self.data, columns=self.columns, copy=False).set_index(
            self.columns[0]
        )
        if self.units:
            table.attrs["units"] = dict(self.units)
        return table

    def to_xarray(self, fields: Sequence[str] = (), parts: int = 1) -> xr.Dataset:
        """Return all columns as variables over time, load factor or mode, and `fields` over stations.

        Coordinates `body` and `s` identify the stations. If states were kept of some rows only, fields are over
        `frame`, their time, load factor or mode. Attributes `units` have the units that the model names.
        """
        import xarray as xr

        row = self.columns[0]
        data: xr.Dataset = xr.Dataset(
            {name: (row, self[name], _attributes(self.units.get(name))) for name in self.columns[1:]},
            coords={row: (row, self[row], _attributes(self.units.get(row)))},
            attrs={"analysis": self.kind},
        )
        if not fields:
            return data
        bodies, lengths = zip(*self.stations(parts), strict=True)
        length = _attributes(self.field_units.get("position"))
        data = data.assign_coords(body=("station", list(bodies)), s=("station", np.array(lengths), length))
        over = row if np.array_equal(self.frame_rows, np.arange(len(self))) else "frame"
        if over == "frame":
            data = data.assign_coords(frame=("frame", self.frames, _attributes(self.units.get(row))))
        for name in fields:
            numbers = self.field(name, parts=parts)
            if name not in STATION_FIELDS:
                own = self._scalar_fields(parts, [0])[name].unit
                data[name] = ((over, "station"), numbers, _attributes(own or None))
                continue
            numbers = numbers.reshape(len(self.frames), len(bodies), -1)
            unit = None if self.is_modal else self.field_units.get(name)
            data[name] = ((over, "station", COMPONENT_NAMES.get(name, "axis")), numbers, _attributes(unit))
        return data

    def surface_grid(self, body: str, parts: int = 1) -> Array:
        """Return the parameters (u, v) of the stations of a shell, `[row, column, 2]`, with u along the columns.

        A field of the shell with the same `parts` has this grid as `field.reshape(*grid.shape[:2], -1)`.
        """
        shells = {own["name"]: own for own in self.model["bodies"] if own["kind"] == "shell"}
        if body not in shells:
            raise KeyError(unknown_name("shell", body, list(shells)))
        u, v = (np.linspace(0, 1, count * parts + 1) for count in shells[body]["elements"])
        return np.stack(np.meshgrid(u, v), axis=-1)

    @property
    def field_units(self) -> dict[str, str]:
        """Units of fields and of the components of section forces and stresses, if the model names its `units`."""
        names = self.model.get("units")
        if not names:
            return {}
        length, time, force = names["length"], names["time"], names["force"]
        own = dict.fromkeys(("position", "displacement"), length)
        own |= {"velocity": f"{length}/{time}", "acceleration": f"{length}/{time}²", "time": time}
        stresses = ("stress", "surface_stress", *VECTORS["stress"], *VECTORS["surface_stress"])
        own |= dict.fromkeys(stresses, f"{force}/{length}²")
        own |= dict.fromkeys(VECTORS["resultants"][:3], f"{force}/{length}")
        own |= dict.fromkeys(VECTORS["resultants"][3:], force)
        return (
            own
            | dict.fromkeys(("N", "Qy", "Qz"), force)
            | dict.fromkeys(("T", "My", "Mz"), f"{force} {length}")
        )


def _attributes(unit: str | None) -> dict[str, str]:
    return {} if unit is None else {"units": unit}
