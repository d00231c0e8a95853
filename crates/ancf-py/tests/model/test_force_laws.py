"""Force laws of joints by formulas and Python functions."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import ancf


def oscillator(force: ancf.ForceExpression | ancf.ExternalForceLaw) -> ancf.Model:
    """Return a mass of 2 on a guide with a force law, released at the speed 2."""
    block = ancf.RigidBody(
        "block", center=[0, 0, 0], mass=2, inertia=[1, 1, 1], motion=ancf.InitialMotion(velocity=[2, 0, 0])
    )
    guide = ancf.Prismatic("guide", a=block.at(), axis=[1, 0, 0], force=force)
    return ancf.Model(bodies=[block], joints=[guide], analysis=ancf.Dynamics(duration=1, step=2e-3))


def test_functions_equal_the_formula() -> None:
    formula = ancf.run(oscillator(ancf.ForceExpression("-8*x - 60*x^3 - 0.2*v")))
    plain = ancf.ExternalForceLaw(lambda t, x, v: -8 * x - 60 * x**3 - 0.2 * v, autonomous=True)
    derived = ancf.ExternalForceLaw(
        lambda t, x, v: (-8 * x - 60 * x**3 - 0.2 * v, -8 - 180 * x * x, -0.2), autonomous=True
    )
    for law in (plain, derived):
        result = ancf.run(oscillator(law))
        np.testing.assert_allclose(result["guide.displacement"], formula["guide.displacement"], atol=1e-8)
        np.testing.assert_allclose(result["strain"], formula["strain"], atol=1e-8)


def test_invalid_results_are_reported() -> None:
    law: Any = lambda t, x, v: "much"  # noqa: E731
    with pytest.raises(ValueError, match="a number"):
        ancf.run(oscillator(ancf.ExternalForceLaw(law)))
