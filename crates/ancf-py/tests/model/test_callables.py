"""Functions of Python in loads, drives and forces."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import ancf

Array = np.typing.NDArray[np.float64]


def push(time: object) -> list[dict[str, Any]]:
    """A force on the tip that varies in time."""
    return [{"kind": "force", "on": {"body": "arm", "at": "end"}, "force": [0, 5, 0], "time": time}]


def test_a_load_by_a_callable_equals_a_formula(rod: dict[str, Any]) -> None:
    formula = {"kind": "expression", "text": "t * sin(30*t)"}
    built_in = ancf.run(rod | {"loads": push(formula)})
    own = ancf.run(rod | {"loads": push(lambda t: t * np.sin(30 * t))})
    np.testing.assert_allclose(own["tip.y"], built_in["tip.y"], rtol=0, atol=1e-10)


@pytest.mark.parametrize("has_rates", [True, False])
def test_a_drive_by_a_callable_equals_a_formula(rod: dict[str, Any], has_rates: bool) -> None:
    def turn(t: float) -> float | tuple[float, float, float]:
        value = 1 - np.cos(8 * t)
        return (value, 8 * np.sin(8 * t), 64 * np.cos(8 * t)) if has_rates else float(value)

    def driven(time: object) -> ancf.Result:
        joint = rod["joints"][0] | {"drive": {"angle": 0.4, "time": time}}
        return ancf.run(rod | {"joints": [joint], "scales": {"kind": "auto"}})

    formula, own = driven({"kind": "expression", "text": "1 - cos(8*t)"}), driven(turn)
    np.testing.assert_allclose(own.joints["pivot"].angle, 0.4 * (1 - np.cos(8 * own.time)), atol=1e-9)
    # Finite differences have eight digits. Their derivatives enter the accelerations.
    limit = 1e-9 if has_rates else 1e-5 * np.abs(formula["pivot.mz"]).max()
    np.testing.assert_allclose(own["pivot.mz"], formula["pivot.mz"], rtol=0, atol=limit)


def test_a_force_by_a_callable_acts_as_spring_and_damper(rod: dict[str, Any]) -> None:
    spring = {
        "kind": "spring",
        "name": "spring",
        "a": {"body": "arm", "at": "end"},
        "b": {"point": [1, 1, 0]},
        "stiffness": 200.0,
        "damping": 3.0,
    }

    def pull(_: float, x: Array, v: Array) -> Array:
        away = x - [1, 1, 0]
        length = float(np.linalg.norm(away))
        along = away / length
        return -(200.0 * (length - 1) + 3.0 * float(v @ along)) * along

    built_in = ancf.run(rod | {"joints": [*rod["joints"], spring]})
    force = {"kind": "external", "name": pull, "on": {"body": "arm", "at": "end"}}
    own = ancf.run(rod | {"loads": [force]})
    np.testing.assert_allclose(own["tip.y"], built_in["tip.y"], rtol=0, atol=1e-8)


def test_a_callback_controls_a_load(rod: dict[str, Any]) -> None:
    free = rod | {"gravity": [0, 0, 0]}
    speed, force = 0.5, 0.0

    def control(instant: ancf.Instant) -> None:
        nonlocal force
        force = 4.0 * (speed - instant.probe("tip").velocity[1])

    result = ancf.run(
        free | {"loads": push(lambda _: force), "analysis": rod["analysis"] | {"duration": 1.0}},
        callback=control,
    )
    assert result.probe("tip").velocity[-1, 1] == pytest.approx(speed, rel=0.02)


@pytest.mark.parametrize("late", [False, True])
def test_an_exception_of_a_callable_ends_the_run(rod: dict[str, Any], late: bool) -> None:
    def fail(t: float) -> float:
        if t > 0.1 or not late:
            msg = "no more"
            raise ArithmeticError(msg)
        return 1.0

    with pytest.raises(ArithmeticError, match="no more") as caught:
        ancf.run(rod | {"loads": push(fail)})
    if late:
        assert len(caught.value.result) == 101  # type: ignore[attr-defined]


def test_an_external_function_without_callable_is_rejected(rod: dict[str, Any]) -> None:
    with pytest.raises(ancf.ModelError, match=r'loads\[0\]\.time\.name: found the external function "motor"'):
        ancf.run(rod | {"loads": push({"kind": "external", "name": "motor"})})


def test_models_with_functions_are_checked(rod: dict[str, Any]) -> None:
    assert "1 beam" in ancf.check(rod | {"loads": push(np.sin)})


def test_an_external_force_with_a_function_of_time(rod: dict[str, Any]) -> None:
    hours = {"kind": "external", "name": lambda t: np.sin(3 * t), "unit": 10.0}
    fast = ancf.run(rod | {"loads": push(hours)})
    own = ancf.run(rod | {"loads": push(lambda t: np.sin(30 * t))})
    np.testing.assert_allclose(fast["tip.y"], own["tip.y"], rtol=0, atol=1e-12)


@pytest.mark.parametrize("answer", [None, "strong", float("nan"), [1.0, 2.0], (1.0, float("inf"), 0.0)])
def test_invalid_return_values_are_reported(rod: dict[str, Any], answer: Any) -> None:
    with pytest.raises(
        ValueError, match=r"loads\[0\]\.time at t = 0: found .*, expected a number, or value"
    ) as caught:
        ancf.run(rod | {"loads": push(lambda _: answer)})
    assert repr(answer) in str(caught.value)
    force = {"kind": "external", "name": lambda *_: answer, "on": {"body": "arm", "at": "end"}}
    with pytest.raises(ValueError, match=r"loads\[0\]\.name at t = 0: found .*, expected three numbers"):
        ancf.run(rod | {"loads": [force]})


def test_the_model_of_a_result_keeps_its_functions(rod: dict[str, Any]) -> None:
    result = ancf.run(rod | {"loads": push(np.sin)})
    np.testing.assert_array_equal(ancf.run(result.model).data, result.data)
    with pytest.raises(
        TypeError,
        match=r"loads\[0\]\.time: found a function of Python, expected a value that a file can state",
    ):
        ancf.Model.from_dict(result.model).to_toml()
