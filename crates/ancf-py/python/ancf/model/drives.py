"""Drives, springs and friction of joints."""

# Written by `cargo xtask schema` from the types of the program: change those.

from dataclasses import dataclass

from ancf.model.functions import TimeFunction
from ancf.part import Part

__all__ = [
    "AngularDrive",
    "AngularFriction",
    "AngularSpring",
    "LinearDrive",
    "LinearFriction",
    "LinearSpring",
]


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class AngularDrive(Part):
    """Prescribes the angle of a joint: by ``angle`` or by ``rate``.

    Attributes
    ----------
    angle
        Angle by which the function of time is multiplied, in radians.
    rate
        Angular velocity by which the function of time is multiplied, 1/time.
    time
        Function of time; 1 by default. Statics turns by ``angle`` with the load, and does not turn by
        ``rate``.

    """

    _form = "AngularDrive"

    angle: float | None = None
    rate: float | None = None
    time: TimeFunction | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class AngularSpring(Part):
    """A torsion spring and a damper: the moment −stiffness (θ − angle) − damping dθ/dt.

    Attributes
    ----------
    angle
        The angle at which the spring is free of moment, in radians; 0 by default.
    damping
        Damping, force length time (>= 0). Default: ``0.0``.
    stiffness
        Stiffness, force length per radian (>= 0). Default: ``0.0``.

    """

    _form = "AngularSpring"

    angle: float | None = None
    damping: float | None = None
    stiffness: float | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class AngularFriction(Part):
    """Dry friction of a hinge: the moment −moment tanh(ω/rate).

    Attributes
    ----------
    moment
        Moment of the friction, force length (>= 0).
    rate
        Angular velocity below which what should stick creeps, 1/time (> 0).

    """

    _form = "AngularFriction"

    moment: float
    rate: float


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class LinearDrive(Part):
    """Prescribes the displacement of a joint: by ``displacement`` or by ``speed``.

    Attributes
    ----------
    displacement
        Displacement by which the function of time is multiplied, length.
    speed
        Velocity by which the function of time is multiplied, length/time.
    time
        Function of time; 1 by default. Statics moves by ``displacement`` with the load, and does not move by
        ``speed``.

    """

    _form = "LinearDrive"

    displacement: float | None = None
    speed: float | None = None
    time: TimeFunction | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class LinearSpring(Part):
    """A spring and a damper: the force −stiffness (s − displacement) − damping ds/dt.

    Attributes
    ----------
    damping
        Damping, force time/length (>= 0). Default: ``0.0``.
    displacement
        The displacement at which the spring is free of force, length; 0 by default.
    stiffness
        Stiffness, force/length (>= 0). Default: ``0.0``.

    """

    _form = "LinearSpring"

    damping: float | None = None
    displacement: float | None = None
    stiffness: float | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class LinearFriction(Part):
    """Dry friction of a slider: the force −force tanh(v/speed).

    Attributes
    ----------
    force
        Force of the friction (>= 0).
    speed
        Velocity below which what should stick creeps, length/time (> 0).

    """

    _form = "LinearFriction"

    force: float
    speed: float
