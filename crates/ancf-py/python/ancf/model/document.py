"""The model as a document: it is read, written, and searched by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Any, TypeVar

from ancf import _ancf
from ancf.model import summary
from ancf.model.base.part import Part, plain
from ancf.model.base.tables import Tables
from ancf.model.output import Probe

__all__ = ["Document"]

D = TypeVar("D", bound="Document")


class Document(Part):
    """Base class of the whole model."""

    __slots__ = ()

    bodies: Sequence[Any]
    joints: Sequence[Any] | None
    probes: Sequence[Any] | None
    materials: Mapping[str, Any] | None
    sections: Mapping[str, Any] | None

    @classmethod
    def read(cls: type[D], path: str | PathLike[str]) -> D:
        """Read a model file. Raises `ModelError` with all errors of the file."""
        return cls.from_dict(_ancf.read(Path(path)))

    def to_dict(self) -> dict[str, Any]:
        """Return plain data as in a model file. Parts given instead of names are in its tables."""
        tables = Tables(materials=self.materials, sections=self.sections)
        data = self._plain(tables)
        data.update({key: plain(table, tables) for key, table in tables.tables.items() if table})
        return data

    def to_toml(self) -> str:
        """Return the text of the model file."""
        return _ancf.to_toml(self.to_dict())

    def write(self, path: str | PathLike[str]) -> None:
        """Write the model file."""
        Path(path).write_text(self.to_toml(), encoding="utf-8")

    # The class of a body or joint is known to the caller only, hence `Any`.

    def body(self, name: str) -> Any:
        """Return the body with a name. Raises ``KeyError`` if there is none."""
        return _named("body", name, self.bodies)

    def joint(self, name: str) -> Any:
        """Return the joint with a name. Raises ``KeyError`` if there is none."""
        return _named("joint", name, self.joints)

    def probe(self, name: str) -> Probe:
        """Return the probe with a name. Raises ``KeyError`` if there is none."""
        found: Probe = _named("probe", name, self.probes)
        return found

    def __repr__(self) -> str:
        return summary.text(self)

    def _repr_html_(self) -> str:
        return summary.html(self)

    def _label(self) -> str | None:
        # Paths of a whole model are complete.
        return None

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Document):
            return NotImplemented
        return self.to_dict() == other.to_dict()


def _named(kind: str, name: str, parts: Sequence[Any] | None) -> Any:
    """Return the part with a name."""
    names = [part.get("name") if isinstance(part, Mapping) else part.name for part in parts or ()]
    if name not in names:
        raise KeyError(f"no {kind} is called {name!r}; there are {names}")
    return (parts or ())[names.index(name)]
