"""Symbols of a scene: joints, ground, springs, probes, gravity, reaction forces and planes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ancf.display.numbers import quantity_text
from ancf.graphics.style import SUPPORT_GREY
from ancf.record.columns import Array

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from pyvista import PolyData

    from ancf.graphics.space.scene import Scene

JOINT = 0.013
"""Radius of a joint, relative to the size of the model."""

SUPPORT = 0.05
"""Edge of a support on the ground, relative to the size of the model."""

PROBE = 0.011
"""Radius of a probe, relative to the size of the model."""

ARROW = 0.22
"""Length of the longest reaction force, relative to the size of the model."""

GRAVITY = 0.12
"""Length of the arrow of gravity, relative to the shown extent."""

LINK = 0.006
"""Radius of the end of a rod, relative to the size of the model."""

NOISE = 1e-6
"""Forces below this fraction of the largest one have no arrow."""

COILS, POINTS_OF_COIL = 8, 16
"""Coils of a spring, points of each."""

COLOURS = {
    "joints": "#303030",
    "ground": SUPPORT_GREY,
    "links": "#5b6770",
    "probes": "#E69F00",
    "reactions": "#C2185B",
    "gravity": "#444444",
    "obstacles": "#b0b0b0",
}
"""Colours of the groups of symbols."""

OPACITIES = {"obstacles": 0.35}
"""Opacities of the groups that are transparent."""


class Symbols:
    """Symbols of a scene in each frame."""

    def __init__(self, scene: Scene, extent: Array) -> None:
        """Read joints, contacts and gravity of the model. The arrow of gravity is beside the points `extent`."""
        self.scene = scene
        self._low, self._high = extent.min(0), extent.max(0)
        self.model: Mapping[str, Any] = scene.model
        self.size = scene.lines.size
        self._joints = {joint["name"]: joint for joint in self.model.get("joints", [])}
        self._places = {probe["name"]: probe["on"]["body"] for probe in self.model.get("probes", [])}
        self._thickness = dict(self._thicknesses())
        reactions = {} if scene.lines.modal else scene.result.reactions
        self._forces = {name: reaction.force for name, reaction in reactions.items()}
        sizes = [np.linalg.norm(force, axis=1).max(initial=0.0) for force in self._forces.values()]
        self._largest_force = float(max(sizes, default=0.0))

    def meshes(self, row: int, scale: float | None = None) -> dict[str, PolyData]:
        """Return the meshes of the groups in a frame. Groups without symbols are omitted."""
        symbols = self.scene.symbols(row, scale)
        links = list(self._links(row, scale))
        groups = {
            "joints": [
                self._joint(name, at) for name, at in symbols["joint"].items() if name not in dict(links)
            ],
            "ground": [self._support(*support, row) for support in self._supports(symbols["joint"], links)],
            "links": [self._link(*link) for _, link in links],
            "probes": [self._probe(name, at) for name, at in symbols["probe"].items()],
            "reactions": [_arrow(start, end) for _, start, end in self.arrows(row, symbols["joint"])],
            "gravity": [_arrow(*ends) for ends in self.gravity()],
            "obstacles": list(self._planes()),
        }
        return {group: _merged(parts) for group, parts in groups.items() if parts}

    def points(self, row: int, scale: float | None = None) -> Array:
        """Return points around all symbols in a frame, for the camera."""
        symbols = self.scene.symbols(row, scale)
        ends = [end for _, start, end in self.arrows(row, symbols["joint"])]
        ends += [point for arrow in self.gravity() for point in arrow]
        ends += [point for _, (_, *points) in self._links(row, scale) for point in points]
        ends += [
            at + shift
            for at in symbols["joint"].values()
            for shift in SUPPORT * self.size * np.vstack([np.eye(3), -np.eye(3)])
        ]
        return np.array(ends).reshape(-1, 3)

    def arrows(self, row: int, joints: Mapping[str, Array]) -> Iterator[tuple[str, Array, Array]]:
        """Return name, start and end of the reaction forces in a frame."""
        number = int(self.scene.result.frame_rows[row])
        for name, force in self._forces.items():
            if number < 0 or name not in joints:
                continue
            vector = force[number]
            if np.linalg.norm(vector) > NOISE * self._largest_force:
                yield name, joints[name], joints[name] + vector * (ARROW * self.size / self._largest_force)

    def labels(self, row: int) -> dict[str, Array]:
        """Return texts with positions: joints with their forces, probes and gravity."""
        symbols = self.scene.symbols(row)
        result = self.scene.result
        texts = {name: name for name in symbols["joint"]}
        for name, _, _ in self.arrows(row, symbols["joint"]):
            size = float(np.linalg.norm(self._forces[name][result.frame_rows[row]]))
            texts[name] = f"{name}: {quantity_text(size, result.units.get(f'{name}.fx'))}"
        found = {text: symbols["joint"][name] for name, text in texts.items()}
        found |= symbols["probe"]
        for _, end in self.gravity():
            found["g"] = end
        return found

    def gravity(self) -> list[tuple[Array, Array]]:
        """Return start and end of the arrow of gravity beside the model. Empty without gravity."""
        gravity = np.asarray(self.model.get("gravity") or np.zeros(3), dtype=float)
        if not gravity.any():
            return []
        down = gravity / np.linalg.norm(gravity)
        low, high = self._low, self._high
        spread = high - low
        spread[np.abs(down).argmax()] = -1.0
        # Beside the model, in its direction of largest extent normal to gravity.
        side = np.eye(3)[spread.argmax()]
        length = GRAVITY * float(np.linalg.norm(high - low))
        middle = np.where(side > 0, low - 0.8 * length, (low + high) / 2)
        return [(middle - 0.5 * length * down, middle + 0.5 * length * down)]

    def _thicknesses(self) -> Iterator[tuple[str, float]]:
        """Return the largest distance of the surface of each flexible body from its axis."""
        names = list(self.scene.lines.bodies)
        for surface in self.scene.surfaces:
            if surface.body >= 0 and len(np.unique(surface.owners)) > 1:
                yield names[surface.body], float(np.linalg.norm(surface.offsets, axis=1).max())

    def _joint(self, name: str, at: Array) -> PolyData:
        """Return a cube for a clamp, and a sphere for other joints, that enclose a thin body."""
        import pyvista as pv

        joint = self._joints[name]
        radius = self._visible(JOINT, joint["a"]["body"])
        if joint["kind"] in {"clamp", "drive"}:
            return pv.Cube(center=at, x_length=1.7 * radius, y_length=1.7 * radius, z_length=1.7 * radius)
        return _sphere(at, radius, 20)

    def _probe(self, name: str, at: Array) -> PolyData:
        """Return a sphere that encloses a thin body."""
        return _sphere(at, self._visible(PROBE, self._places[name]), 16)

    def _visible(self, radius: float, body: str) -> float:
        """Return a relative radius times the size of the model, enlarged up to a factor of 2 to enclose a body."""
        return min(max(radius * self.size, 1.25 * self._thickness.get(body, 0.0)), 2 * radius * self.size)

    def _supports(
        self, joints: Mapping[str, Array], links: list[tuple[str, Any]]
    ) -> Iterator[tuple[str, Array, Array]]:
        """Return names and positions of the ends on the ground, and the direction away from the model."""
        ends = {name: points for name, (_, *points) in links}
        for name, at in joints.items():
            other = self._joints[name].get("b", "ground")
            if other != "ground" and "point" not in other:
                continue
            start, end = ends.get(name, (at, at))
            length = float(np.linalg.norm(end - start))
            yield name, end, (end - start) / length if length > LINK * self.size else self._down()

    def _support(self, name: str, at: Array, away: Array, row: int) -> PolyData:
        """Return a plate behind a clamp, and a pyramid at other joints on the ground."""
        import pyvista as pv

        joint, edge = self._joints[name], SUPPORT * self.size
        lines = self.scene.lines
        stations = lines.bodies.get(joint["a"]["body"])
        if (
            joint["kind"] in {"clamp", "drive"}
            and stations is not None
            and stations.stop - stations.start > 1
        ):
            own = lines.positions(row, self.scene.scale)[stations]
            nearest = int(np.linalg.norm(own - at, axis=1).argmin())
            normal = np.array(self.scene.directors[row, stations][nearest, 0])
            # The plate is on the side without the body.
            outward = normal if nearest > len(own) / 2 else -normal
            edge = max(edge, 1.7 * self._thickness.get(joint["a"]["body"], 0.0))
            thickness = 0.2 * edge
            plate = pv.Cube(x_length=thickness, y_length=2 * edge, z_length=2 * edge)
            return _placed(plate, at + 0.5 * thickness * outward, outward)
        cone: PolyData = pv.Cone(
            center=at + 0.5 * edge * away, direction=-away, height=edge, radius=0.55 * edge, resolution=4
        )
        return cone

    def _down(self) -> Array:
        """Return the direction of gravity, or the negative direction of an axis of the model."""
        for start, end in self.gravity():
            along: Array = (end - start) / np.linalg.norm(end - start)
            return along
        spread = np.ptp(self.scene.lines.reference, axis=0)
        axis: Array = -np.eye(3)[1 if spread[1] >= spread[2] else 2]
        return axis

    def _links(self, row: int, scale: float | None = None) -> Iterator[tuple[str, tuple[str, Array, Array]]]:
        """Return names, kinds and ends of springs, rods and bushings."""
        names, kinds, ends = self.scene.geometry.links(
            row, self.scene.factor_of(row, scale), self.scene.lines.modal
        )
        for name, kind, (start, end) in zip(names, kinds, ends, strict=True):
            yield name, (kind, start, end)

    def _link(self, kind: str, start: Array, end: Array) -> PolyData:
        """Return a coil for a spring, and a cylinder for other links."""
        import pyvista as pv

        radius, length = LINK * self.size, float(np.linalg.norm(end - start))
        if length < radius:
            return _sphere(start, 2 * radius, 16)
        if kind != "spring":
            rod: PolyData = pv.Line(start, end).tube(radius=0.6 * radius, n_sides=12)
            return rod
        turn = np.linspace(0, 2 * np.pi * COILS, COILS * POINTS_OF_COIL + 1)
        along = (end - start) / length
        across = np.cross(along, np.eye(3)[np.abs(along).argmin()])
        across /= np.linalg.norm(across)
        width = 3.0 * radius * np.minimum(1.0, np.minimum(turn, turn[::-1]) / np.pi)[:, None]
        round_ = np.cos(turn)[:, None] * across + np.sin(turn)[:, None] * np.cross(along, across)
        points = start + (turn / turn[-1])[:, None] * (end - start) + width * round_
        coil: PolyData = pv.MultipleLines(points).tube(radius=0.5 * radius, n_sides=8)
        return coil

    def _planes(self) -> Iterator[PolyData]:
        """Return the planes on the ground with which bodies are in contact, as far as the bodies move."""
        import pyvista as pv

        for contact in self.model.get("contacts", []):
            obstacle = contact["with"]
            if obstacle["kind"] != "plane" or isinstance(obstacle.get("on"), dict):
                continue
            normal = np.asarray(obstacle["normal"], dtype=float) / np.linalg.norm(obstacle["normal"])
            points = self.scene.lines.path.reshape(-1, 3)
            offsets = points - np.asarray(obstacle["point"], dtype=float)
            onto = points - np.outer(offsets @ normal, normal)
            low, high = onto.min(0), onto.max(0)
            edge = float(np.linalg.norm(high - low)) + 0.2 * self.size
            yield pv.Plane(center=(low + high) / 2, direction=normal, i_size=edge, j_size=edge)


def _sphere(center: Array, radius: float, sides: int) -> PolyData:
    import pyvista as pv

    sphere: PolyData = pv.Sphere(radius=radius, center=center, theta_resolution=sides, phi_resolution=sides)
    return sphere


def _arrow(start: Array, end: Array) -> PolyData:
    """Return an arrow whose thickness follows its length."""
    import pyvista as pv

    arrow: PolyData = pv.Arrow(
        start=start,
        direction=end - start,
        scale=float(np.linalg.norm(end - start)),
        tip_length=0.28,
        tip_radius=0.09,
        shaft_radius=0.03,
    )
    return arrow


def _placed(mesh: PolyData, center: Array, axis: Array) -> PolyData:
    """Return a mesh with its x-axis along `axis` and its origin at `center`."""
    second = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    second /= np.linalg.norm(second)
    placed: PolyData = mesh.copy()
    placed.points = np.asarray(mesh.points) @ np.stack([axis, second, np.cross(axis, second)]) + center
    return placed


def _merged(parts: list[PolyData]) -> PolyData:
    """Return one mesh of several."""
    import pyvista as pv

    merged: PolyData = pv.merge(parts).extract_surface(algorithm="dataset_surface")
    return merged
