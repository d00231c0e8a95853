"""Columns and states of a run or of one instant."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ancf import _ancf
from ancf.record.columns import JOINT_COORDINATES, VECTORS, Array, Columns
from ancf.record.suggestion import unknown_name
from ancf.record.views import Energy, JointMotion, Probe, Reaction, Views

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from ancf._ancf import States

TENSORS = ("strain", "stress")
"""Fields that are computed at an offset in the section."""

STATION_FIELDS = (
    "position",
    "displacement",
    "velocity",
    "acceleration",
    "directors",
    "section_forces",
    "resultants",
    "surface_stress",
    "principal_stress",
    *TENSORS,
)
"""Fields of vectors and tensors."""


ROWS_OF_THREE = ("directors", "surface_stress", "principal_stress")
"""Fields with the shape (3, 3) at each station."""


class ScalarField(NamedTuple):
    """A number per station, by which the report colours bodies."""

    name: str
    unit: str
    """Unit, empty if the model does not name its units."""
    is_signed: bool
    """True for quantities of both signs."""
    values: Array
    """Values `[frame, station]`, NaN where the quantity is not defined."""


class Record(Columns):
    """Columns and states: those of all rows in a `Result`, those of one row in an `Instant`."""

    def __init__(
        self,
        columns: list[str],
        data: Array,
        states: States,
        indices: dict[str, int] | None = None,
        units: dict[str, str] | None = None,
    ) -> None:
        """Store columns `[..., column]` and the states from which fields are computed."""
        super().__init__(columns, data, indices, units)
        self.states = states

    def probe(self, name: str) -> Probe:
        """Return the recorded quantities of a probe."""
        return self.probes[name]

    @property
    def probes(self) -> Mapping[str, Probe]:
        """Recorded quantities of all probes, by name."""
        firsts = [VECTORS[quantity][0] for quantity in Probe.QUANTITIES]
        return Views(self._names(firsts), lambda name: Probe(self, name), "probe")

    @property
    def reactions(self) -> Mapping[str, Reaction]:
        """Reactions that joints exert on their ends `a`, by the names of the joints."""
        return Views(self._names(["fx"]), lambda name: Reaction(self, name), "joint")

    @property
    def joints(self) -> Mapping[str, JointMotion]:
        """Motions of the joints that have joint coordinates, by name."""
        return Views(self._names(list(JOINT_COORDINATES)), lambda name: JointMotion(self, name), "joint")

    @property
    def energy(self) -> Energy:
        """Energies, work and the energy balance."""
        return Energy(self)

    def _names(self, suffixes: Sequence[str]) -> list[str]:
        names = (column.rpartition(".") for column in self.columns)
        return list(dict.fromkeys(name for name, dot, suffix in names if dot and suffix in suffixes))

    def field(
        self,
        name: str,
        body: str | None = None,
        parts: int = 1,
        rows: int | slice | Sequence[int] | None = None,
        *,
        offset: tuple[float, float] | None = None,
    ) -> Array:
        """Compute a quantity along the bodies, `[row, station, component]`, or `[station, component]` of one row.

        * `position`, `displacement`, `velocity`, `acceleration`: x, y, z
        * `directors`: (3, 3), normal, y and z of the section, or the axes of a rigid body, in global components; normal
          and two tangents of a shell
        * `section_forces`: N, Qy, Qz, T, My, Mz of beams and cables
        * `resultants`: nuu, nvv, nuv, muu, mvv, muv of shells, in the orthonormal frame of the undeformed surface:
          u along its first parameter, v normal to it
        * `surface_stress`: (3, 3), stresses uu, vv, uv of shells at the top, in the middle and at the bottom
        * `principal_stress`: (3, 3), σ₁ ≥ σ₂ and the angle from u to the direction of σ₁, at the same surfaces
        * `strain`, `stress`: Green-Lagrange strain, second Piola-Kirchhoff stress, xx, yy, zz, xy, xz, yz in the frame
          of the section, on the axis or at `offset` (y, z), as a probe records them
        * one number per station, `[row, station]`, as the report colours bodies: `axial_force`, `shear_force`,
          `torque`, `bending_moment`, `axial_stress`, `shear_stress`, `von_mises_stress`, ... Stresses of beams
          are the largest of the section by the section forces. Shells have `von_mises_stress` (the larger of both
          faces), `von_mises_stress_top`, `stress_uu_top`, `principal_stress_1_top`, `membrane_force_uu`, `moment_uu`,
          `energy_density`, ... These numbers have single precision.

        A field is NaN for bodies that do not have it. Stations are the ends of elements and, with `parts` > 1,
        equidistant points within each. Those of a shell are a grid, see `surface_grid`. A rigid body has one station,
        its centre. Stations are in the order of the bodies (see `stations`). `body` selects those of one body,
        `rows` selects rows by a number, a slice or several numbers.

        A result of `ancf.load` has the states that were kept: its rows of a field are at `Result.frames`.
        """
        chosen = np.arange(len(self.states))[slice(None) if rows is None else rows]
        numbers = self._field(name, parts, None if rows is None else np.atleast_1d(chosen).tolist(), offset)
        if body is not None:
            names, numbers_of, _ = self.states.stations(parts)
            if body not in names:
                raise KeyError(unknown_name("body", body, names))
            numbers = numbers[:, np.asarray(numbers_of) == names.index(body)]
        if name in ROWS_OF_THREE:
            numbers = numbers.reshape(*numbers.shape[:2], 3, 3)
        return numbers[0] if np.ndim(chosen) == 0 or self.data.ndim == 1 else numbers

    def _field(
        self, name: str, parts: int, frames: list[int] | None, offset: tuple[float, float] | None
    ) -> Array:
        if offset is not None and name not in TENSORS:
            msg = f"offset: found {offset!r} of the field {name!r}, expected that of 'strain' or 'stress'"
            raise ValueError(msg)
        if name in STATION_FIELDS:
            return self.states.field(name, parts, frames, offset)
        scalars = self._scalar_fields(parts, frames)
        if name not in scalars:
            msg = f"field: {unknown_name('field', name, [*STATION_FIELDS, *scalars])}"
            raise ValueError(msg)
        return scalars[name].values

    def _scalar_fields(self, parts: int = 1, frames: list[int] | None = None) -> dict[str, ScalarField]:
        """Compute all scalar fields of the report that are defined, by their names in Python."""
        found = (ScalarField(*field) for field in _ancf.scalar_fields(self.states, parts, frames))
        return {field.name.lower().replace(" ", "_"): field for field in found}

    def stations(self, parts: int = 1) -> list[tuple[str, float]]:
        """Return body and arc length of each station of a field. The arc length is 0 in shells and rigid bodies."""
        names, bodies, lengths = self.states.stations(parts)
        return [(names[body], s) for body, s in zip(bodies, lengths, strict=True)]
