"""One instant of a run that goes on."""

from __future__ import annotations

from ancf.record import Record


class Instant(Record):
    """What a callback sees at each step: the record of one row, so that vectors are `[component]`."""

    @property
    def time(self) -> float:
        """The time; of other analyses the load factor or the number of the mode."""
        return float(self.data[0])
