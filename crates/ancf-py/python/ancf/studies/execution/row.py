"""A case that was run: a row of the table."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from time import perf_counter
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

from ancf import _ancf
from ancf.analysis import carried_out
from ancf.errors import AnalysisError, ModelError
from ancf.studies.design import substituted
from ancf.studies.objective import ObjectiveError, Objectives

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from ancf.result import Result

Outcome: TypeAlias = Literal["finished", "failed", "invalid", "stopped"]
"""How a case ended: all was computed; it was not solved or measured; no valid model; it was interrupted."""


@dataclass(frozen=True)
class Row:
    """What came of a case."""

    outcome: Outcome
    message: str | None = None
    objectives: Mapping[str, float] = field(default_factory=dict)
    steps: int | None = None
    iterations: int | None = None
    seconds: float = 0.0


@dataclass(frozen=True)
class Work:
    """What is done with the values of each case."""

    base: Mapping[str, Any]
    objectives: Objectives
    states: Literal["all", "positions", "none"]
    taken: frozenset[str]
    """Names of columns that objectives cannot have."""

    def row(self, values: Mapping[str, Any], is_stopped: Callable[[], bool] | None = None) -> Row:
        """Run a case; a true answer of `is_stopped`, which is asked now and then, ends it."""
        clock = perf_counter()
        return replace(self._row(values, is_stopped), seconds=perf_counter() - clock)

    def _row(self, values: Mapping[str, Any], is_stopped: Callable[[], bool] | None) -> Row:
        try:
            simulation = _ancf.Simulation(substituted(self.base, values))
        except ModelError as error:
            return Row("invalid", str(error))
        except Exception as error:  # One case that meets an error must not cost the others.
            return Row("invalid", f"{type(error).__name__}: {error}")
        try:
            result = carried_out(simulation, self.states, stop=is_stopped)
        except AnalysisError as error:
            return counted(Row("failed", str(error)), error.result)
        except Exception as error:
            return Row("failed", f"{type(error).__name__}: {error}")
        if result.summary["outcome"]["kind"] == "stopped":
            return counted(Row("stopped"), result)
        return counted(self._measured(result), result)

    def _measured(self, result: Result) -> Row:
        try:
            values, missing = self.objectives.measured(result)
        except ObjectiveError as error:
            return Row("failed", str(error))
        clash = sorted(self.taken & values.keys())
        if clash:
            return Row("failed", f"objectives.{clash[0]}: another column of the table has this name")
        return Row("finished", "\n".join(missing) or None, values)


def counted(row: Row, result: Result | None) -> Row:
    """A row with the steps and iterations of its run."""
    summary = {} if result is None else result.summary
    return replace(row, steps=summary.get("steps"), iterations=summary.get("iterations"))
