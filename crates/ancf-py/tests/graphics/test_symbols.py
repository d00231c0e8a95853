"""Symbols of scenes: joints, supports, springs, probes, gravity, reaction forces, planes."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import ancf
from ancf.graphics.space.scene import Scene
from ancf.graphics.space.stage import Stage
from ancf.graphics.space.symbols import ARROW, Symbols

MODELS = Path(__file__).parents[4] / "models"


@cache
def result() -> ancf.Result:
    """A rod that falls onto a plane, clamped to the ground at one end, with a spring and a rod to the ground."""
    beam = ancf.Beam(
        "beam",
        from_=[0, 0, 0.2],
        to=[1, 0, 0.2],
        elements=4,
        section=ancf.Circle(diameter=0.02),
        material=ancf.Material("steel", density=7850, young=2.1e9),
    )
    block = ancf.PointMass("block", center=[1, 0, 0.6], mass=0.1)
    return ancf.run(
        ancf.Model(
            units=ancf.Units(length="m", time="s", force="N"),
            gravity=[0, 0, -9.81],
            bodies=[beam, block],
            joints=[
                ancf.Clamp("wall", a=beam.start),
                ancf.Spring("coil", a=block.at(), b=beam.end, stiffness=50.0),
                ancf.Distance("rod", a=block.at(), b=ancf.Ground(point=[1, 0, 1])),
            ],
            contacts=[ancf.Contact(with_=ancf.Plane(point=[0, 0, 0], normal=[0, 0, 1]), stiffness=1e5)],
            probes=[ancf.Probe("tip", on=beam.end)],
            analysis=ancf.Dynamics(duration=0.02, step=1e-3),
        )
    )


def symbols(run: ancf.Result, **settings: Any) -> Symbols:
    """The symbols of a result."""
    scene = Scene(run, **settings)
    return Symbols(scene, scene.lines.path.reshape(-1, 3))


def test_each_part_of_a_model_has_a_symbol() -> None:
    run = result()
    shown = symbols(run).meshes(5)
    assert set(shown) == {"joints", "ground", "links", "probes", "reactions", "gravity", "obstacles"}
    np.testing.assert_allclose(shown["joints"].center, [0, 0, 0.2], atol=1e-9)
    np.testing.assert_allclose(shown["probes"].center, run.probe("tip").position[5], atol=1e-6)
    # The spring reaches from the mass to the beam, the rod from the mass to the ground.
    low, high = shown["links"].bounds[4:]
    assert low == pytest.approx(run["tip.z"][5], abs=0.02)
    assert high == pytest.approx(1, abs=0.02)
    # The plate of the clamp is on the side without the beam; the pyramid is above the end of the rod.
    x, z = shown["ground"].bounds[:2], shown["ground"].bounds[4:]
    assert x[0] < -0.005
    assert z[1] > 1.04
    plane = shown["obstacles"].bounds
    assert plane[4:] == pytest.approx((0, 0), abs=1e-9)
    assert plane[0] < 0 < 1 < plane[1]


def test_arrows_are_proportional_to_forces() -> None:
    run = result()
    own = symbols(run)
    joints = own.scene.symbols(7)["joint"]
    arrows = {name: end - start for name, start, end in own.arrows(7, joints)}
    largest = max(np.linalg.norm(reaction.force, axis=1).max() for reaction in run.reactions.values())
    for name, arrow in arrows.items():
        force = run.reactions[name].force[7]
        np.testing.assert_allclose(arrow, force * ARROW * own.size / largest, atol=1e-12)
    assert "wall" in arrows
    (gravity,) = own.gravity()
    np.testing.assert_allclose(np.cross(gravity[1] - gravity[0], [0, 0, 1]), 0, atol=1e-12)
    assert gravity[1][2] < gravity[0][2]
    assert own.labels(7)["g"] is not None
    assert any(text.startswith("wall: ") and text.endswith(" N") for text in own.labels(7))


def test_modes_have_no_forces() -> None:
    run = ancf.modes(MODELS / "robot_arm.toml", 4)
    shown = symbols(run).meshes(3)
    assert "reactions" not in shown
    assert "joints" in shown


def test_symbols_move_with_the_scene() -> None:
    run = ancf.run(MODELS / "revolute_pendulum.toml")
    stage = Stage(Scene(run), 0, size=(80, 60), hidden=True)
    stage.fill(view=None, paint=None, labels=True, moving=True)
    stage.move(2500)
    np.testing.assert_allclose(stage.shown["probes"].center, run.probe("tip").position[2500], atol=1e-5)
    stage.plotter.close()
    bare = Stage(Scene(run), 0, size=(80, 60), hidden=True, symbols=False)
    bare.fill(view=None, paint=None, labels=False, moving=False)
    assert not bare.shown
    bare.plotter.close()


def test_an_image_shows_arrows_on_request(tmp_path: Path) -> None:
    run = result()
    seen = []
    for symbols_shown in (True, False):
        path = tmp_path / f"{symbols_shown}.png"
        run.show(screenshot=path, size=(320, 240), symbols=symbols_shown, view="xz")
        with Image.open(path) as picture:
            rgb = np.asarray(picture.convert("RGB")).astype(int)
        # Reaction forces are the only magenta.
        seen.append(int(((rgb[..., 0] > 120) & (rgb[..., 1] < 80) & (rgb[..., 2] > 50)).sum()))
    assert seen[0] > 20
    assert seen[1] == 0
