"""Meshes of shear-deformable shells from arrays and meshio."""

from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pytest
import pyvista
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import ancf
from ancf import ElementMesh

ROOT = Path(__file__).parents[4]


def plate(mesh: ElementMesh, clamped: str, loaded: str, end: int) -> ancf.Result:
    """Equilibrium of a cantilever plate of a mesh with a load on its other edge."""
    return ancf.run(
        {
            "materials": {"m": {"young": 1.2e6, "poisson": 0, "density": 1}},
            "bodies": [{"kind": "shear_shell", "name": "s", "mesh": mesh, "thickness": 0.1, "material": "m"}],
            "joints": [
                {
                    "kind": "support",
                    "name": "root",
                    "a": {"body": "s", "at": {"edge": clamped}},
                    "condition": "clamped",
                }
            ],
            "loads": [{"kind": "edge_force", "body": "s", "edge": loaded, "force": [0, 0, 0.01]}],
            "probes": [{"name": "end", "on": {"body": "s", "at": {"node": end}}}],
            "analysis": {"kind": "statics"},
        }
    )


def test_a_grid_bends_as_a_cantilever() -> None:
    """F L³/(3 E I) with shear, for a load of 0.01 per length."""
    u, v = np.meshgrid(np.linspace(0, 2, 9), np.linspace(0, 0.5, 3))
    result = plate(ancf.grid_mesh(np.stack([u, v, 0 * u], axis=-1)), "u_start", "u_end", 8)
    bending, shear = 0.01 * 8 / (3 * 1.2e6 * 1e-3 / 12), 0.01 * 2 / (0.6e6 * 0.1 * 5 / 6)
    assert result["end.z"][-1] == pytest.approx(bending + shear, rel=5e-3)


def mixed() -> meshio.Mesh:
    """Strip of a quadrilateral and two triangles, with an unused node, named edges, points and faces."""
    points = [[0, 0], [9, 9], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]]
    cells: list[tuple[str, Any]] = [
        ("line", [[0, 4], [6, 3]]),
        ("quad", [[0, 2, 5, 4]]),
        ("triangle", [[2, 3, 6], [2, 6, 5]]),
        ("vertex", [[6]]),
    ]
    sets: dict[str, list[Any]] = {
        "left": [[0], [], [], []],
        "right": [[1], [], [], []],
        "outer": [[], [], [0, 1], []],
        "corner": [[], [], [], [0]],
    }
    return meshio.Mesh(
        points, cells, cell_sets={name: [np.array(own, int) for own in of] for name, of in sets.items()}
    )


def test_a_mesh_of_meshio_has_its_sets() -> None:
    mesh = ancf.mesh_from_meshio(mixed(), scale=0.5)
    assert mesh.elements == [[0, 1, 4, 3], [1, 2, 5], [1, 5, 4]]
    assert np.array_equal(np.asarray(mesh.nodes)[4], [0.5, 0.5, 0])
    groups = mesh.groups or {}
    assert groups["left"].edges == [[0, 3]]
    assert groups["outer"].elements == [1, 2]
    assert groups["corner"].nodes == [5]
    assert np.isfinite(plate(mesh, "left", "right", 5)["end.z"][-1])


def test_a_file_of_gmsh_gives_the_same_shell(tmp_path: Path) -> None:
    """Physical groups of meshio are those of the own reader, also after a detour by another format."""
    read = meshio.read(ROOT / "models/bracket.msh")
    model = ancf.Model.read(ROOT / "models/bracket.toml")
    own = ancf.run(model)
    data = model.to_dict()
    data["bodies"][0]["mesh"] = ancf.mesh_from_meshio(read, scale=1e-3)
    assert ancf.run(data)["pin.z"][-1] == pytest.approx(own["pin.z"][-1], rel=1e-9)
    meshio.Mesh(read.points, read.cells).write(tmp_path / "bracket.vtk", binary=False)
    again = ancf.mesh_from_meshio(meshio.read(tmp_path / "bracket.vtk"), scale=1e-3)
    assert len(again.elements or ()) == len(data["bodies"][0]["mesh"].elements)


@pytest.mark.parametrize(
    ("file", "options"),
    [
        ("bracket.vtk", {"binary": True}),
        ("bracket.vtk", {"binary": False}),
        ("bracket.vtk", {"binary": True, "file_format": "vtk42"}),
        ("bracket.vtu", {"binary": True}),
        ("bracket.vtu", {"binary": False}),
        ("bracket.vtu", {"binary": True, "compression": None}),
    ],
)
def test_a_file_of_vtk_gives_the_same_shell(file: str, options: dict[str, Any], tmp_path: Path) -> None:
    """Files that meshio writes. Physical groups are numbers of an array."""
    read = meshio.read(ROOT / "models/bracket.msh")
    name = "physical"
    data = {name: read.cell_data["gmsh:physical"]}
    meshio.Mesh(read.points, read.cells, cell_data=data).write(tmp_path / file, **options)
    text = (ROOT / "models/bracket.toml").read_text().replace("bracket.msh", file)
    for group, (number, _) in read.field_data.items():
        text = text.replace(f'edge = "{group}"', f'edge = "{name} {number}"')
    (tmp_path / "bracket.toml").write_text(text)
    own = ancf.run(ancf.Model.read(ROOT / "models/bracket.toml"))
    result = ancf.run(ancf.Model.read(tmp_path / "bracket.toml"))
    assert result["pin.z"][-1] == pytest.approx(own["pin.z"][-1], rel=1e-9)


STRIP = """
[materials.m]
young = 1.2e6
poisson = 0
density = 1

[[bodies]]
kind = "shear_shell"
name = "s"
mesh = { file = "strip.vtp" }
thickness = 0.1
material = "m"

[[joints]]
kind = "support"
name = "root"
a = { body = "s", at = { edge = "part 1" } }
condition = "clamped"

[[loads]]
kind = "surface_pressure"
body = "s"
region = "part 2"
pressure = 0.01

[[probes]]
name = "end"
on = { body = "s", at = { point = "tip 1" } }

[analysis]
kind = "statics"
"""


@pytest.mark.parametrize("compression", ["None", "ZLib", "LZ4"])
@pytest.mark.parametrize("mode", ["Ascii", "Binary", "Appended", "Raw"])
def test_polygons_of_vtk_are_read(compression: str, mode: str, tmp_path: Path) -> None:
    """A cantilever with the load p, of a file that VTK itself writes: p L⁴/(8 D) with shear."""
    u, v = np.meshgrid(np.linspace(0, 2, 17), np.linspace(0, 0.5, 3))
    grid = ancf.grid_mesh(np.stack([u, v, 0 * u], axis=-1))
    faces = [[4, *element] for element in np.asarray(grid.elements).tolist()]
    surface = pyvista.PolyData(np.asarray(grid.nodes), faces=np.ravel(faces), lines=[3, 0, 17, 34])
    surface.cell_data["part"] = np.array([1] + [2] * len(faces), np.int32)
    surface.point_data["tip"] = (np.arange(51) == 33).astype(np.int32)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(surface)
    writer.SetFileName(str(tmp_path / "strip.vtp"))
    getattr(writer, f"SetCompressorTypeTo{compression}")()
    getattr(writer, f"SetDataModeTo{mode.replace('Raw', 'Appended')}")()
    writer.SetEncodeAppendedData(mode == "Appended")
    if mode == "Binary":
        writer.SetByteOrderToBigEndian()
        writer.SetHeaderTypeToUInt64()
    writer.Write()
    (tmp_path / "strip.toml").write_text(STRIP)
    result = ancf.run(ancf.Model.read(tmp_path / "strip.toml"))
    bending, shear = 0.01 * 16 / (8 * 1.2e6 * 1e-3 / 12), 0.01 * 4 / 2 / (0.6e6 * 0.1 * 5 / 6)
    assert result["end.z"][-1] == pytest.approx(bending + shear, rel=5e-3)


@pytest.mark.parametrize(
    ("change", "found"),
    [
        (lambda mesh: mesh.cells.pop(1), "set 'left': found node"),
        (lambda mesh: setattr(mesh.cells[1], "type", "tetra"), "cells: found tetra"),
        (lambda mesh: mesh.cell_sets["left"].__setitem__(1, np.array([0])), "set 'left': found"),
    ],
)
def test_wrong_meshes_are_rejected(change: Any, found: str) -> None:
    mesh = mixed()
    change(mesh)
    with pytest.raises(ValueError, match=found):
        ancf.mesh_from_meshio(mesh)


def test_arrays_of_another_shape_are_rejected() -> None:
    with pytest.raises(ValueError, match=r"shape \(3, 3\)"):
        ancf.grid_mesh(np.zeros((3, 3)))


def test_numbers_of_physical_groups_belong_to_a_dimension() -> None:
    """Gmsh counts groups from 1 in each dimension. Negative numbers state the opposite orientation."""
    strip = mixed()
    numbers = [np.array([1, -1]), np.array([1]), np.array([1, 2]), np.array([1])]
    names = {"corner": [1, 0], "ends": [1, 1], "plate": [1, 2], "outer": [2, 2]}
    mesh = ancf.mesh_from_meshio(
        meshio.Mesh(
            strip.points,
            strip.cells,
            cell_data={"gmsh:physical": numbers},
            field_data={name: np.array(tag) for name, tag in names.items()},
        )
    )
    assert mesh.groups is not None
    groups = mesh.groups
    assert sorted(groups) == ["corner", "ends", "outer", "plate"]
    assert [len(chain) for chain in groups["ends"].edges or []] == [2, 2]
    assert groups["plate"].elements == [0, 1]
    assert groups["outer"].elements == [2]


@pytest.mark.parametrize("group", [3, -3])
def test_surfaces_are_reversed_in_groups_of_the_opposite_orientation(group: int, tmp_path: Path) -> None:
    """Files of version 4.1 have the elements of a surface in its own orientation."""
    entities = f"4 0 1 0\n1 0 0 0 0\n2 1 0 0 0\n3 1 1 0 0\n4 0 1 0 0\n1 0 0 0 1 1 0 1 {group} 0"
    nodes = "1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0"
    sections = {
        "MeshFormat": "4.1 0 8",
        "Entities": entities,
        "Nodes": nodes,
        "Elements": "1 1 1 1\n2 1 3 1\n1 1 2 3 4",
    }
    text = "".join(f"${name}\n{own}\n$End{name}\n" for name, own in sections.items())
    (tmp_path / "plate.msh").write_text(text)
    mesh = ancf.mesh_from_meshio(meshio.read(tmp_path / "plate.msh"))
    assert np.asarray(mesh.elements).tolist() == [[0, 1, 2, 3] if group > 0 else [3, 2, 1, 0]]


@pytest.mark.parametrize("scale", [0.0, -1.0, float("nan")])
def test_scales_are_positive(scale: float) -> None:
    with pytest.raises(ValueError, match="scale: found"):
        ancf.mesh_from_meshio(mixed(), scale=scale)
