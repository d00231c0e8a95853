"""Names of parts that are given instead of their names."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar, Protocol


class NamedPart(Protocol):
    """A part with an optional name."""

    name: str | None
    _form: ClassVar[str]


class Tables:
    """Tables of a model, such as ``sections``, that collect the parts given instead of their names."""

    def __init__(self, **tables: Mapping[str, NamedPart] | None) -> None:
        self.tables: dict[str, dict[str, NamedPart]] = {
            key: dict(table or {}) for key, table in tables.items()
        }

    def name(self, table: str, part: NamedPart) -> str:
        """Return the name of a part in a table. Adds the part if the table has no equal one."""
        parts = self.tables.setdefault(table, {})
        for name, other in parts.items():
            if part is other or (part == other and part.name in (None, name)):
                return name
        name = self._free_name(table, part)
        parts[name] = part
        return name

    def _free_name(self, table: str, part: NamedPart) -> str:
        """Return the name of the part or the word of its kind, with a number if the name is in use."""
        base = part.name or str(getattr(part, "kind", part._form)).lower()
        names = [base, *(f"{base}_{number}" for number in range(2, len(self.tables[table]) + 2))]
        return next(name for name in names if name not in self.tables[table])
