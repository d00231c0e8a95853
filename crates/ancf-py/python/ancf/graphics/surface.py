"""Surfaces that follow stations: sections swept along bodies, boxes and balls of rigid ones."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from ancf.record import Array

Section: TypeAlias = "Mapping[str, Any]"
"""A cross-section as a model states it: `kind` and its lengths."""

Numbers: TypeAlias = "np.typing.NDArray[np.int64]"


@dataclass(frozen=True)
class Outline:
    """The edge of a section, counter-clockwise seen from the end of the body."""

    points: Array
    """y and z, `[point, 2]`; two at a corner, so that it is not rounded off."""
    edges: Numbers
    """First and second point of each edge, `[edge, 2]`."""
    hole: Array | None = None
    """The edge of the bore, as many points."""

    @classmethod
    def of(cls, section: Section, sides: int) -> Outline:
        """The outline of a section, with so many `sides` if it is round.

        Of a section that is given by numbers, an ellipse of its area and of the ratio of its moments.
        """
        kind = section["kind"]
        if kind == "rectangle":
            y, z = section["height"] / 2, section["width"] / 2
            corners = np.array([[y, -z], [y, z], [-y, z], [-y, -z]])
            points = np.stack([corners, np.roll(corners, -1, axis=0)], axis=1).reshape(-1, 2)
            return cls(points, np.arange(8).reshape(4, 2))
        angles = 2 * np.pi * np.arange(sides) / sides
        circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        edges = np.stack([np.arange(sides), np.roll(np.arange(sides), -1)], axis=1)
        if kind == "circle":
            return cls(section["diameter"] / 2 * circle, edges)
        if kind == "tube":
            return cls(section["outer"] / 2 * circle, edges, section["inner"] / 2 * circle)
        if kind == "ellipse":
            return cls(circle * [section["height"] / 2, section["width"] / 2], edges)
        ratio = (section["iz"] / section["iy"]) ** 0.25
        return cls(np.sqrt(section["area"] / np.pi) * circle * [ratio, 1 / ratio], edges)

    def swelled(self, least: float) -> Outline:
        """The same shape, magnified if it is nowhere as thick as `least`."""
        widest = 2 * float(np.abs(self.points).max())
        if widest >= least:
            return self
        hole = None if self.hole is None else self.hole * least / widest
        return Outline(self.points * least / widest, self.edges, hole)


@dataclass(frozen=True)
class Surface:
    """Points that are fixed in the frames of stations, and faces between them."""

    owners: Numbers
    """The station of each point."""
    offsets: Array
    """From the station to the point in the directors of the station, `[point, 3]`."""
    faces: list[Numbers]
    """Numbers of points, `[face, corner]`, of faces with as many corners each."""
    body: int
    """Number of the body, -1 for what is fixed to the ground."""
    grey: bool = False
    """Whether it is what a body touches or an arm, not a body."""

    @classmethod
    def swept(cls, body: int, stations: range, start: Outline, end: Outline, along: Array) -> Surface:
        """The closed surface of a body with sections from `start` to `end`, as `along` goes from 0 to 1."""
        if len(start.points) != len(end.points) or (start.hole is None) != (end.hole is None):
            end = start
        count, k = len(stations), len(start.points)
        owners = np.repeat(np.array(stations), k)
        loops = [(start.points, end.points, start.edges)]
        if start.hole is not None and end.hole is not None:
            loops.append((start.hole, end.hole, start.edges[:, ::-1]))
        offsets, faces = [], []
        first = k * np.arange(count - 1)[:, None]
        for i, (a, b, edges) in enumerate(loops):
            u = along[:, None, None]
            offsets.append(((1 - u) * a + u * b).reshape(-1, 2))
            one, two = edges[:, 0] + i * k * count, edges[:, 1] + i * k * count
            sides = np.stack([first + one, first + two, first + two + k, first + one + k], axis=-1)
            faces.append(sides.reshape(-1, 4))
        plane = np.concatenate(offsets)
        points = np.concatenate([np.zeros((len(plane), 1)), plane], axis=1)
        made = cls(np.tile(owners, len(loops)), points, faces, body)
        return made.capped(k, count, start.edges)

    def capped(self, k: int, count: int, edges: Numbers) -> Surface:
        """The same with ends, which have points of their own so that their edges are sharp."""
        owners, offsets, faces, total = [self.owners], [self.offsets], list(self.faces), len(self.owners)
        hollow = len(self.faces) == 2
        for station, turn in ((0, -1), (count - 1, 1)):
            own = np.arange(k) + station * k
            if hollow:
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
    def rod(cls, body: int, station: int, start: Array, end: Array, radius: float, sides: int) -> Surface:
        """A cylinder between two points that are fixed at a station."""
        axis = (end - start) / np.linalg.norm(end - start)
        across = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
        across /= np.linalg.norm(across)
        outline = Outline.of({"kind": "circle", "diameter": 2 * radius}, sides)
        tube = cls.swept(body, range(2), outline, outline, np.array([0.0, 1.0]))
        frame = np.stack([across, np.cross(axis, across)])
        offsets = np.where(tube.owners[:, None] == 0, start, end) + tube.offsets[:, 1:] @ frame
        return cls(np.full(len(offsets), station), offsets, tube.faces, body, grey=True)

    @classmethod
    def box(cls, body: int, station: int, edges: Array, axes: Array) -> Surface:
        """A box about a station with `edges` along the rows of `axes`."""
        low = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) / 2
        sides = []
        for axis in range(3):
            for sign in (-0.5, 0.5):
                # Seen from outside the corners go around counter-clockwise.
                around = low if sign > 0 else low[::-1]
                sides.append(np.roll(np.insert(around, 0, sign, axis=1), axis, axis=1))
        offsets = np.concatenate(sides) * edges @ axes
        return cls(np.full(24, station), offsets, [np.arange(24).reshape(6, 4)], body)

    @classmethod
    def ball(cls, body: int, station: int, center: Array, radius: float, sides: int) -> Surface:
        """A ball about a point that is fixed at a station."""
        import pyvista as pv

        ball = pv.Sphere(radius=radius, theta_resolution=sides, phi_resolution=sides)
        faces = ball.regular_faces.astype(np.int64)
        return cls(np.full(ball.n_points, station), ball.points + center, [faces], body)


def inertial(body: Mapping[str, Any], greatest: float) -> tuple[Array, Array]:
    """Edges and axes of the box that has the inertia of a rigid body, at most `greatest`.

    A box of mass m with edges a, b, c has I_a = m (b² + c²)/12, so that a² = 6 (I_b + I_c - I_a)/m.
    """
    inertia = np.diag(np.asarray(body["inertia"], dtype=float))
    products = np.asarray(body.get("products") or [0.0, 0.0, 0.0], dtype=float)
    inertia[[0, 0, 1], [1, 2, 2]] = products
    inertia[[1, 2, 2], [0, 0, 1]] = products
    moments, axes = np.linalg.eigh(inertia)
    edges = np.sqrt(np.maximum(6 * (moments.sum() - 2 * moments) / body["mass"], 0))
    longest = float(edges.max())
    if longest == 0:
        return np.full(3, greatest), np.eye(3)
    # A needle or a plate is to be seen too.
    return np.maximum(edges, 0.15 * longest) * min(1.0, greatest / longest), axes.T
