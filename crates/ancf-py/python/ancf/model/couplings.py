"""Joints that move together."""

# Written by `cargo xtask schema` from the types of the program: change those.

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

from ancf.part import Part

__all__ = ["Coupled", "Coupling", "Freed"]

Freed: TypeAlias = Literal["angle", "displacement"]
"""A freedom of a joint.

* ``"angle"``: The angle about the axis.
* ``"displacement"``: The displacement along the axis.
"""


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Coupled(Part):
    """A joint of a coupling.

    Attributes
    ----------
    joint
        Name of the joint.
    factor
        Factor, not zero: a number for an angle, 1/length for a displacement.
    of
        Which freedom of the joint; by default the angle, if it has one. One of ``"angle"``,
        ``"displacement"``.

    """

    _form = "Coupled"

    joint: str
    factor: float
    of: Freed | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Coupling(Part):
    """Joints that move together: the sum of their angles and displacements, times factors, stays zero.

    Gears, racks, belts, screws.

    Attributes
    ----------
    name
        Name in messages.
    joints
        The joints and their factors, 63 at most.

    """

    _form = "Coupling"

    name: str = field(kw_only=False)
    joints: Sequence[Coupled]
