"""FMUs in three importers: FMPy, libcosim and Ecos."""

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy.validation import validate_fmu
from reference import MODELS, Reference

STEP, END = 1e-3, 0.1
COLUMNS = ["tip.x", "tip.y", "rail.displacement", "pin.angle", "kinetic"]
Fmu = Callable[..., str]

# Equal steps, so equal to rounding.
TOLERANCE = {"rtol": 1e-12, "atol": 0.0}


def constant(push: float | None = None) -> np.ndarray:
    """States of the reference with a constant input."""
    own = Reference.of(MODELS / "cart_pole.toml")
    if push is not None:
        own = Reference((MODELS / "cart_pole.toml").read_text().replace("value = 0.5", f"value = {push}"))
    own.advance(END)
    found = np.array([own.read(name) for name in COLUMNS])
    own.close()
    return found


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("model", ["cart_pole", "moving_base", "overloaded"])
def test_descriptions_are_valid(fmu: Fmu, model: str, version: int) -> None:
    assert validate_fmu(fmu(model, version)) == []


@pytest.mark.parametrize("version", [2, 3])
def test_fmpy_has_the_states_of_the_own_run(fmu: Fmu, version: int) -> None:
    own = Reference((MODELS / "cart_pole.toml").read_text().replace("value = 0.5", "value = 0.0"))
    times = np.linspace(0, END, round(END / STEP) + 1)
    force = np.sin(40 * times)
    signals = np.array(list(zip(times, force, strict=True)), dtype=[("time", float), ("push", float)])
    found = fmpy.simulate_fmu(
        fmu("cart_pole", version), stop_time=END, output_interval=STEP, input=signals, output=COLUMNS
    )
    assert np.allclose(found["time"], times)
    rows = []
    for time, push in zip(times[1:], force, strict=False):
        own.set("push", push)
        own.advance(time)
        rows.append([own.read(name) for name in COLUMNS])
    own.close()
    for i, name in enumerate(COLUMNS):
        assert np.allclose(found[name][1:], np.array(rows)[:, i], **TOLERANCE), name


@pytest.mark.parametrize("step", [7e-4, 2.5e-3])
@pytest.mark.parametrize("control", ["1e-3", "{ tolerance = 1e-4 }"])
def test_communication_steps_have_any_size(tmp_path: Path, step: float, control: str) -> None:
    """Smaller and larger steps than those of the model, and error control."""
    text = (MODELS / "cart_pole.toml").read_text().replace("step = 1e-3", f"step = {control}")
    model = tmp_path / "model.toml"
    model.write_text(text, encoding="utf-8")
    subprocess.run([os.environ["ANCF"], "fmu", str(model)], check=True)
    end = 20 * step
    found = fmpy.simulate_fmu(
        str(model.with_suffix(".fmu")), stop_time=end, output_interval=step, output=COLUMNS
    )
    own = Reference(text)
    for row in found[1:]:
        own.advance(row["time"])
    for name in COLUMNS:
        assert np.isclose(found[name][-1], own.read(name), **TOLERANCE), name
    own.close()


@pytest.mark.parametrize("version", [2, 3])
def test_start_values_change_the_initial_state(fmu: Fmu, version: int) -> None:
    path = fmu("cart_pole", version, "-p", "bodies.cart.mass")
    start = {"push": 2.0, "bodies.cart.mass": 2e-3}
    found = fmpy.simulate_fmu(path, stop_time=END, output_interval=STEP, start_values=start, output=COLUMNS)
    text = (MODELS / "cart_pole.toml").read_text()
    own = Reference(text.replace("value = 0.5", "value = 2.0").replace("mass = 1e-3", "mass = 2e-3"))
    own.advance(END)
    for name in COLUMNS:
        assert np.isclose(found[name][-1], own.read(name), **TOLERANCE), name
    own.close()


def test_libcosim_has_the_states_of_the_own_run(fmu: Fmu) -> None:
    cosim = pytest.importorskip("libcosimpy.CosimExecution", reason="wheels for Linux only")
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    path = fmu("cart_pole", 2)
    references = {v.name: v.valueReference for v in fmpy.read_model_description(path).modelVariables}
    execution = cosim.CosimExecution.from_step_size(step_size=round(STEP * 1e9))
    slave = execution.add_local_slave(CosimLocalSlave(fmu_path=path, instance_name="cart"))
    observer = CosimObserver.create_last_value()
    execution.add_observer(observer)
    execution.real_initial_value(slave, references["push"], 2.0)
    execution.step(step_count=round(END / STEP))
    found = observer.last_real_values(slave, [references[name] for name in COLUMNS])
    assert np.allclose(found, constant(2.0), **TOLERANCE)


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.skipif(sys.platform == "darwin", reason="no binaries")
def test_ecos_has_the_states_of_the_own_run(fmu: Fmu, version: int, tmp_path: Path) -> None:
    from ecospy import EcosSimulation, EcosSimulationStructure

    with EcosSimulationStructure() as structure:
        structure.add_model("cart", fmu("cart_pole", version))
        structure.add_parameter_set("start", {"cart::push": 2.0})
        with EcosSimulation(structure=structure, step_size=STEP) as simulation:
            simulation.init(parameter_set="start")
            for _ in range(round(END / STEP)):
                simulation.step()
            found = [simulation.get_real(f"cart::{name}") for name in COLUMNS]
            simulation.terminate()
    assert np.allclose(found, constant(2.0), **TOLERANCE)
