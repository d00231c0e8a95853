"""Volumes, areas and positions of surfaces; images without a screen."""

from __future__ import annotations

import pickle
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import ancf
from ancf import _ancf
from ancf.graphics.space import stage
from ancf.graphics.space.scene import Scene

MODELS = Path(__file__).parents[4] / "models"


@cache
def result(name: str) -> Any:
    """Return the result of an example model."""
    return ancf.run(MODELS / f"{name}.toml")


def rod(section: dict[str, Any], end: dict[str, Any] | None = None) -> Any:
    """A straight rod of length 2 without loads."""
    beam: dict[str, Any] = {
        "kind": "beam",
        "name": "rod",
        "from": [1, 0, 0],
        "to": [1, 1.2, 1.6],
        "up": [1, 0, 0],
        "elements": 3,
        "section": "own",
        "material": "steel",
    }
    sections = {"own": section}
    if end is not None:
        beam["section_end"], sections["end"] = "end", end
    return ancf.run(
        {
            "materials": {"steel": {"density": 7850, "young": 2.1e11}},
            "sections": sections,
            "bodies": [beam],
            "joints": [{"kind": "clamp", "name": "root", "a": {"body": "rod", "at": "start"}}],
            "analysis": {"kind": "statics"},
        }
    )


def volume(mesh: Any) -> float:
    """Volume of a closed surface by the divergence theorem; negative for inward faces."""
    faces = mesh.triangulate().regular_faces
    a, b, c = (mesh.points[faces[:, i]].astype(float) for i in range(3))
    return float(np.einsum("fi,fi->", a, np.cross(b, c)) / 6)


def polygon(sides: int) -> float:
    """Area of a polygon over that of the circle around it."""
    return sides / (2 * np.pi) * float(np.sin(2 * np.pi / sides))


ROUND = polygon(48)
SECTIONS = [
    ({"kind": "circle", "diameter": 0.1}, np.pi * 0.05**2 * ROUND),
    ({"kind": "tube", "outer": 0.1, "inner": 0.06}, np.pi * (0.05**2 - 0.03**2) * ROUND),
    ({"kind": "rectangle", "height": 0.1, "width": 0.04}, 0.1 * 0.04),
    ({"kind": "ellipse", "height": 0.1, "width": 0.04}, np.pi * 0.05 * 0.02 * ROUND),
    ({"kind": "general", "area": 0.004, "iy": 1e-6, "iz": 4e-6}, 4 * np.pi * 2e-6 / 0.004 * ROUND),
]


@pytest.mark.parametrize(("section", "area"), SECTIONS, ids=[str(section["kind"]) for section, _ in SECTIONS])
def test_a_rod_holds_its_section_times_its_length(section: dict[str, Any], area: float) -> None:
    mesh = rod(section).scene(sides=48)
    assert volume(mesh) == pytest.approx(2 * area, rel=1e-5)
    assert mesh.clean().n_open_edges == 0


def test_the_surface_of_a_rod_is_its_hull_and_its_ends() -> None:
    mesh = rod({"kind": "rectangle", "height": 0.1, "width": 0.04}).scene()
    assert mesh.area == pytest.approx(2 * 0.28 + 2 * 0.004, rel=1e-5)
    # The section's y-axis, along which its height is, points up, which is x here.
    assert np.ptp(mesh.points[:, 0]) == pytest.approx(0.1, rel=1e-5)


def test_a_tapered_rod_is_a_frustum() -> None:
    mesh = rod({"kind": "circle", "diameter": 0.1}, {"kind": "circle", "diameter": 0.05}).scene(sides=48)
    frustum = np.pi * 2 / 3 * (0.05**2 + 0.05 * 0.025 + 0.025**2)
    assert volume(mesh) == pytest.approx(frustum * ROUND, rel=1e-5)


def test_bending_keeps_the_volume() -> None:
    # Pappus: the centroid of each section is on the line, whose length is nearly constant.
    straight = np.pi * 0.0005**2 * polygon(24)
    assert volume(result("elastica").scene()) == pytest.approx(straight, rel=1e-3)
    mesh = result("spring").scene()
    wire = mesh.extract_cells(mesh["body"] == 0).extract_surface(algorithm="dataset_surface")
    length = np.hypot(6 * 2 * np.pi * 0.025, 0.072)
    assert volume(wire) == pytest.approx(np.pi * 0.002**2 * length * polygon(24), rel=2e-3)


def test_points_have_arc_lengths_and_the_chosen_quantity() -> None:
    run = result("cantilever")
    mesh = run.scene(300, color="Mz", parts=2)
    moments = run.field("section_forces", parts=2)[300, :, 5]
    lengths = np.array([s for _, s in run.stations(2)])
    np.testing.assert_allclose(mesh["Mz"], np.interp(mesh["s"], lengths, moments), rtol=1e-6)
    # Points of a section are at half of the diameter from the line.
    line = run.field("position", parts=2)[300]
    station = np.abs(mesh["s"][:, None] - lengths).argmin(axis=1)
    np.testing.assert_allclose(np.linalg.norm(mesh.points - line[station], axis=1), 0.01, rtol=1e-3)


def test_arms_reach_joints_at_all_angles() -> None:
    model = ancf.Model.read(MODELS / "slider_crank.toml").to_dict()
    del model["bodies"][0]["display"]
    run = ancf.run(model)
    for row in (0, 11, 40):
        mesh = run.scene(row)
        crank = mesh.extract_cells(mesh["body"] == 0)
        pin = run.probe("pin").position[row]
        # The end of the arm is a disc about the pin with the radius of the arm.
        nearest = np.linalg.norm(crank.points - pin, axis=1).min()
        assert nearest == pytest.approx(0.008 * 0.45, rel=1e-2)


def test_display_shapes_turn_with_their_body() -> None:
    run = result("slider_crank")
    for row in (0, 11, 40):
        mesh = run.scene(row)
        crank = mesh.extract_cells(mesh["body"] == 0).points
        # The pin ends at z = 0.014 and has the radius 0.016, the counterweight 0.05; there are no arms.
        at_pin = np.linalg.norm(crank - run.probe("pin").position[row], axis=1)
        assert at_pin.min() == pytest.approx(0.014, rel=1e-2)
        assert np.isclose(at_pin, np.hypot(0.016, 0.014), rtol=1e-2).sum() >= 48
        angle = 150 * run.time[row]
        counterweight = -0.05 * np.array([np.cos(angle), np.sin(angle)])
        own = np.linalg.norm(crank[:, :2] - counterweight, axis=1)
        assert np.isclose(own, 0.05, rtol=1e-4).sum() > 90


def tetrahedron(path: Path) -> float:
    """Write a binary STL file of a tetrahedron with unit edges along the axes, and return its volume."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype="<f4")
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    triangles = np.zeros(4, dtype=record)
    triangles["corners"] = corners[faces]
    path.write_bytes(bytes(80) + np.uint32(4).tobytes() + triangles.tobytes())
    return 1 / 6


def falling(display: list[dict[str, Any]]) -> dict[str, Any]:
    """A falling body with display shapes."""
    body = {"kind": "rigid", "name": "part", "center": [1, 2, 3], "mass": 1.0, "inertia": [1, 1, 1]}
    scheme = {"spectral_radius": 0.8}
    analysis = {"kind": "dynamics", "duration": 0.1, "step": 0.05, "scheme": scheme}
    return {"gravity": [0, 0, -10], "bodies": [body | {"display": display}], "analysis": analysis}


@pytest.mark.filterwarnings("ignore::ancf.AnalysisWarning")
def test_meshes_of_files_are_drawn(tmp_path: Path) -> None:
    expected = tetrahedron(tmp_path / "part.stl")
    mesh_file = ancf.DisplayMesh(file=str(tmp_path / "part.stl"), scale=2, origin=[1, 2, 3])
    run = ancf.run(falling([mesh_file.to_dict()]))
    for row in (0, 2):
        mesh = run.scene(row)
        assert volume(mesh) == pytest.approx(8 * expected, rel=1e-6)
        np.testing.assert_allclose(mesh.points.min(axis=0), run.field("position")[row, 0], atol=1e-6)
    # A model file states the path relative to its folder.
    model = falling([{"kind": "mesh", "file": "part.stl"}])
    path = tmp_path / "falling.toml"
    path.write_text(ancf.Model.from_dict(model).to_toml())
    assert volume(ancf.run(path).scene(0)) == pytest.approx(expected, rel=1e-6)
    with pytest.raises(ancf.ModelError, match=r"display\[0\]\.file: found no file nowhere\.stl"):
        ancf.run(falling([{"kind": "mesh", "file": "nowhere.stl"}]))
    # Another process may lack the file.
    (tmp_path / "part.stl").unlink()
    assert pickle.loads(pickle.dumps(run)).scene(0).n_points == 24


def test_positions_of_obstacles() -> None:
    run = result("belt")
    mesh = run.scene()
    pulley = mesh.extract_cells(mesh["body"] == 0).points
    radii = np.hypot(pulley[:, 0], pulley[:, 2])
    assert radii.max() == pytest.approx(0.1, rel=1e-3)


def test_the_box_of_a_rigid_body_has_its_moments_of_inertia() -> None:
    body: dict[str, Any] = {"kind": "rigid", "name": "block", "center": [1, 2, 3], "mass": 3.0}
    body |= {"inertia": [0.5, 0.6, 0.4], "products": [0.05, -0.02, 0.03]}
    edges, axes = _ancf.inertia_box(body, 10.0)
    squares = edges**2
    moments = np.diag(body["mass"] / 12 * (squares.sum() - squares))
    tensor = axes.T @ moments @ axes
    np.testing.assert_allclose(np.diag(tensor), body["inertia"], rtol=1e-9)
    np.testing.assert_allclose(tensor[np.triu_indices(3, 1)], body["products"], rtol=1e-9)


def test_sections_of_modes_are_normal_to_their_lines() -> None:
    scene = Scene(result("column"), sides=48)
    mesh = scene.mesh(0)
    length = np.linalg.norm(np.diff(scene.lines.positions(0), axis=0), axis=1).sum()
    assert length > 2.01
    assert volume(mesh) == pytest.approx(np.pi * 0.01**2 * length * ROUND, rel=1e-3)
    assert mesh.clean().n_open_edges == 0


def pixels(path: Path) -> Any:
    """An image as numbers."""
    with Image.open(path) as picture:
        return np.asarray(picture.convert("RGB")).astype(int)


def test_images_show_bodies_in_their_colours(tmp_path: Path) -> None:
    run = result("spring")
    run.show(screenshot=tmp_path / "spring.png", size=(320, 240), color="red")
    seen = pixels(tmp_path / "spring.png")
    assert seen.shape == (240, 320, 3)
    red = (seen[..., 0] > 100) & (seen[..., 1] < 90) & (seen[..., 2] < 90)
    assert 0.02 < red.mean() < 0.5
    # All bodies are visible: the edges of the image are white.
    edge = np.concatenate([red[0], red[-1], red[:, 0], red[:, -1]])
    assert not edge.any()


def test_animations_move(tmp_path: Path) -> None:
    run = result("slider_crank")
    run.show(movie=tmp_path / "crank.gif", seconds=0.2, size=(160, 120), color="Mz")
    with Image.open(tmp_path / "crank.gif") as film:
        assert film.n_frames == 6
        first = np.asarray(film.convert("RGB")).astype(int)
        film.seek(3)
        later = np.asarray(film.convert("RGB")).astype(int)
    assert np.abs(first - later).max() > 100
    result("tuning_fork").show(7, movie=tmp_path / "fork.gif", seconds=0.2, size=(160, 120), labels=True)
    assert (tmp_path / "fork.gif").stat().st_size > 1000


def test_invalid_arguments_are_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    run = result("elastica")
    with pytest.raises(ValueError, match=r"ends in \.gif"):
        run.show(movie=tmp_path / "x.avi")
    with pytest.raises(ValueError, match="view: found 'front'"):
        run.show(screenshot=tmp_path / "x.png", view="front")
    with pytest.raises(KeyError, match="quantity"):
        run.show(screenshot=tmp_path / "x.png", color="moment")
    monkeypatch.setattr(stage, "find_spec", lambda _: None)
    with pytest.raises(RuntimeError, match="pip install imageio imageio-ffmpeg"):
        run.show(movie=tmp_path / "x.mp4")


def test_invalid_numbers_are_reported(tmp_path: Path) -> None:
    run = result("cantilever")
    for sides in [2, 0, 3.5]:
        with pytest.raises(ValueError, match=f"sides: found {sides}, expected an integer >= 3"):
            run.scene(sides=sides)
    for seconds in [0, -1.0, np.nan]:
        with pytest.raises(ValueError, match=f"seconds: found {seconds}, expected a number > 0"):
            run.show(movie=tmp_path / "film.gif", seconds=seconds)
