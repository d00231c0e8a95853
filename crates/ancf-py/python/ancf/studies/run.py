"""Studies: a model in many cases."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal

from ancf import _ancf
from ancf.analysis import data
from ancf.progress import is_seen
from ancf.studies import cluster, settings, threads
from ancf.studies.design import plain
from ancf.studies.objective import Objectives
from ancf.studies.report import Study
from ancf.studies.results import Results
from ancf.studies.row import Work
from ancf.studies.statement import Statement
from ancf.studies.table import COLUMNS

if TYPE_CHECKING:
    import os
    from collections.abc import Callable

    from ancf.analysis import ModelLike
    from ancf.studies.objective import Objective


def study(
    model: ModelLike,
    parameters: Mapping[str, Any],
    objective: Objective | None = None,
    *,
    samples: int | None = None,
    seed: int = 0,
    combine: Literal["grid", "zip"] = "grid",
    sampling: Literal["latin_hypercube", "random", "sobol"] = "latin_hypercube",
    folder: str | os.PathLike[str] | None = None,
    retry: bool = False,
    states: Literal["all", "positions", "none"] | None = None,
    client: Any = None,
    jobs: int | None = None,
    progress: bool | None = None,
) -> Study:
    """Run a model in many cases, each with other values of some of its keys, and keep a few numbers of each.

    Parameters
    ----------
    model
        A model that is valid by itself.
    parameters
        Values by the path of the key, such as `"bodies.rod.material.young"`: a list, of any data, or a distribution
        of `scipy.stats` (or whatever has `ppf`).
    objective
        A function of the `Result` that gives a number, or several by name; or such functions and columns by name:
        `{"tip": ("tip.y", "mean")}` takes the `"first"`, `"last"`, `"mean"`, `"min"`, `"max"`, `"amplitude"`, `"rms"`
        or the row of a number, from 0.
    samples, seed, sampling
        How many samples of all distributions together, what decides them, and how they fill the distributions.
    combine
        Every value of a list with every one of the others, or the first with the first, the second with the second.
        Every combination runs with every sample.
    folder
        Where `cases.parquet` is written, and from where cases are taken over that were run before.
    retry
        Whether those are run again that failed or were invalid.
    states
        What is kept of states for `Result.field`, as in `run`; by default all if a function is among the objectives.
    client
        A client of `dask.distributed`, on whose workers the cases run instead of on this machine's cores.
    jobs
        How many cases run at a time on this machine; by default, and by -1, as many as there are cores.
    progress
        Whether a bar shows how far the study is; by default if there is a terminal or a notebook.

    Raises
    ------
    ModelError
        With all that is wrong with the model, or with the study, before anything is run. Cases that fail are rows.
    KeyboardInterrupt
        After those cases were written that had finished.

    """
    base = plain(data(model))
    _ancf.Simulation(base)
    objectives = Objectives(objective)
    wrong = settings.faults(folder, states, client, jobs)
    design = Statement(base, objectives, samples, seed, combine, sampling, faults=wrong).design(parameters)
    place = None if folder is None else settings.writable(folder)
    kept = states or ("all" if objectives.need_states else "none")
    results = Results(design, base, objectives, kept, place)
    results.take_over(retry=retry)
    taken = frozenset([*COLUMNS, *(axis.path for axis in design.axes)])
    carry_out(results, Work(base, objectives, kept, taken), client, settings.threads(jobs), progress)
    file = None if place is None else place / "cases.parquet"
    return Study(results.table().to_pandas(), [axis.path for axis in design.axes], results.names, file)


def carry_out(results: Results, work: Work, client: Any, jobs: int, progress: bool | None) -> None:
    """Run the cases that are missing; what is done is written in any event."""
    from tqdm.auto import tqdm

    values, missing = results.design.values, results.missing
    shown = is_seen() if progress is None else progress
    with tqdm(total=results.design.cases, initial=len(results.rows), unit="case", disable=not shown) as bar:

        def ran(case: int, is_stopped: Callable[[], bool]) -> None:
            results.add(case, work.row(values(case), is_stopped))

        def tick() -> None:
            bar.update(len(results.rows) - bar.n)
            results.write_when_due()

        try:
            if client is None:
                threads.run(missing, jobs, ran, tick)
            else:
                cluster.run(client, missing, work, values, results.add, tick)
        finally:
            results.write()
