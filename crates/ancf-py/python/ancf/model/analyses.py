"""What is computed."""

# Written by `cargo xtask schema` from the types of the program: change those.

from dataclasses import dataclass
from typing import ClassVar, Literal, TypeAlias

from ancf.part import Part

__all__ = [
    "HHT",
    "About",
    "AdaptiveStep",
    "Analysis",
    "Buckling",
    "Dynamics",
    "EnergyStop",
    "GeneralizedAlpha",
    "IncrementStop",
    "Modes",
    "Newmark",
    "NewtonMethod",
    "Path",
    "ResidualStop",
    "Scheme",
    "Sense",
    "Start",
    "Statics",
    "StepSize",
    "Stop",
]

NewtonMethod: TypeAlias = Literal["modified", "full"]
"""When Newton's method makes a new tangent.

* ``"modified"``: When it is cheaper than more iterations with an old one; the same solutions in less time.
  Rules in absolute numbers for the end of the iteration, and redundant joints, want the full method and get
  it.
* ``"full"``: In each iteration.
"""


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Newmark(Part):
    """Newmark with any pair.

    Attributes
    ----------
    gamma
        γ; 1/2 for second order, more for damping (>= 0, <= 1).
    beta
        β > 0 (>= 0, <= 1).

    """

    _form = "Scheme"

    gamma: float
    beta: float


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class GeneralizedAlpha(Part):
    """Generalized-α: second order, in reactions too, damps what the step does not resolve.

    Attributes
    ----------
    spectral_radius
        Part of a vibration of infinite frequency that survives a step: 0 ends it, 1 damps nothing, 0.8 is a
        good choice (>= 0, <= 1).

    """

    _form = "Scheme"

    spectral_radius: float


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class HHT(Part):
    """The scheme of Hilber, Hughes and Taylor: second order, in reactions too, damps high frequencies.

    Attributes
    ----------
    alpha
        From −1/3, most damping, to 0, none (>= -0.3333333333333333, <= 0).

    """

    _form = "Scheme"

    alpha: float


Scheme: TypeAlias = (
    Literal["adams", "average_acceleration", "linear_acceleration", "central_difference"]
    | Newmark
    | GeneralizedAlpha
    | HHT
)
"""A scheme of time integration, by name or by number.

Source: Kim et al. (2017), table of the appendix; Hilber, Hughes & Taylor (1977); Chung & Hulbert (1993).

* ``"adams"``: Newmark with γ = 0.70, β = 0.36: first order, strongly damping; the choice of the paper.
* ``"average_acceleration"``: Newmark with γ = 1/2, β = 1/4: second order, keeps the energy of linear systems;
  with joints, reactions alternate.
* ``"linear_acceleration"``: Newmark with γ = 1/2, β = 1/6: second order, stable for small steps only; refused
  with joints, where it never is.
* ``"central_difference"``: Newmark with γ = 1/2, β = 0: explicit, hence refused for equations with
  constraints.
"""

Start: TypeAlias = Literal["consistent", "zero"]
"""Accelerations and multipliers at the start.

* ``"consistent"``: Those that satisfy the equations of motion.
* ``"zero"``: All zero, as Kim et al. (2017) have it.
"""


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class AdaptiveStep(Part):
    """By error control; wants a scheme of second order.

    Attributes
    ----------
    tolerance
        Error that the motion may gather over the duration, a root mean square displacement relative to the
        length of the longest body (> 0, <= 0.1).
    initial
        First step, time; found by itself if left out (> 0).
    largest
        Largest step, time (> 0).

    """

    _form = "Step"

    tolerance: float
    initial: float | None = None
    largest: float | None = None


StepSize: TypeAlias = float | AdaptiveStep
"""Steps of one size, or as large as a tolerance permits."""


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class EnergyStop(Part):
    """Unit-blind.

    The energy |Δz·r| of the increment is at most tolerance² times the largest energy met, or the residual is
    down to its own rounding error.

    Attributes
    ----------
    tolerance
        Relative size of the increment in the energy norm (> 0, <= 0.01). Default: ``1e-8``.

    """

    _form = "Stop"
    _tag = "rule"
    rule: ClassVar[Literal["energy"]] = "energy"

    tolerance: float | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class ResidualStop(Part):
    """|r|₂ below an absolute number *in the units of the solver*, hence unit-dependent.

    Attributes
    ----------
    tolerance
        Bound on the Euclidean norm of the residual (> 0).

    """

    _form = "Stop"
    _tag = "rule"
    rule: ClassVar[Literal["residual"]] = "residual"

    tolerance: float


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class IncrementStop(Part):
    """|Δq|₂ below an absolute number *in the units of the solver*, hence unit-dependent.

    Attributes
    ----------
    tolerance
        Bound on the Euclidean norm of the increment of the coordinates (> 0).

    """

    _form = "Stop"
    _tag = "rule"
    rule: ClassVar[Literal["increment"]] = "increment"

    tolerance: float


Stop: TypeAlias = EnergyStop | ResidualStop | IncrementStop
"""When a Newton iteration ends."""

About: TypeAlias = Literal["reference", "equilibrium"]
"""The state about which modes and critical loads are found.

* ``"reference"``: The undeformed state, free of loads and stress.
* ``"equilibrium"``: The equilibrium under all loads.
"""

Sense: TypeAlias = Literal["stated", "reversed", "either"]
"""Which way the loads grow.

* ``"stated"``: As they are stated.
* ``"reversed"``: Reversed.
* ``"either"``: Either way.
"""


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Dynamics(Part):
    """Motion from rest in the undeformed state.

    Attributes
    ----------
    duration
        Duration, time (> 0).
    step
        Step, time; always the user's, whatever the scales.
    max_halvings
        How often a failed step of fixed size may be halved before the run ends (>= 0, <= 30). Default:
        ``10``.
    max_iterations
        Newton iterations after which a step has failed (>= 1). Default: ``50``.
    newton
        Newton's method with a new tangent in each iteration, or with tangents that are used again. One of
        ``"modified"``, ``"full"``. Default: ``"modified"``.
    scheme
        Scheme of time integration. Default: ``"adams"``.
    start
        Accelerations and multipliers at the start. One of ``"consistent"``, ``"zero"``. Default:
        ``"consistent"``.
    stop
        When the Newton iteration of a step ends. Default: ``EnergyStop(tolerance=1e-8)``.

    """

    _form = "Analysis"
    _tag = "kind"
    kind: ClassVar[Literal["dynamics"]] = "dynamics"

    duration: float
    step: StepSize
    max_halvings: int | None = None
    max_iterations: int | None = None
    newton: NewtonMethod | None = None
    scheme: Scheme | None = None
    start: Start | None = None
    stop: Stop | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Statics(Part):
    """Equilibrium under growing loads.

    Attributes
    ----------
    first
        The part of the way that is tried first (> 0, <= 1). Default: ``1.0``.
    load
        The load factor to reach. Default: ``1.0``.
    max_iterations
        Newton iterations after which an increment has failed (>= 1). Default: ``100``.
    stop
        When the Newton iteration of an increment ends. Default: ``EnergyStop(tolerance=1e-8)``.

    """

    _form = "Analysis"
    _tag = "kind"
    kind: ClassVar[Literal["statics"]] = "statics"

    first: float | None = None
    load: float | None = None
    max_iterations: int | None = None
    stop: Stop | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Path(Part):
    """A path of equilibria by arc length.

    Attributes
    ----------
    first
        The first step, as a change of the load factor (> 0). Default: ``0.05``.
    largest
        The largest step of arc length; one that begins the path changes the load factor by as much (> 0).
        Default: ``0.2``.
    load
        The load factor at which the path ends, when it first gets there. Default: ``1.0``.
    max_iterations
        Newton iterations after which a step has failed (>= 1). Default: ``30``.
    points
        The most points (>= 1, <= 1000000). Default: ``1000``.
    stop
        When the Newton iteration of a point ends. Default: ``EnergyStop(tolerance=1e-8)``.

    """

    _form = "Analysis"
    _tag = "kind"
    kind: ClassVar[Literal["path"]] = "path"

    first: float | None = None
    largest: float | None = None
    load: float | None = None
    max_iterations: int | None = None
    points: int | None = None
    stop: Stop | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Modes(Part):
    """Natural frequencies and mode shapes.

    Attributes
    ----------
    about
        About which state. One of ``"reference"``, ``"equilibrium"``. Default: ``"reference"``.
    count
        How many of the lowest, rigid ones included (>= 1, <= 10000). Default: ``10``.

    """

    _form = "Analysis"
    _tag = "kind"
    kind: ClassVar[Literal["modes"]] = "modes"

    about: About | None = None
    count: int | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Buckling(Part):
    """Critical load factors.

    Attributes
    ----------
    count
        How many of the lowest (>= 1, <= 10000). Default: ``1``.
    sense
        Which way the loads grow. One of ``"stated"``, ``"reversed"``, ``"either"``. Default: ``"stated"``.

    """

    _form = "Analysis"
    _tag = "kind"
    kind: ClassVar[Literal["buckling"]] = "buckling"

    count: int | None = None
    sense: Sense | None = None


Analysis: TypeAlias = Dynamics | Statics | Path | Modes | Buckling
"""What to compute."""
