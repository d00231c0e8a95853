"""Places in a model that parameters set, and conflicts between parameters."""

from __future__ import annotations

from itertools import permutations, product
from typing import TYPE_CHECKING, Any

from ancf import _ancf
from ancf.errors import ModelError

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

NOTHING = "\0"
"""A value that is not the name of anything."""

Places = dict[str, list[str]]
"""Places that each parameter sets, by its path."""


def conflicts(model: Mapping[str, Any], places: Places) -> Iterator[tuple[str, str, str, str | None]]:
    """Return parameters that overwrite or redirect another one: path, found, wanted, hint."""
    order = list(places)
    for path, other in permutations(order, 2):
        if pair := overlap(places[path], places[other]):
            if order.index(other) < order.index(path):
                yield path, *overlap_message(pair, other)
        elif is_redirected(model, path, other, places[path]):
            found = f"a path through what `{other}` sets"
            hint = f"such as `{places[path][0]}`" if places[path] else None
            yield path, found, "a path that leads to the same place in every case", hint


def overlap(mine: Sequence[str], others: Sequence[str]) -> tuple[str, str] | None:
    """Return the first two places of which one is equal to or part of the other."""
    pairs = product(mine, others)
    return next(((one, two) for one, two in pairs if within(one, two) or within(two, one)), None)


def overlap_message(pair: tuple[str, str], other: str) -> tuple[str, str, str | None]:
    """Return found, wanted and hint for a place that another parameter sets as a whole or in part."""
    mine, its = pair
    what = f"which `{other}` sets too" if within(mine, its) else f"of which `{other}` sets a part"
    hint = None if mine == its else "give the whole with its parts, or the parts alone"
    return f"`{mine}`, {what}", "every place to be set once", hint


def is_redirected(model: Mapping[str, Any], path: str, other: str, places: Sequence[str]) -> bool:
    """Return True if a path has another target once another parameter has a value that names nothing."""
    try:
        changed, _ = _ancf.substitute(model, other, NOTHING)
    except ModelError:
        return False
    try:
        return _ancf.substitute(changed, path, NOTHING)[1] != places
    except ModelError:
        return True


def within(place: str, whole: str) -> bool:
    """Return True if a place is equal to or part of another."""
    return place == whole or place.startswith((f"{whole}.", f"{whole}["))
