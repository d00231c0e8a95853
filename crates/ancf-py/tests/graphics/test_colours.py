"""Colour maps: the same for a quantity in plots, scenes and reports."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest

import ancf
from ancf.graphics.quantities import Quantity, quantity
from ancf.graphics.space.scene import Scene
from ancf.graphics.space.stage import Stage
from ancf.graphics.style import COLOUR_MAPS, colour_map

ROOT = Path(__file__).parents[4]


@cache
def result(name: str) -> ancf.Result:
    """Return the result of an example model."""
    return ancf.run(ROOT / f"models/{name}.toml")


def test_the_maps_are_those_of_the_report() -> None:
    table = json.loads((ROOT / "crates/ancf-report/assets/colour_maps.json").read_text("utf-8"))
    assert table == COLOUR_MAPS
    assert (table["sequential"], table["diverging"]) == ("viridis", "coolwarm")
    # The sequential map is that of matplotlib up to the interpolation.
    at = np.linspace(0, 1, 50)
    np.testing.assert_allclose(colour_map("viridis")(at), mpl.colormaps["viridis"](at), atol=0.06)


def test_the_signs_of_quantities_are_those_of_the_report() -> None:
    run = result("robot_arm")
    for name, sign in COLOUR_MAPS["quantities"].items():
        if name not in {"relative displacement", "error of the mesh"}:
            assert quantity(run, name.lower().replace(" ", "_")).is_signed == (sign == "signed"), name


def test_signed_quantities_with_both_signs_diverge() -> None:
    both = Quantity("force", "N", is_signed=True, values=np.array([[-1.0, 2.0], [0.5, 4.0]]))
    assert both.colour_map == "coolwarm"
    assert both.limits(both.values) == (-4, 4)
    # One frame has positive values only, but the colours of a value are the same in all frames.
    assert both.limits(both.values[1]) == (-4, 4)
    tension = Quantity("force", "N", is_signed=True, values=np.array([[1.0, 3.0], [-1e-9, np.nan]]))
    assert tension.colour_map == "viridis"
    assert tension.limits(tension.values) == (0, 3)
    assert tension.limits(tension.values[0]) == (1, 3)
    size = Quantity("speed", "m/s", is_signed=False, values=np.array([[-1.0, 2.0]]))
    assert size.colour_map == "viridis"
    zero = Quantity("speed", "m/s", is_signed=False, values=np.zeros((1, 2)))
    assert zero.limits(zero.values) == (0, 1)
    same = Quantity("speed", "m/s", is_signed=False, values=np.full((1, 2), 2.0))
    assert same.limits(same.values) == (2, 4)


def test_plots_and_scenes_use_the_same_map() -> None:
    run = result("cantilever")
    for color in ("Mz", "axial_stress", "displacement.y", "speed"):
        ax = run.plot_shape(400, color=color)
        (bands,) = ax.collections
        scene = Scene(run, color=color)
        stage = Stage(scene, 400, size=(80, 60), hidden=True)
        colours = stage._colours(None, moving=False)
        stage.plotter.close()
        assert colours["cmap"].name == bands.get_cmap().name == quantity(run, color).colour_map
        assert colours["clim"] == pytest.approx(bands.get_clim())
        assert colours["scalar_bar_args"]["title"].split() == ax.figure.axes[1].get_ylabel().split()
        points = stage.mesh[color]
        assert points.min() >= colours["clim"][0] - 1e-9
        assert points.max() <= colours["clim"][1] + 1e-9


def test_a_mooring_uses_the_whole_scale() -> None:
    force = quantity(result("mooring"), "N")
    low, high = force.limits(force.values[-1])
    known = force.values[-1][np.isfinite(force.values[-1])]
    assert force.colour_map == "viridis"
    assert (low, high) == pytest.approx((known.min(), known.max()))


def test_unknown_quantities_have_a_hint() -> None:
    with pytest.raises(KeyError, match="did you mean 'stress'"):
        quantity(result("mooring"), "strees")


def test_modes_are_relative_to_their_maximum() -> None:
    run = ancf.modes(ROOT / "models/cantilever.toml", 3)
    shape = quantity(run, "displacement")
    assert (shape.label, shape.unit) == ("relative displacement", None)
    np.testing.assert_allclose(shape.values.max(axis=1), 1)
    with pytest.raises(KeyError, match="no quantity 'axial_stress'"):
        quantity(run, "axial_stress")
