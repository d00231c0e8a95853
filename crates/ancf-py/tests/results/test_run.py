"""Runs of models and their results as arrays."""

from __future__ import annotations

import itertools
import math
import os
import pickle
import signal
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ancf
from ancf.record import Probe

BAD = Path(__file__).parents[4] / "crates" / "ancf" / "tests" / "models" / "bad"


def test_a_file_and_its_data_give_the_same_motion(models: Path) -> None:
    file = models / "cantilever.toml"
    by_path, by_text = ancf.run(file), ancf.run(str(file))
    assert by_path.columns == by_text.columns
    np.testing.assert_array_equal(by_path.data, by_text.data)
    # Kim et al. (2017), table 5: the mean deflection of twenty elements, in mm.
    assert 1e3 * by_path["tip.y"].mean() == pytest.approx(-2.037, abs=1e-3)


def test_vectors_are_views_of_one_array(rod: dict[str, Any]) -> None:
    result = ancf.run(rod)
    tip = result.probe("tip")
    widths = {"position": 3, "velocity": 3, "acceleration": 3, "rotation": 4, "angular_velocity": 3}
    widths |= {"section_forces": 6, "strain": 6, "stress": 6}
    for quantity, width in widths.items():
        vector = getattr(tip, quantity)
        assert vector.shape == (len(result), width)
        assert np.shares_memory(vector, result.data)
    np.testing.assert_array_equal(tip.position[:, 1], result["tip.y"])
    np.testing.assert_array_equal(result.reactions["pivot"].moment[:, 2], result["pivot.mz"])
    np.testing.assert_array_equal(result.joints["pivot"].angle, result["pivot.angle"])


def test_the_results_of_a_pendulum(rod: dict[str, Any]) -> None:
    result = ancf.run(rod)
    assert result.time[[0, -1]] == pytest.approx([0, 0.3])
    # The energies of a pendulum that starts at rest add up to those of its start.
    assert np.abs(result.energy.total - result.energy.total[0]).max() < 2e-3 * result.energy.kinetic.max()
    # The hinge is free about its axis. The initial angular acceleration is 3 g / (2 L).
    assert np.abs(result.reactions["pivot"].moment[:, 2]).max() < 1e-9
    rates = np.gradient(result.joints["pivot"].angle, result.time)
    np.testing.assert_allclose(rates[5:-5], result.joints["pivot"].rate[5:-5], rtol=0.02, atol=0.02)
    assert result.joints["pivot"].angle[100] == pytest.approx(-0.5 * 14.715 * 0.1**2, rel=0.03)


def test_fields_equal_probes(rod: dict[str, Any]) -> None:
    result = ancf.run(rod)
    tip = result.probe("tip")
    for name in ["position", "velocity", "acceleration", "section_forces"]:
        field = result.field(name, parts=3)
        assert field.shape[:2] == (len(result), 4 * 3 + 1)
        np.testing.assert_allclose(field[:, -1], getattr(tip, name), rtol=1e-9, atol=1e-12)
    frames = result.field("directors")
    assert frames.shape == (len(result), 5, 3, 3)
    np.testing.assert_allclose(
        frames @ frames.swapaxes(2, 3), np.broadcast_to(np.eye(3), frames.shape), atol=1e-9
    )
    assert result.stations() == [("arm", s) for s in np.linspace(0, 1, 5)]
    np.testing.assert_array_equal(result.field("position", body="arm"), result.field("position"))


def test_kept_parts_of_states(rod: dict[str, Any]) -> None:
    positions = ancf.run(rod, states="positions")
    np.testing.assert_array_equal(positions.field("position"), ancf.run(rod).field("position"))
    with pytest.raises(ValueError, match='run it with states="all"'):
        positions.field("velocity")
    with pytest.raises(ValueError, match="kept no such states"):
        ancf.run(rod, states="none").field("position")
    with pytest.raises(ValueError, match='expected "all", "positions" or "none"'):
        ancf.run(rod, states="some")  # type: ignore[arg-type]


def test_output_every_keeps_the_last_row(rod: dict[str, Any]) -> None:
    whole, part = ancf.run(rod), ancf.run(rod | {"output": {"every": 7}})
    kept = [*range(0, 301, 7), 300]
    np.testing.assert_array_equal(part.data, whole.data[kept])
    np.testing.assert_array_equal(part.field("position"), whole.field("position")[kept])


def test_modes_statics_and_buckling(models: Path, rod: dict[str, Any]) -> None:
    fine = rod["bodies"][0] | {"elements": 12}
    clamped = rod | {
        "bodies": [fine],
        "joints": [{"kind": "clamp", "name": "root", "a": {"body": "arm", "at": "start"}}],
    }
    frequency = 1.8751041**2 / (2 * np.pi) * np.sqrt(5e9 * 0.02**2 / 12 / 2000)
    modes = ancf.modes(clamped, count=3, about="reference")
    assert modes.frequencies[0] == pytest.approx(frequency, rel=2e-3)
    assert modes.shapes.shape == (3, 13, 3)
    np.testing.assert_allclose(modes.shapes[:, -1], modes.probe("tip").position, rtol=1e-9, atol=1e-12)
    light = clamped | {"gravity": [0, -0.01, 0]}
    sag = 2000 * 0.05 * 0.02 * 0.01 / (8 * 5e9 * 0.05 * 0.02**3 / 12)
    assert ancf.statics(light)["tip.y"][-1] == pytest.approx(-sag, rel=3e-3)
    assert ancf.buckling(models / "column.toml").factors[0] > 0
    with pytest.raises(AttributeError, match="a result of statics has no frequency"):
        _ = ancf.statics(light).frequencies


def test_tables(rod: dict[str, Any]) -> None:
    result = ancf.run(rod)
    table = result.to_pandas()
    assert table.index.name == "t"
    assert table["tip.y"].iloc[-1] == result["tip.y"][-1]
    data = result.to_xarray(fields=["position", "section_forces"])
    assert data["position"].dims == ("t", "station", "axis")
    assert data["position"].sel(t=0.1, method="nearest").shape == (5, 3)
    np.testing.assert_array_equal(data["tip.x"], result["tip.x"])


@pytest.mark.parametrize("file", sorted(BAD.glob("*.toml")), ids=lambda file: file.stem)
def test_errors_are_those_of_the_command_line(file: Path) -> None:
    text = file.read_text(encoding="utf-8", errors="surrogateescape")
    expected = [line.removeprefix("#! ") for line in text.splitlines() if line.startswith("#! ")]
    with pytest.raises(ancf.ModelError) as caught:
        ancf.run(file)
    assert str(caught.value).splitlines() == [f"{file}:{line}" for line in expected]
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value)
    assert again.errors == caught.value.errors


def test_errors_of_data_have_no_position(rod: dict[str, Any]) -> None:
    with pytest.raises(ancf.ModelError) as caught:
        ancf.run(rod | {"gravity": [0, 1], "tile": "x"})
    assert [error.path for error in caught.value.errors] == ["tile", "gravity"]
    assert str(caught.value).splitlines()[1] == "gravity: found an array of 2, expected an array of 3 numbers"
    with pytest.raises(TypeError, match=r"bodies\[0\]\.to\[1\]: found an object of type object"):
        ancf.run(rod | {"bodies": [rod["bodies"][0] | {"to": [0, object(), 0]}]})


def test_infinite_data_are_rejected(rod: dict[str, Any]) -> None:
    rod["title"] = rod
    with pytest.raises(ValueError, match="a model that holds itself"):
        ancf.run(rod)
    with pytest.raises(TypeError, match=r"gravity: found an object of type count"):
        ancf.run({"gravity": itertools.count()})


def test_numpy_numbers_are_numbers(rod: dict[str, Any]) -> None:
    body = rod["bodies"][0] | {"to": np.array([1.0, 0, 0]), "elements": np.int64(4)}
    numbers = rod | {"gravity": (np.float32(0), np.float64(-9.81), 0), "bodies": (body,), "title": None}
    np.testing.assert_array_equal(ancf.run(numbers).data, ancf.run(rod).data)


def test_a_failure_keeps_the_rows_before_it(rod: dict[str, Any]) -> None:
    stiff = rod | {"analysis": rod["analysis"] | {"step": 0.1, "max_iterations": 1, "max_halvings": 0}}
    with pytest.raises(ancf.AnalysisError, match=r"failed at t = 0\.1: .*; at: ") as caught:
        ancf.run(stiff)
    result = caught.value.result
    assert result is not None
    assert len(result) == 1
    assert result.summary["outcome"]["kind"] == "failed"


def test_a_callback_sees_each_step_and_may_end_the_run(rod: dict[str, Any]) -> None:
    seen: list[tuple[float, float, float]] = []

    def look(instant: ancf.Instant) -> bool:
        tip = instant.probe("tip").position
        seen.append((instant.time, tip[1], instant.field("position")[-1, 1]))
        return instant.time > 0.1

    result = ancf.run(rod, callback=look)
    assert len(seen) == len(result) == 102
    np.testing.assert_array_equal([y for _, y, _ in seen], result["tip.y"])
    np.testing.assert_allclose([y for *_, y in seen], result["tip.y"], rtol=1e-12)
    assert result.summary["outcome"]["kind"] == "stopped"


def test_an_exception_in_a_callback_ends_the_run(rod: dict[str, Any]) -> None:
    def fail(instant: ancf.Instant) -> None:
        if instant.time > 0.05:
            msg = "enough"
            raise ArithmeticError(msg)

    with pytest.raises(ArithmeticError, match="enough") as caught:
        ancf.run(rod, callback=fail)
    assert len(caught.value.result) == 52  # type: ignore[attr-defined]


def test_ctrl_c_ends_a_run(rod: dict[str, Any]) -> None:
    endless = rod | {"analysis": rod["analysis"] | {"duration": 1e6}, "output": {"every": 1000}}
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt) as caught:
        ancf.run(endless)
    assert len(caught.value.result) > 0  # type: ignore[attr-defined]


def test_other_threads_run_meanwhile(rod: dict[str, Any]) -> None:
    endless = rod | {"analysis": rod["analysis"] | {"duration": 1e6}, "output": {"every": 1000}}
    done = threading.Event()

    # The other thread can only ever set the event if the run lets it.
    timer = threading.Timer(0.1, done.set)
    timer.start()
    result = ancf.run(endless, callback=lambda _: done.is_set())
    assert result.summary["outcome"]["kind"] == "stopped"


def test_a_progress_bar_of_a_motion(rod: dict[str, Any], capsys: pytest.CaptureFixture[str]) -> None:
    still = rod | {"analysis": rod["analysis"] | {"duration": 1e6}, "output": {"every": 1000}}
    done = threading.Event()
    threading.Timer(0.5, done.set).start()
    ancf.run(still, progress=True, callback=lambda _: done.is_set())
    assert "of 1e+06" in capsys.readouterr().err
    ancf.run(rod)
    assert capsys.readouterr().err == ""


def test_unknown_names(rod: dict[str, Any]) -> None:
    result = ancf.run(rod)
    with pytest.raises(KeyError, match=r"no column 'tip\.aay'; did you mean 'tip\.ay'"):
        result["tip.aay"]
    with pytest.raises(KeyError, match="no probe 'top'; did you mean 'tip'"):
        result.probe("top")
    with pytest.raises(AttributeError, match="'pivot' has no position"):
        _ = Probe(result, "pivot").position
    with pytest.raises(AttributeError, match="did you mean 'angle'"):
        _ = result.joints["pivot"].angel
    with pytest.raises(KeyError, match="no body 'leg'"):
        result.field("position", body="leg")
    with pytest.raises(ValueError, match="field: no field 'sped'; did you mean 'speed'"):
        result.field("sped")


def test_a_model_in_the_units_of_the_solver(models: Path) -> None:
    model = ancf.Model.read(models / "cantilever.toml").to_dict() | {"scales": {"kind": "paper"}}
    numbers, scales = ancf.scaled(model)
    # Kim et al. (2017), eqs (7), (8): the length of the beam, the weight of an element, T = L sqrt(rho A / F).
    weight = 8030 * np.pi / 4 * 0.02**2 * 9.81 / 20
    assert scales == pytest.approx({"length": 1.0, "time": np.sqrt(20 / 9.81), "force": weight})
    assert numbers["analysis"]["duration"] == pytest.approx(2 / scales["time"])
    assert ancf.schema()["title"] == "ancf model"


def test_other_objects_than_models_are_rejected() -> None:
    for what in [None, 3, ancf.Model]:
        with pytest.raises(TypeError, match="its data in a dictionary, or the path of a file"):
            ancf.run(what)  # type: ignore[arg-type]
    with pytest.raises(
        TypeError, match=r"density: found an object of type int, expected a number within the range"
    ):
        ancf.Material(density=10**400, young=1e9)


def test_too_large_fields_raise_a_memory_error(rod: dict[str, Any]) -> None:
    result = ancf.run(rod)
    with pytest.raises(ValueError, match="parts: found 0, expected an integer from 1 to 1000"):
        result.field("position", parts=0)
    with pytest.raises(MemoryError, match="the field does not fit into memory"):
        result.field("directors", parts=1000, rows=[0] * 4_000_000)
    with pytest.raises(TypeError, match="not iterable"):
        iter(result)  # type: ignore[call-overload]


def test_results_are_pickled(rod: dict[str, Any]) -> None:
    result = ancf.run(rod)
    again = pickle.loads(pickle.dumps(result))
    np.testing.assert_array_equal(again.data, result.data)
    np.testing.assert_array_equal(again.field("section_forces"), result.field("section_forces"))
    assert again.summary == result.summary


def test_statics_estimates_the_error_of_the_mesh() -> None:
    """P x² (3a - x)/6EI of a cantilever with a load at a: value + error is the closed form on one element."""
    steel = ancf.Material(density=8000, young=2e11)
    section = ancf.Circle(diameter=0.02)
    bar = ancf.Cable("bar", from_=[0, 0, 0], to=[2, 0, 0], elements=1, section=section, material=steel)
    model = ancf.Model(
        bodies=[bar],
        joints=[ancf.Clamp("root", a=bar.start)],
        loads=[ancf.Force(on=bar.at(1.0), force=[0, 0, 1e-3])],
        probes=[ancf.Probe("inner", on=bar.at(0.5))],
        analysis=ancf.Statics(),
    )
    result = ancf.run(model)
    exact = 1e-3 * 0.5**2 * (3 - 0.5) / (6 * 2e11 * math.pi * 0.01**4 / 4)
    assert result["inner.z"][-1] + result.errors["inner.z"] == pytest.approx(exact, rel=1e-6)
    assert abs(result.errors["inner.z"]) > 0.01 * exact
    assert result.summary["errors"]["resolution"] == "good"


def test_frequencies_have_estimated_errors() -> None:
    """Bernoulli-Euler cantilever: the corrected frequency of two cable elements is exact to 1e-5."""
    steel, wire = ancf.Material(density=7850, young=2e11), ancf.Circle(diameter=0.002)
    bar = ancf.Cable("bar", from_=[0, 0, 0], to=[1, 0, 0], elements=2, section=wire, material=steel)
    root = ancf.Clamp("root", a=bar.start)
    result = ancf.run(ancf.Model(bodies=[bar], joints=[root], analysis=ancf.Modes(count=1)))
    exact = 1.875104068711961**2 * math.sqrt(2e11 / 7850) * 0.0005 / (2 * math.pi)
    error = result.errors["frequency[1]"]
    assert result.frequencies[0] + error == pytest.approx(exact, rel=1e-5)
    assert result["frequency_error"][0] == pytest.approx(error)
    assert abs(error) > 1e-4 * exact


def test_meshes_are_refined_to_an_error() -> None:
    """Bernoulli-Euler cantilever: the third frequency has at most the requested error."""
    steel, wire = ancf.Material(density=7850, young=2e11), ancf.Circle(diameter=0.002)
    bar = ancf.Cable("bar", from_=[0, 0, 0], to=[1, 0, 0], elements=3, section=wire, material=steel)
    root = ancf.Clamp("root", a=bar.start)
    result = ancf.run(ancf.Model(bodies=[bar], joints=[root], analysis=ancf.Modes(count=5)), to=1e-4)
    exact = 7.854757438237613**2 * math.sqrt(2e11 / 7850) * 0.0005 / (2 * math.pi)
    # Both planes have equal frequencies.
    assert result.frequencies[4] == pytest.approx(exact, rel=2e-4)
    meshes = result.summary["meshes"]
    counts = [count for mesh in meshes for _, count in mesh["elements"]]
    assert counts[0] == 3
    assert counts == sorted(set(counts))
    assert meshes[-1]["error"] <= 1e-4 < meshes[0]["error"]
    assert result.model["bodies"][0]["elements"] == meshes[-1]["elements"][0][1]
    assert bar.elements == 3


def test_refinement_keeps_callables_and_states_its_limits(rod: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match="to: refines the meshes of statics, modes and buckling"):
        ancf.run(rod, to=0.01)
    rod["analysis"] = {"kind": "modes", "count": 1}
    for wrong in (0, 1, -0.1, math.nan):
        with pytest.raises(ValueError, match="expected a relative error between"):
            ancf.run(rod, to=wrong)
    steel, section = ancf.Material(density=8000, young=2e9, poisson=0.3), ancf.Circle(diameter=0.02)
    bar = ancf.Beam(
        "bar",
        from_=[0, 0, 0],
        to=[1, 0, 0],
        elements=2,
        section=section,
        material=steel,
        formulation="continuum",
    )
    model = ancf.Model(
        bodies=[bar],
        joints=[ancf.Clamp("root", a=bar.start)],
        loads=[ancf.Force(on=bar.end, force=[0, 0, 1], time=lambda t: 1.0)],
        probes=[ancf.Probe("tip", on=bar.end)],
        analysis=ancf.Statics(),
    )
    # Poisson locking: no mesh has the requested error.
    with pytest.warns(ancf.AnalysisWarning, match="the error of 1 % is not reached"):
        result = ancf.run(model, to=0.01)
    assert len(result.summary["meshes"]) > 1


def test_motions_have_estimated_errors() -> None:
    """Mass on a spring, x = sin 20 t/20: value + error is closer to it by a factor of ten."""
    motion = ancf.InitialMotion(velocity=[1, 0, 0])
    body = ancf.RigidBody("m", center=[1, 0, 0], mass=2, inertia=[1, 1, 1], motion=motion)
    guide = ancf.Prismatic("guide", a=body.at(), axis=[1, 0, 0], spring=ancf.LinearSpring(stiffness=800))
    settings = ancf.Dynamics(duration=2, step=5e-3, scheme=ancf.GeneralizedAlpha(spectral_radius=0.8))
    probe = ancf.Probe("p", on=body.at())
    output = ancf.Output(errors=True)
    result = ancf.run(
        ancf.Model(bodies=[body], joints=[guide], probes=[probe], analysis=settings, output=output)
    )
    exact = 1 + np.sin(20 * result["t"]) / 20
    error = np.abs(exact - result["p.x"]).max()
    assert np.abs(exact - result["p.x"] - result["p.x_error"]).max() < 0.1 * error
    assert result.errors["p.x"] == pytest.approx(result["p.x_error"][-1])
    ax = result.plot("p.x")
    (band,) = ax.collections
    (path,) = band.get_paths()
    width = np.ptp(np.asarray(path.vertices)[:, 1]) - np.ptp(result["p.x"])
    assert 0 < width <= 2 * np.abs(result["p.x_error"]).max()


def test_warnings_of_a_run_are_warnings_of_python(bar: dict[str, Any]) -> None:
    """They refer to the line of the caller, also through other functions of the package."""
    coarse = bar | {"bodies": [bar["bodies"][0] | {"elements": 1}]}
    for analyse in (ancf.run, ancf.statics):
        with pytest.warns(ancf.AnalysisWarning, match="shear locking") as caught:
            result = analyse(coarse)
        assert [str(warning.message) for warning in caught] == result.summary["warnings"]
        assert caught[0].filename == __file__
        assert f"{len(caught)} warning" in repr(result)
    # The warnings of a failed run may state its cause.
    with pytest.warns(ancf.AnalysisWarning, match="shear locking"), pytest.raises(ancf.AnalysisError):
        ancf.run(coarse | {"joints": []})
