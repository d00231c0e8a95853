"""Loads besides gravity."""

# Written by `cargo xtask schema` from the types of the program: change those.

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import ClassVar, Literal, TypeAlias

from ancf.model.functions import TimeFunction
from ancf.model.places import At, Place
from ancf.part import ForceFunction, Numbers, Part, Vector

__all__ = [
    "BaseAcceleration",
    "DistributedForce",
    "DistributedMoment",
    "ExternalForce",
    "Fluid",
    "Force",
    "Load",
    "Moment",
    "Scales",
]


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Scales(Part):
    """Units of length, time and force that turn a model into the same model in other numbers.

    A quantity x of dimension Lˡ Tᵗ Fᶠ has the number x* = x / (Lˡ Tᵗ Fᶠ) in these units. Scales form a group:
    ``Scales::UNIT`` changes nothing, ``Scales::then`` composes, ``Scales::inverse`` undoes.

    Units: the user's own, whatever coherent system that is. Source: Kim et al. (2017), eqs (7), (8), (26),
    (33).

    Attributes
    ----------
    length
        Unit of length, ``L_ND`` (> 0).
    time
        Unit of time, ``T_ND`` (> 0).
    force
        Unit of force, ``F_ND`` (> 0).

    """

    _form = "Scales"

    length: float
    time: float
    force: float


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Force(Part):
    """A force on a point of the axis.

    Attributes
    ----------
    on
        Where it acts.
    force
        The force in the global frame; of a follower, in the undeformed state.
    follower
        Whether it turns with the section. Default: ``False``.
    time
        Function of time by which it is multiplied; statics ignores it. Default: ``1.0``.

    """

    _form = "Load"
    _tag = "kind"
    kind: ClassVar[Literal["force"]] = "force"

    on: Place
    force: Vector
    follower: bool | None = None
    time: TimeFunction | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Moment(Part):
    """A moment on a section.

    Attributes
    ----------
    on
        Where it acts.
    moment
        The moment in the global frame; of a follower, in the undeformed state.
    follower
        Whether it turns with the section. Default: ``False``.
    time
        Function of time by which it is multiplied; statics ignores it. Default: ``1.0``.

    """

    _form = "Load"
    _tag = "kind"
    kind: ClassVar[Literal["moment"]] = "moment"

    on: Place
    moment: Vector
    follower: bool | None = None
    time: TimeFunction | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class DistributedForce(Part):
    """A force per length along an axis.

    Attributes
    ----------
    body
        Name of the body.
    force
        The force per undeformed length, in the global frame; of a follower, in that of each section.
    follower
        Whether it turns with the sections. Default: ``False``.
    force_end
        Likewise at ``to``, if it varies: linearly, from ``force`` at ``from``.
    from_
        Where it begins; at the start of the body by default.
    time
        Function of time by which it is multiplied; statics ignores it. Default: ``1.0``.
    to
        Where it ends; at the end of the body by default.

    """

    _form = "Load"
    _tag = "kind"
    kind: ClassVar[Literal["distributed_force"]] = "distributed_force"

    body: str
    force: Vector
    follower: bool | None = None
    force_end: Vector | None = None
    from_: At | None = None
    time: TimeFunction | None = None
    to: At | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class DistributedMoment(Part):
    """A moment per length on the sections of a beam.

    Attributes
    ----------
    body
        Name of the body.
    moment
        The moment per undeformed length, in the global frame; of a follower, in that of each section.
    follower
        Whether it turns with the sections. Default: ``False``.
    from_
        Where it begins; at the start of the body by default.
    moment_end
        Likewise at ``to``, if it varies: linearly, from ``moment`` at ``from``.
    time
        Function of time by which it is multiplied; statics ignores it. Default: ``1.0``.
    to
        Where it ends; at the end of the body by default.

    """

    _form = "Load"
    _tag = "kind"
    kind: ClassVar[Literal["distributed_moment"]] = "distributed_moment"

    body: str
    moment: Vector
    follower: bool | None = None
    from_: At | None = None
    moment_end: Vector | None = None
    time: TimeFunction | None = None
    to: At | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class BaseAcceleration(Part):
    """The ground accelerates without turning; all that is computed is relative to it.

    Attributes
    ----------
    acceleration
        Acceleration of the ground, length/time².
    time
        Function of time by which it is multiplied; statics ignores it. Default: ``1.0``.

    """

    _form = "Load"
    _tag = "kind"
    kind: ClassVar[Literal["base_acceleration"]] = "base_acceleration"

    acceleration: Vector
    time: TimeFunction | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Fluid(Part):
    """A fluid around bodies: drag, added mass and buoyancy.

    Attributes
    ----------
    bodies
        Names of the bodies in the fluid.
    density
        Mass per volume of the fluid, ρ (> 0).
    drag
        Coefficients of drag across and along the axis: ½ρ d C_n |w_n| w_n and ½ρ π d C_t |w_t| w_t per
        length.
    added_mass
        Coefficients of added mass across and along the axis, in multiples of ρ A per length. Default: ``[1.0,
        0.0]``.
    area
        Area A of the fluid that a section displaces, length²; that of a circle of the diameter by default (>
        0).
    current
        Velocity of the fluid, the same everywhere; at rest by default.
    diameter
        Diameter d that meets the flow, length; the outer one of circles and tubes by default (> 0).
    time
        Function of time by which the current is multiplied; statics ignores it. Default: ``1.0``.

    """

    _form = "Load"
    _tag = "kind"
    kind: ClassVar[Literal["fluid"]] = "fluid"

    bodies: Sequence[str]
    density: float
    drag: Numbers
    added_mass: Numbers | None = None
    area: float | None = None
    current: Vector | None = None
    diameter: float | None = None
    time: TimeFunction | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class ExternalForce(Part):
    """A force on a point that the program computes from time, position and velocity of the point.

    The command line has none. In statics the velocity is 0, the time 1.

    Attributes
    ----------
    name
        The name under which the program supplies it. Or the function itself, F(t, x, v).
    on
        Where it acts.
    units
        What the model's units of length, time and force are in those of the function; the same by default.

    """

    _form = "Load"
    _tag = "kind"
    kind: ClassVar[Literal["external"]] = "external"

    name: str | ForceFunction = field(kw_only=False)
    on: Place
    units: Scales | None = None


Load: TypeAlias = (
    Force | Moment | DistributedForce | DistributedMoment | BaseAcceleration | Fluid | ExternalForce
)
"""A load on bodies. Gravity is a property of the model."""
