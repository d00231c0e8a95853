"""The places in a model that parameters set, and parameters that are in each other's way."""

from __future__ import annotations

from itertools import permutations, product
from typing import TYPE_CHECKING, Any

from ancf import _ancf
from ancf.errors import ModelError

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

NOTHING = "\0"
"""A value that names nothing."""

Places = dict[str, list[str]]
"""The places that each parameter sets, by its path."""


def clashes(model: Mapping[str, Any], places: Places) -> Iterator[tuple[str, str, str, str | None]]:
    """Parameters of which one would undo, or turn elsewhere, what another sets: path, found, wanted, hint."""
    order = list(places)
    for path, other in permutations(order, 2):
        if pair := overlap(places[path], places[other]):
            if order.index(other) < order.index(path):
                yield path, *twice(pair, other)
        elif is_turned(model, path, other, places[path]):
            found = f"a path through what `{other}` sets"
            hint = f"such as `{places[path][0]}`" if places[path] else None
            yield path, found, "a path that leads to the same place in every case", hint


def overlap(mine: Sequence[str], others: Sequence[str]) -> tuple[str, str] | None:
    """The first two places of which one is the other or lies in it."""
    pairs = product(mine, others)
    return next(((one, two) for one, two in pairs if within(one, two) or within(two, one)), None)


def twice(pair: tuple[str, str], other: str) -> tuple[str, str, str | None]:
    """What is found, wanted and advised where another parameter sets the same place, the whole of it or a part."""
    mine, its = pair
    told = f"which `{other}` sets too" if within(mine, its) else f"of which `{other}` sets a part"
    hint = None if mine == its else "give the whole with its parts, or the parts alone"
    return f"`{mine}`, {told}", "every place to be set once", hint


def is_turned(model: Mapping[str, Any], path: str, other: str, places: Sequence[str]) -> bool:
    """Whether a path leads elsewhere once another parameter has a value that names nothing."""
    try:
        changed, _ = _ancf.substitute(model, other, NOTHING)
    except ModelError:
        return False
    try:
        return _ancf.substitute(changed, path, NOTHING)[1] != places
    except ModelError:
        return True


def within(place: str, whole: str) -> bool:
    """Whether a place is another or lies in it."""
    return place == whole or place.startswith((f"{whole}.", f"{whole}["))
