"""Settings of the execution of a study and their errors."""

from __future__ import annotations

import os
from pathlib import Path
from tempfile import TemporaryFile
from typing import TYPE_CHECKING, Any

from ancf.errors import ModelError
from ancf.studies.definition.messages import choice_fault, fault, is_integer, quoted, shown
from ancf.studies.execution.threads import cores

if TYPE_CHECKING:
    from ancf.errors import Fault

STATES = ("all", "positions", "none")
"""Parts of states that can be kept."""


def faults(folder: object, states: object, client: object, jobs: object) -> list[Fault]:
    """Return all errors of the settings."""
    found: list[Fault | None] = []
    if folder is not None and not isinstance(folder, str | os.PathLike):
        found.append(fault("folder", shown(folder), "a path"))
    if states is not None:
        found.append(choice_fault("states", states, STATES))
    if client is not None and not all(hasattr(client, name) for name in ("submit", "nthreads", "cancel")):
        found.append(fault("client", shown(client), "a client of dask.distributed"))
    if jobs is not None and not is_integer(jobs, 1) and not (is_integer(jobs, -1) and jobs == -1):
        found.append(fault("jobs", shown(jobs), "an integer >= 1, or -1 for all cores"))
    return [one for one in found if one is not None]


def threads(jobs: Any) -> int:
    """Return the number of cases that run at a time."""
    return cores() if jobs is None or jobs == -1 else int(jobs)


def writable(folder: str | os.PathLike[str]) -> Path:
    """Create a folder if necessary and check that files can be written to it.

    Raises
    ------
    ModelError
        If no file can be written.

    """
    place = Path(folder)
    try:
        place.mkdir(parents=True, exist_ok=True)
        with TemporaryFile(dir=place):
            return place
    except OSError as error:
        found = f"{quoted(place)}, where no file can be written ({error.strerror})"
        raise ModelError([fault("folder", found, "a folder to write to")]) from error
