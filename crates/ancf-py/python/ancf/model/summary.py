"""Summaries of models as text and as HTML."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from reprlib import Repr
from typing import Any

import numpy as np

from ancf.display.tables import Table, collapsible, joined, representation, titled
from ancf.model.base.part import Part
from ancf.model.base.places import Ground, Place

LISTS = ("bodies", "joints", "couplings", "loads", "contacts", "probes")
"""Keys of a model with lists of parts."""

TABLES = ("sections", "materials")
"""Keys of a model with named parts."""

MAX_OPEN = 12
"""Maximum number of parts of a list that is not collapsed."""

SHORT = Repr()
SHORT.maxstring = SHORT.maxother = 30
SHORT.maxlist = SHORT.maxtuple = 4
"""Short representations of values."""


def text(model: Any) -> str:
    """Return the number and the names of the parts of a model, and its analysis, in a few lines."""
    rows = _settings(model)
    rows += [
        [key, counted(parts_of(getattr(model, key)))] for key in (*LISTS, *TABLES) if getattr(model, key)
    ]
    rows.append(["analysis", line(model.analysis)])
    title = f' "{model.title}"' if model.title else ""
    return f"Model{title}\n{Table(('', ''), rows, names=2).text('  ')}"


def html(model: Any) -> str:
    """Return the representation of a model in notebooks: a table of each list of parts."""
    parts = [
        titled("Model", model.title or ""),
        Table(("", ""), [*_settings(model), ["analysis", line(model.analysis)]], names=2).html(),
    ]
    for key in (*LISTS, *TABLES):
        named = parts_of(getattr(model, key))
        if named:
            inner = Table(
                ("name", "class", "data"), [_cells(name, part) for name, part in named], names=3
            ).html()
            parts.append(
                collapsible(
                    f"{key} ({len(named)})", inner, is_open=key == "bodies" and len(named) <= MAX_OPEN
                )
            )
    return representation(parts)


def _settings(model: Any) -> list[list[str]]:
    rows = []
    if model.units is not None:
        rows.append(
            ["units", ", ".join(str(getattr(model.units, key)) for key in ("length", "time", "force"))]
        )
    if model.gravity is not None:
        rows.append(["gravity", short(model.gravity)])
    return rows


def parts_of(parts: Sequence[Any] | Mapping[str, Any] | None) -> list[tuple[str, Any]]:
    """Return the parts of a list or a table with their names, which may be empty."""
    if isinstance(parts, Mapping):
        return list(parts.items())
    return [(_name(part), part) for part in parts or ()]


def _name(part: Any) -> str:
    name = part.get("name") if isinstance(part, Mapping) else getattr(part, "name", None)
    return name if isinstance(name, str) else ""


def _class(part: Any) -> str:
    return type(part).__name__


def counted(named: Sequence[tuple[str, Any]]) -> str:
    """Return the number of parts of each class, and the names."""
    classes = [_class(part) for _, part in named]
    counts = ", ".join(f"{classes.count(one)} {one}" for one in dict.fromkeys(classes))
    names = [name for name, _ in named if name]
    return f"{counts}: {joined(names)}" if names else counts


def line(part: Any) -> str:
    """Return a part without its name in one line."""
    return f"{_class(part)}({data(part)})" if isinstance(part, Part) else short(part)


def data(part: Any) -> str:
    """Return the values of a part without its name."""
    if not isinstance(part, Part):
        return short(part)
    return ", ".join(f"{key}={short(value)}" for key, value in part._given().items() if key != "name")


def _cells(name: str, part: Any) -> list[str]:
    return [name, _class(part), data(part)]


def short(value: Any) -> str:
    """Return a short representation of a value. Places and named parts are represented by their names."""
    if isinstance(value, Place):
        return (
            f"{value.body}.{value.at}" if isinstance(value.at, str) else f"{value.body}.at({short(value.at)})"
        )
    if isinstance(value, Ground):
        return f"ground at {short(value.point)}"
    if isinstance(value, Part):
        return f'"{_name(value)}"' if _name(value) else line(value)
    if isinstance(value, np.ndarray | np.generic):
        value = value.tolist()
    if callable(value):
        return getattr(value, "__qualname__", type(value).__name__)
    return SHORT.repr(value)
