"""Numbers under the names of columns, seen as what they are: motions of points, reactions, energies."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from typing import TYPE_CHECKING, Generic, TypeVar

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ancf._ancf import States

Array = np.typing.NDArray[np.float64]
View = TypeVar("View")

VECTORS: dict[str, tuple[str, ...]] = {
    "position": ("x", "y", "z"),
    "velocity": ("vx", "vy", "vz"),
    "acceleration": ("ax", "ay", "az"),
    "rotation": ("e0", "e1", "e2", "e3"),
    "angular_velocity": ("wx", "wy", "wz"),
    "section_forces": ("N", "Qy", "Qz", "T", "My", "Mz"),
    "strain": ("exx", "eyy", "ezz", "exy", "exz", "eyz"),
    "stress": ("sxx", "syy", "szz", "sxy", "sxz", "syz"),
    "force": ("fx", "fy", "fz"),
    "moment": ("mx", "my", "mz"),
}
"""Columns of each vector, after the name of the probe or the joint."""

FREEDOMS = ("angle", "rate", "displacement", "speed", "position", "length")
"""Columns of what a joint leaves free."""


class Record:
    """Columns of numbers: those of all rows in a `Result`, those of one row in an `Instant`."""

    def __init__(
        self, columns: list[str], data: Array, states: States, places: dict[str, int] | None = None
    ) -> None:
        """Columns `[..., column]`, the states that fields are read from, and the columns' numbers if known."""
        self.columns = columns
        """Names of all columns."""
        self.data = data
        """All numbers, `[row, column]` or `[column]`."""
        self.states = states
        self.places = {name: i for i, name in enumerate(columns)} if places is None else places
        """Numbers of the columns by their names."""

    def __getitem__(self, column: str) -> Array:
        """A column by its name, a view."""
        place = self.places.get(column)
        if place is None:
            raise KeyError(unknown("column", column, self.columns))
        return self.data[..., place]

    # Rows or columns? Neither goes without saying.
    __iter__ = None

    def __contains__(self, column: object) -> bool:
        return column in self.places

    def _ipython_key_completions_(self) -> list[str]:
        return self.columns

    def vector(self, name: str, quantity: str) -> Array:
        """A vector of a probe or a joint, `[..., component]`, a view; `quantity` as in `VECTORS`."""
        names = [f"{name}.{suffix}" for suffix in VECTORS[quantity]]
        first = self.places.get(names[0])
        if first is None or self.columns[first : first + len(names)] != names:
            msg = f"{name!r} has no {quantity}: it was not recorded"
            raise AttributeError(msg)
        return self.data[..., first : first + len(names)]

    def probe(self, name: str) -> Probe:
        """What a probe recorded."""
        return self.probes[name]

    @property
    def probes(self) -> Mapping[str, Probe]:
        """What all probes recorded, by their names."""
        firsts = [VECTORS[quantity][0] for quantity in Probe.QUANTITIES]
        return Views(self._names(firsts), lambda name: Probe(self, name), "probe")

    @property
    def reactions(self) -> Mapping[str, Reaction]:
        """What joints exert on their ends `a`, by the names of the joints."""
        return Views(self._names(["fx"]), lambda name: Reaction(self, name), "joint")

    @property
    def joints(self) -> Mapping[str, JointMotion]:
        """How joints move, by their names: of those that leave something free."""
        return Views(self._names(list(FREEDOMS)), lambda name: JointMotion(self, name), "joint")

    @property
    def energy(self) -> Energy:
        """Energies, work and what the books say."""
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
    ) -> Array:
        """A quantity along the bodies, `[row, station, component]`, or `[station, component]` of one row.

        * `position`, `displacement`, `velocity`, `acceleration`: x, y, z
        * `directors`: (3, 3), normal, y and z of the section, or the axes of a rigid body, in global components
        * `section_forces`: N, Qy, Qz, T, My, Mz; not a number for rigid bodies

        Stations are the ends of elements and, with `parts` > 1, as many places within each; of rigid bodies
        their centres. They follow one another in the order of the bodies (see `stations`) or are those of
        one `body`. Of long runs some `rows` may be enough: a number, a slice or several numbers.

        Of a result of `ancf.load` rows of a field are the states that were kept, at `Result.frames`.
        """
        chosen = np.arange(len(self.states))[slice(None) if rows is None else rows]
        numbers = self.states.field(name, parts, None if rows is None else np.atleast_1d(chosen).tolist())
        if body is not None:
            names, numbers_of, _ = self.states.stations(parts)
            if body not in names:
                raise KeyError(unknown("body", body, names))
            numbers = numbers[:, np.asarray(numbers_of) == names.index(body)]
        if name == "directors":
            numbers = numbers.reshape(*numbers.shape[:2], 3, 3)
        return numbers[0] if np.ndim(chosen) == 0 or self.data.ndim == 1 else numbers

    def stations(self, parts: int = 1) -> list[tuple[str, float]]:
        """Body and arc length of each station of a field."""
        names, bodies, lengths = self.states.stations(parts)
        return [(names[body], s) for body, s in zip(bodies, lengths, strict=True)]


class Views(Mapping[str, View], Generic[View]):
    """Views of a record by names."""

    def __init__(self, names: Sequence[str], view: Callable[[str], View], what: str) -> None:
        """Views that `view` makes of each of the `names` of a kind of thing."""
        self._names, self._view, self._what = names, view, what

    def __getitem__(self, name: str) -> View:
        if name not in self._names:
            raise KeyError(unknown(self._what, name, self._names))
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
    """What a probe recorded, of which each is `[..., component]`."""

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

    def __init__(self, record: Record, name: str) -> None:
        """The probe of a name."""
        self._record, self.name = record, name

    @property
    def position(self) -> Array:
        """x, y, z; length. In modes and shapes of buckling, the displacement."""
        return self._record.vector(self.name, "position")

    @property
    def velocity(self) -> Array:
        """x, y, z; length/time."""
        return self._record.vector(self.name, "velocity")

    @property
    def acceleration(self) -> Array:
        """x, y, z; length/time²."""
        return self._record.vector(self.name, "acceleration")

    @property
    def rotation(self) -> Array:
        """Euler parameters e₀, e₁, e₂, e₃ of the rotation since the reference state."""
        return self._record.vector(self.name, "rotation")

    @property
    def angular_velocity(self) -> Array:
        """x, y, z in the global frame; 1/time."""
        return self._record.vector(self.name, "angular_velocity")

    @property
    def section_forces(self) -> Array:
        """N, Qy, Qz, T, My, Mz in the frame of the section; force, force × length."""
        return self._record.vector(self.name, "section_forces")

    @property
    def strain(self) -> Array:
        """Green's strain xx, yy, zz, xy, xz, yz in the frame of the section."""
        return self._record.vector(self.name, "strain")

    @property
    def stress(self) -> Array:
        """Second Piola-Kirchhoff stress xx, yy, zz, xy, xz, yz; force/length²."""
        return self._record.vector(self.name, "stress")

    def __repr__(self) -> str:
        record = self._record
        found = [of for of in self.QUANTITIES if f"{self.name}.{VECTORS[of][0]}" in record]
        return f"Probe({self.name!r}: {', '.join(found)})"


class Reaction:
    """What a joint exerts on its end `a`, global components, `[..., component]`."""

    def __init__(self, record: Record, name: str) -> None:
        """The reaction of the joint of a name."""
        self._record, self.name = record, name

    @property
    def force(self) -> Array:
        """x, y, z; force."""
        return self._record.vector(self.name, "force")

    @property
    def moment(self) -> Array:
        """x, y, z; force × length."""
        return self._record.vector(self.name, "moment")


class JointMotion:
    """How a joint moves; what it has depends on its kind: `angle` and `rate`, `displacement` and `speed`, ..."""

    def __init__(self, record: Record, name: str) -> None:
        """The motion of the joint of a name."""
        self._record, self.name = record, name

    def __getattr__(self, quantity: str) -> Array:
        if quantity.startswith("_"):
            raise AttributeError(quantity)
        column = f"{self.name}.{quantity}"
        if quantity not in FREEDOMS or column not in self._record:
            raise AttributeError(unknown(f"motion of joint {self.name!r},", quantity, dir(self)))
        return self._record[column]

    def __dir__(self) -> list[str]:
        return [of for of in FREEDOMS if f"{self.name}.{of}" in self._record]


class Energy:
    """Energies of the whole model, force × length."""

    def __init__(self, record: Record) -> None:
        """The energies of a record."""
        self._record = record

    @property
    def kinetic(self) -> Array:
        """Kinetic energy."""
        return self._record["kinetic"]

    @property
    def strain(self) -> Array:
        """Strain energy, that of springs included."""
        return self._record["strain"]

    @property
    def potential(self) -> Array:
        """Potential of gravity and of constant loads, zero in the reference configuration."""
        return self._record["potential"]

    @property
    def work(self) -> Array:
        """Supplied since the start by prescribed motions and by loads without potential."""
        return self._record["work"]

    @property
    def dissipated(self) -> Array:
        """Lost since the start by damping, drag and friction."""
        return self._record["dissipated"]

    @property
    def balance(self) -> Array:
        """What the integration lost: energy at the start, plus work, less dissipated, less energy."""
        return self._record["balance"]

    @property
    def total(self) -> Array:
        """Kinetic, strain and potential energy."""
        total: Array = self.kinetic + self.strain + self.potential
        return total


def unknown(what: str, name: str, known: Sequence[str]) -> str:
    """Say that a name is not known, and which one was probably meant."""
    near = get_close_matches(name, known, n=1)
    hint = f"; did you mean {near[0]!r}?" if near else f"; there are {', '.join(map(repr, known)) or 'none'}"
    return f"no {what} {name!r}{hint}"
