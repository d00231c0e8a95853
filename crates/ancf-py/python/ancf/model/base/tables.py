"""Names of parts that are given in the place of their names."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ancf.part import Shared


class Tables:
    """The tables of a model, such as ``sections``, to which parts come that are given in the place of names."""

    def __init__(self, **tables: Mapping[str, Shared] | None) -> None:
        self.tables: dict[str, dict[str, Shared]] = {key: dict(table or {}) for key, table in tables.items()}

    def name(self, table: str, part: Shared) -> str:
        """The name of a part in a table, into which it is put if no equal one is there."""
        parts = self.tables.setdefault(table, {})
        for name, other in parts.items():
            if part is other or (part == other and part.name in (None, name)):
                return name
        name = self._free(table, part)
        parts[name] = part
        return name

    def _free(self, table: str, part: Shared) -> str:
        """Its own name or the word of its kind, with a number if that is taken."""
        base = part.name or str(getattr(part, "kind", part._form)).lower()
        names = [base, *(f"{base}_{number}" for number in range(2, len(self.tables[table]) + 2))]
        return next(name for name in names if name not in self.tables[table])
