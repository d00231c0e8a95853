"""Objectives: the numbers recorded for each case."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Literal, SupportsFloat, TypeAlias, get_args

from ancf import _ancf
from ancf.studies.definition.fingerprint import describe

if TYPE_CHECKING:
    from ancf.result import Result

Take: TypeAlias = Literal["first", "last", "mean", "min", "max", "amplitude", "rms"]
"""Reduction of a column to one number."""

Reading: TypeAlias = "str | tuple[str, Take | int] | Callable[[Result], SupportsFloat]"
"""Last value of a column, reduction or row (from 0) of a column, or a function of the result."""

Objective: TypeAlias = (
    "Mapping[str, Reading] | Reading | Callable[[Result], Mapping[str, SupportsFloat]]"
    " | Callable[[Result], SupportsFloat | Mapping[str, SupportsFloat]]"
)
"""Readings by name, one reading, or a function that returns a number or several by name."""

TAKES = get_args(Take)


class Objectives:
    """Objectives of a study."""

    def __init__(self, stated: Objective | None) -> None:
        """Normalise the objectives of a user."""
        self.readings: dict[str, Any] = {}
        """Readings by the names of the columns of the table."""
        self.has_open_names = callable(stated)
        """True if a function returns the names together with the numbers."""
        if isinstance(stated, Mapping):
            self.readings = {name: stated[name] for name in sorted(stated, key=str)}
        elif stated is not None:
            name = getattr(stated, "__name__", "<lambda>")
            self.readings = {"objective" if name == "<lambda>" else name: stated}

    @property
    def columns(self) -> dict[str, str]:
        """Columns of results by the names of the objectives."""
        pairs = {name: pair(reading) for name, reading in self.readings.items() if not callable(reading)}
        return {name: column for name, (column, _) in pairs.items()}

    @property
    def need_states(self) -> bool:
        """True if functions may compute fields from the states."""
        return len(self.columns) < len(self.readings)

    @property
    def definition(self) -> Any:
        """Objectives as plain data, for the keys of cases."""
        return {
            name: describe(reading if callable(reading) else list(pair(reading)))
            for name, reading in self.readings.items()
        }

    def measured(self, result: Result) -> tuple[dict[str, float], list[str]]:
        """Return the values of all objectives, and a message for each missing row.

        Raises
        ------
        ObjectiveError
            If a function fails, with its error message.

        """
        evaluated = [
            measured(name, reading, result, several=self.has_open_names)
            for name, reading in self.readings.items()
        ]
        values = {name: value for numbers, _ in evaluated for name, value in numbers.items()}
        return values, [missing for _, missing in evaluated if missing]


class ObjectiveError(RuntimeError):
    """Failure of a function of an objective."""

    def __init__(self, name: str, error: Exception) -> None:
        """Store the name of the objective and its error."""
        kind = "" if isinstance(error, NumberError) else f"{type(error).__name__}: "
        super().__init__(f"objectives.{name}: {kind}{error}")


class NumberError(ValueError):
    """Return value of a function that is not a number."""

    def __init__(self, found: object, expected: str) -> None:
        """Describe the return value."""
        text = repr(found)
        super().__init__(
            f"found {text if len(text) <= 40 else f'a {type(found).__name__}'}, expected {expected}"
        )


def measured(
    name: str, reading: Any, result: Result, *, several: bool
) -> tuple[dict[str, float], str | None]:
    """Return the numbers of a reading, or a message about a missing row."""
    try:
        return numbers(name, reading, result, several=several), None
    except Exception as error:
        if isinstance(error, IndexError) and not callable(reading):
            return {}, f"objectives.{name}: {missing_row(reading, result)}"
        raise ObjectiveError(name, error) from error


def pair(reading: Any) -> tuple[str, Any]:
    """Return column and reduction of a reading."""
    return (reading, "last") if isinstance(reading, str) else tuple(reading)


def numbers(name: str, reading: Any, result: Result, *, several: bool) -> dict[str, float]:
    """Return the number of a reading by its name, or the numbers of a function that may return `several`."""
    if not callable(reading):
        column, take = pair(reading)
        values = result[column]
        return {name: _ancf.reduce_column(values, take) if isinstance(take, str) else float(values[take])}
    answer = reading(result)
    if not isinstance(answer, Mapping):
        return {name: number(answer, "a number or several by name" if several else "a number")}
    if not several:
        raise NumberError(answer, "a number, since this objective is one of several by name")
    if not answer or not all(isinstance(key, str) for key in answer):
        raise NumberError(answer, "at least one number, by names that are texts")
    return {key: number(value, f"a number as {key!r}") for key, value in answer.items()}


def number(value: Any, expected: str) -> float:
    """Convert the return value of a function to a number."""
    try:
        return float(value)
    except (TypeError, ValueError) as error:
        raise NumberError(value, expected) from error


def missing_row(reading: Any, result: Result) -> str:
    """Return the message about a missing row."""
    take = pair(reading)[1]
    return f"no {'row' if isinstance(take, str) else f'row {take}'} among {len(result)}"
