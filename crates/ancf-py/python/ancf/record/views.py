"""Views of columns as probes, reactions, joint motions and energies."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Generic, TypeVar

from ancf.record.columns import JOINT_COORDINATES, VECTORS, Array, Columns
from ancf.record.suggestion import unknown_name

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

View = TypeVar("View")


class Views(Mapping[str, View], Generic[View]):
    """Views of one class by name."""

    def __init__(self, names: Sequence[str], view: Callable[[str], View], what: str) -> None:
        """Map `names` of a kind of object to the views that the function `view` returns."""
        self._names, self._view, self._what = names, view, what

    def __getitem__(self, name: str) -> View:
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


class Probe:
    """Recorded quantities of a probe, each an array `[..., component]`."""

    QUANTITIES = (
        "position",
        "velocity",
        "acceleration",
        "rotation",
        "angular_velocity",
        "section_forces",
        "strain",
        "stress",
    )

    def __init__(self, columns: Columns, name: str) -> None:
        """View the columns of the probe with a name."""
        self._columns, self.name = columns, name

    @property
    def position(self) -> Array:
        """x, y, z; length. Displacement in modes and buckling shapes."""
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
    def stress(self) -> Array:
        """Second Piola-Kirchhoff stress xx, yy, zz, xy, xz, yz; force/length²."""
        return self._columns.vector(self.name, "stress")

    def __repr__(self) -> str:
        columns = self._columns
        found = [of for of in self.QUANTITIES if f"{self.name}.{VECTORS[of][0]}" in columns]
        return f"Probe({self.name!r}: {', '.join(found)})"


class Reaction:
    """Force and moment that a joint exerts on its end `a`, global components, `[..., component]`."""

    def __init__(self, columns: Columns, name: str) -> None:
        """View the columns of the joint with a name."""
        self._columns, self.name = columns, name

    @property
    def force(self) -> Array:
        """x, y, z; force."""
        return self._columns.vector(self.name, "force")

    @property
    def moment(self) -> Array:
        """x, y, z; force × length."""
        return self._columns.vector(self.name, "moment")


class JointMotion:
    """Joint coordinates and their rates: `angle` and `rate`, or `displacement` and `speed`, by the kind of joint."""

    def __init__(self, columns: Columns, name: str) -> None:
        """View the columns of the joint with a name."""
        self._columns, self.name = columns, name

    def __getattr__(self, quantity: str) -> Array:
        if quantity.startswith("_"):
            raise AttributeError(quantity)
        column = f"{self.name}.{quantity}"
        if quantity not in JOINT_COORDINATES or column not in self._columns:
            raise AttributeError(unknown_name(f"motion of joint {self.name!r},", quantity, dir(self)))
        return self._columns[column]

    def __dir__(self) -> list[str]:
        return [of for of in JOINT_COORDINATES if f"{self.name}.{of}" in self._columns]


class Energy:
    """Energies of the whole model and the energy balance, force × length."""

    def __init__(self, columns: Columns) -> None:
        """View the energy columns."""
        self._columns = columns

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
