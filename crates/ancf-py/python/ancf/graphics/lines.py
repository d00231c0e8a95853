"""Axes of bodies as lines through their stations, and shells as grids."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from ancf import _ancf
from ancf.record.columns import Array

if TYPE_CHECKING:
    from ancf.record.result_data import ResultData


Indices: TypeAlias = "np.typing.NDArray[np.int64]"

NO_CELLS: Indices = np.empty((0, 4), dtype=np.int64)

NEGLIGIBLE = 1e-3
"""Imaginary part of a shape, relative to the real part, below which it is drawn as real."""

MAX_SHELL_STATIONS = 4000
"""Number of stations of all shells above which the parts of their elements are fewer."""


def drawn_parts(result: ResultData, parts: int) -> int:
    """Return the number of parts per element, less than `parts` if a model has shells with many elements."""
    shells = [body["elements"] for body in result.model["bodies"] if body["kind"] == "shell"]
    while parts > 1 and sum((n * parts + 1) * (m * parts + 1) for n, m in shells) > MAX_SHELL_STATIONS:
        parts -= 1
    return parts


class Lines:
    """Lines along the axes of all bodies and along the elements of shells in each frame of a result."""

    def __init__(self, result: ResultData, parts: int = 8) -> None:
        """Compute lines with `parts` segments per element. The line of a rigid body is a point."""
        stations = result.stations(parts)
        names = [name for name, _ in stations]
        starts = [i for i, name in enumerate(names) if i == 0 or name != names[i - 1]]
        self.bodies = {names[a]: slice(a, b) for a, b in zip(starts, [*starts[1:], len(names)], strict=True)}
        """Stations of each body."""
        self.arc_lengths = np.array([s for _, s in stations])
        """Arc length of each station."""
        shells = {
            body["name"]: body["elements"] for body in result.model["bodies"] if body["kind"] == "shell"
        }
        self.grids: dict[str, Indices] = {
            name: self.bodies[name].start
            + np.arange((n * parts + 1) * (m * parts + 1)).reshape(m * parts + 1, n * parts + 1)
            for name, (n, m) in shells.items()
        }
        """Stations of each shell, `[row, column]`."""
        is_along = [names[i] == names[i + 1] and names[i] not in shells for i in range(len(names) - 1)]
        self.segments: Indices = np.flatnonzero(is_along)
        """First station of each segment of beams and cables."""
        self.cells: Indices = np.concatenate([cells(grid) for grid in self.grids.values()] or [NO_CELLS])
        """Corners of the cells of shells, `[cell, 4]`."""
        self._parts = parts
        self.path = result.field("position", parts=parts)
        """Positions, `[frame, station, 3]`. Modes have the positions of the linearised state."""
        self.reference: Array = (self.path[:1] - result.field("displacement", parts=parts)[:1])[0]
        """Reference configuration, `[station, 3]`."""
        self.modal = result.is_modal
        """True if the frames are shapes."""
        self.shapes: Array | None = result.shape_at(parts=parts) if self.modal else None
        self.imaginary = _imaginary_parts(result, parts)
        """Imaginary parts of the shapes of damped modes, `[mode, station, 3]`."""
        self.geometry = _ancf.ModelGeometry(result.states)
        """Positions of joints and arms."""
        self.arms = Arms.of(result, self, parts)
        """Arms of the rigid bodies."""

    @property
    def size(self) -> float:
        """Diagonal of the bounding box of the reference configuration."""
        points = np.concatenate([self.reference, self.reference[self.arms.stations] + self.arms.offsets])
        return float(np.linalg.norm(np.ptp(points, axis=0))) or 1.0

    def scale(self, row: int) -> float:
        """Return the default factor of deflections: 1, and that of the report for a shape. Bodies do not cross."""
        return self.geometry.shape_factor(row, self.size) if self.modal else 1.0

    def phase_positions(self, row: int, scale: float, phase: float) -> Array:
        """Return the positions at a phase of the vibration of a mode, `[station, 3]`.

        The phase of a real shape is that of its sine. A complex shape moves by Re cos ωt − Im sin ωt with ωt + π/2 as
        the phase, so that its real part has the factor of a real shape.
        """
        positions: Array = self.positions(row, scale * float(np.sin(phase)))
        if self.imaginary is not None:
            positions = positions + scale * float(np.cos(phase)) * self.imaginary[row]
        return positions

    def positions(self, row: int, scale: float | None = None) -> Array:
        """Return the positions in a frame with deflections multiplied by `scale`, `[station, 3]`."""
        scale = self.scale(row) if scale is None else scale
        if not np.isfinite(scale):
            raise ValueError(f"scale: found {scale}, expected a finite number")
        if self.shapes is not None:
            shape: Array = self.path[row] + scale * self.shapes[row]
            return shape
        deflected: Array = (
            self.path[row] if scale == 1 else self.reference + scale * (self.path[row] - self.reference)
        )
        return deflected

    def polylines(self, seen: Array) -> list[Array]:
        """Return the points of the line of each body from those of all stations, with gaps of NaN in shells."""
        extended = np.concatenate([seen, np.full_like(seen[:1], np.nan)])
        return [
            extended[element_edges(self.grids[name], self._parts)] if name in self.grids else seen[stations]
            for name, stations in self.bodies.items()
        ]

    def symbols(self, row: int, scale: float | None = None) -> dict[str, dict[str, Array]]:
        """Return the positions of joints, probes and loads in a frame, by kind and name."""
        scale = self.scale(row) if scale is None else scale
        names, kinds, positions = self.geometry.symbols(row, scale, self.modal)
        found: dict[str, dict[str, Array]] = {"joint": {}, "probe": {}, "load": {}}
        for name, kind, position in zip(names, kinds, positions, strict=True):
            found[kind][name] = position
        return found

    def points(self, row: int, positions: Array) -> Array:
        """Return all points of the lines and arms of bodies at `positions`, `[point, 3]`."""
        return np.concatenate([positions, self.arms.tips(row, positions)])


def _imaginary_parts(result: ResultData, parts: int) -> Array | None:
    """Return the imaginary parts of the shapes of damped modes. Negligible ones, of real shapes, are zero."""
    if "damping_ratio" not in result:
        return None
    shapes = result.complex_shape_at(parts=parts)
    largest = np.abs(shapes.real).max(axis=(1, 2), keepdims=True)
    is_complex = np.abs(shapes.imag).max(axis=(1, 2), keepdims=True) > NEGLIGIBLE * largest
    imaginary: Array = np.where(is_complex, shapes.imag, 0.0)
    return imaginary


def cells(grid: Indices) -> Indices:
    """Return the corners of the cells of a grid, counter-clockwise as seen from the side of the normal."""
    corners = [grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]]
    return np.stack(corners, axis=-1).reshape(-1, 4)


def element_edges(grid: Indices, parts: int) -> Indices:
    """Return the stations along the edges of elements, with -1 between the lines."""
    gap = [[-1]]
    lines = [*grid[::parts], *grid.T[::parts]]
    return np.concatenate([part for line in lines for part in (line, *gap)])


class Arms:
    """Rigid arms from the centres of rigid bodies to their joints."""

    def __init__(self, stations: list[int], offsets: Array, directors: Array) -> None:
        """Arms from `stations` by `offsets` in the axes of their bodies, `directors[frame, arm, 3, 3]`."""
        self.stations = np.array(stations, dtype=int)
        """Station of the centre of each arm."""
        self.offsets = offsets
        """Vector from the centre to the joint in the axes of the body, `[arm, 3]`. These axes are initially global."""
        self._directors = directors

    @classmethod
    def of(cls, result: ResultData, lines: Lines, parts: int) -> Arms:
        """Return the arms of all rigid bodies. Modes are drawn without arms."""
        rigid = [] if lines.modal else [b["name"] for b in result.model["bodies"] if b["kind"] == "rigid"]
        if not rigid:
            return cls([], np.empty((0, 3)), np.empty((len(result.frames), 0, 3, 3)))
        # Joints at the same point share an arm.
        offsets = {body: np.unique(lines.geometry.arms(body), axis=0) for body in rigid}
        stations = [lines.bodies[body].start for body, own in offsets.items() for _ in own]
        directors = result.field("directors", parts=parts)[:, stations]
        return cls(stations, np.concatenate(list(offsets.values())), directors)

    def tips(self, row: int, positions: Array) -> Array:
        """Return the ends of all arms of bodies at `positions`, `[arm, 3]`."""
        tips: Array = positions[self.stations] + np.einsum("ai,aij->aj", self.offsets, self._directors[row])
        return tips
