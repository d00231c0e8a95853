"""What all parts of a model have in common."""

from __future__ import annotations

import types
import typing
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from typing import Any, ClassVar, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from ancf import _ancf
from ancf.tables import Tables

__all__ = ["ForceFunction", "Numbers", "Part", "Points", "Shared", "Vector"]

Numbers: TypeAlias = Sequence[float] | NDArray[Any]
"""Numbers in a row."""
Vector: TypeAlias = Sequence[float] | NDArray[Any]
"""Three numbers in the global frame."""
Points: TypeAlias = Sequence[Vector] | NDArray[Any]
"""Points in a row, each three numbers."""
ForceFunction: TypeAlias = Callable[[float, NDArray[Any], NDArray[Any]], Vector]
"""The force at a time on a point with a position and a velocity."""

P = TypeVar("P", bound="Part")


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Part:
    """A part of a model: its attributes are the keys that it has in a model file.

    What is left out is ``None``, and the program's default holds. A part is checked when it is built; the whole
    model is checked when it is run.

    Raises
    ------
    ModelError
        When it is built, with all that is wrong with it.
    TypeError
        When another part is given than is wanted, or an argument is unknown or missing.

    """

    # Its definition in the schema; the key whose word, a class constant, tells it from others of the definition.
    _form: ClassVar[str] = ""
    _tag: ClassVar[str | None] = None
    # Keys that name a part in a table of the model, for which the part itself may be given.
    _tables: ClassVar[Mapping[str, str]] = {}
    # Attributes that are not keys of the schema.
    _own: ClassVar[frozenset[str]] = frozenset()

    def __post_init__(self) -> None:
        hints = _hints(type(self))
        found = [
            misplaced(hints[name], value, name) for name, value in self._given().items() if name in hints
        ]
        if any(found):
            raise TypeError("\n".join(filter(None, found)))
        _ancf.check_part(self._form, self.to_dict())

    def to_dict(self) -> dict[str, Any]:
        """Plain data as in a model file; keys that are left out stay left out, callables stay callables."""
        return self._plain(Tables())

    @classmethod
    def from_dict(cls: type[P], data: Mapping[str, Any]) -> P:
        """Make a part of plain data, as in a model file; raises `ModelError` with all that is wrong."""
        tag = {cls._tag: getattr(cls, cls._tag)} if cls._tag else {}
        data = {**tag, **data}
        _ancf.check_part(cls._form, plain(data, Tables()))
        if not cls._fits(data):
            raise ValueError(f"these are not the data of a {cls.__name__}")
        return cls._of(data)

    @classmethod
    def _fits(cls, data: Mapping[str, Any]) -> bool:
        """Whether data are of this class, among others of the same definition."""
        if cls._tag:
            return bool(data.get(cls._tag) == getattr(cls, cls._tag))
        return {_key(name) for name in _hints(cls)} >= data.keys()

    @classmethod
    def _of(cls: type[P], data: Mapping[str, Any]) -> P:
        """A part of data that fit."""
        given = {name: (hint, data.get(_key(name))) for name, hint in _hints(cls).items()}
        return cls(**{name: typed(hint, item) for name, (hint, item) in given.items() if item is not None})

    def _plain(self, tables: Tables) -> dict[str, Any]:
        """Plain data; parts in the place of names get their names from the tables."""
        data: dict[str, Any] = {self._tag: getattr(self, self._tag)} if self._tag else {}
        for name, value in self._given().items():
            key = _key(name)
            if key in self._tables and isinstance(value, Shared):
                data[key] = tables.name(self._tables[key], value)
            elif name not in self._own:
                data[key] = plain(value, tables)
        return data

    def _given(self) -> dict[str, Any]:
        """Attributes that are not left out."""
        items = ((item.name, getattr(self, item.name)) for item in fields(self))
        return {name: value for name, value in items if value is not None}

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Part) or type(self) is not type(other):
            return NotImplemented
        return same(self._given(), other._given())

    def __repr__(self) -> str:
        items = (f"{name}={value!r}" for name, value in self._given().items())
        return f"{type(self).__name__}({', '.join(items)})"


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Shared(Part):
    """A part that others refer to by name: the name is its key in a table of the model.

    Attributes
    ----------
    name
        Key in the model's table, for a part that is given in the place of its name; found by itself if left out.

    """

    _own: ClassVar[frozenset[str]] = frozenset({"name"})

    name: str | None = field(default=None, kw_only=False)


def plain(value: Any, tables: Tables) -> Any:
    """Plain data of parts, arrays and all that holds them."""
    if isinstance(value, Part):
        return value._plain(tables)
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, Mapping):
        return {key: plain(item, tables) for key, item in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [plain(item, tables) for item in value]
    return value


def typed(hint: Any, data: Any) -> Any:
    """Plain data as parts of the classes that a type hint allows."""
    arms = _arms(hint)
    if isinstance(data, Mapping):
        for part in _parts(arms):
            if part._fits(data):
                return part._of(data)
        for arm in arms:
            if typing.get_origin(arm) is Mapping:
                return {key: typed(typing.get_args(arm)[1], item) for key, item in data.items()}
    if isinstance(data, list | tuple):
        for arm in arms:
            if typing.get_origin(arm) is Sequence:
                return [typed(typing.get_args(arm)[0], item) for item in data]
    return data


def misplaced(hint: Any, value: Any, path: str) -> str | None:
    """Where another part is given than a type hint allows, in words."""
    arms = _arms(hint)
    if isinstance(value, Part):
        wanted = _parts(arms)
        if not wanted or isinstance(value, wanted):
            return None
        return f"{path}: found a {type(value).__name__}, wanted a {' or '.join(part.__name__ for part in wanted)}"
    lines: list[str | None] = []
    for arm in arms:
        # Whether numbers are numbers is seen by the engine.
        if (
            typing.get_origin(arm) is Sequence
            and typing.get_args(arm) != (float,)
            and isinstance(value, list | tuple)
        ):
            item = typing.get_args(arm)[0]
            lines += [misplaced(item, part, f"{path}[{i}]") for i, part in enumerate(value)]
        if typing.get_origin(arm) is Mapping and isinstance(value, Mapping):
            item = typing.get_args(arm)[1]
            lines += [misplaced(item, part, f"{path}.{key}") for key, part in value.items()]
    return "\n".join(filter(None, lines)) or None


def same(one: Any, other: Any) -> bool:
    """Whether two values are equal; lists, tuples and arrays of the same numbers are."""
    if isinstance(one, Part):
        return bool(one == other)
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return one.keys() == other.keys() and all(same(item, other[key]) for key, item in one.items())
    if _is_row(one) and _is_row(other):
        return len(one) == len(other) and all(same(a, b) for a, b in zip(one, other, strict=True))
    return bool(one == other)


def _is_row(value: Any) -> bool:
    return isinstance(value, Sequence | np.ndarray) and not isinstance(value, str)


def _arms(hint: Any) -> tuple[Any, ...]:
    """The alternatives of a type hint."""
    return typing.get_args(hint) if typing.get_origin(hint) in (typing.Union, types.UnionType) else (hint,)


def _parts(arms: tuple[Any, ...]) -> tuple[type[Part], ...]:
    """The classes of parts among alternatives."""
    return tuple(arm for arm in arms if isinstance(arm, type) and issubclass(arm, Part))


def _key(name: str) -> str:
    """The key of an attribute; those that are words of Python end with an underscore."""
    return name.rstrip("_")


_KNOWN: dict[type[Part], dict[str, Any]] = {}


def _hints(part: type[Part]) -> dict[str, Any]:
    """Type hints of the attributes that are keys."""
    if part not in _KNOWN:
        hints = typing.get_type_hints(part)
        _KNOWN[part] = {item.name: hints[item.name] for item in fields(part) if item.name not in part._own}
    return _KNOWN[part]
