"""Views of columns as probes, reactions, joint motions and energies."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Generic, TypeVar

from ancf.display.numbers_table import numbers_table
from ancf.display.tables import Table, representation, titled
from ancf.record.columns import ENERGIES, JOINT_COORDINATES, VECTORS, Array, Columns
from ancf.record.suggestion import unknown_name

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

T = TypeVar("T")


class Views(Mapping[str, T], Generic[T]):
    """Views of one class by name."""

    def __init__(self, names: Sequence[str], view: Callable[[str], T], what: str) -> None:
        """Map `names` of a kind of object to the views that the function `view` returns."""
        self._names, self._view, self._what = names, view, what

    def __getitem__(self, name: str) -> T:
        if name not in self._names:
            raise KeyError(unknown_name(self._what, name, self._names))
        return self._view(name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __repr__(self) -> str:
        return f"{{{', '.join(map(repr, self._names))}}}"

    def _ipython_key_completions_(self) -> list[str]:
        return list(self._names)


class View:
    """Columns of one object, which shows them as a table."""

    kind = ""
    """Word for the object."""

    def __init__(self, columns: Columns, name: str) -> None:
        """View the columns of the object with a name."""
        self._columns, self.name = columns, name

    def _own(self) -> dict[str, str]:
        """Return the columns of the object by their names in its table."""
        return {column.removeprefix(f"{self.name}."): column for column in self._suffixed()}

    def _suffixed(self) -> list[str]:
        return [
            f"{self.name}.{suffix}" for suffix in self._suffixes() if f"{self.name}.{suffix}" in self._columns
        ]

    def _suffixes(self) -> Sequence[str]:
        raise NotImplementedError

    def _unit(self, column: str) -> str | None:
        return self._columns.units.get(column)

    def _table(self) -> Table:
        own = self._own()
        columns = {name: self._columns[column] for name, column in own.items()}
        return numbers_table(columns, {name: self._unit(column) for name, column in own.items()})

    def _title(self) -> str:
        data = self._columns.data
        rows = f", {len(data)} rows" if data.ndim > 1 else ""
        return f"{self.kind} {self.name!r}{rows}" if self.name else f"{self.kind}{rows}"

    def __repr__(self) -> str:
        return f"{self._title()}\n{self._table().text('  ')}"

    def _repr_html_(self) -> str:
        return representation([titled(self._title()), self._table().html()])


class Probe(View):
    """Recorded quantities of a probe, each an array `[..., component]`."""

    QUANTITIES = (
        "position",
        "velocity",
        "acceleration",
        "rotation",
        "angular_velocity",
        "accelerometer",
        "gyroscope",
        "section_forces",
        "strain",
        "stress",
        "resultants",
        "surface_stress",
    )

    kind = "Probe"

    def _suffixes(self) -> Sequence[str]:
        return [suffix for quantity in self.QUANTITIES for suffix in VECTORS[quantity]]

    @property
    def position(self) -> Array:
        """x, y, z; length. Displacement in modes and buckling shapes, of damped modes the real part."""
        return self._columns.vector(self.name, "position")

    @property
    def velocity(self) -> Array:
        """x, y, z; length/time."""
        return self._columns.vector(self.name, "velocity")

    @property
    def acceleration(self) -> Array:
        """x, y, z; length/time²."""
        return self._columns.vector(self.name, "acceleration")

    @property
    def rotation(self) -> Array:
        """Euler parameters e₀, e₁, e₂, e₃ of the rotation relative to the reference state."""
        return self._columns.vector(self.name, "rotation")

    @property
    def angular_velocity(self) -> Array:
        """x, y, z in the global frame; 1/time."""
        return self._columns.vector(self.name, "angular_velocity")

    @property
    def section_forces(self) -> Array:
        """N, Qy, Qz, T, My, Mz in the frame of the section; force, force × length."""
        return self._columns.vector(self.name, "section_forces")

    @property
    def strain(self) -> Array:
        """Green-Lagrange strain xx, yy, zz, xy, xz, yz in the frame of the section."""
        return self._columns.vector(self.name, "strain")

    @property
    def accelerometer(self) -> Array:
        """Acceleration less gravity along the axes of the section or the rigid body; length/time²."""
        return self._columns.vector(self.name, "accelerometer")

    @property
    def gyroscope(self) -> Array:
        """Angular velocity along the axes of the section or the rigid body; 1/time."""
        return self._columns.vector(self.name, "gyroscope")

    @property
    def stress(self) -> Array:
        """Second Piola-Kirchhoff stress xx, yy, zz, xy, xz, yz; force/length²."""
        return self._columns.vector(self.name, "stress")

    @property
    def resultants(self) -> Array:
        """Membrane forces and moments of a shell, nuu, nvv, nuv, muu, mvv, muv; force/length, force."""
        return self._columns.vector(self.name, "resultants")

    @property
    def surface_stress(self) -> Array:
        """Stresses of a shell uu, vv, uv at the top, in the middle and at the bottom, `[..., 9]`; force/length²."""
        return self._columns.vector(self.name, "surface_stress")


class Reaction(View):
    """Force and moment that a joint exerts on its end `a`, global components, `[..., component]`."""

    kind = "Reaction"

    def _suffixes(self) -> Sequence[str]:
        return [*VECTORS["force"], *VECTORS["moment"]]

    @property
    def force(self) -> Array:
        """x, y, z; force."""
        return self._columns.vector(self.name, "force")

    @property
    def moment(self) -> Array:
        """x, y, z; force × length."""
        return self._columns.vector(self.name, "moment")


class JointMotion(View):
    """Joint coordinates and their rates: `angle` and `rate`, or `displacement` and `speed`, by the kind of joint."""

    kind = "JointMotion"

    def _suffixes(self) -> Sequence[str]:
        return JOINT_COORDINATES

    def __getattr__(self, quantity: str) -> Array:
        if quantity.startswith("_"):
            raise AttributeError(quantity)
        column = f"{self.name}.{quantity}"
        if quantity not in JOINT_COORDINATES or column not in self._columns:
            raise AttributeError(unknown_name(f"motion of joint {self.name!r},", quantity, dir(self)))
        return self._columns[column]

    def __dir__(self) -> list[str]:
        return [of for of in JOINT_COORDINATES if f"{self.name}.{of}" in self._columns]


class Energy(View):
    """Energies of the whole model and the energy balance, force × length."""

    kind = "Energy"

    def __init__(self, columns: Columns) -> None:
        """View the energy columns."""
        super().__init__(columns, "")

    def _own(self) -> dict[str, str]:
        return {name: name for name in ENERGIES if name in self._columns}

    @property
    def kinetic(self) -> Array:
        """Kinetic energy."""
        return self._columns["kinetic"]

    @property
    def strain(self) -> Array:
        """Strain energy, including springs."""
        return self._columns["strain"]

    @property
    def potential(self) -> Array:
        """Potential energy of gravity and of constant loads, zero in the reference configuration."""
        return self._columns["potential"]

    @property
    def work(self) -> Array:
        """Work since the start of prescribed motions and of loads without potential."""
        return self._columns["work"]

    @property
    def dissipated(self) -> Array:
        """Energy dissipated since the start by damping, drag and friction."""
        return self._columns["dissipated"]

    @property
    def balance(self) -> Array:
        """Error of the integration: initial energy plus work minus dissipated energy minus energy."""
        return self._columns["balance"]

    @property
    def total(self) -> Array:
        """Sum of kinetic, strain and potential energy."""
        total: Array = self.kinetic + self.strain + self.potential
        return total
