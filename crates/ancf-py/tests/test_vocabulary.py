"""Words that `docs/style.md` rejects do not occur in texts for readers and users."""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[3]
STYLE = ROOT / "docs" / "style.md"

CHECKED = [
    "*.md",
    ".github/**/*.md",
    ".github/**/*.yml",
    "docs/**/*.md",
    "docs/**/*.ipynb",
    "models/**/*.toml",
    "crates/*/src/**/*.rs",
    "crates/ancf-py/python/**/*.py",
    "verification/src/**/*.rs",
    "viewer/src/**/*.ts",
    "xtask/src/**/*.rs",
]
"""Files that are checked."""

Line = tuple[int, str]


def rejected() -> dict[str, str]:
    """Words and phrases of the table, with their replacements."""
    section = STYLE.read_text(encoding="utf-8").split("## Extended vocabulary")[1]
    table = section.split("| not | but |\n|---|---|\n")[1].split("\n\n")[0]
    words: dict[str, str] = {}
    for row in table.splitlines():
        phrases, instead = row.strip("| ").split(" | ")
        for phrase in re.sub(r"\([^()]*\)", "", phrases).split(","):
            words[phrase.strip()] = instead
    return words


def hits(lines: Iterator[Line]) -> list[str]:
    """Rejected words in lines of text, with line numbers and replacements. Phrases may cross line ends."""
    words = rejected()
    pattern = re.compile(
        rf"(?<![\w-])(?:{'|'.join(map(re.escape, words))})(?![\w-])".replace(r"\ ", r"\s+"), re.I
    )
    numbers, text = [], ""
    for number, line in lines:
        numbers += [number] * (len(line) + 1)
        text += line + "\n"
    found = []
    for match in pattern.finditer(text):
        word = " ".join(match.group().split())
        found.append(f"{numbers[match.start()]}: {word!r}, use {words[word.lower()]!r}")
    return found


def prose(text: str) -> Iterator[Line]:
    """Lines of Markdown without addresses of links. Of code, only comments."""
    fence = ""
    for number, line in enumerate(text.splitlines(), 1):
        mark = re.match(r" *(```+|~~~+)", line)
        if mark and (not fence or line.strip().startswith(fence)):
            fence = "" if fence else mark.group(1)
        elif fence:
            yield number, line.partition("#")[2]
        else:
            yield number, re.sub(r"`[^`]*`|\]\([^()]*\)", "`", line)


def strings_and_comments(text: str, comments: str) -> Iterator[Line]:
    """Comments and strings of Rust and TypeScript, line by line."""
    for number, line in enumerate(text.splitlines(), 1):
        body = line.strip()
        if re.match(comments, body):
            yield number, re.sub(r"`[^`]*`", "`", body)
        else:
            strings = " ".join(re.findall(r'"((?:[^"\\]|\\.)*)"', line))
            # Braces of format strings contain variables.
            yield number, re.sub(r"\{[^{}]*\}", "", strings)


def python_texts(text: str) -> Iterator[Line]:
    """Strings and comments of Python."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.lineno, re.sub(r"`[^`]*`", "`", node.value)
    for number, line in enumerate(text.splitlines(), 1):
        if line.strip().startswith("#"):
            yield number, line


def cell_text(cell: dict[str, Any]) -> str:
    """Cell of a notebook as Markdown."""
    source = "".join(cell["source"])
    return source if cell["cell_type"] == "markdown" else f"```\n{source}\n```"


def texts(file: Path) -> Iterator[Line]:
    """Texts of a file that readers or users see."""
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".ipynb":
        return prose("\n\n".join(cell_text(cell) for cell in json.loads(text)["cells"]))
    if file.suffix == ".md":
        return prose(text)
    if file.suffix == ".py":
        return python_texts(text)
    if file.suffix in {".rs", ".ts", ".mjs"}:
        return strings_and_comments(text, r"//|/\*|\*")
    if file.suffix == ".toml":
        return ((number, line.partition("#")[2]) for number, line in enumerate(text.splitlines(), 1))
    return iter(enumerate(text.splitlines(), 1))


def files() -> list[Path]:
    """Files that are checked, without the list of words itself."""
    return sorted({file for pattern in CHECKED for file in ROOT.glob(pattern)} - {STYLE})


def test_texts_use_the_vocabulary() -> None:
    found = [f"{file.relative_to(ROOT)}:{hit}" for file in files() for hit in hits(texts(file))]
    assert not found


def test_rejected_words_are_found() -> None:
    text = "The program keeps the\nbooks.\n\n```sh\nkeeps the books\n```\nIt says `says`."
    assert [hit.split(",")[0] for hit in hits(prose(text))] == ["1: 'keeps the books'", "7: 'says'"]
    code = '//! The film of a run.\nlet films = "no films";\nlet film = 1;'
    assert [hit.split(",")[0] for hit in hits(strings_and_comments(code, "//"))] == [
        "1: 'film'",
        "2: 'films'",
    ]
