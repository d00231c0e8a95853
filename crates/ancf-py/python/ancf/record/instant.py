"""One instant of a run in progress."""

from __future__ import annotations

from ancf.record.record import Record


class Instant(Record):
    """Argument of a callback: the record of one row, whose vectors are `[component]`."""

    @property
    def time(self) -> float:
        """Time. Load factor or number of the mode in other analyses than dynamics."""
        return float(self.data[0])
