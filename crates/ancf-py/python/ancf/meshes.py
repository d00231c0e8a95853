"""Meshes of shear-deformable shells from arrays and from meshes of meshio."""

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike

from ancf.model import ElementMesh, MeshGroup

__all__ = ["grid_mesh", "mesh_from_meshio"]

FACES = {"quad", "triangle"}
"""Types of cells that are elements."""


class MeshioCells(Protocol):
    """Block of cells of one type, as in meshio."""

    @property
    def type(self) -> str:
        """Name of the type of the cells."""

    @property
    def data(self) -> Any:
        """Numbers of the nodes of each cell."""


class MeshioMesh(Protocol):
    """Attributes of a mesh of meshio that are used."""

    @property
    def points(self) -> Any:
        """Nodes."""

    @property
    def cells(self) -> Sequence[MeshioCells]:
        """Blocks of cells."""

    @property
    def point_sets(self) -> Mapping[str, Any]:
        """Named nodes."""

    @property
    def cell_sets(self) -> Mapping[str, Sequence[Any]]:
        """Named cells: numbers in each block."""

    @property
    def cell_data(self) -> Mapping[str, Sequence[Any]]:
        """Data of the cells of each block."""

    @property
    def field_data(self) -> Mapping[str, Any]:
        """Numbers and dimensions of physical groups of Gmsh."""


def grid_mesh(points: ArrayLike) -> ElementMesh:
    """Return the mesh of quadrilaterals of a grid of points.

    Its edges have the names ``u_start``, ``u_end``, ``v_start`` and ``v_end``.

    Parameters
    ----------
    points
        Points as an array of shape (m + 1, n + 1, 3) for m elements along v and n along u. The normal has the
        direction of u × v.

    """
    grid = np.asarray(points, dtype=float)
    if grid.ndim != 3 or grid.shape[2] != 3 or min(grid.shape[:2]) < 2:
        message = f"points: found an array of shape {grid.shape}, expected (m + 1, n + 1, 3) with m, n >= 1"
        raise ValueError(message)
    numbers = np.arange(grid.shape[0] * grid.shape[1]).reshape(grid.shape[:2])
    corners = [numbers[:-1, :-1], numbers[:-1, 1:], numbers[1:, 1:], numbers[1:, :-1]]
    edges = {
        "u_start": numbers[:, 0],
        "u_end": numbers[:, -1],
        "v_start": numbers[0],
        "v_end": numbers[-1],
    }
    return ElementMesh(
        nodes=grid.reshape(-1, 3),
        elements=np.stack(corners, axis=-1).reshape(-1, 4),
        groups={name: MeshGroup(edges=[nodes.tolist()]) for name, nodes in edges.items()},
    )


def mesh_from_meshio(mesh: MeshioMesh, scale: float = 1.0) -> ElementMesh:
    """Return the mesh of the quadrilaterals and triangles of a mesh of meshio.

    Sets of points, lines and faces, and physical groups of Gmsh, become groups of the same name. Nodes of no
    quadrilateral and no triangle are left out.

    Parameters
    ----------
    mesh
        Mesh as ``meshio.read`` returns it, also from files of Abaqus, Nastran and other formats.
    scale
        Length of the unit of the mesh: 0.001 for millimetres in a model in metres.

    Raises
    ------
    ValueError
        If there are no faces, or others than quadrilaterals of four and triangles of three nodes, or a set mixes
        points, lines and faces, or has nodes of no face.

    """
    other = sorted({block.type for block in mesh.cells} - FACES - {"vertex", "line"})
    if other:
        raise ValueError(f"cells: found {', '.join(other)}, expected quad and triangle, with line and vertex")
    faces = list(_oriented(mesh))
    if not faces:
        raise ValueError("cells: found no quad and no triangle")
    if not (np.isfinite(scale) and scale > 0):
        raise ValueError(f"scale: found {scale}, expected a number > 0")
    used = np.unique(np.concatenate(faces))
    number = {int(node): k for k, node in enumerate(used)}
    points = np.asarray(mesh.points, dtype=float)[used] * scale
    return ElementMesh(
        # Points of plane meshes may have two components.
        nodes=np.pad(points, ((0, 0), (0, 3 - points.shape[1]))),
        elements=[[number[int(node)] for node in face] for face in faces],
        groups=_groups(mesh, number) or None,
    )


def _oriented(mesh: MeshioMesh) -> Iterable[Any]:
    """Return the faces of a mesh, reversed in physical groups of Gmsh with a negative number.

    Files of version 4.1 have faces in the orientation of their surface, and those of version 2.2 in that of the group.
    meshio states the entities of the former only as sets.
    """
    physical = mesh.cell_data.get("gmsh:physical")
    is_version_4 = any(name.startswith("gmsh:bounding_entities") for name in mesh.cell_sets)
    for index, block in enumerate(mesh.cells):
        if block.type in FACES:
            numbers = physical[index] if physical is not None and is_version_4 else np.zeros(len(block.data))
            for face, group in zip(block.data, numbers, strict=True):
                yield face[::-1] if group < 0 else face


def _groups(mesh: MeshioMesh, number: Mapping[int, int]) -> dict[str, MeshGroup]:
    """Return the groups of a mesh, given the new numbers of its nodes."""

    def renumbered(name: str, nodes: Iterable[Any]) -> list[int]:
        try:
            return [number[int(node)] for node in nodes]
        except KeyError as missing:
            raise ValueError(
                f"set {name!r}: found node {missing}, which no quad and no triangle has"
            ) from None

    members: dict[str, dict[str, list[Any]]] = defaultdict(lambda: defaultdict(list))
    for name, nodes in mesh.point_sets.items():
        members[name]["nodes"] += renumbered(name, nodes)
    first = 0
    for index, block in enumerate(mesh.cells):
        for name, cells in _sets(mesh, index):
            if block.type in FACES:
                members[name]["elements"] += [first + int(cell) for cell in cells]
            elif block.type == "line":
                members[name]["edges"] += [renumbered(name, block.data[int(cell)]) for cell in cells]
            else:
                members[name]["nodes"] += renumbered(name, np.ravel(np.asarray(block.data)[cells]))
        first += len(block.data) if block.type in FACES else 0
    for name, kinds in members.items():
        if len(kinds) > 1:
            raise ValueError(f"set {name!r}: found {' and '.join(kinds)}, expected one of them")
        if "edges" in kinds:
            kinds["edges"] = _chains(kinds["edges"])
    return {name: MeshGroup(**kinds) for name, kinds in members.items()}


def _sets(mesh: MeshioMesh, block: int) -> Iterable[tuple[str, Any]]:
    """Return the named sets of the cells of a block: sets of meshio, and physical groups of Gmsh."""
    found = {}
    for name, of_blocks in mesh.cell_sets.items():
        cells = of_blocks[block]
        # meshio stores entities of Gmsh as sets with names of its own.
        if cells is not None and len(cells) > 0 and not name.startswith("gmsh:"):
            found[name] = cells
    physical = mesh.cell_data.get("gmsh:physical")
    if physical is not None:
        # Numbers of physical groups begin with 1 in each dimension, and are negative for the opposite orientation.
        numbers, dimension = np.abs(physical[block]), _dimension(mesh.cells[block].type)
        names = {int(tag): name for name, (tag, of) in mesh.field_data.items() if int(of) == dimension}
        for tag in np.unique(numbers):
            if tag != 0:
                found.setdefault(names.get(int(tag), str(tag)), np.flatnonzero(numbers == tag))
    return found.items()


def _dimension(cell: str) -> int:
    """Return the dimension of a type of cells."""
    if cell in FACES:
        return 2
    return 1 if cell == "line" else 0


def _chains(segments: list[list[int]]) -> list[list[int]]:
    """Return segments joined to chains. A closed chain ends with its first node."""
    at = defaultdict(list)
    for k, (a, b) in enumerate(segments):
        at[a].append(k)
        at[b].append(k)
    # Chains start at ends and branches; closed ones are left for the second pass.
    starts = [node for node in at if len(at[node]) != 2] + list(at)
    unused, chains = set(range(len(segments))), []
    for start in starts:
        for first in at[start]:
            chain, following = [start], first if first in unused else None
            while following is not None:
                unused.discard(following)
                a, b = segments[following]
                chain.append(b if a == chain[-1] else a)
                own = at[chain[-1]]
                following = next((k for k in own if len(own) == 2 and k in unused), None)
            if len(chain) > 1:
                chains.append(chain)
    return chains
