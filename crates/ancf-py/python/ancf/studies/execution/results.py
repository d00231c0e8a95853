"""Rows of completed cases, kept in a file."""

from __future__ import annotations

from time import perf_counter
from typing import TYPE_CHECKING, Any

from ancf.errors import ModelError
from ancf.studies.definition.design import Design, substituted
from ancf.studies.definition.fingerprint import key
from ancf.studies.execution.table import rows_in, table, write

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    import pyarrow as pa

    from ancf.studies.definition.objective import Objectives
    from ancf.studies.execution.row import Row

MIN_INTERVAL = 1.0
"""Minimum time between two writes in seconds."""

WRITE_RATIO = 50
"""Minimum ratio of the time between two writes to the time of a write."""


class Results:
    """Rows of completed cases and their file."""

    def __init__(
        self,
        design: Design,
        base: Mapping[str, Any],
        objectives: Objectives,
        states: str,
        folder: Path | None,
    ) -> None:
        """Start without rows. No file is written without a folder."""
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
        """Return the key of a case."""
        if case not in self._keys:
            values = self.design.values(case)
            try:
                data = substituted(self._base, values)
            except (ModelError, TypeError) as error:
                data = {"error": str(error), "values": values}
            self._keys[case] = key(data, self._definition)
        return self._keys[case]

    def reuse(self, *, retry: bool) -> None:
        """Reuse rows of earlier runs by key, with `retry` only those of finished cases."""
        earlier = {} if self.folder is None else rows_in(self.folder)
        done = {"finished"} if retry else {"finished", "failed", "invalid"}
        expected = {key: row for key, row in earlier.items() if row.outcome in done}
        if expected:
            keys = {case: self.key(case) for case in range(self.design.cases)}
            self.rows = {case: expected[key] for case, key in keys.items() if key in expected}

    @property
    def missing(self) -> list[int]:
        """Cases without a row."""
        return [case for case in range(self.design.cases) if case not in self.rows]

    @property
    def names(self) -> list[str]:
        """Names of the objectives, including those returned by functions."""
        found = {name for row in list(self.rows.values()) for name in row.objectives}
        stated = set() if found and self._objectives.has_open_names else set(self._objectives.readings)
        return sorted(stated | found)

    def add(self, case: int, row: Row) -> None:
        """Add the row of a case. Thread-safe."""
        self.rows[case] = row
        self._is_due = True

    def table(self) -> pa.Table:
        """Return all rows as a table."""
        names, rows = self.names, dict(self.rows)
        return table(self.design.axes, names, rows, {case: self.key(case) for case in rows})

    def write_when_due(self) -> None:
        """Write new rows, unless the last write was too recent."""
        if self._is_due and perf_counter() - self._written >= max(MIN_INTERVAL, WRITE_RATIO * self._cost):
            self.write()

    def write(self) -> None:
        """Write all rows."""
        if self.folder is None:
            return
        clock = perf_counter()
        self._is_due = False
        write(self.table(), self.folder / "cases.parquet")
        self._written = perf_counter()
        self._cost = self._written - clock
