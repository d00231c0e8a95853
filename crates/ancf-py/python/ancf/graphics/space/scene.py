"""Surfaces of all bodies in space."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ancf import _ancf
from ancf.graphics.frames import require_int
from ancf.graphics.lines import Lines, drawn_parts
from ancf.graphics.quantities import quantity
from ancf.graphics.space.surface import Outlines, Surface
from ancf.graphics.style import COLOURS

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from pyvista import PolyData

    from ancf.record.columns import Array
    from ancf.record.result_data import ResultData

ARM_RADIUS = 0.008
"""Radius of the arms of rigid bodies, relative to the size of the model."""

CYLINDER_MARGIN = 0.04
"""Length of a cylindrical obstacle beyond the bodies, relative to the size of the model."""


class Scene:
    """Surfaces of all bodies of a result. Faces are computed once, points in each frame."""

    def __init__(
        self,
        result: ResultData,
        *,
        color: str | None = None,
        scale: float | None = None,
        parts: int = 8,
        sides: int = 24,
        least: float = 0.0,
    ) -> None:
        """Compute the surfaces of `Result.scene`. Their minimum thickness is `least` times the size of the model."""
        require_int("sides", sides, 3)
        self.result, self.color = result, color
        parts = drawn_parts(result, parts)
        self.lines = Lines(result, parts)
        self.geometry = self.lines.geometry
        self.scale = scale
        self.directors = result.field("directors", parts=parts)
        self.quantity = None if color is None else quantity(result, color, parts)
        """Quantity to colour by."""
        self.factor = 1.0
        """Factor of the values, for a unit with a prefix."""
        self.model: Mapping[str, Any] = result.model
        self.sides, self._least = sides, least * self.lines.size
        self.surfaces = [*self._bodies(), *self._arms(), *self._obstacles()]
        starts = np.cumsum([0, *(len(surface.owners) for surface in self.surfaces)])
        self._owners = np.concatenate([surface.owners for surface in self.surfaces])
        self._offsets = np.concatenate([surface.offsets for surface in self.surfaces])
        self._faces = [
            (surface, face + start)
            for surface, start in zip(self.surfaces, starts[:-1], strict=True)
            for face in surface.faces
        ]

    def points(self, row: int, scale: float | None = None) -> Array:
        """Return the points of all surfaces in a frame, `[point, 3]`."""
        scale = self.scale if scale is None else scale
        positions = self.lines.positions(row, scale)
        directors: Array = self.directors[row]
        if self.lines.modal or scale not in {None, 1.0}:
            directors = self._aligned(directors, positions)
        # Surfaces on the ground belong to an additional station at the origin.
        positions = np.concatenate([positions, np.zeros((1, 3))])
        directors = np.concatenate([directors, np.eye(3)[None]])
        turned = np.einsum("pi,pij->pj", self._offsets, directors[self._owners])
        points: Array = positions[self._owners] + turned
        return points

    def mesh(self, row: int) -> PolyData:
        """Return the mesh of all surfaces in a frame."""
        import pyvista as pv

        faces = [np.insert(face, 0, face.shape[1], axis=1).ravel() for _, face in self._faces]
        mesh = pv.PolyData(self.points(row), np.concatenate(faces))
        counts = [len(face) for _, face in self._faces]
        mesh.cell_data["body"] = np.repeat([surface.body for surface, _ in self._faces], counts)
        mesh.cell_data["shade"] = np.repeat(
            np.array([_rgb(surface) for surface, _ in self._faces], dtype=np.uint8), counts, axis=0
        )
        mesh.point_data["s"] = np.append(self.lines.arc_lengths, 0.0)[self._owners]
        self._set_values(mesh, row)
        return mesh

    def joints(self, row: int) -> dict[str, Array]:
        """Return the positions of joints in a frame by name: those of their ends `a`."""
        return self.symbols(row)["joint"]

    def symbols(self, row: int, scale: float | None = None) -> dict[str, dict[str, Array]]:
        """Return the positions of joints, probes and loads in a frame, by kind and name."""
        return self.lines.symbols(row, self.factor_of(row, scale))

    def factor_of(self, row: int, scale: float | None = None) -> float:
        """Return the factor of deflections in a frame."""
        scale = self.scale if scale is None else scale
        return self.lines.scale(row) if scale is None else scale

    def move(self, mesh: PolyData, row: int, scale: float | None = None) -> None:
        """Move a mesh of this scene to another frame."""
        mesh.points = self.points(row, scale)
        self._set_values(mesh, row)

    def _set_values(self, mesh: PolyData, row: int) -> None:
        if self.quantity is not None and self.color is not None:
            values = np.append(self.factor * self.quantity.values[row], np.nan)
            mesh.point_data[self.color] = values[self._owners]
        mesh.compute_normals(cell_normals=False, split_vertices=False, consistent_normals=False, inplace=True)

    def _aligned(self, directors: Array, positions: Array) -> Array:
        """Return directors rotated to the tangents of the lines, with minimal rotation, and those of shells."""
        turned: Array = directors.copy()
        for name, stations in self.lines.bodies.items():
            if name in self.lines.grids:
                turned[stations] = _frames(positions[self.lines.grids[name]])
            elif stations.stop - stations.start > 1:
                tangent = np.gradient(positions[stations], axis=0)
                normal = tangent / np.linalg.norm(tangent, axis=1, keepdims=True)
                y = directors[stations, 1]
                y = y - normal * np.sum(y * normal, axis=1, keepdims=True)
                y /= np.linalg.norm(y, axis=1, keepdims=True)
                turned[stations] = np.stack([normal, y, np.cross(normal, y)], axis=1)
        return turned

    def _bodies(self) -> Iterator[Surface]:
        data = {body["name"]: body for body in self.model["bodies"]}
        size = self.lines.size
        for number, (name, stations) in enumerate(self.lines.bodies.items()):
            if name in self.lines.grids:
                thickness = max(data[name]["thickness"], self._least)
                yield Surface.shell(number, self.lines.grids[name], thickness)
            elif stations.stop - stations.start > 1:
                s = self.lines.arc_lengths[stations]
                outlines = Outlines.of_body(self.geometry, name, s, self.sides).thickened(self._least)
                yield Surface.swept(number, range(stations.start, stations.stop), outlines)
            elif (surface := self.geometry.surface(name)) is not None:
                yield Surface.triangles(number, stations.start, *surface)
            elif data[name]["kind"] == "rigid":
                edges, axes = _ancf.inertia_box(data[name], _ancf.BOX_EDGE * size)
                yield Surface.box(number, stations.start, edges, axes)
            else:
                contact = data[name].get("surface", {}).get("radius", 0)
                radius = contact if contact > 0 else _ancf.POINT_MASS_RADIUS * size
                yield Surface.sphere(number, stations.start, np.zeros(3), radius, self.sides)

    def _arms(self) -> Iterator[Surface]:
        """Return the arms of rigid bodies without a surface."""
        numbers = {
            stations.start: number
            for number, (name, stations) in enumerate(self.lines.bodies.items())
            if self.geometry.surface(name) is None
        }
        arms, radius = self.lines.arms, ARM_RADIUS * self.lines.size
        drawn = (arm for arm in zip(arms.stations, arms.offsets, strict=True) if arm[0] in numbers)
        for station, offset in drawn:
            yield Surface.cylinder(numbers[station], station, np.zeros(3), offset, radius, self.sides)

    def _obstacles(self) -> Iterator[Surface]:
        """Return spheres and cylinders that bodies touch from outside, on the ground or on rigid bodies."""
        centres = {body["name"]: body["center"] for body in self.model["bodies"] if "center" in body}
        names = list(self.lines.bodies)
        for contact in self.model.get("contacts", []):
            obstacle, on = contact["with"], contact["with"].get("on", "ground")
            carrier = on.get("body") if isinstance(on, dict) else None
            if obstacle["kind"] not in {"sphere", "cylinder"} or obstacle.get("inside"):
                continue
            if carrier is not None and carrier not in centres:
                continue
            station = len(self.lines.arc_lengths) if carrier is None else self.lines.bodies[carrier].start
            origin = np.asarray(centres.get(carrier, (0.0, 0.0, 0.0)), dtype=float)
            body = -1 if carrier is None else names.index(carrier)
            yield self._obstacle(obstacle, body, station, origin)

    def _obstacle(self, obstacle: Mapping[str, Any], body: int, station: int, origin: Array) -> Surface:
        radius, sides = float(obstacle["radius"]), 2 * self.sides
        if obstacle["kind"] == "sphere":
            centre = np.asarray(obstacle["center"], dtype=float) - origin
            return Surface.sphere(body, station, centre, radius, sides, grey=True)
        # The cylinder is infinite: the surface ends a little beyond the bodies.
        point = np.asarray(obstacle["point"], dtype=float)
        axis = np.asarray(obstacle["axis"], dtype=float) / np.linalg.norm(obstacle["axis"])
        along, margin = (self.lines.reference - point) @ axis, CYLINDER_MARGIN * self.lines.size
        start, end = (point - origin + axis * s for s in (along.min() - margin, along.max() + margin))
        return Surface.cylinder(body, station, start, end, radius, sides)


def _frames(grid: Array) -> Array:
    """Return normal and tangents of a surface, `[point, 3, 3]`, from its points `[row, column, 3]`."""
    along, across = np.gradient(grid, axis=1), np.gradient(grid, axis=0)
    normal = np.cross(along, across)
    normal, along = (x / np.linalg.norm(x, axis=-1, keepdims=True) for x in (normal, along))
    frames: Array = np.stack([normal, along, np.cross(normal, along)], axis=-2)
    return frames.reshape(-1, 3, 3)


def _rgb(surface: Surface) -> list[int]:
    """Return red, green and blue of a surface."""
    colour = "#b0b0b0" if surface.grey else COLOURS[surface.body % len(COLOURS)]
    return [int(colour[i : i + 2], 16) for i in (1, 3, 5)]
