"""A model as a document: read, written, and its parts found by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from ancf import _ancf
from ancf.part import Part, plain
from ancf.tables import Tables

if TYPE_CHECKING:
    from ancf.model.output import Probe

__all__ = ["Document"]

D = TypeVar("D", bound="Document")


class Document(Part):
    """What a whole model can do that its parts cannot."""

    __slots__ = ()

    bodies: Sequence[Any]
    joints: Sequence[Any] | None
    probes: Sequence[Any] | None
    materials: Mapping[str, Any] | None
    sections: Mapping[str, Any] | None

    @classmethod
    def read(cls: type[D], path: str | PathLike[str]) -> D:
        """Read a model file; raises `ModelError` with all that is wrong."""
        return cls.from_dict(_ancf.read(Path(path)))

    def to_dict(self) -> dict[str, Any]:
        """Plain data as in a model file; what bodies have in the place of names is in its tables."""
        tables = Tables(materials=self.materials, sections=self.sections)
        data = self._plain(tables)
        data.update({key: plain(table, tables) for key, table in tables.tables.items() if table})
        return data

    def to_toml(self) -> str:
        """The text of the model file."""
        return _ancf.to_toml(self.to_dict())

    def write(self, path: str | PathLike[str]) -> None:
        """Write the model file."""
        Path(path).write_text(self.to_toml(), encoding="utf-8")

    # The kind of a body or joint is known to whoever asks for it by name, hence `Any`.

    def body(self, name: str) -> Any:
        """The body of a name; ``KeyError`` if there is none."""
        return _named("body", name, self.bodies)

    def joint(self, name: str) -> Any:
        """The joint of a name; ``KeyError`` if there is none."""
        return _named("joint", name, self.joints)

    def probe(self, name: str) -> Probe:
        """The probe of a name; ``KeyError`` if there is none."""
        found: Probe = _named("probe", name, self.probes)
        return found

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Document):
            return NotImplemented
        return self.to_dict() == other.to_dict()


def _named(kind: str, name: str, parts: Sequence[Any] | None) -> Any:
    """The part of a name."""
    names = [part.name for part in parts or ()]
    if name not in names:
        raise KeyError(f"no {kind} is called {name!r}; there are {names}")
    return (parts or ())[names.index(name)]
