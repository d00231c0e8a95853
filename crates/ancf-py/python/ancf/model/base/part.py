"""Base class of all parts of a model."""

from __future__ import annotations

import types
import typing
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from typing import Any, ClassVar, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from ancf import _ancf
from ancf.model.base.arguments import checked_arguments, label
from ancf.model.base.tables import Tables

__all__ = ["ForceFunction", "LawFunction", "Numbers", "Part", "PointGrid", "Points", "Shared", "Vector"]

Numbers: TypeAlias = Sequence[float] | NDArray[Any]
"""A sequence of numbers."""
Vector: TypeAlias = Sequence[float] | NDArray[Any]
"""Three components in the global frame."""
Points: TypeAlias = Sequence[Vector] | NDArray[Any]
"""A sequence of points, three components each."""
PointGrid: TypeAlias = Sequence[Points] | NDArray[Any]
"""Rows of points, three components each."""
ForceFunction: TypeAlias = Callable[[float, NDArray[Any], NDArray[Any]], Vector]
"""Force as a function of time, position and velocity of its point."""
LawFunction: TypeAlias = Callable[[float, float, float], float | tuple[float, float, float]]
"""Force of a law as a function of time, coordinate and rate; or force and its derivatives by coordinate and rate."""

P = TypeVar("P", bound="Part")


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Part:
    """A part of a model. Its attributes are its keys in a model file.

    Omitted attributes are ``None`` and take the default value of the program. A part is checked when it is built;
    the whole model is checked when it is run.

    Raises
    ------
    ModelError
        If the part is invalid, with all errors.
    TypeError
        If a part of another class is given than expected, or an argument is unknown or missing.

    """

    # Definition of the part in the schema. Key whose word, a class constant, selects the form of the definition.
    _form: ClassVar[str] = ""
    _tag: ClassVar[str | None] = None
    # Keys that refer to a table of the model by name and accept the part itself.
    _tables: ClassVar[Mapping[str, str]] = {}
    # Attributes that are not keys of the schema.
    _own: ClassVar[frozenset[str]] = frozenset()
    # Expressions for places on the part after its name.
    _places: ClassVar[Sequence[str]] = ()

    def __post_init__(self) -> None:
        hints = _hints(type(self))
        found = [
            misplaced(hints[name], value, name) for name, value in self._given().items() if name in hints
        ]
        if any(found):
            raise TypeError(
                "\n".join(self._prefixed(line) for text in filter(None, found) for line in text.splitlines())
            )
        _ancf.check_part(self._form, self.to_dict(), self._label())

    def _label(self) -> str | None:
        """Return the class and the name of the part for messages."""
        return label(type(self).__name__, getattr(self, "name", None))

    def _prefixed(self, message: str) -> str:
        part = self._label()
        return message if part is None else f"{part}: {message}"

    def to_dict(self) -> dict[str, Any]:
        """Return plain data as in a model file. Omitted keys stay omitted, callables stay callables."""
        return self._plain(Tables())

    @classmethod
    def from_dict(cls: type[P], data: Mapping[str, Any]) -> P:
        """Build a part from plain data as in a model file. Raises `ModelError` with all errors."""
        tag = {cls._tag: getattr(cls, cls._tag)} if cls._tag else {}
        data = {**tag, **data}
        _ancf.check_part(cls._form, plain(data, Tables()))
        if not cls._fits(data):
            raise ValueError(f"these are not the data of a {cls.__name__}")
        return cls._of(data)

    @classmethod
    def _fits(cls, data: Mapping[str, Any]) -> bool:
        """Return True if data belong to this class among the forms of its definition."""
        if cls._tag:
            return bool(data.get(cls._tag) == getattr(cls, cls._tag))
        return {_key(name) for name in _hints(cls)} >= data.keys()

    @classmethod
    def _of(cls: type[P], data: Mapping[str, Any]) -> P:
        """Build a part from data that belong to this class."""
        given = {name: (hint, data.get(_key(name))) for name, hint in _hints(cls).items()}
        return cls(**{name: typed(hint, item) for name, (hint, item) in given.items() if item is not None})

    def _plain(self, tables: Tables) -> dict[str, Any]:
        """Return plain data. Parts given instead of names are added to the tables."""
        data: dict[str, Any] = {self._tag: getattr(self, self._tag)} if self._tag else {}
        for name, value in self._given().items():
            key = _key(name)
            if key in self._tables and isinstance(value, Shared):
                data[key] = tables.name(self._tables[key], value)
            elif name not in self._own:
                data[key] = plain(value, tables)
        return data

    def _given(self) -> dict[str, Any]:
        """Return the attributes that are not omitted."""
        items = ((item.name, getattr(self, item.name)) for item in fields(self))
        return {name: value for name, value in items if value is not None}

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Part) or type(self) is not type(other):
            return NotImplemented
        return same(self._given(), other._given())

    def __repr__(self) -> str:
        items = (f"{name}={value!r}" for name, value in self._given().items())
        return f"{type(self).__name__}({', '.join(items)})"


@checked_arguments
@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Shared(Part):
    """A part to which others refer by name. The name is its key in a table of the model.

    Attributes
    ----------
    name
        Key in the table of the model, for a part that is given instead of its name. Chosen automatically if
        omitted.

    """

    _own: ClassVar[frozenset[str]] = frozenset({"name"})

    name: str | None = field(default=None, kw_only=False)


def plain(value: Any, tables: Tables) -> Any:
    """Convert parts, arrays and their containers to plain data."""
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
    """Convert plain data to parts of the classes that a type hint allows."""
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
    """Describe the parts of other classes than a type hint allows, and values instead of parts."""
    arms = _arms(hint)
    expected = _parts(arms)
    if isinstance(value, Part):
        return _misplaced_part(arms, value, path)
    if expected and isinstance(value, str | int | float) and not _accepts(arms, value):
        words = [repr(word) for arm in arms for word in _words(arm)]
        near = [f'Place("{value}", "end")'] if _is_place(expected) and isinstance(value, str) else []
        return f"{path}: found {value!r}, expected {alternatives([*words, *_classes(expected)])}{meant(near)}"
    lines: list[str | None] = []
    for arm in arms:
        # The engine checks numbers.
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


def _misplaced_part(arms: tuple[Any, ...], value: Part, path: str) -> str | None:
    """Describe a part of another class than the alternatives of a type hint."""
    expected = _parts(arms)
    found = f"{path}: found {with_article(type(value))}, expected"
    if not expected:
        is_list = any(
            typing.get_origin(arm) is Sequence and _parts(_arms(typing.get_args(arm)[0])) for arm in arms
        )
        return f"{found} a list of parts{meant([f'{path}=[...]'])}" if is_list else None
    if isinstance(value, expected):
        return None
    near = _places_on(value) if _is_place(expected) else []
    return f"{found} {alternatives(_classes(expected))}{meant(near)}"


def _is_place(parts: Sequence[type[Part]]) -> bool:
    """Return True if a place on a body is among the classes."""
    return any(part.__name__ == "Place" for part in parts)


def _accepts(arms: tuple[Any, ...], value: object) -> bool:
    """Return True if a text or a number is among the alternatives of a type hint. The engine checks its value."""
    if isinstance(value, str):
        return str in arms or any(value in _words(arm) for arm in arms) or not all(map(_is_certain, arms))
    return float in arms or int in arms or bool in arms or not all(map(_is_certain, arms))


def _is_certain(arm: Any) -> bool:
    """Return True for a class of parts, for words and for None."""
    return arm is types.NoneType or typing.get_origin(arm) is typing.Literal or bool(_parts((arm,)))


def _words(arm: Any) -> tuple[Any, ...]:
    """Return the words of a type hint."""
    return typing.get_args(arm) if typing.get_origin(arm) is typing.Literal else ()


def meant(near: Sequence[str]) -> str:
    """Return a hint with texts that were probably meant."""
    return f"; did you mean {alternatives(near)}?" if near else ""


def _classes(parts: Sequence[type[Part]]) -> list[str]:
    """Return the names of classes, the first with an article."""
    return [with_article(parts[0]), *(part.__name__ for part in parts[1:])]


def with_article(part: type[Part]) -> str:
    """Return the name of a class with an article."""
    return f"{'an' if part.__name__[0] in 'AEIO' else 'a'} {part.__name__}"


def alternatives(items: Sequence[str]) -> str:
    """Return texts separated by commas and `or`."""
    *first, last = items
    return f"{', '.join(first)} or {last}" if first else last


def _places_on(part: Part) -> list[str]:
    """Return expressions for the places on a body, with its name as variable if possible."""
    name = getattr(part, "name", None)
    variable = name if isinstance(name, str) and name.isidentifier() else type(part).__name__.lower()
    return [f"{variable}.{place}" for place in part._places]


def same(one: Any, other: Any) -> bool:
    """Compare two values. Lists, tuples and arrays of the same numbers are equal."""
    if isinstance(one, Part):
        return bool(one == other)
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return one.keys() == other.keys() and all(same(item, other[key]) for key, item in one.items())
    if _is_sequence(one) and _is_sequence(other):
        return len(one) == len(other) and all(same(a, b) for a, b in zip(one, other, strict=True))
    return bool(one == other)


def _is_sequence(value: Any) -> bool:
    return isinstance(value, Sequence | np.ndarray) and not isinstance(value, str)


def _arms(hint: Any) -> tuple[Any, ...]:
    """Return the alternatives of a type hint."""
    return typing.get_args(hint) if typing.get_origin(hint) in (typing.Union, types.UnionType) else (hint,)


def _parts(arms: tuple[Any, ...]) -> tuple[type[Part], ...]:
    """Return the part classes among alternatives."""
    return tuple(arm for arm in arms if isinstance(arm, type) and issubclass(arm, Part))


def _key(name: str) -> str:
    """Return the key of an attribute. Python keywords end with an underscore as attributes."""
    return name.rstrip("_")


_KNOWN: dict[type[Part], dict[str, Any]] = {}


def _hints(part: type[Part]) -> dict[str, Any]:
    """Return the type hints of the attributes that are keys."""
    if part not in _KNOWN:
        hints = typing.get_type_hints(part)
        _KNOWN[part] = {item.name: hints[item.name] for item in fields(part) if item.name not in part._own}
    return _KNOWN[part]
