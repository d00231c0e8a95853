"""What can go wrong, in the words of the command line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ancf.result import Result


@dataclass(frozen=True)
class Fault:
    """One thing that is wrong with a model."""

    path: str
    """Path of the key, such as ``bodies[0].material``; empty for the model as a whole."""
    found: str
    """What was found there."""
    wanted: str
    """What is wanted instead."""
    hint: str | None
    """A suggestion, such as the key that was probably meant."""
    place: tuple[int, int] | None
    """Line and column in the file, from 1, if the model came from one."""
    text: str
    """All of it in a line."""


class ModelError(ValueError):
    """All that is wrong with a model; its text has one line an error, as on the command line."""

    def __init__(self, errors: Sequence[Fault], file: str | None = None) -> None:
        """All `errors` of a model, which was read from `file` if it was."""
        self.errors = list(errors)
        self.file = file
        super().__init__("\n".join(self._line(error) for error in self.errors))

    @classmethod
    def of(cls, faults: Sequence[tuple[object, ...]], file: str | None) -> ModelError:
        """Make one from what the engine found."""
        return cls([Fault(*fault) for fault in faults], file)  # type: ignore[arg-type]

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.errors, self.file)

    def _line(self, error: Fault) -> str:
        if self.file is None:
            return error.text
        return f"{self.file}{':' if error.place else ': '}{error.text}"


class AnalysisError(RuntimeError):
    """An analysis that could not go on: when, why and where; what it computed until then is in `result`."""

    def __init__(self, message: str, result: Result | None = None) -> None:
        """The text of the failure and the results so far."""
        super().__init__(message)
        self.result = result

    def __reduce__(self) -> tuple[object, ...]:
        # Results stay where they were computed.
        return type(self), (str(self),)
