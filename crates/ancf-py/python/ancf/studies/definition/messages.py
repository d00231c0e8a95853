"""Errors of a study, in the format of the engine."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from difflib import get_close_matches
from typing import Any, TypeGuard

import numpy as np

from ancf.errors import Fault

MAX_SHOWN = 40
"""Maximum length of a value in a message."""


def fault(path: str, found: str, expected: str, hint: str | None = None) -> Fault:
    """Create an error of a study."""
    text = f"{path}: found {found}, expected {expected}" + (f" ({hint})" if hint else "")
    return Fault(path, found, expected, hint, None, text)


def choice_fault(name: str, word: object, words: Iterable[str]) -> Fault | None:
    """Return the error of a word that is not among the allowed ones."""
    if isinstance(word, str) and word in words:
        return None
    return fault(name, shown(word), listed(words), near(word, words) if isinstance(word, str) else None)


def key_faults(path: str, data: object) -> list[Fault]:
    """Return the errors of data that must be a dictionary with texts as keys."""
    if not isinstance(data, Mapping):
        return [fault(path, shown(data), "a dictionary")]
    return [
        fault(path, f"the name {shown(key)}", "texts as names") for key in data if not isinstance(key, str)
    ]


def with_text_keys(data: object) -> Mapping[str, Any]:
    """Return the items whose keys are texts. Other data than a dictionary have none."""
    if not isinstance(data, Mapping):
        return {}
    return {key: value for key, value in data.items() if isinstance(key, str)}


def is_integer(value: object, least: int) -> TypeGuard[int]:
    """Return True for an integer of Python or NumPy that is not too small."""
    return isinstance(value, int | np.integer) and not isinstance(value, bool) and int(value) >= least


def integer_fault(name: str, value: object, least: int, most: int) -> Fault | None:
    """Return the error of a value that is not an integer in a range."""
    if is_integer(value, least) and int(value) <= most:
        return None
    return fault(name, shown(value), f"an integer from {least} to {most}")


def parameter_path(path: str) -> str:
    """Return the path of a parameter in the statement of the study."""
    return join("parameters", path)


def join(path: str, name: str) -> str:
    """Join a path and a name. Names with other characters than letters, digits, `_` and `-` are quoted."""
    is_bare = name.isascii() and name.replace("_", "").replace("-", "").isalnum()
    return f"{path}.{name}" if is_bare else f"{path}.{json.dumps(name, ensure_ascii=False)}"


def quoted(word: object) -> str:
    """Return a word in quotes."""
    return f'"{word}"'


def listed(words: Iterable[str]) -> str:
    """Return words in quotes, separated by commas and `or`."""
    *first, last = [word if " " in word else quoted(word) for word in words]
    return f"{', '.join(first)} or {last}" if first else last


def near(word: str, words: Iterable[str]) -> str | None:
    """Return a hint with the word that was probably meant."""
    found = get_close_matches(word, list(words), n=1)
    return f"did you mean {quoted(found[0])}?" if found else None


def shown(value: Any) -> str:
    """Return a short value as text, or the type of a long one."""
    text = quoted(value) if isinstance(value, str) else repr(value)
    return text if len(text) <= MAX_SHOWN else f"a {type(value).__name__}"
