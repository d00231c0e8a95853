"""Modes with damping, and modes of a rotating blade."""

from __future__ import annotations

import numpy as np
import pytest

import ancf
from ancf.graphics.lines import Lines


def rotor(speed: float) -> ancf.Model:
    """Return a blade with strain damping, on a ground that rotates about z."""
    composite = ancf.Material("composite", density=1800, young=4e10, damping=ancf.Damping(strain=1e-4))
    blade = ancf.Beam(
        "blade",
        from_=[0.1, 0, 0],
        to=[1.1, 0, 0],
        elements=8,
        section=ancf.Rectangle(height=0.01, width=0.05),
        up=[0, 0, 1],
        material=composite,
    )
    return ancf.Model(
        bodies=[blade],
        joints=[ancf.Clamp("hub", a=blade.start)],
        loads=[ancf.BaseRotation(angular_velocity=[0, 0, speed])],
        probes=[ancf.Probe("tip", on=blade.end)],
        analysis=ancf.Modes(count=2, about="equilibrium", damped=True),
    )


def test_damping_ratios_and_centrifugal_stiffening() -> None:
    at_rest, turning = ancf.run(rotor(0)), ancf.run(rotor(100))
    omega = 2 * np.pi * at_rest.frequencies[0] / np.sqrt(1 - at_rest.damping_ratios[0] ** 2)
    assert at_rest.damping_ratios[0] == pytest.approx(0.5e-4 * omega, rel=1e-6)
    assert turning.frequencies[0] > 1.5 * at_rest.frequencies[0]
    assert at_rest.shapes.shape == (2, 9, 3)
    at_rest.plot_modes(2)


def test_modes_without_gyroscopic_forces_are_rejected() -> None:
    model = rotor(10)
    model.analysis = ancf.Modes(count=2)
    with pytest.raises(ancf.ModelError, match="Coriolis forces couple the modes") as failure:
        ancf.run(model)
    assert "analysis.about" in str(failure.value)
    result = ancf.statics(rotor(10))
    with pytest.raises(AttributeError, match="a result of statics has no damping ratio"):
        _ = result.damping_ratios


def whirls(speed: float) -> ancf.Result:
    """Return the modes of a round shaft along x that turns about its axis."""
    shaft = ancf.Beam(
        "shaft",
        from_=[0, 0, 0],
        to=[1, 0, 0],
        elements=6,
        section=ancf.Circle(diameter=0.02),
        material=ancf.Material("steel", density=7850, young=2.1e11),
    )
    return ancf.run(
        ancf.Model(
            bodies=[shaft],
            joints=[ancf.Clamp("chuck", a=shaft.start)],
            loads=[ancf.BaseRotation(angular_velocity=[speed, 0, 0])],
            analysis=ancf.Modes(count=2, about="equilibrium", damped=True),
        )
    )


def test_complex_shapes_of_whirls_are_circles() -> None:
    result = whirls(30)
    shapes = result.complex_shapes
    assert np.array_equal(shapes.real, result.shapes)
    for shape, sense in zip(shapes, [-1j, 1j], strict=True):
        assert shape[:, 2] == pytest.approx(sense * shape[:, 1], abs=1e-5 * np.abs(shape).max())
    lines = Lines(result)
    for row, sense in enumerate([1, -1]):
        phases = np.linspace(0, 2 * np.pi, 13)
        tips = np.array(
            [lines.phase_positions(row, 1.0, phase)[-1] - lines.path[row][-1] for phase in phases]
        )
        angles = np.unwrap(np.arctan2(tips[:, 2], tips[:, 1]))
        assert np.diff(angles) == pytest.approx(sense * np.diff(phases), abs=1e-5)
        assert np.hypot(tips[:, 1], tips[:, 2]) == pytest.approx(np.abs(shapes[row, -1, 1]), rel=1e-5)


def test_undamped_shapes_have_no_imaginary_part() -> None:
    model = rotor(0)
    model.loads = []
    model.analysis = ancf.Modes(count=2)
    assert np.all(ancf.run(model).complex_shapes.imag == 0)
    imaginary = Lines(ancf.run(rotor(0))).imaginary
    assert imaginary is not None
    assert not imaginary.any()
