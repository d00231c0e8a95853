"""Analyses: a model in, a result out."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Protocol, TypeAlias, runtime_checkable

from ancf import _ancf
from ancf.errors import AnalysisError
from ancf.instant import Instant
from ancf.progress import Bar
from ancf.result import Result

if TYPE_CHECKING:
    from ancf._ancf import States
    from ancf.record import Array


@runtime_checkable
class HasData(Protocol):
    """What can tell its data, such as `ancf.Model`."""

    def to_dict(self) -> dict[str, Any]:
        """Tell its data as plain dictionaries."""
        ...


ModelLike: TypeAlias = "HasData | Mapping[str, Any] | str | os.PathLike[str]"
"""A model: `ancf.Model`, its data in dictionaries, or the path of a model file."""

Callback: TypeAlias = Callable[[Instant], object]
"""What is called at each step; a true answer ends the run."""


def data(model: ModelLike) -> dict[str, Any]:
    """The data of a model, whichever way it is stated."""
    if isinstance(model, (str, os.PathLike)):
        return _ancf.read(Path(model))
    if isinstance(model, Mapping):
        return dict(model)
    if isinstance(model, type) or not isinstance(model, HasData):
        msg = f"model: found {model!r}, wanted an ancf.Model, its data in a dictionary, or the path of a file"
        raise TypeError(msg)
    return model.to_dict()


def run(
    model: ModelLike,
    *,
    callback: Callback | None = None,
    progress: bool | None = None,
    states: Literal["all", "positions", "none"] = "all",
) -> Result:
    """Run the analysis that a model asks for.

    Parameters
    ----------
    model
        An `ancf.Model`, its data in dictionaries, or the path of a model file.
    callback
        Is called with an `Instant` at the start and after each step, or with `output.interval` at the instants
        that are recorded: to watch, or to set what the functions of loads and drives then give. A true answer
        ends the run in good order.
    progress
        Whether a bar shows how far a motion is; by default if there is a terminal or a notebook.
    states
        What is kept of each state for `Result.field`: all of it, positions only, or nothing. All takes
        24 bytes a coordinate and 8 a multiplier and row: 12 coordinates a node and 1000 rows of 1000 elements
        take 290 MB. `Result.report` needs all.

    Raises
    ------
    ModelError
        If the model is not valid, with all that is wrong.
    AnalysisError
        If the analysis cannot go on; its `result` has what was computed until then. So has the attribute
        `result` of any exception that ends a run from outside, such as `KeyboardInterrupt`.

    """
    simulation = _ancf.Simulation(data(model))
    _, duration = simulation.analysis
    watch = None if callback is None else Watch(callback)
    with Bar(duration, progress) as bar:
        return carried_out(simulation, states, watch, bar.tick)


def carried_out(
    simulation: _ancf.Simulation,
    states: str,
    watch: Watch | None = None,
    tick: Callable[[float], object] | None = None,
    stop: Callable[[], object] | None = None,
) -> Result:
    """Run a simulation; `watch` sees each row, `tick` is told the time now and then, `stop` is asked in each iteration.

    A true answer of any of them ends it.
    """
    done = simulation.run(states, watch, tick, stop)
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
    """Read what `ancf run` wrote into a folder, also of a run that was killed or still goes on.

    The columns are those that `ancf.run` gives. Fields are of the states that the run kept, `Result.frames`: of
    motions about as many as `output.states` says, of all else every one. Of a run that goes on it is what was on the
    disk a moment ago; `summary["outcome"]["kind"]` is `running` then, and `broken` of one that was killed, with a
    `reason` in words.

    Raises
    ------
    ModelError
        If the model in the folder is none of this version.
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


def statics(model: ModelLike, **settings: Any) -> Result:
    """Find the equilibrium of a model, whatever analysis it asks for; `settings` are the keys of `ancf.Statics`.

    The last row is the equilibrium under all loads. Raises as `run` does.
    """
    return _analysed(model, "statics", settings)


def path(model: ModelLike, **settings: Any) -> Result:
    """Follow the path of equilibria of a model through limit points; `settings` are the keys of `ancf.Path`."""
    return _analysed(model, "path", settings)


def modes(model: ModelLike, count: int = 10, **settings: Any) -> Result:
    """Find the lowest natural modes of a model: `frequencies` and `shapes`; `settings` are the keys of `ancf.Modes`."""
    return _analysed(model, "modes", {"count": count, **settings})


def buckling(model: ModelLike, count: int = 1, **settings: Any) -> Result:
    """Find the lowest critical loads of a model: `factors` and `shapes`; `settings` are the keys of `ancf.Buckling`."""
    return _analysed(model, "buckling", {"count": count, **settings})


def _analysed(model: ModelLike, kind: str, settings: dict[str, Any]) -> Result:
    return run(data(model) | {"analysis": {"kind": kind, **settings}})


def check(model: ModelLike) -> str:
    """Check a model; what it consists of, what joints tie and what is free to move, in words. Raises `ModelError`."""
    return _ancf.diagnose(data(model))


def scaled(model: ModelLike) -> tuple[dict[str, Any], dict[str, float]]:
    """Give the data of a model in the units in which its equations are solved, and these units.

    The units are those of `length`, `time` and `force` in the model's own.
    """
    numbers, scales = _ancf.scaled(data(model))
    return numbers, dict(zip(("length", "time", "force"), scales, strict=True))


def schema() -> dict[str, Any]:
    """Give the JSON Schema of models."""
    found: dict[str, Any] = json.loads(_ancf.schema())
    return found


class Watch:
    """Shows each row of a run to a callback."""

    def __init__(self, callback: Callback) -> None:
        """Show them to `callback`."""
        self._callback = callback
        self._places: dict[str, int] | None = None

    def __call__(self, columns: list[str], row: Array, states: States) -> object:
        """Show a row."""
        instant = Instant(columns, row, states, self._places)
        self._places = instant.places
        return self._callback(instant)
