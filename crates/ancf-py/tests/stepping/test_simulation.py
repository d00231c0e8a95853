"""Motions advanced step by step: steps, inputs, states, snapshots, threads, linear models."""

from __future__ import annotations

import copy
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.linalg

import ancf


def pendulum(**more: Any) -> dict[str, Any]:
    """Return an inverted or hanging pendulum with a motor."""
    return {
        "gravity": [0, -9.81, 0],
        "bodies": [
            {"kind": "rigid", "name": "rod", "center": [0, -0.8, 0], "mass": 3, "inertia": [0.58, 0.1, 0.58]}
        ],
        "inputs": [{"name": "torque"}],
        "probes": [{"name": "rod", "on": {"body": "rod", "at": "center"}}],
        "joints": [
            {"kind": "revolute", "name": "pin", "a": {"body": "rod", "at": [0, 0, 0]}, "axis": [0, 0, 1]}
        ],
        "loads": [
            {
                "kind": "moment",
                "on": {"body": "rod", "at": "center"},
                "moment": [0, 0, 1],
                "follower": True,
                "time": {"kind": "input", "name": "torque"},
            }
        ],
        "analysis": {"kind": "dynamics", "duration": 0.5, "step": 1e-3, "scheme": {"spectral_radius": 0.9}},
    } | more


def test_advance_equals_a_run() -> None:
    data = pendulum(inputs=[{"name": "torque", "value": 2.0}])
    result = ancf.run(data, progress=False)
    sim = ancf.Simulation(data)
    info = sim.advance(0.5)
    row = sim.row()
    assert info.substeps == result.summary["steps"] == 500
    assert all(row[name] == result[name][-1] for name in result.columns if name != "iterations")
    assert result.summary["inputs"] == [["torque", 2.0]]
    assert sim.energies() == {name: row[name] for name in sim.energies()}
    assert repr(sim) == "Simulation at t = 0.5"


def test_a_torque_is_set() -> None:
    model = ancf.Model(
        bodies=[ancf.RigidBody("rotor", center=[0, 0, 0], mass=1, inertia=[1, 1, 2])],
        joints=[ancf.Revolute("shaft", a=ancf.Place(body="rotor", at="center"), axis=[0, 0, 1])],
        inputs=[ancf.Input("torque")],
        loads=[
            ancf.Moment(
                on=ancf.Place(body="rotor", at="center"),
                moment=[0, 0, 4],
                follower=True,
                time=ancf.InputFunction("torque"),
            )
        ],
        analysis=ancf.Dynamics(duration=1, step=0.01, scheme="average_acceleration"),
    )
    sim = ancf.Simulation(model)
    sim.set("torque", 1.0)
    assert sim.inputs == {"torque": 1.0}
    sim.advance(0.5)
    assert sim.read("shaft.rate") == pytest.approx(1.0, rel=1e-4)
    sim.set("torque", -1.0, ramp=0.5)
    sim.advance(1.0)
    assert sim.read("shaft.rate") == pytest.approx(1.0, rel=1e-3)


@pytest.mark.parametrize("h", [0, -1, float("nan"), float("inf")])
def test_invalid_steps_change_nothing(h: float) -> None:
    sim = ancf.Simulation(pendulum())
    before = sim.save()
    with pytest.raises(ValueError, match="h: found"):
        sim.step(h)
    assert sim.save() == before


def test_invalid_names_and_values() -> None:
    sim = ancf.Simulation(pendulum())
    with pytest.raises(ValueError, match='perhaps "torque"'):
        sim.set("torqe", 1)
    with pytest.raises(ValueError, match="finite number"):
        sim.set("torque", float("nan"))
    with pytest.raises(KeyError, match="perhaps"):
        sim.read("rod.xx")
    with pytest.raises(ancf.ModelError, match="no load, no drive and no force law uses"):
        ancf.Simulation(pendulum(inputs=[{"name": "torque"}, {"name": "unused"}]))
    with pytest.raises(ancf.ModelError, match="which is advanced step by step"):
        ancf.Simulation(pendulum(analysis={"kind": "statics"}))


SCRIPT = """
import sys, pathlib, ancf
sys.path.insert(0, sys.argv[1])
from test_simulation import pendulum
sim = ancf.Simulation(pendulum())
sim.restore(pathlib.Path(sys.argv[2]).read_bytes())
sim.advance(0.4)
print(sim.row())
"""


def test_snapshots_continue_in_another_process(tmp_path: Path) -> None:
    sim = ancf.Simulation(pendulum())
    sim.set("torque", 5.0, ramp=0.15)
    sim.advance(0.1)
    snapshot = sim.save()
    (tmp_path / "snapshot").write_bytes(snapshot)
    sim.advance(0.4)
    arguments = [sys.executable, "-c", SCRIPT, str(Path(__file__).parent), str(tmp_path / "snapshot")]
    done = subprocess.run(arguments, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == str(sim.row())
    other = ancf.Simulation(pendulum(gravity=[0, -1.62, 0]))
    with pytest.raises(ValueError, match="another model"):
        other.restore(snapshot)
    with pytest.raises(ValueError, match="damaged"):
        sim.restore(snapshot[:-3])


def test_states_are_projected() -> None:
    sim = ancf.Simulation(pendulum())
    sim.advance(0.1)
    state = sim.state
    body = state.body("rod")
    assert body.positions == pytest.approx(np.array([[0, -0.8, 0]]), abs=1e-9)
    assert body.directions.shape == (3, 3)
    clone = state.copy()
    sim.state = clone
    body.velocities[0] += [1.0, 0, 0]
    with pytest.warns(ancf.AnalysisWarning, match="violates constraints"):
        sim.state = state
    assert 0 < sim.read("rod.vx") < 1
    body.positions = [[0.1, -0.8, 0]]
    moved, _, _ = sim.set_state(state)
    assert 1e-3 < moved < 0.1
    state.coordinates = state.coordinates[:-1]
    with pytest.raises(ValueError, match="state, coordinates"):
        sim.set_state(state)
    with pytest.raises(KeyError, match="rod"):
        state.body("road")


def test_exceptions_of_functions_leave_the_last_state() -> None:
    def force(t: float) -> float:
        if t > 0.2:
            raise ZeroDivisionError("beyond")
        return 1.0

    data = copy.deepcopy(pendulum())
    data["loads"].append(
        {"kind": "force", "on": {"body": "rod", "at": "center"}, "force": [1, 0, 0], "time": force}
    )
    sim = ancf.Simulation(data)
    with pytest.raises(ZeroDivisionError, match="beyond"):
        sim.advance(0.5)
    assert sim.time == pytest.approx(0.2)
    sim.set("torque", 1.0)
    with pytest.raises(ZeroDivisionError):
        sim.step(0.1)


def test_a_function_that_calls_its_simulation_is_an_error() -> None:
    sims: list[ancf.Simulation] = []

    def force(t: float) -> float:
        if sims and t > 0:
            sims[0].read("rod.x")
        return 1.0

    data = copy.deepcopy(pendulum())
    data["loads"].append(
        {"kind": "force", "on": {"body": "rod", "at": "center"}, "force": [1, 0, 0], "time": force}
    )
    sims.append(ancf.Simulation(data))
    with pytest.raises(RuntimeError, match="in use"):
        sims[0].step(1e-3)


def test_threads_advance_independent_simulations() -> None:
    alone = ancf.Simulation(pendulum())
    alone.set("torque", 3.0)
    alone.advance(0.3)
    rows: dict[int, dict[str, float]] = {}

    def advance(number: int) -> None:
        sim = ancf.Simulation(pendulum())
        sim.set("torque", 3.0)
        sim.advance(0.3)
        rows[number] = sim.row()

    threads = [threading.Thread(target=advance, args=(i,)) for i in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(rows[i] == alone.row() for i in range(3))


def test_linear_models_contain_states_and_signals_of_laws() -> None:
    def body(name: str, y: float, mass: float) -> ancf.RigidBody:
        return ancf.RigidBody(name, center=[0, y, 0], mass=mass, inertia=[0.1, 0.1, 0.1])

    own, other = body("own", 0, 2), body("other", 1, 3)
    law = ancf.ForceExpression(
        "-50*(x - y) - 4*v + 10*u + z",
        states=[ancf.LawStateEquation("z", rate="y - 2*z")],
        signals=[ancf.LawSignal("y", value="two.displacement")],
    )
    spring = ancf.LinearSpring(stiffness=30, damping=1)
    push = ancf.Force(on=other.at(), force=[1, 0, 0], time=ancf.InputFunction("u"))
    model = ancf.Model(
        bodies=[own, other],
        inputs=[ancf.Input("u")],
        joints=[
            ancf.Prismatic("one", a=own.at(), axis=[1, 0, 0], force=law),
            ancf.Prismatic("two", a=other.at(), axis=[1, 0, 0], spring=spring),
        ],
        loads=[push],
        analysis=ancf.Dynamics(duration=1, step=1e-3),
    )
    sim = ancf.Simulation(model)
    linear = sim.linearize(["one.displacement", "one.z", "two.speed"])
    assert linear.A.shape == (5, 5)
    sim.set("u", 1)
    sim.advance(0.5)
    # The model is linear: x(t) = A⁻¹ (exp(A t) - 1) B.
    expected = np.linalg.solve(linear.A, (scipy.linalg.expm(linear.A * 0.5) - np.eye(5)) @ linear.B[:, 0])
    assert np.abs(linear.x(sim) - expected).max() < 1e-5 * np.abs(expected).max()
    found = [sim.read(name) for name in linear.outputs]
    assert np.allclose(found, linear.C @ expected, rtol=0, atol=1e-5)


def test_linear_model_of_a_pendulum() -> None:
    sim = ancf.Simulation(pendulum())
    model = sim.linearize(["pin.angle", "pin.rate"])
    omega = np.sqrt(3 * 9.81 * 0.8 / 2.5)
    assert np.sort(model.poles.imag) == pytest.approx([-omega, omega])
    assert (model.C @ model.B)[1, 0] == pytest.approx(1 / 2.5)
    assert model.inputs == ["torque"]
    assert np.abs(model.D).max() < 1e-12
    sim.set("torque", 0.01)
    sim.advance(0.2)
    # Outputs of a small motion.
    assert model.C @ model.x(sim) == pytest.approx(sim.values(model.outputs), rel=1e-3)
    with pytest.raises(ValueError, match="functions of the state"):
        sim.linearize(["work"])
