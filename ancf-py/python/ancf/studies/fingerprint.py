"""Keys of cases: hashes of all that decides their results."""

from __future__ import annotations

import functools
import hashlib
import json
import pickle
import types
import uuid
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np


def key(data: Mapping[str, Any], definition: Any) -> str:
    """A hash of the data of a model, but its title, and of what the objectives are."""
    decisive = {name: value for name, value in data.items() if name != "title"}
    text = json.dumps([told(decisive), definition], sort_keys=True)
    return hashlib.blake2b(text.encode(), digest_size=16).hexdigest()


def told(value: Any, above: tuple[int, ...] = ()) -> Any:
    """A value as plain data, functions too; what cannot be told is never the same twice.

    A function is told by its name, its compiled code, its defaults and what it takes from around it: numbers,
    texts, arrays and other functions of its module. `above` are the objects that it is told within.
    """
    if value is None or isinstance(value, bool | int | float | str):
        return value
    if id(value) in above:
        return "itself"
    above = (*above, id(value))
    if isinstance(value, np.ndarray | np.generic):
        return told(value.tolist(), above)
    if isinstance(value, Mapping):
        return {str(name): told(item, above) for name, item in value.items()}
    if isinstance(value, list | tuple):
        return [told(item, above) for item in value]
    if isinstance(value, set | frozenset):
        return sorted(json.dumps(told(item, above)) for item in value)
    if isinstance(value, types.FunctionType):
        return function(value, above)
    if isinstance(value, types.MethodType):
        return [told(value.__func__, above), told(value.__self__, above)]
    if isinstance(value, functools.partial):
        return ["partial", *(told(item, above) for item in (value.func, value.args, value.keywords))]
    if isinstance(value, types.CodeType):
        return code(value, above)
    return object_of(value)


def function(value: types.FunctionType, above: tuple[int, ...]) -> dict[str, Any]:
    """A function by what it does."""
    closure = [cell.cell_contents for cell in value.__closure__ or () if is_filled(cell)]
    around = {name: value.__globals__[name] for name in names(value.__code__) if name in value.__globals__}
    return {
        "name": f"{value.__module__}.{value.__qualname__}",
        "code": code(value.__code__, above),
        "defaults": told([value.__defaults__, value.__kwdefaults__], above),
        "closure": told(closure, above),
        "around": {
            name: told(item, above) for name, item in around.items() if is_own(item, value.__module__)
        },
    }


def code(value: types.CodeType, above: tuple[int, ...]) -> list[Any]:
    """Compiled code; where it stands in a file does not matter."""
    return [value.co_code.hex(), list(value.co_names), [told(item, above) for item in value.co_consts]]


def names(value: types.CodeType) -> Iterator[str]:
    """The names that code looks up, that within it too."""
    yield from value.co_names
    for item in value.co_consts:
        if isinstance(item, types.CodeType):
            yield from names(item)


def is_own(item: Any, module: str) -> bool:
    """Whether what a function finds around it is data or a function of its own module."""
    if isinstance(item, types.FunctionType):
        return item.__module__ == module
    return isinstance(item, bool | int | float | str | list | tuple | dict | np.ndarray | np.generic)


def is_filled(cell: types.CellType) -> bool:
    """Whether a variable of a closure has a value yet."""
    try:
        _ = cell.cell_contents
    except ValueError:
        return False
    return True


def object_of(value: Any) -> str:
    """Any other object, by its name or its state."""
    if isinstance(value, type | types.BuiltinFunctionType | types.ModuleType | np.ufunc):
        return f"{getattr(value, '__module__', '')}.{value.__name__}"
    if isinstance(value, bytes | complex) or value is Ellipsis:
        return repr(value)
    try:
        return hashlib.blake2b(pickle.dumps(value), digest_size=16).hexdigest()
    except Exception:  # Any object may refuse in its own way.
        return uuid.uuid4().hex
