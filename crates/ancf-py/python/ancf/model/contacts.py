"""What bodies may touch."""

# Written by `cargo xtask schema` from the types of the program: change those.

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Literal, TypeAlias

from ancf.model.places import Place
from ancf.part import Part, Vector

__all__ = ["Against", "Contact", "Cylinder", "EachOther", "Plane", "Sphere"]


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Plane(Part):
    """The half space behind a plane.

    Attributes
    ----------
    point
        A point of it in the undeformed state, length.
    normal
        Its normal in the undeformed state, towards the bodies; its length does not matter.
    on
        What carries it; the ground by default.

    """

    _form = "Against"
    _tag = "kind"
    kind: ClassVar[Literal["plane"]] = "plane"

    point: Vector
    normal: Vector
    on: Place | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Sphere(Part):
    """A ball, or a round hollow.

    Attributes
    ----------
    center
        Its centre in the undeformed state, length.
    radius
        Its radius, length (> 0).
    inside
        Whether the bodies are inside. Default: ``False``.
    on
        What carries it; the ground by default.

    """

    _form = "Against"
    _tag = "kind"
    kind: ClassVar[Literal["sphere"]] = "sphere"

    center: Vector
    radius: float
    inside: bool | None = None
    on: Place | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Cylinder(Part):
    """An endless cylinder, or a bore.

    Attributes
    ----------
    point
        A point of its axis in the undeformed state, length.
    axis
        Direction of its axis in the undeformed state; its length does not matter.
    radius
        Its radius, length (> 0).
    inside
        Whether the bodies are inside. Default: ``False``.
    on
        What carries it; the ground by default.

    """

    _form = "Against"
    _tag = "kind"
    kind: ClassVar[Literal["cylinder"]] = "cylinder"

    point: Vector
    axis: Vector
    radius: float
    inside: bool | None = None
    on: Place | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class EachOther(Part):
    """The bodies each other, and each itself."""

    _form = "Against"
    _tag = "kind"
    kind: ClassVar[Literal["bodies"]] = "bodies"


Against: TypeAlias = Plane | Sphere | Cylinder | EachOther
"""What bodies may touch."""


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Contact(Part):
    """What bodies may touch, and how hard and rough they are there.

    Bodies are round tubes about their axes.

    Attributes
    ----------
    with_
        What the bodies may touch.
    stiffness
        Force per length of a body and per depth, force/length² (> 0).
    bodies
        Names of the beams and cables; all but the one that carries an obstacle, by default.
    damping
        Part by which the force is less at each speed of parting, and more when meeting, time/length (>= 0).
        Default: ``0.0``.
    friction
        Coefficient of friction; none in statics (>= 0). Default: ``0.0``.
    points
        Contact points of each element; by default so many that their distance suits the obstacle and the
        radius (>= 1, <= 10000).
    radius
        Radius of the bodies, length; that of circles and tubes by default (> 0).
    slip_speed
        Sliding speed below which friction is viscous, length/time; by default a thousandth of the length of
        the longest body over the duration (> 0).
    transition
        Depth over which the stiffness grows from zero, length; a fiftieth of the smallest radius by default
        (> 0).

    """

    _form = "Contact"

    with_: Against
    stiffness: float
    bodies: Sequence[str] | None = None
    damping: float | None = None
    friction: float | None = None
    points: int | None = None
    radius: float | None = None
    slip_speed: float | None = None
    transition: float | None = None
