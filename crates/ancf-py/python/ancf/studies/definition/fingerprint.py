"""Keys of cases: hashes of all that decides their results."""

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
"""What classes have of C, which is told by its name."""

NOT_BODY = {"_abc_impl", "__dict__", "__doc__", "__module__", "__weakref__", "__dataclass_params__"}
NOT_BODY |= {"__annotate__", "__annotate_func__", "__annotations__", "__annotations_cache__"}
NOT_BODY |= {
    "__dataclass_fields__",
    "__firstlineno__",
    "__orig_bases__",
    "__slotnames__",
    "__static_attributes__",
}
"""What decides nothing in the body of a class, or is told by its functions too."""


def key(data: Mapping[str, Any], definition: Any) -> str:
    """A hash of the data of a model, but its title, and of what the objectives are."""
    decisive = {name: value for name, value in data.items() if name != "title"}
    text = json.dumps([told(decisive), definition], sort_keys=True)
    return hashlib.blake2b(text.encode(), digest_size=16).hexdigest()


def told(value: Any) -> Any:
    """A value as plain data, functions too; what cannot be told is never the same twice.

    A function is told by its name, its compiled code, its defaults and all that it takes from around it, but
    modules, and functions and classes of other modules. A class of its module is told by its body, an object by
    its class and its state.
    """
    return Teller().told(value)


class Teller:
    """What was told already, and within what the next value is told."""

    def __init__(self) -> None:
        """Nothing told yet."""
        self._above: list[Any] = []
        self._module: str | None = None
        self._bodies: list[Any] = []

    def told(self, value: Any) -> Any:
        """A value as plain data; classes of the module of the outermost function or object by their bodies."""
        if value is None or isinstance(value, bool | int | float | str):
            return value
        if any(value is item for item in self._above):
            return "itself"
        module = self._module
        self._above.append(value)
        try:
            return self._told(value)
        except Exception:  # Any object may refuse in its own way.
            return uuid.uuid4().hex
        finally:
            self._above.pop()
            self._module = module

    def _told(self, value: Any) -> Any:
        if isinstance(value, np.ndarray | np.generic) and value.dtype.names is None:
            return self.told(value.tolist())
        if isinstance(value, Mapping):
            return {str(name): self.told(value[name]) for name in sorted(value, key=str)}
        if isinstance(value, list | tuple):
            return self._items(value)
        if isinstance(value, set | frozenset):
            return ["set", *sorted(json.dumps(self.told(item), sort_keys=True) for item in value)]
        if isinstance(value, types.FunctionType):
            return self._once(value, self._function)
        if isinstance(value, types.CodeType):
            return self._code(value)
        if isinstance(value, type):
            is_own = value.__module__ == self._module
            return self._once(value, self._class) if is_own else named(value)
        return self._object(value)

    def _items(self, values: Iterable[Any]) -> list[Any]:
        return [self.told(item) for item in values]

    def _once(self, value: Any, tell: Any) -> Any:
        """What may be met on many ways, told on the first."""
        number = next((i for i, item in enumerate(self._bodies) if item is value), None)
        if number is not None:
            return f"{named(value)}, body {number}"
        self._bodies.append(value)
        return tell(value)

    def _function(self, value: types.FunctionType) -> dict[str, Any]:
        """A function by what it does."""
        self._module = self._module or value.__module__
        closure = [cell.cell_contents for cell in value.__closure__ or () if is_filled(cell)]
        around = {
            name: value.__globals__[name] for name in names(value.__code__) if name in value.__globals__
        }
        return {
            "name": named(value),
            "code": self._code(value.__code__),
            "defaults": self.told([value.__defaults__, value.__kwdefaults__]),
            "closure": self.told(closure),
            "attributes": self.told(vars(value)),
            "around": {
                name: self.told(item)
                for name, item in sorted(around.items())
                if not is_foreign(item, value.__module__)
            },
        }

    def _code(self, value: types.CodeType) -> list[Any]:
        """Compiled code; where it stands in a file does not matter."""
        return [value.co_code.hex(), list(value.co_names), self._items(value.co_consts)]

    def _class(self, value: type) -> dict[str, Any]:
        """A class by its bases, functions and data."""
        body = {name: item for name, item in sorted(vars(value).items()) if name not in NOT_BODY}
        plain = {n: named(x) if is_foreign(x, value.__module__) else self.told(x) for n, x in body.items()}
        return {"class": named(value), "bases": self._items(value.__bases__), "body": plain}

    def _object(self, value: Any) -> Any:
        """Any other object, by its name or its state."""
        if isinstance(value, types.MethodType):
            owner = value.__self__ if isinstance(value.__self__, type) else type(value.__self__)
            self._module = self._module or owner.__module__
            return [self.told(value.__func__), self.told(value.__self__)]
        if isinstance(value, staticmethod | classmethod):
            return [type(value).__name__, self.told(value.__func__)]
        if isinstance(value, property):
            return ["property", *self._items([value.fget, value.fset, value.fdel])]
        if isinstance(value, functools.cached_property):
            return ["property", self.told(value.func)]
        if isinstance(value, functools.partial):
            return ["partial", *self._items([value.func, value.args, value.keywords])]
        if isinstance(value, types.ModuleType | np.ufunc):
            return value.__name__
        if isinstance(value, DESCRIPTORS) or is_function(value):
            return [named(value), self.told(getattr(value, "__wrapped__", None))]
        if isinstance(value, bytes | bytearray | complex) or value is Ellipsis:
            return repr(value)
        return self._state(value)

    def _state(self, value: Any) -> list[Any]:
        """An object as it would be pickled, but with its class told too."""
        self._module = self._module or type(value).__module__
        if type(value) is object:
            raise TypeError("an object without a state is only told by what it is")
        reduced = value.__reduce_ex__(4)
        if isinstance(reduced, str):
            return [reduced, self.told(getattr(value, "__wrapped__", None))]
        make, *state = reduced
        parts = [list(part) if isinstance(part, Iterator) else part for part in state]
        return [self.told(type(value)), named(make), *self._items(parts)]


def names(value: types.CodeType) -> Iterator[str]:
    """The names that code looks up, that within it too."""
    yield from value.co_names
    for item in value.co_consts:
        if isinstance(item, types.CodeType):
            yield from names(item)


def named(value: Any) -> str:
    """The name of a function or a class."""
    return f"{getattr(value, '__module__', '')}.{getattr(value, '__qualname__', value.__name__)}"


def is_function(value: Any) -> bool:
    """Whether this is a function, in whatever language, that is bound to no object."""
    bound = getattr(value, "__self__", None)
    return hasattr(value, "__qualname__") and (bound is None or isinstance(bound, types.ModuleType))


def is_foreign(item: Any, module: str) -> bool:
    """Whether what a function finds around it is a module, or a function or a class of another module."""
    if isinstance(item, types.ModuleType | np.ufunc):
        return True
    return is_function(item) and item.__module__ != module


def is_filled(cell: types.CellType) -> bool:
    """Whether a variable of a closure has a value yet."""
    try:
        _ = cell.cell_contents
    except ValueError:
        return False
    return True
