"""Places on bodies."""

# Written by `cargo xtask schema` from the types of the program: change those.

from dataclasses import dataclass, field
from typing import Literal, TypeAlias

from ancf.part import Part, Vector

__all__ = ["At", "End", "Ground", "Named", "Place"]

Named: TypeAlias = Literal["start", "center", "end"]
"""Positions that have names.

* ``"start"``: Where the axis starts.
* ``"center"``: The middle of the axis, or the centre of mass of a rigid body.
* ``"end"``: Where the axis ends.
"""

At: TypeAlias = Named | float | Vector
"""A position on a body.

Of a beam or a cable ``"start"``, ``"center"``, ``"end"`` or the arc length from the start; of a rigid body
``"center"`` or a point.
"""


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Place(Part):
    """A point of a body.

    Attributes
    ----------
    body
        Name of the body.
    at
        Where on its axis, or where on a rigid body.
    offset
        A rigid arm from there, fixed to the section, in the global frame at the start, length; none by
        default.

    """

    _form = "Place"

    body: str = field(kw_only=False)
    at: At = field(kw_only=False)
    offset: Vector | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Ground(Part):
    """A point of the fixed frame.

    Attributes
    ----------
    point
        The point, length.

    """

    _form = "Ground"

    point: Vector


End: TypeAlias = Literal["ground"] | Place | Ground
"""What a joint ties its first end to.

* ``"ground"``: The fixed frame: ``"ground"``.
"""
