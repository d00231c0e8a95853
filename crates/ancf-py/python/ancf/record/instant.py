"""One instant of a run in progress."""

from __future__ import annotations

from ancf.display.numbers import format_number
from ancf.display.tables import joined
from ancf.record.record import Record


class Instant(Record):
    """Argument of a callback: the record of one row, whose vectors are `[component]`."""

    @property
    def time(self) -> float:
        """Time. Load factor or number of the mode in other analyses than dynamics."""
        return float(self.data[0])

    def __repr__(self) -> str:
        probes = f"; probes: {joined(list(self.probes))}" if self.probes else ""
        return f"Instant({self.columns[0]} = {format_number(self.time)}{probes})"
