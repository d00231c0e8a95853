"""Joints."""

# Written by `cargo xtask schema` from the types of the program: change those.

from dataclasses import dataclass, field
from typing import ClassVar, Literal, TypeAlias

from ancf.model.drives import (
    AngularDrive,
    AngularFriction,
    AngularSpring,
    LinearDrive,
    LinearFriction,
    LinearSpring,
)
from ancf.model.functions import TimeFunction
from ancf.model.places import End, Place
from ancf.part import Numbers, Part, Vector

__all__ = [
    "Bushing",
    "Clamp",
    "Clamped",
    "Cylindrical",
    "Distance",
    "Drive",
    "Joint",
    "Planar",
    "PointOnLine",
    "Prismatic",
    "Revolute",
    "Slide",
    "Spherical",
    "Spring",
    "Universal",
]

Clamped: TypeAlias = Literal["all", "section"]
"""Which gradients a clamp ties besides the position.

* ``"all"``: r_x, r_y and r_z: all twelve coordinates of the node, as Kim et al. (2017) do. Stretch and shear
  of the axis are then zero at the clamp, which stiffens coarse meshes: 8/9 of the exact elongation for one
  element.
* ``"section"``: r_y and r_z only: the section is fixed and the axis is free to stretch, exact in tension. Of
  a cable, the direction of the tangent.
"""


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Clamp(Part):
    """Ties position and orientation.

    Attributes
    ----------
    name
        Name in outputs and messages.
    a
        The end that receives the reaction.
    b
        The other end; the ground by default.
    fix
        Which gradients are tied besides the position: ``"all"`` for beams of the continuum formulation,
        ``"section"`` for all else, by default. One of ``"all"``, ``"section"``.

    """

    _form = "Joint"
    _tag = "kind"
    kind: ClassVar[Literal["clamp"]] = "clamp"

    name: str = field(kw_only=False)
    a: Place
    b: End | None = None
    fix: Clamped | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Revolute(Part):
    """A hinge: ties the position and leaves rotation about one axis.

    Attributes
    ----------
    name
        Name in outputs and messages.
    a
        The end that receives the reaction.
    axis
        Direction of the axis in the undeformed state, in the global frame; its length does not matter.
    b
        The other end; the ground by default.
    drive
        Prescribes the angle.
    friction
        Dry friction.
    spring
        A torsion spring and a damper.

    """

    _form = "Joint"
    _tag = "kind"
    kind: ClassVar[Literal["revolute"]] = "revolute"

    name: str = field(kw_only=False)
    a: Place
    axis: Vector
    b: End | None = None
    drive: AngularDrive | None = None
    friction: AngularFriction | None = None
    spring: AngularSpring | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Spherical(Part):
    """A ball joint: ties the position.

    Attributes
    ----------
    name
        Name in outputs and messages.
    a
        The end that receives the reaction.
    b
        The other end; the ground by default.

    """

    _form = "Joint"
    _tag = "kind"
    kind: ClassVar[Literal["spherical"]] = "spherical"

    name: str = field(kw_only=False)
    a: Place
    b: End | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Drive(Part):
    """A clamp to a frame that turns about the place and moves as it is told.

    Attributes
    ----------
    name
        Name in outputs and messages.
    a
        The end that is led, and receives the reaction.
    time
        Function of time; statics ignores it, turns and moves with the load.
    angle
        Angle by which the function of time is multiplied, in radians; 1 by default.
    axis
        Direction of the axis in the global frame; its length does not matter. Without one the frame does not
        turn.
    displacement
        Displacement by which the function of time is multiplied, length; none by default.
    fix
        Which gradients are tied besides the position, by default as those of a clamp. One of ``"all"``,
        ``"section"``.

    """

    _form = "Joint"
    _tag = "kind"
    kind: ClassVar[Literal["drive"]] = "drive"

    name: str = field(kw_only=False)
    a: Place
    time: TimeFunction
    angle: float | None = None
    axis: Vector | None = None
    displacement: Vector | None = None
    fix: Clamped | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Universal(Part):
    """Two shafts that meet.

    Attributes
    ----------
    name
        Name in outputs and messages.
    a
        The end that receives the reaction.
    axis_a
        Direction of the arm of the cross that is fixed to ``a``, in the undeformed state.
    axis_b
        Direction of the arm of the cross that is fixed to ``b``, in the undeformed state, not along the
        other.
    b
        The other end; the ground by default.

    """

    _form = "Joint"
    _tag = "kind"
    kind: ClassVar[Literal["universal"]] = "universal"

    name: str = field(kw_only=False)
    a: Place
    axis_a: Vector
    axis_b: Vector
    b: End | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Cylindrical(Part):
    """A pin in a sleeve.

    Attributes
    ----------
    name
        Name in outputs and messages.
    a
        The end that receives the reaction.
    axis
        Direction of the axis in the undeformed state, in the global frame; its length does not matter.
    b
        The other end, which carries the axis; the ground by default.
    drive
        Prescribes the angle.
    feed
        Prescribes the displacement.
    spring
        A torsion spring and a damper.

    """

    _form = "Joint"
    _tag = "kind"
    kind: ClassVar[Literal["cylindrical"]] = "cylindrical"

    name: str = field(kw_only=False)
    a: Place
    axis: Vector
    b: End | None = None
    drive: AngularDrive | None = None
    feed: LinearDrive | None = None
    spring: AngularSpring | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Prismatic(Part):
    """A slider in a straight guide.

    Attributes
    ----------
    name
        Name in outputs and messages.
    a
        The end that receives the reaction.
    axis
        Direction of the axis in the undeformed state, in the global frame; its length does not matter.
    b
        The other end, which carries the axis; the ground by default.
    drive
        Prescribes the displacement.
    friction
        Dry friction.
    spring
        A spring and a damper.

    """

    _form = "Joint"
    _tag = "kind"
    kind: ClassVar[Literal["prismatic"]] = "prismatic"

    name: str = field(kw_only=False)
    a: Place
    axis: Vector
    b: End | None = None
    drive: LinearDrive | None = None
    friction: LinearFriction | None = None
    spring: LinearSpring | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Planar(Part):
    """A plate on a plane.

    Attributes
    ----------
    name
        Name in outputs and messages.
    a
        The end that receives the reaction.
    normal
        Normal of the plane in the undeformed state, in the global frame; its length does not matter.
    b
        The other end, which carries the plane; the ground by default.

    """

    _form = "Joint"
    _tag = "kind"
    kind: ClassVar[Literal["planar"]] = "planar"

    name: str = field(kw_only=False)
    a: Place
    normal: Vector
    b: End | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class PointOnLine(Part):
    """A point on a straight line.

    Attributes
    ----------
    name
        Name in outputs and messages.
    a
        The end that receives the reaction.
    axis
        Direction of the line in the undeformed state, in the global frame; its length does not matter.
    b
        The other end, which carries the line; the ground by default.

    """

    _form = "Joint"
    _tag = "kind"
    kind: ClassVar[Literal["point_on_line"]] = "point_on_line"

    name: str = field(kw_only=False)
    a: Place
    axis: Vector
    b: End | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Distance(Part):
    """A massless rod with balls at its ends.

    Attributes
    ----------
    name
        Name in outputs and messages.
    a
        The end that receives the reaction.
    b
        The other end: a place or a point of the ground, elsewhere than ``a``.
    change
        By how much the distance grows, times the function of time, length; 0 by default.
    time
        Function of time; 1 by default. Statics ignores it and changes the distance with the load.

    """

    _form = "Joint"
    _tag = "kind"
    kind: ClassVar[Literal["distance"]] = "distance"

    name: str = field(kw_only=False)
    a: Place
    b: End
    change: float | None = None
    time: TimeFunction | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Slide(Part):
    """A bead on a beam.

    Attributes
    ----------
    name
        Name in outputs and messages.
    a
        The point that slides, and receives the reaction.
    b
        The place of a beam of two-node elements or of a cable where it is at the start.
    drive
        Prescribes the displacement along the beam.
    friction
        Dry friction along the beam, of a given force.
    spring
        A spring and a damper along the beam.

    """

    _form = "Joint"
    _tag = "kind"
    kind: ClassVar[Literal["slide"]] = "slide"

    name: str = field(kw_only=False)
    a: Place
    b: End
    drive: LinearDrive | None = None
    friction: LinearFriction | None = None
    spring: LinearSpring | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Bushing(Part):
    """An elastic mount.

    Attributes
    ----------
    name
        Name in outputs and messages.
    a
        The end that receives the reaction.
    stiffness
        Stiffnesses along x, y, z, force/length, and about x, y, z, force length.
    b
        The other end, which carries the axes, at first the global ones; the ground by default.
    damping
        Dampings along x, y, z, force time/length, and about x, y, z, force length time; none by default.

    """

    _form = "Joint"
    _tag = "kind"
    kind: ClassVar[Literal["bushing"]] = "bushing"

    name: str = field(kw_only=False)
    a: Place
    stiffness: Numbers
    b: End | None = None
    damping: Numbers | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Spring(Part):
    """A spring and a damper between two points.

    Attributes
    ----------
    name
        Name in outputs and messages.
    a
        The end that receives the reaction.
    b
        The other end: a place or a point of the ground, elsewhere than ``a``.
    damping
        Damping, force time/length (>= 0). Default: ``0.0``.
    length
        Length at which it is free of force; the distance in the undeformed state by default (>= 0).
    stiffness
        Stiffness, force/length (>= 0). Default: ``0.0``.
    tension_only
        Whether it only draws, as a rope does. Default: ``False``.

    """

    _form = "Joint"
    _tag = "kind"
    kind: ClassVar[Literal["spring"]] = "spring"

    name: str = field(kw_only=False)
    a: Place
    b: End
    damping: float | None = None
    length: float | None = None
    stiffness: float | None = None
    tension_only: bool | None = None


Joint: TypeAlias = (
    Clamp
    | Revolute
    | Spherical
    | Drive
    | Universal
    | Cylindrical
    | Prismatic
    | Planar
    | PointOnLine
    | Distance
    | Slide
    | Bushing
    | Spring
)
"""A joint between a body and the ground or another body.

Reactions are reported as the force and the moment that the joint exerts on its end ``a``.
"""
