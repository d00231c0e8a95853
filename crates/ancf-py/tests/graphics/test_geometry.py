"""Shapes of bodies are those of the report: outlines, arms of rigid bodies, positions of joints."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ancf
from ancf import _ancf
from ancf.graphics.lines import Lines
from ancf.graphics.space.scene import Scene

MODELS = Path(__file__).parents[4] / "models"

SECTIONS = [
    ({"kind": "circle", "diameter": 0.2}, [0.1, 0.1]),
    ({"kind": "ellipse", "height": 0.2, "width": 0.1}, [0.1, 0.05]),
    ({"kind": "rectangle", "height": 0.2, "width": 0.1}, [0.1, 0.05]),
    ({"kind": "tube", "outer": 0.2, "inner": 0.1}, [0.1, 0.1]),
    # Semi-axes 2 sqrt(iz/area) along y and 2 sqrt(iy/area) along z.
    ({"kind": "general", "area": 1e-3, "iy": 1e-6, "iz": 4e-6}, [0.12649110640673517, 0.06324555320336758]),
]


@pytest.mark.parametrize(("section", "half"), SECTIONS, ids=[str(section["kind"]) for section, _ in SECTIONS])
def test_half_extents_of_outlines(section: dict[str, Any], half: list[float]) -> None:
    outer, inner, edges = _ancf.outline(section, 24)
    np.testing.assert_allclose(np.abs(outer).max(axis=0), half, rtol=1e-14)
    assert (inner is not None) == (section["kind"] == "tube")
    if inner is not None:
        np.testing.assert_allclose(np.linalg.norm(inner, axis=1), 0.05, rtol=1e-14)
    assert len(edges) == (4 if section["kind"] == "rectangle" else 24)
    # The edges form a counter-clockwise polygon.
    one, two = outer[edges[:, 0]], outer[edges[:, 1]]
    assert np.sum(one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]) > 0


def test_points_of_an_elliptic_outline() -> None:
    outer, _, _ = _ancf.outline({"kind": "general", "area": 1e-3, "iy": 1e-6, "iz": 4e-6}, 12)
    angles = 2 * np.pi * np.arange(12) / 12
    expected = np.stack([4e-3**0.5 * 2 * np.cos(angles), 1e-3**0.5 * 2 * np.sin(angles)], axis=1)
    np.testing.assert_allclose(outer, expected, atol=1e-16)


def test_invalid_sections_are_rejected() -> None:
    with pytest.raises(ancf.ModelError, match="diameter: found -1"):
        _ancf.outline({"kind": "circle", "diameter": -1}, 24)


def test_a_tapered_tube_has_the_outline_of_each_section() -> None:
    beam = {"kind": "beam", "name": "mast", "from": [0, 0, 0], "to": [0, 0, 3], "elements": 3}
    beam |= {"section": "foot", "section_end": "top", "material": "steel"}
    model: dict[str, Any] = {
        "materials": {"steel": {"density": 7850, "young": 2.1e11}},
        "sections": {
            "foot": {"kind": "tube", "outer": 0.4, "inner": 0.2},
            "top": {"kind": "tube", "outer": 0.2, "inner": 0.15},
        },
        "bodies": [beam],
        "joints": [{"kind": "clamp", "name": "foot", "a": {"body": "mast", "at": "start"}}],
        "analysis": {"kind": "statics"},
    }
    outer, inner, _ = _ancf.ModelGeometry(ancf.run(model).states).outlines("mast", [0.0, 0.5, 1.0], 16)
    np.testing.assert_allclose(np.linalg.norm(outer, axis=2)[:, 0], [0.2, 0.15, 0.1], rtol=1e-12)
    assert inner is not None
    np.testing.assert_allclose(np.linalg.norm(inner, axis=2)[:, 0], [0.1, 0.0875, 0.075], rtol=1e-12)


def crank(joints: list[dict[str, Any]]) -> Any:
    """A rigid body with its centre at (1, 0, 0) that turns about the z-axis through a joint."""
    body = {"kind": "rigid", "name": "crank", "center": [1, 0, 0], "mass": 2, "inertia": [1, 1, 1]}
    weight = {"kind": "mass", "name": "weight", "center": [1, 2, 0], "mass": 1}
    rod = {"kind": "distance", "name": "rod", "a": {"body": "weight", "at": "center"}}
    rod |= {"b": {"body": "crank", "at": "center"}}
    return ancf.run(
        {
            "bodies": [body, weight],
            "joints": [*joints, rod],
            "gravity": [0, -9.81, 0],
            "analysis": {"kind": "dynamics", "duration": 0.4, "step": 0.02},
        }
    )


def hinge(place: dict[str, Any]) -> dict[str, Any]:
    """A hinge at a place of the crank."""
    return {"kind": "revolute", "name": "pin", "a": {"body": "crank", **place}, "axis": [0, 0, 1]}


PLACES = [
    ({"at": [0.25, 0, 0.5]}, [[-0.75, 0, 0.5]]),
    ({"at": [0.25, 0, 0], "offset": [0, 0.25, 0.5]}, [[-0.75, 0.25, 0.5]]),
    ({"at": "center", "offset": [-1, 0, 0]}, [[-1, 0, 0]]),
    ({"at": "center"}, np.empty((0, 3))),
]


@pytest.mark.parametrize(("place", "arms"), PLACES, ids=["point", "offset", "named", "centre"])
def test_arms_of_rigid_bodies(place: dict[str, Any], arms: Any) -> None:
    run = crank([hinge(place)])
    lines = Lines(run)
    np.testing.assert_allclose(lines.arms.offsets, arms, atol=1e-15)
    # An arm is fixed to its body: its end is a point of the axis of the hinge.
    for row in (0, 7, 20):
        tips = lines.arms.tips(row, lines.positions(row))
        np.testing.assert_allclose(tips[:, :2], np.array([[1, 0]]) + np.array(arms)[:, :2], atol=1e-9)


def test_joints_are_at_their_offsets() -> None:
    run = crank([hinge({"at": [0.25, 0, 0], "offset": [0, 0.25, 0.5]})])
    for row in (0, 7, 20):
        joints = Scene(run).joints(row)
        assert list(joints) == ["pin", "rod"]
        np.testing.assert_allclose(joints["pin"], [0.25, 0.25, 0.5], atol=1e-9)
        weight = run.field("position", "weight", rows=row)[0]
        np.testing.assert_allclose(joints["rod"], weight, atol=1e-12)
    # Deflections are scaled from the reference configuration, in which the hinge is at the same point.
    np.testing.assert_allclose(Scene(run, scale=2.0).joints(20)["pin"], [0.25, 0.25, 0.5], atol=1e-9)
    free = run.field("position", "weight")[[0, 20], 0]
    np.testing.assert_allclose(Scene(run, scale=2.0).joints(20)["rod"], 2 * free[1] - free[0], atol=1e-12)


def test_joints_of_modes_move_with_the_shape() -> None:
    beam: dict[str, Any] = {"kind": "beam", "name": "rod", "from": [0, 0, 0], "to": [1, 0, 0], "elements": 4}
    beam |= {"section": "round", "material": "steel"}
    support: dict[str, Any] = {
        "kind": "spring",
        "name": "support",
        "a": {"body": "rod", "at": "end", "offset": [0.5, 0, 0]},
    }
    support |= {"b": {"point": [1.5, -1, 0]}, "stiffness": 1e3}
    model: dict[str, Any] = {
        "materials": {"steel": {"density": 7850, "young": 2.1e11}},
        "sections": {"round": {"kind": "circle", "diameter": 0.02}},
        "bodies": [beam],
        "joints": [{"kind": "clamp", "name": "root", "a": {"body": "rod", "at": "start"}}, support],
        "analysis": {"kind": "modes", "count": 2},
    }
    scene = Scene(ancf.run(model))
    joints = scene.joints(0)
    np.testing.assert_allclose(joints["root"], [0, 0, 0], atol=1e-12)
    end, arm = scene.lines.positions(0)[-1], joints["support"]
    # The arm of 0.5 m beyond the end turns with the end of the rod.
    assert np.linalg.norm(arm - end) == pytest.approx(0.5, rel=0.05)
    assert np.linalg.norm(arm - [1.5, 0, 0]) > 1.3 * np.linalg.norm(end - [1, 0, 0])


@pytest.mark.parametrize("scales", ["none", "auto"])
def test_bodies_of_modes_do_not_cross(scales: str) -> None:
    model = ancf.Model.read(MODELS / "tuning_fork.toml").to_dict() | {"scales": {"kind": scales}}
    run = ancf.modes(model, 12)
    lines = Lines(run)
    assert lines.shapes is not None
    gap = np.linalg.norm(
        lines.path[0][lines.bodies["left"]] - lines.path[0][lines.bodies["right"]], axis=1
    ).min()
    for mode in range(6, 12):
        factor = lines.scale(mode)
        assert 0 < factor * np.linalg.norm(lines.shapes[mode], axis=1).max() < 0.11 * lines.size
        for sign in (1, -1):
            at = lines.positions(mode, sign * factor)
            apart = np.linalg.norm(at[lines.bodies["left"]] - at[lines.bodies["right"]], axis=1)
            assert apart.min() > 0.1 * gap
        # Symbols move with the bodies, in all units of the solver.
        moved = (
            lines.symbols(mode, factor)["probe"]["left tip"] - lines.symbols(mode, 0.0)["probe"]["left tip"]
        )
        shape = [run[f"left tip.{axis}"][mode] for axis in "xyz"]
        np.testing.assert_allclose(moved, factor * np.array(shape), atol=1e-9)
