"""Run of a study: one model in many cases."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal

from ancf import _ancf
from ancf.analysis import data, stack_level
from ancf.errors import AnalysisWarning
from ancf.progress import is_seen
from ancf.studies import settings
from ancf.studies.definition.design import plain
from ancf.studies.definition.objective import Objectives
from ancf.studies.definition.statement import Statement
from ancf.studies.execution import cluster, threads
from ancf.studies.execution.results import Results
from ancf.studies.execution.row import Work
from ancf.studies.report import Study

if TYPE_CHECKING:
    import os
    from collections.abc import Callable

    from ancf.analysis import ModelLike
    from ancf.studies.definition.objective import Objective


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
    """Run a model in many cases with different values of some of its keys, and record a few numbers of each.

    Parameters
    ----------
    model
        A valid model.
    parameters
        Values by the path of the key, such as `"bodies.rod.material.young"`: a list of any data, or a distribution
        of `scipy.stats` or any other object with a method `ppf`.
    objective
        A function of the `Result` that returns a number, or several by name; or functions and columns by name:
        `{"tip": ("tip.y", "mean")}` reduces a column by `"first"`, `"last"`, `"mean"`, `"min"`, `"max"`,
        `"amplitude"`, `"rms"` or the number of a row, from 0.
    samples, seed, sampling
        Number of samples of all distributions together, their seed and the sampling method.
    combine
        Combine every value of a list with every value of the others, or the first with the first, the second with
        the second. Every combination runs with every sample.
    folder
        Folder of `cases.parquet`. Rows of cases that were run before are reused.
    retry
        True to run failed and invalid cases again.
    states
        Part of each state that is kept for `Result.field`, as in `run`; by default all if an objective is a function.
    client
        A client of `dask.distributed`. Cases run on its workers instead of on the cores of this machine.
    jobs
        Number of cases that run at a time on this machine; by default, and by -1, the number of cores.
    progress
        True for a progress bar; by default in terminals and notebooks.

    Raises
    ------
    ModelError
        If the model or the study is invalid, with all errors, before any case is run. Failed cases are rows.
    KeyboardInterrupt
        After the rows of finished cases were written.

    """
    base = plain(data(model))
    _ancf.Simulation(base)
    objectives = Objectives(objective)
    wrong = settings.faults(folder, states, client, jobs)
    design = Statement(base, objectives, samples, seed, combine, sampling, faults=wrong).design(parameters)
    place = None if folder is None else settings.writable(folder)
    kept = states or ("all" if objectives.need_states else "none")
    results = Results(design, base, objectives, kept, place)
    results.reuse(retry=retry)
    reserved = frozenset([*_ancf.STUDY_COLUMNS, *(axis.path for axis in design.axes)])
    run_cases(results, Work(base, objectives, kept, reserved), client, settings.threads(jobs), progress)
    file = None if place is None else place / "cases.parquet"
    ended = Study(results.table().to_pandas(), [axis.path for axis in design.axes], results.names, file)
    warn_of(ended)
    return ended


def warn_of(study: Study) -> None:
    """Issue one warning for all finished cases with warnings or missing objectives."""
    warned = study.warned
    if len(warned):
        first = warned.iloc[0]
        text = (
            f"cases with warnings (column `message`): {len(warned)}; case {first['case']}: {first['message']}"
        )
        warnings.warn(text, AnalysisWarning, stacklevel=stack_level())


def run_cases(results: Results, work: Work, client: Any, jobs: int, progress: bool | None) -> None:
    """Run the cases without a row. Rows are written also after an exception."""
    from tqdm.auto import tqdm

    values, missing = results.design.values, results.missing
    shown = is_seen() if progress is None else progress
    with tqdm(total=results.design.cases, initial=len(results.rows), unit="case", disable=not shown) as bar:

        def run_case(case: int, is_stopped: Callable[[], bool]) -> None:
            results.add(case, work.row(values(case), is_stopped))

        def tick() -> None:
            bar.update(len(results.rows) - bar.n)
            results.write_when_due()

        try:
            if client is None:
                threads.run(missing, jobs, run_case, tick)
            else:
                cluster.run(client, missing, work, values, results.add, tick)
        finally:
            results.write()
