"""Bodies in space: one surface that follows the stations of a result."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ancf.lines import COLOURS, Lines, rows, whole
from ancf.surface import Outline, Surface, inertial

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from pyvista import PolyData

    from ancf.record import Array
    from ancf.result import Result


class Scene:
    """The surfaces of all bodies of a result, put together once; only their points move."""

    def __init__(
        self,
        result: Result,
        *,
        color: str | None = None,
        scale: float | None = None,
        parts: int = 8,
        sides: int = 24,
        least: float = 0.0,
    ) -> None:
        """Surfaces as `Result.scene` describes them; nothing is thinner than `least` of the model's size."""
        whole("sides", sides, 3)
        self.result, self.color = result, color
        self.lines = Lines(result, parts)
        self.scale = scale
        self.directors = result.field("directors", parts=parts)
        self.values = None if color is None else self.lines.values(result, color, parts)
        """Numbers to colour by, `[row, station]`."""
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

    def row(self, frame: int, time: float | None) -> int:
        """The number of the row that is asked for."""
        return rows(self.result, frame, time)[0]

    def points(self, row: int, scale: float | None = None) -> Array:
        """Points of all surfaces in a row, `[point, 3]`."""
        scale = self.scale if scale is None else scale
        places = self.lines.places(row, scale)
        directors: Array = self.directors[row]
        if self.lines.modal or scale not in {None, 1.0}:
            directors = self._aligned(directors, places)
        # What stands on the ground is at one more station, the origin.
        places = np.concatenate([places, np.zeros((1, 3))])
        directors = np.concatenate([directors, np.eye(3)[None]])
        turned = np.einsum("pi,pij->pj", self._offsets, directors[self._owners])
        points: Array = places[self._owners] + turned
        return points

    def mesh(self, row: int) -> PolyData:
        """The surfaces in a row."""
        import pyvista as pv

        faces = [np.insert(face, 0, face.shape[1], axis=1).ravel() for _, face in self._faces]
        mesh = pv.PolyData(self.points(row), np.concatenate(faces))
        counts = [len(face) for _, face in self._faces]
        mesh.cell_data["body"] = np.repeat([surface.body for surface, _ in self._faces], counts)
        mesh.cell_data["shade"] = np.repeat(
            np.array([self._shade(surface) for surface, _ in self._faces], dtype=np.uint8), counts, axis=0
        )
        mesh.point_data["s"] = np.append(self.lines.along, 0.0)[self._owners]
        self._dress(mesh, row)
        return mesh

    def joints(self, row: int) -> dict[str, Array]:
        """Where joints are in a row, by their names: the places of their ends `a`."""
        places, found = self.lines.places(row, self.scale), {}
        for joint in self.model.get("joints", []):
            span, at = self.lines.bodies[joint["a"]["body"]], joint["a"].get("at", "center")
            along = self.lines.along[span]
            named = {"start": 0.0, "center": along[-1] / 2, "end": along[-1]}
            s = named.get(at) if isinstance(at, str) else at
            # Of a rigid body, whose stations are one, it is the centre.
            found[joint["name"]] = places[span][np.abs(along - s).argmin() if np.isscalar(s) else 0]
        return found

    def move(self, mesh: PolyData, row: int, scale: float | None = None) -> None:
        """Move a mesh of this scene to another row."""
        mesh.points = self.points(row, scale)
        self._dress(mesh, row)

    def _dress(self, mesh: PolyData, row: int) -> None:
        if self.values is not None and self.color is not None:
            mesh.point_data[self.color] = np.append(self.values[row], np.nan)[self._owners]
        mesh.compute_normals(cell_normals=False, split_vertices=False, consistent_normals=False, inplace=True)

    def _shade(self, surface: Surface) -> list[int]:
        colour = "#b0b0b0" if surface.grey else COLOURS[surface.body % len(COLOURS)]
        return [int(colour[i : i + 2], 16) for i in (1, 3, 5)]

    def _aligned(self, directors: Array, places: Array) -> Array:
        """Directors turned as little as makes them go with lines that are not where the directors were."""
        turned: Array = directors.copy()
        for span in self.lines.bodies.values():
            if span.stop - span.start > 1:
                tangent = np.gradient(places[span], axis=0)
                normal = tangent / np.linalg.norm(tangent, axis=1, keepdims=True)
                y = directors[span, 1] - normal * np.sum(directors[span, 1] * normal, axis=1, keepdims=True)
                y /= np.linalg.norm(y, axis=1, keepdims=True)
                turned[span] = np.stack([normal, y, np.cross(normal, y)], axis=1)
        return turned

    def _bodies(self) -> Iterator[Surface]:
        data = {body["name"]: body for body in self.model["bodies"]}
        size = self.lines.size
        for number, (name, span) in enumerate(self.lines.bodies.items()):
            body = data[name]
            if span.stop - span.start > 1:
                s = self.lines.along[span]
                start = self._outline(body["section"])
                end = self._outline(body["section_end"]) if body.get("section_end") else start
                yield Surface.swept(number, range(span.start, span.stop), start, end, s / s[-1])
            elif body["kind"] == "rigid":
                yield Surface.box(number, span.start, *inertial(body, 0.12 * size))
            else:
                yield Surface.ball(number, span.start, np.zeros(3), 0.02 * size, self.sides)

    def _outline(self, name: str) -> Outline:
        return Outline.of(self.model["sections"][name], self.sides).swelled(self._least)

    def _arms(self) -> Iterator[Surface]:
        numbers = {span.start: number for number, span in enumerate(self.lines.bodies.values())}
        arms = self.lines.arms
        for station, offset in zip(arms.stations, arms.offsets, strict=True):
            radius = 0.008 * self.lines.size
            yield Surface.rod(numbers[station], station, np.zeros(3), offset, radius, self.sides)

    def _obstacles(self) -> Iterator[Surface]:
        """Balls and cylinders that bodies touch from outside, on the ground or on rigid bodies."""
        centres = {body["name"]: body["center"] for body in self.model["bodies"] if "center" in body}
        names = list(self.lines.bodies)
        for contact in self.model.get("contacts", []):
            obstacle, on = contact["with"], contact["with"].get("on", "ground")
            carrier = on.get("body") if isinstance(on, dict) else None
            if obstacle["kind"] not in {"sphere", "cylinder"} or obstacle.get("inside"):
                continue
            if carrier is not None and carrier not in centres:
                continue
            station = len(self.lines.along) if carrier is None else self.lines.bodies[carrier].start
            origin = np.asarray(centres.get(carrier, (0.0, 0.0, 0.0)), dtype=float)
            body = -1 if carrier is None else names.index(carrier)
            yield self._obstacle(obstacle, body, station, origin)

    def _obstacle(self, obstacle: Mapping[str, Any], body: int, station: int, origin: Array) -> Surface:
        radius = float(obstacle["radius"])
        if obstacle["kind"] == "sphere":
            centre = np.asarray(obstacle["center"], dtype=float) - origin
            ball = Surface.ball(body, station, centre, radius, 2 * self.sides)
            return Surface(ball.owners, ball.offsets, ball.faces, body, grey=True)
        # It is endless: what is shown reaches a little beyond the bodies.
        point = np.asarray(obstacle["point"], dtype=float)
        axis = np.asarray(obstacle["axis"], dtype=float) / np.linalg.norm(obstacle["axis"])
        along, beyond = (self.lines.rest - point) @ axis, 0.04 * self.lines.size
        start, end = (point - origin + axis * s for s in (along.min() - beyond, along.max() + beyond))
        return Surface.rod(body, station, start, end, radius, 2 * self.sides)
