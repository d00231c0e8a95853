"""Objectives: the numbers that are kept of each case."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np

from ancf.studies import fingerprint

if TYPE_CHECKING:
    from ancf.record import Array
    from ancf.result import Result

Take: TypeAlias = Literal["first", "last", "mean", "min", "max", "amplitude", "rms"]
"""What is taken of a column."""

Reading: TypeAlias = "str | tuple[str, Take | int] | Callable[[Result], float]"
"""The last value of a column, what is taken of it or one row of it, from 0, or what a function tells."""

Objective: TypeAlias = "Mapping[str, Reading] | Callable[[Result], float | Mapping[str, float]]"
"""Readings by name, or a function that tells a number or several by name."""

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
            self.readings = {name: stated[name] for name in sorted(stated)}
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
        told = [measured(name, reading, result) for name, reading in self.readings.items()]
        values = {name: value for numbers, _ in told for name, value in numbers.items()}
        return values, [missing for _, missing in told if missing]


class ObjectiveError(RuntimeError):
    """A function of an objective that raised something."""

    def __init__(self, name: str, error: Exception) -> None:
        """What it raised."""
        super().__init__(f"objectives.{name}: {type(error).__name__}: {error}")


def measured(name: str, reading: Any, result: Result) -> tuple[dict[str, float], str | None]:
    """The numbers of a reading, and what there is no row for."""
    try:
        return numbers(name, reading, result), None
    except Exception as error:
        if isinstance(error, IndexError) and not callable(reading):
            return {}, f"objectives.{name}: {no_row(reading, result)}"
        raise ObjectiveError(name, error) from error


def pair(reading: Any) -> tuple[str, Any]:
    """The column, and what is taken of it."""
    return (reading, "last") if isinstance(reading, str) else tuple(reading)


def numbers(name: str, reading: Any, result: Result) -> dict[str, float]:
    """The number of a reading under its name, or those that a function tells."""
    if not callable(reading):
        column, take = pair(reading)
        return {name: float(TAKES[take](result[column]) if isinstance(take, str) else result[column][take])}
    told = reading(result)
    if not isinstance(told, Mapping):
        return {name: float(told)}
    return {str(key): float(value) for key, value in told.items()}


def no_row(reading: Any, result: Result) -> str:
    """What is missing."""
    take = pair(reading)[1]
    return f"no {'row' if isinstance(take, str) else f'row {take}'} among {len(result)}"
