"""Messages about unknown names."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches


def unknown_name(what: str, name: str, known: Sequence[str]) -> str:
    """Return the message for an unknown name, with the closest known name as a hint."""
    near = get_close_matches(name, known, n=1)
    hint = f"; did you mean {near[0]!r}?" if near else f"; there are {', '.join(map(repr, known)) or 'none'}"
    return f"no {what} {name!r}{hint}"
