"""Objectives: the numbers that are kept of each case."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Literal, SupportsFloat, TypeAlias

import numpy as np

from ancf.studies import fingerprint

if TYPE_CHECKING:
    from ancf.record import Array
    from ancf.result import Result

Take: TypeAlias = Literal["first", "last", "mean", "min", "max", "amplitude", "rms"]
"""What is taken of a column."""

Reading: TypeAlias = "str | tuple[str, Take | int] | Callable[[Result], SupportsFloat]"
"""The last value of a column, what is taken of it or one row of it, from 0, or what a function tells."""

Objective: TypeAlias = (
    "Mapping[str, Reading] | Reading | Callable[[Result], Mapping[str, SupportsFloat]]"
    " | Callable[[Result], SupportsFloat | Mapping[str, SupportsFloat]]"
)
"""Readings by name, or one reading, or a function that tells a number or several by name."""

TAKES: dict[str, Callable[[Array], Any]] = {
    "first": lambda x: x[0],
    "last": lambda x: x[-1],
    "mean": np.mean,
    "min": np.min,
    "max": np.max,
    "amplitude": lambda x: 0.5 * (x.max() - x.min()),
    "rms": lambda x: np.sqrt(np.mean(x * x)),
}


class Objectives:
    """The objectives of a study."""

    def __init__(self, stated: Objective | None) -> None:
        """Those that a user states."""
        self.readings: dict[str, Any] = {}
        """What is read, by the names of the columns of the table."""
        self.tells_names = callable(stated)
        """Whether the names are told by a function only, as it may give several numbers."""
        if isinstance(stated, Mapping):
            self.readings = {name: stated[name] for name in sorted(stated, key=str)}
        elif stated is not None:
            name = getattr(stated, "__name__", "<lambda>")
            self.readings = {"objective" if name == "<lambda>" else name: stated}

    @property
    def columns(self) -> dict[str, str]:
        """The columns of results that are read, by the names of the objectives."""
        pairs = {name: pair(reading) for name, reading in self.readings.items() if not callable(reading)}
        return {name: column for name, (column, _) in pairs.items()}

    @property
    def need_states(self) -> bool:
        """Whether functions may want to see fields."""
        return len(self.columns) < len(self.readings)

    @property
    def definition(self) -> Any:
        """What they are, as plain data."""
        return {
            name: fingerprint.told(r if callable(r) else list(pair(r))) for name, r in self.readings.items()
        }

    def measured(self, result: Result) -> tuple[dict[str, float], list[str]]:
        """Their values, and what there is no row for.

        Raises
        ------
        ObjectiveError
            With what a function raises, in words.

        """
        told = [
            measured(name, reading, result, several=self.tells_names)
            for name, reading in self.readings.items()
        ]
        values = {name: value for numbers, _ in told for name, value in numbers.items()}
        return values, [missing for _, missing in told if missing]


class ObjectiveError(RuntimeError):
    """A function of an objective that raised something."""

    def __init__(self, name: str, error: Exception) -> None:
        """What it raised."""
        kind = "" if isinstance(error, NumberError) else f"{type(error).__name__}: "
        super().__init__(f"objectives.{name}: {kind}{error}")


class NumberError(ValueError):
    """What a function tells instead of a number."""

    def __init__(self, found: object, wanted: str) -> None:
        """What was found."""
        text = repr(found)
        super().__init__(f"found {text if len(text) <= 40 else f'a {type(found).__name__}'}, wanted {wanted}")


def measured(
    name: str, reading: Any, result: Result, *, several: bool
) -> tuple[dict[str, float], str | None]:
    """The numbers of a reading, and what there is no row for."""
    try:
        return numbers(name, reading, result, several=several), None
    except Exception as error:
        if isinstance(error, IndexError) and not callable(reading):
            return {}, f"objectives.{name}: {no_row(reading, result)}"
        raise ObjectiveError(name, error) from error


def pair(reading: Any) -> tuple[str, Any]:
    """The column, and what is taken of it."""
    return (reading, "last") if isinstance(reading, str) else tuple(reading)


def numbers(name: str, reading: Any, result: Result, *, several: bool) -> dict[str, float]:
    """The number of a reading under its name, or those that a function tells if it may tell `several`."""
    if not callable(reading):
        column, take = pair(reading)
        return {name: float(TAKES[take](result[column]) if isinstance(take, str) else result[column][take])}
    told = reading(result)
    if not isinstance(told, Mapping):
        return {name: number(told, "a number or several by name" if several else "a number")}
    if not several:
        raise NumberError(told, "a number, since this objective is one of several by name")
    if not told or not all(isinstance(key, str) for key in told):
        raise NumberError(told, "at least one number, by names that are texts")
    return {key: number(value, f"a number as {key!r}") for key, value in told.items()}


def number(value: Any, wanted: str) -> float:
    """A number that a function tells."""
    try:
        return float(value)
    except (TypeError, ValueError) as error:
        raise NumberError(value, wanted) from error


def no_row(reading: Any, result: Result) -> str:
    """What is missing."""
    take = pair(reading)[1]
    return f"no {'row' if isinstance(take, str) else f'row {take}'} among {len(result)}"
