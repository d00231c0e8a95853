"""Planes and space in which bodies are drawn."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from ancf.display.numbers import with_unit
from ancf.graphics.quantities import AXES
from ancf.graphics.style import grid
from ancf.record.columns import Array

FLATNESS = 0.02
"""Maximum extent normal to a plane, relative to the maximum extent, of bodies drawn in the plane."""

Canvas: TypeAlias = "Any"
"""Axes of matplotlib in a plane or in space. The types of matplotlib do not declare what both have in common."""


class View:
    """A plane, given by its horizontal and its vertical direction, or space."""

    def __init__(self, basis: Array, names: str) -> None:
        """View along the directions `basis[2, 3]`, or in space with three, with the names of the coordinates."""
        self.basis, self.names = basis, names

    @classmethod
    def of(cls, plane: str | None, points: Array, ax: Canvas = None) -> View:
        """Return the named plane such as `xy`. By default the plane of the points, or space if they are not plane.

        Existing axes `ax` determine whether the view is a plane or space.
        """
        if plane is None:
            spread = np.ptp(points.reshape(-1, 3), axis=0)
            spatial = spread.min() > FLATNESS * spread.max() if ax is None else hasattr(ax, "get_zlim")
            if spatial:
                return cls(np.eye(3), "xyz")
            # For a straight line, several planes are possible: the rounding makes the choice reproducible.
            off = min(
                "zyx", key=lambda axis: round(spread[AXES[axis]] / spread.max(), 9) if spread.any() else 0
            )
            plane = "xyz".replace(off, "")
        if plane == "3d":
            return cls(np.eye(3), "xyz")
        if len(plane) != 2 or not set(plane) < set(AXES) or plane[0] == plane[1]:
            msg = f"plane: found {plane!r}, expected two of the letters x, y, z, such as 'xz', or '3d'"
            raise ValueError(msg)
        return cls(np.eye(3)[[AXES[letter] for letter in plane]], plane)

    @classmethod
    def along(cls, line: Array, shape: Array) -> View | None:
        """Return the plane of a straight line and its largest deflections. None if the line is not straight."""
        sizes, axes = np.linalg.svd(line - line.mean(0), full_matrices=False)[1:]
        if sizes[1] > 1e-6 * sizes[0]:
            return None
        axis = axes[0] * np.sign(axes[0][np.abs(axes[0]).argmax()])
        across = shape - np.outer(shape @ axis, axis)
        normal = np.linalg.svd(np.vstack([across, 1e-9 * np.abs(shape).max() * np.eye(3)]))[2][0]
        # The sign must not depend on rounding errors.
        normal = normal * np.sign(normal[np.abs(normal).round(6).argmax()])
        upright = abs(axis[0]) < 0.5
        return cls(np.stack([normal, axis] if upright else [axis, normal]), "  ")

    @property
    def spatial(self) -> bool:
        """True if the view is space."""
        return len(self.basis) == 3

    def coordinates(self, points: Array) -> Array:
        """Return the coordinates of points in the view."""
        coordinates: Array = points @ self.basis.T
        return coordinates

    def axes(self, ax: Canvas = None, unit: str | None = None) -> Canvas:
        """Label axes with the unit of length. Creates axes if none are given."""
        import matplotlib.pyplot as plt

        if ax is not None:
            pass
        elif self.spatial:
            _, ax = plt.subplots(subplot_kw={"projection": "3d"})
        else:
            _, ax = plt.subplots()
            grid(ax)
        self.label(ax, unit)
        return ax

    def label(self, ax: Canvas, unit: str | None = None) -> None:
        """Label the axes with their names and the unit of length."""
        for name, own in zip("xyz", self.names, strict=False):
            getattr(ax, f"set_{name}label")(with_unit(own, unit) if own.strip() else own)

    def remove_labels(self, ax: Canvas) -> None:
        """Remove ticks and labels, for small plots of shapes of arbitrary amplitude."""
        if self.spatial:
            self.label(ax)
            for name in "xyz":
                getattr(ax, f"set_{name}ticklabels")([])
                getattr(ax, f"{name}axis").labelpad = -12
        else:
            ax.set_axis_off()

    def fit(self, ax: Canvas, points: Array, zoom: float = 0.82) -> None:
        """Set limits that show all points with equal scales, in space with a margin for labels."""
        seen = self.coordinates(points.reshape(-1, 3))
        if not self.spatial:
            ax.set_aspect("equal", adjustable="datalim")
            ax.update_datalim(seen)
            ax.autoscale_view()
            return
        middle, half = (seen.max(0) + seen.min(0)) / 2, np.ptp(seen, axis=0) / 2
        half = 1.05 * np.maximum(half, 0.3 * half.max() or 1.0)
        for name, m, h in zip("xyz", middle, half, strict=True):
            getattr(ax, f"set_{name}lim")(m - h, m + h)
            axis = getattr(ax, f"{name}axis")
            axis.get_major_locator().set_params(nbins=max(2, int(5 * h / half.max())))
            axis.labelpad = 12 if name == "z" else 7
        ax.set_box_aspect(half, zoom=zoom)
