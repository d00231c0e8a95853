"""Shells in results, plots and scenes."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pytest

import ancf

mpl.use("Agg")

SIDE, THICKNESS, PRESSURE = 1.0, 0.02, 1000.0


@cache
def plate() -> Any:
    """A clamped square plate under a pressure."""
    edges = ["u_start", "u_end", "v_start", "v_end"]
    return ancf.run(
        {
            "units": {"length": "m", "time": "s", "force": "N"},
            "materials": {"steel": {"density": 7850, "young": 2.1e11, "poisson": 0.3}},
            "bodies": [
                {"kind": "mass", "name": "stone", "center": [0, 0, 1], "mass": 1},
                {
                    "kind": "shell",
                    "name": "plate",
                    "surface": {
                        "kind": "flat",
                        "corner": [0, 0, 0],
                        "side_u": [SIDE, 0, 0],
                        "side_v": [0, SIDE, 0],
                    },
                    "elements": [12, 12],
                    "thickness": THICKNESS,
                    "material": "steel",
                },
            ],
            "joints": [
                {"kind": "spherical", "name": "nail", "a": {"body": "stone", "at": "center"}},
                *(
                    {
                        "kind": "support",
                        "name": edge,
                        "a": {"body": "plate", "at": {"edge": edge}},
                        "condition": "clamped",
                    }
                    for edge in edges
                ),
            ],
            "loads": [{"kind": "surface_pressure", "body": "plate", "pressure": PRESSURE}],
            "probes": [
                {
                    "name": "middle",
                    "on": {"body": "plate", "at": [0.5, 0.5]},
                    "record": ["motion", "resultants", "surface_stress"],
                }
            ],
            "analysis": {"kind": "statics"},
        }
    )


def test_fields_of_a_clamped_plate() -> None:
    run = plate()
    moment = 0.0229051 * PRESSURE * SIDE**2
    grid = run.surface_grid("plate", parts=2)
    assert grid.shape == (25, 25, 2)
    np.testing.assert_allclose(grid[3, 5], [5 / 24, 3 / 24])
    resultants = run.field("resultants", "plate", parts=2, rows=-1).reshape(25, 25, 6)
    assert resultants[12, 12, 3] == pytest.approx(moment, rel=0.015)
    np.testing.assert_allclose(resultants[12, 12], run.probe("middle").resultants[-1], rtol=1e-9, atol=1e-6)
    stress = run.field("surface_stress", "plate", parts=2, rows=-1).reshape(25, 25, 3, 3)
    assert stress[12, 12, 0, 0] == pytest.approx(6 * moment / THICKNESS**2, rel=0.015)
    np.testing.assert_allclose(
        stress[12, 12].ravel(), run.probe("middle").surface_stress[-1], rtol=1e-9, atol=1
    )
    principal = run.field("principal_stress", "plate", rows=-1)
    assert (principal[:, :, 0] >= principal[:, :, 1]).all()
    assert np.isnan(run.field("resultants", "stone")).all()
    assert np.isnan(run.field("section_forces", "plate")).all()
    largest = run.field("von_mises_stress", "plate", rows=-1)
    both = [run.field(f"von_mises_stress_{side}", "plate", rows=-1) for side in ("top", "bottom")]
    np.testing.assert_array_equal(largest, np.maximum(*both))
    assert run.units["middle.muu"] == "N"
    assert run.units["middle.suu_top"] == "N/m²"
    with pytest.raises(KeyError, match="plate"):
        run.surface_grid("stone")


def test_the_energy_density_integrates_to_the_strain_energy() -> None:
    run = plate()
    density = run.field("energy_density", "plate", parts=4, rows=-1).reshape(49, 49)
    integral = np.trapezoid(np.trapezoid(density, dx=SIDE / 48), dx=SIDE / 48)
    assert integral == pytest.approx(run["strain"][-1], rel=0.03)


def test_plots_show_grids_and_values() -> None:
    run = plate()
    ax = run.plot_shape(plane="3d")
    labels = [line.get_label() for line in ax.get_lines()]
    assert "plate" in labels
    ax = run.plot_shape(color="von_mises", plane="3d", scale=100)
    (cells,) = ax.collections
    values = run.field("von_mises_stress", "plate", parts=4, rows=-1)
    # The colours of cells are means of their corners, in kPa.
    assert 0.7 * np.nanmax(values) < 1e3 * cells.get_array().max() <= 1.01 * np.nanmax(values)
    ax = run.plot_shape(color="muu", plane="xy")
    assert len(ax.collections[0].get_paths()) >= 12 * 12
    plt.close("all")


def test_scenes_hold_the_volume_of_the_shell() -> None:
    mesh = plate().scene(color="suu_top", parts=2)
    triangles = mesh.triangulate()
    faces = triangles.regular_faces[triangles.cell_data["body"] == 1]
    a, b, c = (triangles.points[faces[:, i]].astype(float) for i in range(3))
    volume = np.einsum("fi,fi->", a, np.cross(b, c)) / 6
    assert volume == pytest.approx(SIDE**2 * THICKNESS, rel=1e-3)
    assert mesh.clean().n_open_edges == 0
    assert np.isfinite(mesh.point_data["suu_top"]).sum() >= 2 * 25 * 25
    larger = plate().scene(scale=1000, parts=2)
    # The stone is above the plate.
    heights = [scene.points[:, 2][scene.points[:, 2] < SIDE / 2] for scene in (mesh, larger)]
    assert np.ptp(heights[1]) > 1.2 * np.ptp(heights[0])


def test_animations_and_modes_have_shells(tmp_path: Path) -> None:
    modes = ancf.modes(plate().model, count=2)
    assert len(modes.plot_modes(2, plane="3d")) == 2
    film = modes.animate(mode=0, fps=4, parts=1, save=tmp_path / "plate.gif")
    assert film is not None
    plt.close("all")


def test_parts_of_large_shells_are_fewer() -> None:
    ax = plate().plot_shape(color="nuu", plane="xy", parts=8)
    assert len(ax.collections[0].get_paths()) <= 4000
    plt.close("all")
