"""Axes of bodies as lines through their stations."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ancf import _ancf
from ancf.record.columns import Array

if TYPE_CHECKING:
    from ancf.record.result_data import ResultData


class Lines:
    """Lines along the axes of all bodies in each frame of a result."""

    def __init__(self, result: ResultData, parts: int = 8) -> None:
        """Compute lines with `parts` segments per element. The line of a rigid body is a point."""
        stations = result.stations(parts)
        names = [name for name, _ in stations]
        starts = [i for i, name in enumerate(names) if i == 0 or name != names[i - 1]]
        self.bodies = {names[a]: slice(a, b) for a, b in zip(starts, [*starts[1:], len(names)], strict=True)}
        """Stations of each body."""
        self.arc_lengths = np.array([s for _, s in stations])
        """Arc length of each station."""
        self.segments = np.array([i for i in range(len(names) - 1) if names[i] == names[i + 1]], dtype=int)
        """First station of each segment."""
        self.path = result.field("position", parts=parts)
        """Positions, `[frame, station, 3]`. Modes have the positions of the linearised state."""
        self.reference: Array = (self.path[:1] - result.field("displacement", parts=parts)[:1])[0]
        """Reference configuration, `[station, 3]`."""
        self.modal = result.is_modal
        """True if the frames are shapes."""
        self.shapes: Array | None = result.shape_at(parts=parts) if self.modal else None
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

    def positions(self, row: int, scale: float | None = None) -> Array:
        """Return the positions in a frame with deflections multiplied by `scale`, `[station, 3]`."""
        scale = self.scale(row) if scale is None else scale
        if self.shapes is not None:
            shape: Array = self.path[row] + scale * self.shapes[row]
            return shape
        deflected: Array = (
            self.path[row] if scale == 1 else self.reference + scale * (self.path[row] - self.reference)
        )
        return deflected

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
