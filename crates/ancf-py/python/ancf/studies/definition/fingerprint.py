"""Keys of cases: hashes of all inputs of a case."""

from __future__ import annotations

import functools
import hashlib
import json
import types
import uuid
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np

DESCRIPTORS = (
    types.GetSetDescriptorType
    | types.MemberDescriptorType
    | types.MethodDescriptorType
    | types.WrapperDescriptorType
)
"""Attributes implemented in C, which are described by their names."""

NOT_BODY = {"_abc_impl", "__dict__", "__doc__", "__module__", "__weakref__", "__dataclass_params__"}
NOT_BODY |= {"__annotate__", "__annotate_func__", "__annotations__", "__annotations_cache__"}
NOT_BODY |= {
    "__dataclass_fields__",
    "__firstlineno__",
    "__orig_bases__",
    "__slotnames__",
    "__static_attributes__",
}
"""Attributes of a class without effect on results, or described by its functions."""


def key(data: Mapping[str, Any], definition: Any) -> str:
    """Return a hash of the data of a model without its title, and of the objectives."""
    decisive = {name: value for name, value in data.items() if name != "title"}
    text = json.dumps([describe(decisive), definition], sort_keys=True)
    return hashlib.blake2b(text.encode(), digest_size=16).hexdigest()


def describe(value: Any) -> Any:
    """Describe a value, also a function, as plain data. Objects without a description get a unique one.

    A function is described by its name, its compiled code, its defaults and the global and enclosing names that it
    uses, except modules, and functions and classes of other modules. A class of the module of the function is
    described by its body, an object by its class and its state.
    """
    return Describer().describe(value)


class Describer:
    """Recursive description of a value."""

    def __init__(self) -> None:
        """Start without described values."""
        self._enclosing: list[Any] = []
        self._module: str | None = None
        self._described: list[Any] = []

    def describe(self, value: Any) -> Any:
        """Describe a value. Classes of the module of the outermost function or object are described by their bodies."""
        if value is None or isinstance(value, bool | int | float | str):
            return value
        if any(value is item for item in self._enclosing):
            return "itself"
        module = self._module
        self._enclosing.append(value)
        try:
            return self._describe(value)
        except Exception:  # The error depends on the object.
            return uuid.uuid4().hex
        finally:
            self._enclosing.pop()
            self._module = module

    def _describe(self, value: Any) -> Any:
        if isinstance(value, np.ndarray | np.generic) and value.dtype.names is None:
            return self.describe(value.tolist())
        if isinstance(value, Mapping):
            return {str(name): self.describe(value[name]) for name in sorted(value, key=str)}
        if isinstance(value, list | tuple):
            return self._items(value)
        if isinstance(value, set | frozenset):
            return ["set", *sorted(json.dumps(self.describe(item), sort_keys=True) for item in value)]
        if isinstance(value, types.FunctionType):
            return self._once(value, self._function)
        if isinstance(value, types.CodeType):
            return self._code(value)
        if isinstance(value, type):
            is_own = value.__module__ == self._module
            return self._once(value, self._class) if is_own else qualified_name(value)
        return self._object(value)

    def _items(self, values: Iterable[Any]) -> list[Any]:
        return [self.describe(item) for item in values]

    def _once(self, value: Any, method: Any) -> Any:
        """Describe a value that may occur several times, at its first occurrence."""
        number = next((i for i, item in enumerate(self._described) if item is value), None)
        if number is not None:
            return f"{qualified_name(value)}, body {number}"
        self._described.append(value)
        return method(value)

    def _function(self, value: types.FunctionType) -> dict[str, Any]:
        """Describe a function by its code and its environment."""
        self._module = self._module or value.__module__
        closure = [cell.cell_contents for cell in value.__closure__ or () if is_filled(cell)]
        around = {
            name: value.__globals__[name] for name in names(value.__code__) if name in value.__globals__
        }
        return {
            "name": qualified_name(value),
            "code": self._code(value.__code__),
            "defaults": self.describe([value.__defaults__, value.__kwdefaults__]),
            "closure": self.describe(closure),
            "attributes": self.describe(vars(value)),
            "around": {
                name: self.describe(item)
                for name, item in sorted(around.items())
                if not is_foreign(item, value.__module__)
            },
        }

    def _code(self, value: types.CodeType) -> list[Any]:
        """Describe compiled code without its position in the file."""
        return [value.co_code.hex(), list(value.co_names), self._items(value.co_consts)]

    def _class(self, value: type) -> dict[str, Any]:
        """Describe a class by its bases, functions and data."""
        body = {name: item for name, item in sorted(vars(value).items()) if name not in NOT_BODY}
        plain = {
            n: qualified_name(x) if is_foreign(x, value.__module__) else self.describe(x)
            for n, x in body.items()
        }
        return {"class": qualified_name(value), "bases": self._items(value.__bases__), "body": plain}

    def _object(self, value: Any) -> Any:
        """Describe any other object by its name or its state."""
        if isinstance(value, types.MethodType):
            owner = value.__self__ if isinstance(value.__self__, type) else type(value.__self__)
            self._module = self._module or owner.__module__
            return [self.describe(value.__func__), self.describe(value.__self__)]
        if isinstance(value, staticmethod | classmethod):
            return [type(value).__name__, self.describe(value.__func__)]
        if isinstance(value, property):
            return ["property", *self._items([value.fget, value.fset, value.fdel])]
        if isinstance(value, functools.cached_property):
            return ["property", self.describe(value.func)]
        if isinstance(value, functools.partial):
            return ["partial", *self._items([value.func, value.args, value.keywords])]
        if isinstance(value, types.ModuleType | np.ufunc):
            return value.__name__
        if isinstance(value, DESCRIPTORS) or is_function(value):
            return [qualified_name(value), self.describe(getattr(value, "__wrapped__", None))]
        if isinstance(value, bytes | bytearray | complex) or value is Ellipsis:
            return repr(value)
        return self._state(value)

    def _state(self, value: Any) -> list[Any]:
        """Describe an object by its pickled state and its class."""
        self._module = self._module or type(value).__module__
        if type(value) is object:
            raise TypeError("an object without a state has no description")
        reduced = value.__reduce_ex__(4)
        if isinstance(reduced, str):
            return [reduced, self.describe(getattr(value, "__wrapped__", None))]
        make, *state = reduced
        parts = [list(part) if isinstance(part, Iterator) else part for part in state]
        return [self.describe(type(value)), qualified_name(make), *self._items(parts)]


def names(value: types.CodeType) -> Iterator[str]:
    """Return the names that code looks up, including nested code."""
    yield from value.co_names
    for item in value.co_consts:
        if isinstance(item, types.CodeType):
            yield from names(item)


def qualified_name(value: Any) -> str:
    """Return the name of a function or a class."""
    return f"{getattr(value, '__module__', '')}.{getattr(value, '__qualname__', value.__name__)}"


def is_function(value: Any) -> bool:
    """Return True for a function in any language that is not bound to an object."""
    bound = getattr(value, "__self__", None)
    return hasattr(value, "__qualname__") and (bound is None or isinstance(bound, types.ModuleType))


def is_foreign(item: Any, module: str) -> bool:
    """Return True if a name in the environment of a function is a module, or belongs to another module."""
    if isinstance(item, types.ModuleType | np.ufunc):
        return True
    return is_function(item) and item.__module__ != module


def is_filled(cell: types.CellType) -> bool:
    """Return True if a variable of a closure has a value."""
    try:
        _ = cell.cell_contents
    except ValueError:
        return False
    return True
