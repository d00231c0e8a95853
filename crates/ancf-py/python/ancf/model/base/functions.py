"""Functions of time."""

# Written by `cargo xtask schema` from the types of the program: change those.

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import ClassVar, Literal, TypeAlias

from ancf.part import Numbers, Part

__all__ = ["Expression", "ExternalFunction", "Ramp", "Sine", "Step", "Table", "TimeFunction", "Varying"]


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Table(Part):
    """Linear between points, held before the first and after the last.

    Attributes
    ----------
    times
        Times of the points, in order; two equal ones are a jump. Time.
    values
        Values at these times.

    """

    _form = "Varying"
    _tag = "kind"
    kind: ClassVar[Literal["table"]] = "table"

    times: Numbers
    values: Numbers


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Ramp(Part):
    """0 until the start, then linear up to 1 at the end, then 1.

    Attributes
    ----------
    end
        Where it reaches 1, time.
    start
        Where it leaves 0, time. Default: ``0.0``.

    """

    _form = "Varying"
    _tag = "kind"
    kind: ClassVar[Literal["ramp"]] = "ramp"

    end: float
    start: float | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Step(Part):
    """0, then 1 from a time on.

    Attributes
    ----------
    at
        Where it becomes 1, time. Default: ``0.0``.
    until
        Where it becomes 0 again, time; never by default.

    """

    _form = "Varying"
    _tag = "kind"
    kind: ClassVar[Literal["step"]] = "step"

    at: float | None = None
    until: float | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Sine(Part):
    """sin(2π f t + φ).

    Attributes
    ----------
    frequency
        Frequency f, cycles per time (>= 0).
    phase
        Phase φ in radians. Default: ``0.0``.

    """

    _form = "Varying"
    _tag = "kind"
    kind: ClassVar[Literal["sine"]] = "sine"

    frequency: float
    phase: float | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Expression(Part):
    """A formula in t.

    Attributes
    ----------
    text
        The formula in t, the time, such as ``if(t < 2, t^2/4, 1)``.
    unit
        The t of the formula when one unit of time has passed; 1 by default (> 0).

    """

    _form = "Varying"
    _tag = "kind"
    kind: ClassVar[Literal["expression"]] = "expression"

    text: str = field(kw_only=False)
    unit: float | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class ExternalFunction(Part):
    """A function that the program supplies under this name; the command line has none.

    Attributes
    ----------
    name
        The name under which the program supplies it.
    unit
        The t of the function when one unit of time has passed; 1 by default (> 0).

    """

    _form = "Varying"
    _tag = "kind"
    kind: ClassVar[Literal["external"]] = "external"

    name: str = field(kw_only=False)
    unit: float | None = None


Varying: TypeAlias = Table | Ramp | Step | Sine | Expression | ExternalFunction
"""How a function varies in time. All values are pure numbers."""

TimeFunction: TypeAlias = float | Varying | Callable[[float], float | tuple[float, float, float]]
"""A function of time by which a load or an angle is multiplied.

A number, or a table that says how it varies.

Or a function of Python, which gives its value at a time, or value, rate and acceleration.
"""
