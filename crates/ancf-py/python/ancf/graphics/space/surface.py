"""Surfaces fixed to stations: swept sections, shells, boxes, cylinders and spheres."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np

from ancf import _ancf
from ancf.graphics.lines import cells
from ancf.record.columns import Array

Numbers: TypeAlias = "np.typing.NDArray[np.int64]"

CORNERS = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) / 2
"""Corners of a unit square, counter-clockwise."""


@dataclass(frozen=True)
class Outlines:
    """Outlines of the sections at the stations of a body, counter-clockwise seen from its end."""

    outer: Array
    """Outer outline, y and z, `[station, point, 2]`. A corner has two points, which keeps its edges sharp."""
    inner: Array | None
    """Outline of the bore of a tube, with the same number of points."""
    edges: Numbers
    """First and second point of each edge, `[edge, 2]`."""

    @classmethod
    def of_body(cls, geometry: _ancf.ModelGeometry, body: str, arc_lengths: Array, sides: int) -> Outlines:
        """Return the outlines of a beam or cable at its stations. Round sections are polygons with `sides`."""
        return cls(*geometry.outlines(body, (arc_lengths / arc_lengths[-1]).tolist(), sides))

    @classmethod
    def of_cylinder(cls, radius: float, sides: int) -> Outlines:
        """Return the outlines of both ends of a cylinder."""
        outer, inner, edges = _ancf.outline({"kind": "circle", "diameter": 2 * radius}, sides)
        return cls(np.stack([outer, outer]), inner, edges)

    def thickened(self, least: float) -> Outlines:
        """Return the outlines magnified to a thickness of at least `least`."""
        thickness = 2 * np.abs(self.outer).max(axis=(1, 2), keepdims=True)
        factor = np.maximum(1.0, least / thickness)
        return replace(
            self, outer=self.outer * factor, inner=None if self.inner is None else self.inner * factor
        )


@dataclass(frozen=True)
class Surface:
    """Points fixed to stations, and faces between them."""

    owners: Numbers
    """Station of each point."""
    offsets: Array
    """Vector from the station to the point in the directors of the station, `[point, 3]`."""
    faces: list[Numbers]
    """Numbers of points, `[face, corner]`. Each array has faces with the same number of corners."""
    body: int
    """Number of the body, -1 for a surface fixed to the ground."""
    grey: bool = False
    """True for obstacles and arms."""

    @classmethod
    def swept(cls, body: int, stations: range, outlines: Outlines) -> Surface:
        """Return the closed surface of outlines swept along stations."""
        count, k = outlines.outer.shape[:2]
        loops = [(outlines.outer, outlines.edges)]
        if outlines.inner is not None:
            loops.append((outlines.inner, outlines.edges[:, ::-1]))
        offsets, faces = [], []
        first = k * np.arange(count - 1)[:, None]
        for i, (points, edges) in enumerate(loops):
            offsets.append(points.reshape(-1, 2))
            one, two = edges[:, 0] + i * k * count, edges[:, 1] + i * k * count
            sides = np.stack([first + one, first + two, first + two + k, first + one + k], axis=-1)
            faces.append(sides.reshape(-1, 4))
        plane = np.concatenate(offsets)
        points = np.concatenate([np.zeros((len(plane), 1)), plane], axis=1)
        owners = np.repeat(np.array(stations), k)
        side = cls(np.tile(owners, len(loops)), points, faces, body)
        return side._with_ends(k, count, outlines.edges)

    @classmethod
    def shell(cls, body: int, grid: Numbers, thickness: float) -> Surface:
        """Return both faces of a shell over a grid of stations, and the border between them."""
        inside, count = np.arange(grid.size).reshape(grid.shape), grid.size
        faces = cells(inside)
        border = np.concatenate([inside[0], inside[1:, -1], inside[-1, -2::-1], inside[-2::-1, 0]])
        # The border has points of its own, which keeps its edges sharp.
        top, bottom = 2 * count + np.arange(len(border)), 2 * count + len(border) + np.arange(len(border))
        walls = np.stack([bottom[:-1], bottom[1:], top[1:], top[:-1]], axis=1)
        owners = grid.ravel()
        height = np.repeat([0.5, -0.5, 0.5, -0.5], [count, count, len(border), len(border)]) * thickness
        offsets = np.zeros((len(height), 3))
        offsets[:, 0] = height
        return cls(
            np.concatenate([owners, owners, owners[border], owners[border]]),
            offsets,
            [np.concatenate([faces, faces[:, ::-1] + count, walls])],
            body,
        )

    def _with_ends(self, k: int, count: int, edges: Numbers) -> Surface:
        """Return the surface with end faces, which have points of their own to keep their edges sharp."""
        owners, offsets, faces, total = [self.owners], [self.offsets], list(self.faces), len(self.owners)
        is_hollow = len(self.faces) == 2
        for station, turn in ((0, -1), (count - 1, 1)):
            own = np.arange(k) + station * k
            if is_hollow:
                taken = np.concatenate([own, own + k * count])
                rim = np.stack([edges[:, 0], edges[:, 1], edges[:, 1] + k, edges[:, 0] + k], axis=1)
                faces.append(total + rim[:, ::turn])
            else:
                taken = own[edges[:, 0]]
                faces.append(total + np.arange(len(taken))[None, ::turn])
            owners.append(self.owners[taken])
            offsets.append(self.offsets[taken])
            total += len(taken)
        return Surface(np.concatenate(owners), np.concatenate(offsets), faces, self.body, self.grey)

    @classmethod
    def cylinder(
        cls, body: int, station: int, start: Array, end: Array, radius: float, sides: int
    ) -> Surface:
        """Return a cylinder between two points fixed to a station."""
        axis = (end - start) / np.linalg.norm(end - start)
        across = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
        across /= np.linalg.norm(across)
        straight = cls.swept(body, range(2), Outlines.of_cylinder(radius, sides))
        frame = np.stack([across, np.cross(axis, across)])
        offsets = np.where(straight.owners[:, None] == 0, start, end) + straight.offsets[:, 1:] @ frame
        return cls(np.full(len(offsets), station), offsets, straight.faces, body, grey=True)

    @classmethod
    def box(cls, body: int, station: int, edges: Array, axes: Array) -> Surface:
        """Return a box around a station with `edges` along the rows of `axes`."""
        sides = []
        for axis in range(3):
            for sign in (-0.5, 0.5):
                # Corners are counter-clockwise seen from outside.
                around = CORNERS if sign > 0 else CORNERS[::-1]
                sides.append(np.roll(np.insert(around, 0, sign, axis=1), axis, axis=1))
        offsets = np.concatenate(sides) * edges @ axes
        return cls(np.full(24, station), offsets, [np.arange(24).reshape(6, 4)], body)

    @classmethod
    def triangles(cls, body: int, station: int, points: Array, corners: Numbers) -> Surface:
        """Return triangles between points fixed to a station. Points at creases occur once for each side."""
        return cls(np.full(len(points), station), points, [corners], body)

    @classmethod
    def sphere(
        cls, body: int, station: int, center: Array, radius: float, sides: int, *, grey: bool = False
    ) -> Surface:
        """Return a sphere around a point fixed to a station."""
        import pyvista as pv

        sphere = pv.Sphere(radius=radius, theta_resolution=sides, phi_resolution=sides)
        faces = sphere.regular_faces.astype(np.int64)
        return cls(np.full(sphere.n_points, station), sphere.points + center, [faces], body, grey)
