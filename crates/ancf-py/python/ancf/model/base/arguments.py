"""Arguments of the constructors of parts: messages that name the correct ones."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import MISSING, fields
from functools import wraps
from reprlib import Repr
from typing import Any, TypeVar

from ancf import _ancf

__all__ = ["checked_arguments", "label"]

T = TypeVar("T")

RADII = ("r", "radius")
"""Arguments whose value is half of a diameter."""

SHORT = Repr()
SHORT.maxstring = SHORT.maxother = 40
"""Short representations of values."""


def checked_arguments(part: type[T]) -> type[T]:
    """Check the names of the arguments before the class is built. The signature of the class remains."""
    init: Callable[..., None] = part.__init__
    arguments = Arguments(part)

    @wraps(init)
    def checked(self: T, *args: Any, **kwargs: Any) -> None:
        arguments.check(args, kwargs)
        init(self, *args, **kwargs)

    part.__init__ = checked  # type: ignore[method-assign, assignment]
    return part


def label(kind: str, name: object) -> str:
    """Return the class of a part with its name, if it has one."""
    return f'{kind} "{name}"' if isinstance(name, str) and name else kind


class Arguments:
    """Names of the arguments of a part."""

    def __init__(self, part: type[Any]) -> None:
        """Read the arguments of a dataclass."""
        self.part = part.__name__
        self.names = [item.name for item in fields(part)]
        self.positional = [item.name for item in fields(part) if not item.kw_only]
        self.required = [item.name for item in fields(part) if item.default is MISSING]
        self._known = frozenset(self.names)

    def check(self, args: Sequence[Any], kwargs: Mapping[str, Any]) -> None:
        """Raise a `TypeError` for unknown, surplus or missing arguments."""
        given = [*self.positional[: len(args)], *kwargs]
        is_complete = all(name in given for name in self.required)
        # A force function is given instead of its name.
        is_name = not args or isinstance(args[0], str | None) or callable(args[0])
        has_name = is_name or self.positional[:1] != ["name"]
        if is_complete and has_name and len(args) <= len(self.positional) and kwargs.keys() <= self._known:
            return
        raise TypeError("\n".join(self._errors(args, kwargs, has_name=has_name)))

    def _errors(self, args: Sequence[Any], kwargs: Mapping[str, Any], *, has_name: bool) -> list[str]:
        own = self.positional if has_name else []
        surplus, positional = args[len(own) :], dict(zip(own, args, strict=False))
        who = label(self.part, {**positional, **kwargs}.get("name"))
        unknown = {name: value for name, value in kwargs.items() if name not in self._known}
        free = [name for name in self.names if name not in positional and name not in kwargs]
        meant = {name: self._nearest(name, free) for name in unknown}
        covered = {*positional, *kwargs, *meant.values()}
        missing = [name for name in self.required if name not in covered]
        if surplus:
            values = ", ".join(map(SHORT.repr, surplus))
            known = {key: value for key, value in kwargs.items() if key in self._known}
            example = self._example(positional, surplus, known)
            found = f"positional argument{'s' * (len(surplus) > 1)} {values}"
            return [f"{who}: found the {found}, expected keywords, such as {example}"]
        lines = [self._unknown(who, name, value, meant[name]) for name, value in unknown.items()]
        if missing:
            lines.append(f"{who}: missing argument{'s' * (len(missing) > 1)} {listed(missing)}")
        return lines

    def _unknown(self, who: str, name: str, value: Any, meant: str | None) -> str:
        if meant is None:
            return f"{who}: unknown argument {name}; there are {listed(self.names)}"
        if name.lower() in RADII and meant == "diameter" and isinstance(value, int | float):
            return f"{who}: unknown argument {name}; did you mean diameter={2 * value:g}, twice the radius?"
        return f"{who}: unknown argument {name}; did you mean {meant}={SHORT.repr(value)}?"

    @staticmethod
    def _nearest(name: str, free: Sequence[str]) -> str | None:
        """Return the free argument that a name means. Python keywords end with an underscore as arguments."""
        by_key = {argument.rstrip("_"): argument for argument in free}
        found = _ancf.nearest(name.rstrip("_"), list(by_key))
        return None if found is None else by_key[found]

    def _example(
        self, positional: Mapping[str, Any], surplus: Sequence[Any], known: Mapping[str, Any]
    ) -> str:
        """Return a call in which surplus positional arguments are the first required keywords."""
        free = [name for name in self.required if name not in positional and name not in known]
        keywords = dict(zip(free, map(SHORT.repr, surplus), strict=False))
        keywords |= dict.fromkeys(free[len(surplus) :], "...")
        keywords |= {name: SHORT.repr(value) for name, value in known.items()}
        items = [
            *map(SHORT.repr, positional.values()),
            *(f"{name}={text}" for name, text in keywords.items()),
        ]
        return f"{self.part}({', '.join(items)})"


def listed(names: Iterable[str]) -> str:
    """Return names separated by commas and `and`."""
    *first, last = names
    return f"{', '.join(first)} and {last}" if first else last
