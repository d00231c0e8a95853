"""Names of earlier versions, and messages for unknown names of the package."""

from __future__ import annotations

from collections.abc import Sequence

from ancf import _ancf

RENAMED = {
    "About": "LinearizationState",
    "At": "Position",
    "Coupled": "CoupledJoint",
    "Drive": "PrescribedMotion",
    "EachOther": "MutualContact",
    "End": "JointEnd",
    "EnergyStop": "EnergyCriterion",
    "Fluid": "FluidLoad",
    "IncrementStop": "IncrementCriterion",
    "Path": "EquilibriumPath",
    "Quantity": "ProbeQuantity",
    "ResidualStop": "ResidualCriterion",
    "Sense": "LoadDirection",
    "Shape": "AxisShape",
    "Slide": "SlidingJoint",
    "Slopes": "SlopeCoordinates",
    "Start": "InitialAccelerations",
    "Step": "StepFunction",
    "Stop": "ConvergenceCriterion",
    "Table": "TimeTable",
    "Unstable": "InstabilityAction",
    "Varying": "VaryingFunction",
}
"""New names by the names up to version 0.1."""


def unknown(name: str, known: Sequence[str]) -> str:
    """Return the message for an unknown name of the package."""
    if name in RENAMED:
        return f"ancf.{name} is now called ancf.{RENAMED[name]}"
    near = _ancf.nearest(name, list(known))
    hint = f"; did you mean {near!r}?" if near else ""
    return f"module 'ancf' has no attribute {name!r}{hint}"
