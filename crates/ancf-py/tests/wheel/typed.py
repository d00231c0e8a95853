"""Typed use of the package, for type checkers beside an installed wheel. An `ignore` without an error fails."""

# pyright: reportUnnecessaryTypeIgnoreComment=true

from typing import Any

import numpy as np
from numpy.typing import NDArray

import ancf

rod = ancf.Beam(
    "rod",
    from_=[0, 0, 0],
    to=[1, 0, 0],
    elements=4,
    section=ancf.Circle(diameter=0.02),
    material=ancf.Material(density=1100, young=5e6),
)
model = ancf.Model(
    gravity=[0, 0, -9.81],
    bodies=[rod],
    joints=[ancf.Revolute("hinge", a=rod.start, axis=[0, 1, 0])],
    probes=[ancf.Probe("tip", on=rod.end)],
    analysis=ancf.Dynamics(duration=0.1, step=1e-3),
)
result: ancf.Result = ancf.run(model)
height: NDArray[np.float64] = result["tip.z"]
columns: Any = list(result.columns)
wrong: str = ancf.run(model)  # type: ignore[assignment]
ancf.Circle(radius=0.01)  # type: ignore[call-arg]
