"""Bodies as lines through their stations, which is what pictures are drawn of."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ancf.record import VECTORS, Array, unknown

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ancf.result import Result

SHOWN = 0.15
"""Greatest deflection with which a shape of no size of its own is drawn, over the size of the model."""

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#444444")
"""Colours that the colour-blind tell apart, after Okabe & Ito (2008)."""

AXES = {"x": 0, "y": 1, "z": 2}


class Lines:
    """Where the lines of all bodies are in each frame of a result."""

    def __init__(self, result: Result, parts: int = 8) -> None:
        """Lines of the bodies of a `result`, with as many `parts` to an element; a rigid body is a point."""
        stations = result.stations(parts)
        names = [name for name, _ in stations]
        starts = [i for i, name in enumerate(names) if i == 0 or name != names[i - 1]]
        self.bodies = {names[a]: slice(a, b) for a, b in zip(starts, [*starts[1:], len(names)], strict=True)}
        """Stations of each body."""
        self.along = np.array([s for _, s in stations])
        """Arc length of each station."""
        self.pieces = np.array([i for i in range(len(names) - 1) if names[i] == names[i + 1]], dtype=int)
        """Stations after which the line of their body goes on."""
        self.path = result.field("position", parts=parts)
        """Positions, `[frame, station, 3]`; of modes, those about which it moves."""
        self.rest: Array = (self.path[:1] - result.field("displacement", parts=parts)[:1])[0]
        """The reference configuration, `[station, 3]`."""
        self.modal = result.kind in {"modes", "buckling"}
        """Whether rows are shapes."""
        self.shapes: Array | None = result.shape_at(parts=parts) if self.modal else None
        self.arms = Arms.of(result, self, parts)
        """Lines from the centres of rigid bodies to their joints."""

    @property
    def size(self) -> float:
        """Diagonal of the box about the reference configuration."""
        points = np.concatenate([self.rest, self.rest[self.arms.stations] + self.arms.offsets])
        return float(np.linalg.norm(np.ptp(points, axis=0))) or 1.0

    def scale(self, row: int) -> float:
        """By what to multiply deflections if nothing else is said: 1, and what makes a shape well seen."""
        if self.shapes is None:
            return 1.0
        greatest = float(np.linalg.norm(self.shapes[row], axis=1).max())
        return SHOWN * self.size / greatest if greatest > 0 else 1.0

    def places(self, row: int, scale: float | None = None) -> Array:
        """Positions in a row with deflections multiplied by `scale`, `[station, 3]`."""
        scale = self.scale(row) if scale is None else scale
        if self.shapes is not None:
            shape: Array = self.path[row] + scale * self.shapes[row]
            return shape
        still: Array = self.path[row] if scale == 1 else self.rest + scale * (self.path[row] - self.rest)
        return still

    def reach(self, row: int, places: Array) -> Array:
        """All points that a picture of the bodies at `places` has, `[point, 3]`."""
        return np.concatenate([places, self.arms.tips(row, places)])

    def values(self, result: Result, name: str, parts: int = 8) -> Array:
        """A number for each row and station, `[row, station]`, by the name of a section force or of a vector.

        `N`, `Qy`, `Qz`, `T`, `My`, `Mz`; `displacement`, `velocity`, `acceleration` (their lengths), or
        components of them such as `displacement.y`. Of shapes, `displacement` is that of the shape.
        """
        vector, _, component = name.partition(".")
        forces = VECTORS["section_forces"]
        if name in forces:
            return result.field("section_forces", parts=parts)[..., forces.index(name)]
        if vector not in MAPPED or (component and component not in AXES):
            raise KeyError(unknown("quantity", name, [*forces, *MAPPED]))
        if vector == "displacement" and self.shapes is not None:
            numbers = self.shapes
        else:
            numbers = result.field(vector, parts=parts)
        length: Array = np.linalg.norm(numbers, axis=-1)
        return numbers[..., AXES[component]] if component else length


def brief(number: float) -> str:
    """A number in four digits, without a power of ten if it is of moderate size."""
    if number == 0 or 1e-4 <= abs(number) < 1e7:
        return np.format_float_positional(float(f"{number:.4g}"), trim="-")
    return f"{number:.3e}"


MAPPED = ("displacement", "velocity", "acceleration")
"""Vectors by which lines can be coloured."""


class Arms:
    """Lines from the centres of rigid bodies to their joints, fixed in the bodies."""

    def __init__(self, stations: list[int], offsets: Array, directors: Array) -> None:
        """Arms from `stations` by `offsets` in the axes of their bodies, `directors[row, arm, 3, 3]`."""
        self.stations = np.array(stations, dtype=int)
        """The station of the centre from which each arm goes."""
        self.offsets = offsets
        """From the centre to the end in the axes of the body, which are global at the start, `[arm, 3]`."""
        self._directors = directors

    @classmethod
    def of(cls, result: Result, lines: Lines, parts: int) -> Arms:
        """Arms of all rigid bodies; none of modes."""
        model = result.model
        rigid = [] if lines.modal else [body for body in model["bodies"] if body["kind"] == "rigid"]
        stations, offsets = [], []
        for body in rigid:
            for place in sorted(set(tied(model, body["name"]))):
                stations.append(lines.bodies[body["name"]].start)
                offsets.append(np.subtract(place, body["center"]))
        if not stations:
            return cls([], np.empty((0, 3)), np.empty((len(result.frames), 0, 3, 3)))
        return cls(stations, np.array(offsets), result.field("directors", parts=parts)[:, stations])

    def tips(self, row: int, places: Array) -> Array:
        """Ends of all arms of the bodies at `places`, `[arm, 3]`."""
        tips: Array = places[self.stations] + np.einsum("ai,aij->aj", self.offsets, self._directors[row])
        return tips


def tied(model: Mapping[str, Any], body: str) -> Iterator[tuple[float, ...]]:
    """Points off the centre of a rigid body that joints hold, where they are at the start."""
    for joint in model.get("joints", []):
        for end in (joint.get("a"), joint.get("b")):
            if isinstance(end, Mapping) and end.get("body") == body and not isinstance(end.get("at"), str):
                yield tuple(float(number) for number in end["at"])


def rows(
    result: Result, frame: int | Iterable[int] = -1, time: float | Iterable[float] | None = None
) -> list[int]:
    """Numbers of the frames that `frame` names, from the end if negative, or those next to `time`, if given."""
    if time is not None:
        times = np.atleast_1d(np.asarray(time, dtype=float))
        if not times.size or not np.isfinite(times).all():
            msg = f"time: found {time}, wanted a finite number or several"
            raise ValueError(msg)
        if result.kind != "dynamics":
            msg = f"a result of {result.kind} has no time"
            raise AttributeError(msg)
        return [int(np.abs(result.frames - t).argmin()) for t in times]
    wanted = list(frame) if isinstance(frame, Iterable) else [frame]
    if not wanted or not all(isinstance(row, int | np.integer) for row in wanted):
        msg = f"frame: found {frame}, wanted the number of a row or of several"
        raise ValueError(msg)
    count = len(result.frames)
    for row in wanted:
        if not -count <= row < count:
            msg = f"frame {row}: the result has {count} {'rows' if count == len(result) else 'states'}"
            raise IndexError(msg)
    return [int(row) % count for row in wanted]


def whole(name: str, value: object, least: int) -> None:
    """Refuse what is no whole number or too small."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or value < least:
        msg = f"{name}: found {value!r}, wanted a whole number >= {least}"
        raise ValueError(msg)


def filmed(result: Result) -> None:
    """Refuse what has nothing to go through."""
    count = len(result.frames)
    # Where no states were kept, that is to be said, by what asks for them.
    if result.kind not in {"modes", "buckling"} and count < 2 and (count or not len(result)):
        msg = f"film: found a result of {count} row{'s' * (count != 1)}, wanted two rows at least"
        raise ValueError(msg)


def told(result: Result, frame: int) -> str:
    """The frame in words: time, load factor, frequency or critical load factor."""
    value, row = result.frames[frame], result.frame_rows[frame]
    if result.kind == "dynamics":
        return f"t = {with_unit(brief(value), result.field_units.get('time'), ' ')}"
    if result.kind in {"modes", "buckling"} and row < 0:
        return f"{'mode' if result.kind == 'modes' else 'shape'} {brief(value)}"
    if result.kind == "modes":
        squared, frequency = result["squared"][row], result.frequencies[row]
        if squared < 0:
            return f"mode {row + 1}: unstable"
        unit = result.units.get("frequency")
        unit = "Hz" if unit == "1/s" else unit
        return f"mode {row + 1}: f = {with_unit(brief(frequency), unit, ' ')}"
    if result.kind == "buckling":
        return f"shape {row + 1}: factor {brief(result.factors[row])}"
    return f"load factor {brief(value)}"


def with_unit(words: str, unit: str | None, between: str = ", ") -> str:
    """Words with a unit, if there is one that has a name."""
    if unit in {None, "", "1"}:
        return words
    return f"{words}{between}{unit}" if words else str(unit)


def shaking(result: Result) -> list[int]:
    """Frames of the modes that are no rigid motions, or all if there are no others."""
    every = list(range(len(result.frames)))
    if result.kind == "buckling":
        return every
    rows = result.frame_rows
    elastic = [frame for frame in every if rows[frame] < 0 or result.frequencies[rows[frame]] != 0]
    return elastic or every
