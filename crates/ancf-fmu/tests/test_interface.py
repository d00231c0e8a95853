"""Functions of the standard, called through the classes of FMPy: states, derivatives, errors."""

import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import fmpy
import numpy as np
import pytest
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from reference import MODELS, Reference

Fmu = Callable[..., str]
VERSIONS = pytest.mark.parametrize("version", [2, 3])


class Instance:
    """Instance of an FMU with the same calls for both versions."""

    def __init__(self, path: str, token: str | None = None, *, early: bool = False) -> None:
        description = fmpy.read_model_description(path)
        self.version = int(description.fmiVersion[0])
        self.references = {v.name: v.valueReference for v in description.modelVariables}
        self.folder = fmpy.extract(path)
        self.messages: list[str] = []
        kind = FMU2Slave if self.version == 2 else FMU3Slave
        self.fmu: Any = kind(
            guid=token or description.guid,
            unzipDirectory=self.folder,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName="one",
        )
        if self.version == 2:
            from fmpy.fmi2 import (
                fmi2CallbackAllocateMemoryTYPE,
                fmi2CallbackFreeMemoryTYPE,
                fmi2CallbackFunctions,
                fmi2CallbackLoggerTYPE,
            )

            callbacks = fmi2CallbackFunctions()
            callbacks.logger = fmi2CallbackLoggerTYPE(lambda *given: self.messages.append(given[4].decode()))
            callbacks.allocateMemory = fmi2CallbackAllocateMemoryTYPE(fmpy.calloc)
            callbacks.freeMemory = fmi2CallbackFreeMemoryTYPE(fmpy.free)
            self.fmu.instantiate(callbacks=callbacks)
        else:
            self.fmu.instantiate(
                logMessage=lambda *given: self.messages.append(given[3].decode()), earlyReturnAllowed=early
            )

    def start(
        self, values: dict[str, float] | None = None, within: dict[str, float] | None = None, **times: float
    ) -> None:
        """Initialise with start values that are set before or within the initialization mode."""
        for name, value in (values or {}).items():
            self.set(name, value)
        if self.version == 2:
            self.fmu.setupExperiment(**times)
            self.fmu.enterInitializationMode()
        else:
            self.fmu.enterInitializationMode(**times)
        for name, value in (within or {}).items():
            self.set(name, value)
        self.fmu.exitInitializationMode()

    def set(self, name: str, value: float) -> None:
        """Set a variable."""
        call = self.fmu.setReal if self.version == 2 else self.fmu.setFloat64
        call([self.references[name]], [value])

    def get(self, *names: str) -> list[float]:
        """Values of variables."""
        call = self.fmu.getReal if self.version == 2 else self.fmu.getFloat64
        return list(call([self.references[name] for name in names]))

    def all(self) -> list[float]:
        """Values of all variables."""
        return self.get(*self.references)

    def step(self, time: float, size: float) -> Any:
        """Advance."""
        return self.fmu.doStep(currentCommunicationPoint=time, communicationStepSize=size)

    def save(self) -> Any:
        """State."""
        return self.fmu.getFMUstate() if self.version == 2 else self.fmu.getFMUState()

    def restore(self, state: Any) -> None:
        """Return to a state."""
        (self.fmu.setFMUstate if self.version == 2 else self.fmu.setFMUState)(state)

    def serialized(self, state: Any) -> bytes:
        """State as bytes."""
        call = self.fmu.serializeFMUstate if self.version == 2 else self.fmu.serializeFMUState
        return bytes(call(state))

    def deserialized(self, data: bytes) -> Any:
        """State of bytes."""
        call = self.fmu.deSerializeFMUstate if self.version == 2 else self.fmu.deserializeFMUState
        return call(data)


@contextmanager
def instance(path: str, **options: Any) -> Iterator[Instance]:
    """Instance that is released at the end."""
    one = Instance(path, **options)
    try:
        yield one
    finally:
        one.fmu.freeInstance()
        shutil.rmtree(one.folder, ignore_errors=True)


@VERSIONS
def test_a_restored_state_continues_with_the_same_bits(fmu: Fmu, version: int) -> None:
    path = fmu("cart_pole", version)
    with instance(path) as one, instance(path) as other:
        one.start()
        other.start()
        one.step(0, 0.05)
        one.set("push", -2.0)
        state = one.save()
        data = one.serialized(state)
        one.step(0.05, 0.03)
        one.set("push", 7.0)
        first = one.all()
        one.restore(state)
        one.step(0.05, 0.03)
        one.set("push", 7.0)
        assert one.all() == first
        other.restore(other.deserialized(data))
        other.step(0.05, 0.03)
        other.set("push", 7.0)
        assert other.all() == first
        with pytest.raises(FMICallException):
            other.restore(other.deserialized(data[:40]))
        assert "damaged" in other.messages[-1]
        assert other.all() == first


@VERSIONS
def test_a_state_contains_the_parameters(fmu: Fmu, version: int) -> None:
    path = fmu("cart_pole", version, "-p", "bodies.cart.mass")
    with instance(path) as light, instance(path) as heavy:
        light.start()
        heavy.start({"bodies.cart.mass": 5e-3, "push": 3.0})
        for one in (light, heavy):
            one.step(0, 0.02)
        data = heavy.serialized(heavy.save())
        heavy.step(0.02, 0.02)
        light.restore(light.deserialized(data))
        light.step(0.02, 0.02)
        assert light.all() == heavy.all()


@VERSIONS
def test_parameters_may_be_set_in_initialization_mode(fmu: Fmu, version: int) -> None:
    path = fmu("cart_pole", version, "-p", "bodies.cart.mass")
    values = {"bodies.cart.mass": 5e-3, "push": 3.0}
    with instance(path) as before, instance(path) as within:
        before.start(values)
        within.start(within=values)
        for one in (before, within):
            one.step(0, 0.02)
        assert within.all() == before.all()


@VERSIONS
def test_reset_returns_to_the_start(fmu: Fmu, version: int) -> None:
    with instance(fmu("cart_pole", version)) as one:
        one.start()
        first = one.all()
        one.set("push", 3.0)
        one.step(0, 0.02)
        assert one.all() != first
        one.fmu.reset()
        one.start()
        assert one.all() == first


@VERSIONS
def test_derivatives_are_those_of_the_outputs(fmu: Fmu, version: int) -> None:
    """Change of the outputs by a new value of the input: δ dy/du, since the equations are linear in the force."""
    names = ["tip.ax", "tip.ay", "pin.fx", "rail.displacement"]
    with instance(fmu("cart_pole", version)) as one:
        one.start()
        one.step(0, 0.05)
        one.set("push", 0.75)
        before = np.array(one.get(*names))
        one.set("push", 1.0)
        change = np.array(one.get(*names)) - before
        outputs = [one.references[name] for name in names]
        inputs = [one.references["push"]]
        if version == 2:
            found = one.fmu.getDirectionalDerivative(outputs, inputs, [0.25])
        else:
            found = one.fmu.getDirectionalDerivative(unknowns=outputs, knowns=inputs, seed=[0.25])
        assert abs(change[0]) > 1
        scale = np.abs(change[:2]).max()
        assert np.allclose(found, change, rtol=1e-6, atol=1e-6 * scale)


@VERSIONS
def test_a_moving_base_follows_its_input_within_the_step(fmu: Fmu, version: int) -> None:
    own = Reference.of(MODELS / "moving_base.toml")
    path = fmu("moving_base", version)
    assert not fmpy.read_model_description(path).coSimulation.providesDirectionalDerivative
    with instance(path) as one:
        one.start()
        for i, base in enumerate([0.01, 0.03, 0.02, 0.02]):
            one.set("base", base)
            one.step(0.05 * i, 0.05)
            own.set("base", base, 0.05 * i + 0.05 - 0.05 * i)
            own.advance(0.05 * i + 0.05)
            names = ("rail.displacement", "pin.angle", "pin.fx")
            assert np.allclose(one.get(*names), [own.read(name) for name in names], rtol=1e-9, atol=1e-12)
            assert np.isclose(one.get("rail.displacement")[0], base, atol=1e-12)
    own.close()


@VERSIONS
def test_a_step_that_fails_states_the_time_of_its_state(fmu: Fmu, version: int) -> None:
    with instance(fmu("overloaded", version), early=True) as one:
        one.start()
        if version == 2:
            with pytest.raises(FMICallException) as raised:
                one.step(0, 1)
            assert raised.value.status == 2
            assert one.fmu.getRealStatus(2) == 0.5
        else:
            _, _, early, time = one.step(0, 1)
            assert (early, time) == (True, 0.5)
        assert "failed at t = 0.6" in one.messages[-1]
        assert one.get("time") == [0.5]
        with pytest.raises(FMICallException) as raised:
            one.step(0.5, 0.5)
        assert raised.value.status == 3
        one.step(0.5, 1e-6)


@VERSIONS
def test_invalid_calls_are_rejected_with_messages(fmu: Fmu, version: int) -> None:
    path = fmu("cart_pole", version, "-p", "bodies.cart.mass")

    def rejected(one: Instance, call: Callable[[], object], text: str) -> None:
        with pytest.raises(FMICallException) as raised:
            call()
        assert raised.value.status == 3
        assert text in one.messages[-1], one.messages

    with instance(path) as one:
        rejected(one, lambda: one.step(0, 0.1), "not allowed in the phase Instantiated")
        rejected(one, lambda: one.set("push", float("nan")), "expected a finite number")
        one.references["none"] = 10_000
        rejected(one, lambda: one.set("none", 1.0), "no variable has the value reference 10000")
        rejected(one, lambda: one.set("tip.x", 1.0), '"tip.x" cannot be set')
        rejected(one, lambda: one.start({"bodies.cart.mass": -1.0}), "mass")
        one.fmu.reset()
        rejected(one, lambda: one.start(startTime=1.0), "start time: found 1, expected 0")
        one.start(stopTime=0.05)
        rejected(one, lambda: one.set("bodies.cart.mass", 1.0), "fixed after the initialization")
        rejected(one, lambda: one.step(0.01, 0.01), "communication point: found 0.01, expected 0")
        rejected(one, lambda: one.step(0, -0.01), "expected a number above 0")
        rejected(one, lambda: one.step(0, 0.1), "expected at most 0.05")
        one.step(0, 0.05)
    with pytest.raises(Exception, match="nstantiate"):
        Instance(path, token="{other}")
