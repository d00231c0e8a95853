"""Analyses of models."""

from __future__ import annotations

import json
import os
import sys
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Protocol, TypeAlias, runtime_checkable

from ancf import _ancf
from ancf.errors import AnalysisError, AnalysisWarning
from ancf.model.base.part import Part
from ancf.model.document import Document
from ancf.progress import Bar
from ancf.record.instant import Instant
from ancf.result import Result

if TYPE_CHECKING:
    from ancf._ancf import States
    from ancf.record.columns import Array


@runtime_checkable
class HasData(Protocol):
    """An object with plain data, such as `ancf.Model`."""

    def to_dict(self) -> dict[str, Any]:
        """Return the data as plain dictionaries."""
        ...


ModelLike: TypeAlias = "HasData | Mapping[str, Any] | str | os.PathLike[str]"
"""A model: `ancf.Model`, its data in dictionaries, or the path of a model file."""

Callback: TypeAlias = Callable[[Instant], object]
"""Function called in each step. A true return value ends the run."""


def data(model: ModelLike) -> dict[str, Any]:
    """Return the data of a model as plain dictionaries."""
    if isinstance(model, (str, os.PathLike)):
        return _ancf.read(Path(model))
    if isinstance(model, Mapping):
        return dict(model)
    is_part = isinstance(model, Part) and not isinstance(model, Document)
    if is_part or isinstance(model, type) or not isinstance(model, HasData):
        msg = (
            f"model: found {model!r}, expected an ancf.Model, its data in a dictionary, or the path of a file"
        )
        raise TypeError(msg)
    return model.to_dict()


def run(
    model: ModelLike,
    *,
    to: float | None = None,
    callback: Callback | None = None,
    progress: bool | None = None,
    states: Literal["all", "positions", "none"] = "all",
) -> Result:
    """Run the analysis of a model.

    Parameters
    ----------
    model
        An `ancf.Model`, its data in dictionaries, or the path of a model file.
    to
        Relative error to which the bodies are refined, such as 0.01: the largest estimated error of a displacement,
        frequency or load factor. Statics, modes and buckling only. The bodies of the result have the refined meshes,
        `summary["meshes"]` has the history. An error that cannot be reached is an `AnalysisWarning`.
    callback
        Function called with an `Instant` at the start and after each step, or with `output.interval` at the recorded
        instants. It may observe the run or set the values that functions of loads and drives return next. A true
        return value ends the run without an error.
    progress
        True for a progress bar of a motion; by default in terminals and notebooks.
    states
        Part of each state that is kept for `Result.field`: all of it, positions only, or nothing. A complete state
        takes 24 bytes per coordinate and 8 per multiplier and row: 12 coordinates per node and 1000 rows of 1000
        elements take 290 MB. `Result.report` needs complete states.

    Raises
    ------
    ModelError
        If the model is invalid, with all errors.
    AnalysisError
        If the analysis fails; its `result` has the rows up to the failure. Any other exception that ends a run,
        such as `KeyboardInterrupt`, has the same attribute `result`.

    Warns
    -----
    AnalysisWarning
        For each of `summary["warnings"]`, such as a mesh that is too coarse or units that do not fit.

    """
    simulation = _ancf.Simulation(data(model))
    if to is not None:
        simulation = simulation.refine(to)
    return _run_shown(simulation, states, callback, progress)


def _run_shown(
    simulation: _ancf.Simulation,
    states: str,
    callback: Callback | None,
    progress: bool | None,
    after: Result | None = None,
) -> Result:
    """Run a simulation with a progress bar, and issue its warnings."""
    _, duration = simulation.analysis
    observer = None if callback is None else CallbackObserver(callback)
    with Bar(duration, progress) as bar:
        try:
            result = run_simulation(simulation, states, observer, bar.tick, after=after)
        except AnalysisError as error:
            warn(error.result)
            raise
    warn(result)
    return result


def run_sequence(
    model: ModelLike, *, callback: Callback | None = None, progress: bool | None = None
) -> dict[str, Result]:
    """Run a model with a list of analyses, each of which starts in the last state before it.

    Parameters
    ----------
    model
        The path of a model file, or data in dictionaries, whose `analysis` is a list. Data of an `ancf.Model` have
        one by ``model.to_dict() | {"analysis": [{"name": "hang", "kind": "statics"}, ...]}``. Joints, loads, contacts
        and other parts exist in some analyses by ``only_in`` and ``not_in``.
    callback, progress
        As of `run`, for each analysis.

    Returns
    -------
    dict
        The result of each analysis by its name, in their order. A single analysis is a list of one.

    Raises
    ------
    ModelError
        If a model is invalid, with all errors.
    AnalysisError
        If an analysis fails; `completed` has the results of those before it.

    """
    stages = _stages(model)
    if not stages:
        result = run(model, callback=callback, progress=progress)
        return {result.kind: result}
    results: dict[str, Result] = {}
    folders: dict[str, Result] = {}
    time = 0.0
    for stage in stages:
        numbers = stage.data(time)
        before = folders.get(Path(str(numbers.get("initial", {}).get("from", ""))).name)
        try:
            result = _run_shown(_ancf.Simulation(numbers), "all", callback, progress, before)
        except AnalysisError as error:
            error.completed = results
            raise
        results[stage.name] = folders[stage.folder] = result
        if result.kind == "dynamics":
            time = result.summary["time"]
        if result.summary["outcome"]["kind"] != "finished":
            break
    return results


def _stages(model: ModelLike) -> list[_ancf.Stage]:
    """Return the analyses of a model with a list of them; none of a model with a single one."""
    if isinstance(model, (str, os.PathLike)):
        return _ancf.stages_of_file(Path(model))
    numbers = data(model)
    return _ancf.stages(numbers) if isinstance(numbers.get("analysis"), (list, tuple)) else []


def warn(result: Result | None) -> None:
    """Issue the warnings of a run. Those of a failed run may state its cause."""
    for text in [] if result is None else result.summary.get("warnings", []):
        warnings.warn(text, AnalysisWarning, stacklevel=stack_level())


def stack_level() -> int:
    """Return the level of the first caller outside of this package, to which warnings refer."""
    level, frame = 2, sys._getframe(2)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").startswith("ancf."):
        level, frame = level + 1, frame.f_back
    return level


def run_simulation(
    simulation: _ancf.Simulation,
    states: str,
    observer: CallbackObserver | None = None,
    tick: Callable[[float], object] | None = None,
    stop: Callable[[], object] | None = None,
    after: Result | None = None,
) -> Result:
    """Run a simulation. `observer` receives each row, `tick` the time now and then, `stop` is called in each iteration.

    A true return value of any of them ends the run. It starts in the last state of the result `after`, if there is one.
    """
    last = (
        None
        if after is None
        else (after.states, dict(zip(after.columns, after.data[-1].tolist(), strict=True)))
    )
    done = simulation.run(states, observer, tick, stop, last)
    kind, _ = simulation.analysis
    result = Result(
        done["columns"],
        done["rows"],
        done["states"],
        kind,
        done["summary"],
        simulation.model,
        units=done["units"],
    )
    error = done["error"]
    if error is not None:
        error.result = result  # type: ignore[attr-defined]
        raise error
    if done["failure"] is not None:
        raise AnalysisError(done["failure"], result)
    return result


def load(folder: str | os.PathLike[str]) -> Result:
    """Read the results that `ancf run` wrote to a folder, also of a run that was killed or is in progress.

    The columns are those of `ancf.run`. Fields are based on the states that the run kept, `Result.frames`: about
    `output.states` states of a motion, all states of other analyses. Of a run in progress, the results written so far
    are read. Its `summary["outcome"]["kind"]` is `running`, that of a killed run is `broken` with a `reason`.

    Raises
    ------
    ModelError
        If the model in the folder is not valid in this version.
    OSError
        If there is no run (`FileNotFoundError`), or a file is damaged or cannot be read.

    """
    done = _ancf.load(Path(folder))
    return Result(
        done["columns"],
        done["rows"],
        done["states"],
        done["kind"],
        done["summary"],
        done["model"],
        units=done["units"],
        frames=done["frames"],
        frame_rows=done["frame_rows"],
    )


def statics(model: ModelLike, *, to: float | None = None, **settings: Any) -> Result:
    """Compute the equilibrium of a model; `settings` are the keys of `ancf.Statics`.

    The last row is the equilibrium under all loads. The analysis of the model itself is ignored. `to` refines the mesh
    to a relative error. Raises as `run` does.
    """
    return _analysed(model, "statics", settings, to)


def path(model: ModelLike, **settings: Any) -> Result:
    """Trace the equilibrium path of a model through limit points; `settings` are the keys of `ancf.EquilibriumPath`."""
    return _analysed(model, "path", settings)


def modes(model: ModelLike, count: int = 10, *, to: float | None = None, **settings: Any) -> Result:
    """Compute the lowest natural modes: `frequencies` and `shapes`; `settings` are the keys of `ancf.Modes`.

    `to` refines the mesh to a relative error of all frequencies.
    """
    return _analysed(model, "modes", {"count": count, **settings}, to)


def buckling(model: ModelLike, count: int = 1, *, to: float | None = None, **settings: Any) -> Result:
    """Compute the lowest critical loads: `factors` and `shapes`; `settings` are the keys of `ancf.Buckling`.

    `to` refines the mesh to a relative error of all factors.
    """
    return _analysed(model, "buckling", {"count": count, **settings}, to)


def _analysed(model: ModelLike, kind: str, settings: dict[str, Any], to: float | None = None) -> Result:
    return run(data(model) | {"analysis": {"kind": kind, **settings}}, to=to)


def check(model: ModelLike) -> str:
    """Check a model and describe its parts, constraints and degrees of freedom. Raises `ModelError`.

    Of a model with a list of analyses, each of them has a description under its name.
    """
    stages = _stages(model)
    if not stages:
        return _ancf.diagnose(data(model))
    return "\n\n".join(f"analysis `{stage.name}`\n{_ancf.diagnose(stage.data(0.0))}" for stage in stages)


def scaled(model: ModelLike) -> tuple[dict[str, Any], dict[str, float]]:
    """Return the data of a model in the units of the solver, and these units.

    The units are those of `length`, `time` and `force`, expressed in the units of the model.
    """
    numbers, scales = _ancf.scaled(data(model))
    return numbers, dict(zip(("length", "time", "force"), scales, strict=True))


def schema() -> dict[str, Any]:
    """Return the JSON Schema of models."""
    found: dict[str, Any] = json.loads(_ancf.schema())
    return found


class CallbackObserver:
    """Calls a callback with each row of a run."""

    def __init__(self, callback: Callback) -> None:
        """Store the callback."""
        self._callback = callback
        self._indices: dict[str, int] | None = None

    def __call__(self, columns: list[str], row: Array, states: States) -> object:
        """Call the callback with a row."""
        instant = Instant(columns, row, states, self._indices)
        self._indices = instant.indices
        return self._callback(instant)
