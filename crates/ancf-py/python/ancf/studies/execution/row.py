"""Execution of a case: one row of the table."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from time import perf_counter
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

from ancf import _ancf
from ancf.analysis import run_simulation
from ancf.errors import AnalysisError, ModelError
from ancf.studies.definition.design import substituted
from ancf.studies.definition.objective import ObjectiveError, Objectives

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from ancf.result import Result

Outcome: TypeAlias = Literal["finished", "failed", "invalid", "stopped"]
"""Outcome of a case: completed; not solved or without objectives; invalid model; interrupted."""


@dataclass(frozen=True)
class Row:
    """Results of a case."""

    outcome: Outcome
    message: str | None = None
    objectives: Mapping[str, float] = field(default_factory=dict)
    steps: int | None = None
    iterations: int | None = None
    seconds: float = 0.0


@dataclass(frozen=True)
class Work:
    """Computation of a case from the values of its parameters."""

    base: Mapping[str, Any]
    objectives: Objectives
    states: Literal["all", "positions", "none"]
    reserved: frozenset[str]
    """Names of other columns, which objectives cannot have."""

    def row(self, values: Mapping[str, Any], is_stopped: Callable[[], bool] | None = None) -> Row:
        """Run a case. A true return value of `is_stopped`, which is called in each iteration, ends it."""
        clock = perf_counter()
        return replace(self._row(values, is_stopped), seconds=perf_counter() - clock)

    def _row(self, values: Mapping[str, Any], is_stopped: Callable[[], bool] | None) -> Row:
        try:
            simulation = _ancf.Simulation(substituted(self.base, values))
        except ModelError as error:
            return Row("invalid", str(error))
        except Exception as error:  # The error of one case must not end the others.
            return Row("invalid", f"{type(error).__name__}: {error}")
        try:
            result = run_simulation(simulation, self.states, stop=is_stopped)
        except AnalysisError as error:
            return with_counts(Row("failed", str(error)), error.result)
        except Exception as error:
            return Row("failed", f"{type(error).__name__}: {error}")
        if result.summary["outcome"]["kind"] == "stopped":
            return with_counts(Row("stopped"), result)
        return with_counts(self._measured(result), result)

    def _measured(self, result: Result) -> Row:
        try:
            values, missing = self.objectives.measured(result)
        except ObjectiveError as error:
            return Row("failed", str(error))
        clash = sorted(self.reserved & values.keys())
        if clash:
            return Row("failed", f"objectives.{clash[0]}: another column of the table has this name")
        warnings = (f"warning: {warning}" for warning in result.summary["warnings"])
        return Row("finished", "\n".join([*missing, *warnings]) or None, values)


def with_counts(row: Row, result: Result | None) -> Row:
    """Return a row with the steps and iterations of its run."""
    summary = {} if result is None else result.summary
    return replace(row, steps=summary.get("steps"), iterations=summary.get("iterations"))
