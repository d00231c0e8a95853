"""Errors of models and analyses, with the messages of the command line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ancf.result import Result


@dataclass(frozen=True)
class Fault:
    """One error of a model."""

    path: str
    """Path of the key, such as ``bodies[0].material``; empty for the model as a whole."""
    found: str
    """Value that was found."""
    expected: str
    """Values that are allowed."""
    hint: str | None
    """Suggestion, such as the key that was probably meant."""
    place: tuple[int, int] | None
    """Line and column in the file, from 1, if the model came from a file."""
    text: str
    """Message in one line."""


class ModelError(ValueError):
    """All errors of a model. The text has one line per error, as on the command line."""

    def __init__(self, errors: Sequence[Fault], file: str | None = None) -> None:
        """Store the `errors` of a model and the `file` from which it was read, if any."""
        self.errors = list(errors)
        self.file = file
        super().__init__("\n".join(self._line(error) for error in self.errors))

    @classmethod
    def of(cls, faults: Sequence[tuple[object, ...]], file: str | None) -> ModelError:
        """Create an exception from the errors of the engine."""
        return cls([Fault(*fault) for fault in faults], file)  # type: ignore[arg-type]

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.errors, self.file)

    def _line(self, error: Fault) -> str:
        if self.file is None:
            return error.text
        return f"{self.file}{':' if error.place else ': '}{error.text}"


class AnalysisError(RuntimeError):
    """A failed analysis: the text has time, reason and place of the failure, `result` the rows up to it.

    `completed` has the results of the analyses before it, if it is one of several.
    """

    def __init__(self, message: str, result: Result | None = None) -> None:
        """Store the message of the failure and the results up to it."""
        super().__init__(message)
        self.result = result
        self.completed: dict[str, Result] = {}

    def __reduce__(self) -> tuple[object, ...]:
        # Results are not sent to other processes.
        return type(self), (str(self),)


class AnalysisWarning(UserWarning):
    """A warning of an analysis that continued: its results may be inaccurate, or the model has a probable error."""
