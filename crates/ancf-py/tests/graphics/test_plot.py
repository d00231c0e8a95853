"""Plots by matplotlib show the numbers of the result."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pytest
from PIL import Image

import ancf
from ancf.graphics import animation
from ancf.graphics.frames import frames_of_animation
from ancf.graphics.style import style

mpl.use("Agg")

MODELS = Path(__file__).parents[4] / "models"


@cache
def result(name: str) -> Any:
    """Return the result of an example model."""
    return ancf.run(MODELS / f"{name}.toml")


@pytest.fixture(autouse=True)
def _closed() -> Iterator[None]:
    yield
    plt.close("all")


def test_a_column_over_time() -> None:
    run = result("cantilever")
    ax = run.plot("tip.y")
    (line,) = ax.get_lines()
    np.testing.assert_array_equal(line.get_xdata(), run.time)
    np.testing.assert_array_equal(line.get_ydata(), run["tip.y"])
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("time, s", "tip.y, m")


def test_a_probe_means_its_position_and_a_joint_its_angle() -> None:
    run = result("revolute_pendulum")
    ax = run.plot("tip", "hinge")
    assert [line.get_label() for line in ax.get_lines()] == ["tip.x", "tip.y", "tip.z", "hinge.angle"]
    ax = run.plot("tip.velocity")
    assert [line.get_label() for line in ax.get_lines()] == ["tip.vx", "tip.vy", "tip.vz"]
    assert ax.get_ylabel() == "velocity, m/s"
    force = result("cantilever").plot("root")
    assert [line.get_label() for line in force.get_lines()] == ["root.fx", "root.fy", "root.fz"]


def test_energies_sum_up_and_the_pendulum_keeps_them() -> None:
    drawn = {
        line.get_label(): line.get_ydata() for line in result("revolute_pendulum").plot("energy").get_lines()
    }
    total = drawn["kinetic"] + drawn["strain"] + drawn["potential"]
    np.testing.assert_allclose(drawn["total"], total, atol=1e-12)
    assert np.ptp(drawn["total"]) < 1e-3 * np.ptp(drawn["kinetic"])


def test_angles_have_radians() -> None:
    run = result("slider_crank")
    assert run.plot("motor.angle").get_ylabel() == "motor.angle, rad"
    assert run.plot("motor.rate").get_ylabel() == "motor.rate, rad/s"
    assert run.plot("kinetic").get_ylabel() == "kinetic, J"
    assert run.plot("motor.mz").get_ylabel() == "motor.mz, N m"
    model = ancf.Model.read(MODELS / "slider_crank.toml")
    model.units = None
    assert ancf.run(model).plot("motor.angle").get_ylabel() == "motor.angle"


def test_a_curve_over_another_column_is_the_circle_of_a_pendulum() -> None:
    (line,) = result("revolute_pendulum").plot("tip.y", x="tip.x").get_lines()
    radius = np.hypot(line.get_xdata(), line.get_ydata())
    np.testing.assert_allclose(radius, 1, atol=1e-3)


def test_loads_are_vertical_over_displacements() -> None:
    run = result("lees_frame")
    ax = run.plot("load.y")
    (line,) = ax.get_lines()
    np.testing.assert_array_equal(line.get_xdata(), run["load.y"])
    np.testing.assert_array_equal(line.get_ydata(), run.load)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("load.y", "load factor")
    (line,) = run.plot("load.y", x="load").get_lines()
    np.testing.assert_array_equal(line.get_xdata(), run.load)
    (line,) = run.plot("foot.fx").get_lines()
    np.testing.assert_array_equal(line.get_xdata(), run.load)


def test_subplots_by_names_or_by_columns() -> None:
    run = result("revolute_pendulum")
    assert [len(ax.get_lines()) for ax in run.plot("tip", "hinge", subplots=True)] == [3, 1]
    assert [len(ax.get_lines()) for ax in run.plot("tip", subplots=True)] == [1, 1, 1]
    with pytest.raises(ValueError, match="subplots"):
        run.plot("tip", subplots=True, ax=plt.gca())


def test_axes_and_line_properties_of_the_caller() -> None:
    run = result("cantilever")
    _, ax = plt.subplots()
    assert run.plot("tip.y", ax=ax, linestyle="--", label="steel") is ax
    assert run.plot("tip.x", ax=ax) is ax
    first, second = ax.get_lines()
    assert (first.get_linestyle(), first.get_label()) == ("--", "steel")
    assert first.get_color() != second.get_color()


def test_settings_of_matplotlib_stay_as_they_are() -> None:
    before = dict(mpl.rcParams)
    run = result("slider_crank")
    run.plot()
    run.plot_shape(color="Mz")
    result("tuning_fork").plot()
    assert dict(mpl.rcParams) == before


def test_the_overview_shows_probes_and_energies() -> None:
    run = result("slider_crank")
    axes = run.plot()
    moved = [f"displacement of {name}, m" for name in ("pin", "middle", "block along x")]
    assert [ax.get_ylabel() for ax in axes] == [*moved, "energy, J"]
    # Curves that are zero are omitted: no z in a planar motion, no gravity, no damping.
    assert [line.get_label() for line in axes[0].get_lines()] == ["pin.x", "pin.y"]
    assert [line.get_label() for line in axes[3].get_lines()] == [
        "kinetic",
        "strain",
        "work",
        "balance",
        "total",
    ]
    np.testing.assert_array_equal(axes[0].get_lines()[1].get_ydata(), run["pin.y"] - run["pin.y"][0])


def test_unknown_names_are_reported_with_a_hint() -> None:
    run = result("cantilever")
    with pytest.raises(KeyError, match=r"did you mean 'tip'"):
        run.plot("tipp")
    with pytest.raises(ValueError, match=r"x: found 'tip'"):
        run.plot("tip.y", x="tip")
    with pytest.raises(KeyError, match="displacement"):
        run.plot_shape(color="displacment")
    with pytest.raises(ValueError, match="plane: found 'xx'"):
        run.plot_shape(plane="xx")
    with pytest.raises(IndexError, match="2001 rows"):
        run.plot_shape(2001)


def test_a_shape_is_the_field_of_positions() -> None:
    run = result("elastica")
    ax = run.plot_shape(parts=4)
    reference, shape = [line for line in ax.get_lines() if len(line.get_xdata()) > 0][:2]
    positions = run.field("position", parts=4)[-1]
    np.testing.assert_array_equal(np.stack(shape.get_data(), axis=1), positions[:, :2])
    np.testing.assert_allclose(reference.get_ydata(), 0, atol=1e-12)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("x, m", "y, m")
    assert ax.get_aspect() == 1


def test_shapes_at_times_are_those_of_the_nearest_rows() -> None:
    run = result("revolute_pendulum")
    ax = run.plot_shape(time=[0.25, 0.5], reference=False, plane="yx")
    shapes = [line for line in ax.get_lines() if line.get_label() == "rod"]
    assert [line.get_alpha() for line in shapes] == pytest.approx([0.625, 1])
    np.testing.assert_allclose(shapes[0].get_xdata()[-1], run["tip.y"][2500], rtol=1e-9)
    np.testing.assert_allclose(shapes[1].get_ydata()[-1], run["tip.x"][5000], rtol=1e-9)


def test_arms_of_rigid_bodies_reach_their_joints() -> None:
    run = result("slider_crank")
    for row in (0, 7, 30):
        ax = run.plot_shape(row)
        (arm,) = [line for line in ax.get_lines() if line.get_label() == "_arms"]
        np.testing.assert_allclose(
            [arm.get_xdata()[1], arm.get_ydata()[1]], run.probe("pin").position[row, :2], atol=1e-7
        )


def test_joints_and_supports_are_at_their_positions() -> None:
    run = result("robot_arm")
    ax = run.plot_shape(time=[0.5, 1.0])
    drawn = {line.get_marker(): line for line in ax.get_lines() if line.get_label() == "_joints"}
    assert set(drawn) == {"o", 6}
    np.testing.assert_allclose(np.stack(drawn[6].get_data(), axis=1), [[0, 0]], atol=1e-6)
    row = int(np.abs(run.time - 1.0).argmin())
    elbow = run.field("position", "upper", rows=row)[-1, :2]
    np.testing.assert_allclose(np.stack(drawn["o"].get_data(), axis=1)[0], elbow, atol=1e-6)
    clamped = result("cantilever").plot_shape()
    assert [line.get_marker() for line in clamped.get_lines() if line.get_label() == "_joints"] == ["s"]
    without = run.plot_shape(joints=False)
    assert not [line for line in without.get_lines() if line.get_label() == "_joints"]


def test_colours_are_those_of_the_section_forces() -> None:
    run = result("cantilever")
    ax = run.plot_shape(400, color="Mz", parts=2)
    moments = run.field("section_forces", parts=2)[400, :, 5]
    (bands,) = ax.collections
    np.testing.assert_allclose(bands.get_array(), (moments[1:] + moments[:-1]) / 2)
    # A cantilever bends most at its root.
    assert int(np.abs(bands.get_array()).argmax()) == 0
    assert bands.get_clim()[0] == pytest.approx(moments.min())
    assert len(ax.figure.axes) == 2
    assert ax.figure.axes[1].get_ylabel() == "bending moment Mz, N m"


def test_colour_limits_are_symmetric_for_both_signs() -> None:
    ax = result("lees_frame").plot_shape(50, color="N")
    least, greatest = ax.collections[0].get_clim()
    assert least == -greatest
    ax = result("elastica").plot_shape(color="red")
    assert [line.get_color() for line in ax.get_lines() if line.get_label() == "wire"][1] == "red"


def test_rigid_body_modes_are_omitted_by_default() -> None:
    run = result("tuning_fork")
    axes = run.plot_modes(3)
    assert [ax.get_title() for ax in axes] == [
        "mode 7: f = 439.8 Hz",
        "mode 8: f = 662.6 Hz",
        "mode 9: f = 1492 Hz",
    ]
    assert [ax.get_title() for ax in run.plot_modes(2, rigid=True)] == [
        "mode 1: f = 0 Hz",
        "mode 2: f = 0 Hz",
    ]
    with pytest.raises(AttributeError, match="no shapes"):
        result("cantilever").plot_modes()


def test_buckling_of_a_column_is_shown_in_its_plane() -> None:
    run = result("column")
    for row, ax in enumerate(run.plot_modes(2, scale=1.0, parts=1)):
        _, shape = ax.get_lines()
        np.testing.assert_allclose(
            np.abs(shape.get_xdata()), np.linalg.norm(run.shapes[row], axis=1), atol=1e-6
        )
        # Euler's first shape: 1 - cos(pi z / 2L).
        euler = 1 - np.cos(np.pi * shape.get_ydata() / 4)
        np.testing.assert_allclose(shape.get_xdata() / shape.get_xdata()[-1], euler, atol=2e-3)


def test_frames_of_an_animation_are_positions_at_rows(tmp_path: Path) -> None:
    run = result("slider_crank")
    film = run.animate(fps=4, parts=2, save=tmp_path / "crank.gif")
    rows = list(film.new_frame_seq())
    assert len(rows) == 21
    np.testing.assert_allclose(run.time[rows], np.linspace(0, 0.05, 21), atol=5.1e-4)
    ax = plt.gcf().axes[0]
    rod = [line for line in ax.get_lines() if line.get_label() == "rod"][-1]
    for row in rows[::5]:
        film._draw_frame(row)
        positions = run.field("position", "rod", parts=2)[row]
        np.testing.assert_array_equal(np.stack(rod.get_data(), axis=1), positions[:, :2])
        assert ax.get_title(loc="left").startswith(f"t = {run.time[row]:.4f}")
    with Image.open(tmp_path / "crank.gif") as picture:
        assert picture.is_animated


def test_the_speed_determines_the_duration_of_an_animation() -> None:
    run = result("revolute_pendulum")
    rows, speed = frames_of_animation(run, 1.0, 25)
    assert (len(rows), speed) == (26, 1.0)
    np.testing.assert_allclose(run.time[rows], np.arange(26) / 25, atol=1e-4)
    assert len(frames_of_animation(run, 0.1, 25)[0]) == 251
    assert len(frames_of_animation(run, None, 25)[0]) == 126
    with pytest.raises(ValueError, match="speed: found 0"):
        run.animate(speed=0)


def test_an_animation_of_a_mode_has_both_directions(tmp_path: Path) -> None:
    run = result("tuning_fork")
    film = run.animate(fps=8, scale=0.001, parts=1, save=tmp_path / "fork.html")
    ax = plt.gcf().axes[0]
    prong: Any = [line for line in ax.get_lines() if line.get_label() == "left"][-1]
    swing = 0.001 * run["left tip.x"][6]
    for frame, expected in ((0, 0), (2, swing), (4, 0), (6, -swing)):
        film._draw_frame(frame)
        assert prong.get_xdata()[0] + 0.008 == pytest.approx(expected, abs=1e-9)
    assert "<script" in (tmp_path / "fork.html").read_text()


def test_errors_of_animations(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    run = result("elastica")
    with pytest.raises(ValueError, match=r"ends in \.gif"):
        run.animate(save=tmp_path / "x.avi")
    monkeypatch.setattr(animation, "find_spec", lambda _: None)
    monkeypatch.setattr("matplotlib.animation.FFMpegWriter.isAvailable", lambda: False)
    with pytest.raises(RuntimeError, match=r"ffmpeg.*save a \.gif"):
        run.animate(save=tmp_path / "x.mp4")


def test_a_notebook_continues_to_show_figures(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(mpl.rcParams, "interactive", False)
    with style():
        # Like the notebook backend at the first figure.
        mpl.interactive(True)
    assert mpl.is_interactive()


def test_errors_of_plots() -> None:
    run = result("cantilever")
    with pytest.raises(ValueError, match="time: found nan, expected a finite number or several"):
        run.plot_shape(time=np.nan)
    with pytest.raises(ValueError, match=r"time: found \[\], expected"):
        run.plot_shape(time=[])
    with pytest.raises(ValueError, match=r"frame: found \[\], expected the number of a row or of several"):
        run.plot_shape([])
    with pytest.raises(ValueError, match=r"frame: found 1\.5, expected"):
        run.plot_shape(1.5)
    for fps in [0, -1, 2.5]:
        with pytest.raises(ValueError, match=rf"fps: found {fps}, expected an integer >= 1"):
            run.animate(fps=fps)
    modes = result("tuning_fork")
    with pytest.raises(ValueError, match="energy: found a result of modes without energies, expected"):
        modes.plot("energy")
    with pytest.raises(ValueError, match="count: found 0, expected an integer >= 1"):
        modes.plot_modes(0)
    still = ancf.run(MODELS / "cantilever.toml", callback=lambda _: True)
    assert len(still) == 1
    with pytest.raises(ValueError, match="animation: found a result of 1 row, expected at least two rows"):
        still.animate()
