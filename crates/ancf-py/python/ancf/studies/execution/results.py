"""The cases that are done, kept in a file."""

from __future__ import annotations

from time import perf_counter
from typing import TYPE_CHECKING, Any

from ancf.errors import ModelError
from ancf.studies.design import Design, substituted
from ancf.studies.fingerprint import key
from ancf.studies.table import rows_in, table, write

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    import pyarrow as pa

    from ancf.studies.objective import Objectives
    from ancf.studies.row import Row

PAUSE = 1.0
"""The least time between two writings, in seconds."""

SHARE = 50
"""Writing takes one part in so many of the time."""


class Results:
    """The cases that are done, and the file that has them."""

    def __init__(
        self,
        design: Design,
        base: Mapping[str, Any],
        objectives: Objectives,
        states: str,
        folder: Path | None,
    ) -> None:
        """No case done yet; without a folder nothing is written."""
        self.design = design
        self.rows: dict[int, Row] = {}
        self.folder = folder
        self._base = base
        self._objectives = objectives
        self._definition = [objectives.definition, states]
        self._keys: dict[int, str] = {}
        self._is_due = True
        self._written = perf_counter()
        self._cost = 0.0

    def key(self, case: int) -> str:
        """The key of a case."""
        if case not in self._keys:
            values = self.design.values(case)
            try:
                data = substituted(self._base, values)
            except (ModelError, TypeError) as error:
                data = {"error": str(error), "values": values}
            self._keys[case] = key(data, self._definition)
        return self._keys[case]

    def take_over(self, *, retry: bool) -> None:
        """Take over what was done earlier, by key; with `retry` only what finished."""
        earlier = {} if self.folder is None else rows_in(self.folder)
        done = {"finished"} if retry else {"finished", "failed", "invalid"}
        wanted = {key: row for key, row in earlier.items() if row.outcome in done}
        if wanted:
            keys = {case: self.key(case) for case in range(self.design.cases)}
            self.rows = {case: wanted[key] for case, key in keys.items() if key in wanted}

    @property
    def missing(self) -> list[int]:
        """The cases that are not done."""
        return [case for case in range(self.design.cases) if case not in self.rows]

    @property
    def names(self) -> list[str]:
        """Names of the objectives, those that functions told too."""
        told = {name for row in list(self.rows.values()) for name in row.objectives}
        stated = set() if told and self._objectives.tells_names else set(self._objectives.readings)
        return sorted(stated | told)

    def add(self, case: int, row: Row) -> None:
        """Add what came of a case; threads may do so at any time."""
        self.rows[case] = row
        self._is_due = True

    def table(self) -> pa.Table:
        """All rows."""
        names, rows = self.names, dict(self.rows)
        return table(self.design.axes, names, rows, {case: self.key(case) for case in rows})

    def write_when_due(self) -> None:
        """Write if there is something new and writing does not come too often."""
        if self._is_due and perf_counter() - self._written >= max(PAUSE, SHARE * self._cost):
            self.write()

    def write(self) -> None:
        """Write all that is there."""
        if self.folder is None:
            return
        clock = perf_counter()
        self._is_due = False
        write(self.table(), self.folder / "cases.parquet")
        self._written = perf_counter()
        self._cost = self._written - clock
