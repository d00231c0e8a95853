"""Links of the documentation: files and headings exist, addresses are well formed."""

from __future__ import annotations

import itertools
import json
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
from markdown_it import MarkdownIt
from markdown_it.token import Token

ROOT = Path(__file__).parents[3]
DOCS = ROOT / "docs"
PAGES = [
    *sorted(ROOT.glob("*.md")),
    *sorted((ROOT / ".github").rglob("*.md")),
    *sorted(DOCS.rglob("*.md")),
    *sorted(DOCS.rglob("*.ipynb")),
]


def text_of(page: Path) -> str:
    """Markdown of a page, or of the text cells of a notebook."""
    text = page.read_text(encoding="utf-8")
    if page.suffix != ".ipynb":
        return text
    cells = json.loads(text)["cells"]
    return "\n\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")


@cache
def tokens(page: Path) -> tuple[Token, ...]:
    """Blocks of a page."""
    return tuple(MarkdownIt().enable("table").parse(text_of(page)))


def slug(heading: str) -> str:
    """Anchor of a heading, as on GitHub and on the site."""
    letters = re.sub(r"[^\w\- ]", "", heading.replace("`", "").strip().lower())
    return letters.replace(" ", "-")


@cache
def anchors(page: Path) -> frozenset[str]:
    """Anchors of the headings of a page. Equal headings have numbers."""
    blocks = tokens(page)
    found: set[str] = set()
    for opening, content in itertools.pairwise(blocks):
        if opening.type == "heading_open":
            base = slug(re.sub(r"\[([^][]*)\]\([^()]*\)", r"\1", content.content))
            names = (base if k == 0 else f"{base}-{k}" for k in range(len(blocks)))
            found.add(next(name for name in names if name not in found))
    return frozenset(found)


def targets(page: Path) -> Iterator[str]:
    """Targets of all links and pictures of a page."""
    for block in tokens(page):
        for token in [block, *(block.children or [])]:
            value = token.attrGet("href") or token.attrGet("src")
            if value is not None:
                yield str(value)
            if token.type in {"html_block", "html_inline"}:
                yield from re.findall(r'(?:href|src|srcset)="([^"]+)"', token.content)


def fault(page: Path, target: str) -> str | None:
    """Returns what is wrong with a link, or nothing."""
    parts = urlsplit(target)
    if parts.scheme == "mailto":
        return None if re.fullmatch(r"[^@\s]+@[^@\s]+\.[^@\s]+", parts.path) else "no mail address"
    if parts.scheme:
        host = parts.hostname or ""
        is_address = parts.scheme in {"http", "https"} and re.fullmatch(r"[\w-]+(\.[\w-]+)+|localhost", host)
        return None if is_address and not re.search(r"\s", target) else "no web address"
    file = (page.parent / unquote(parts.path)).resolve() if parts.path else page
    if not file.exists():
        return "no such file"
    if not file.is_relative_to(ROOT):
        return "outside of the repository"
    if parts.fragment and (file.suffix not in {".md", ".ipynb"} or parts.fragment not in anchors(file)):
        return "no such heading"
    return None


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_have_targets(page: Path) -> None:
    faults = [(target, why) for target in targets(page) if (why := fault(page, target))]
    assert not faults


@pytest.mark.parametrize(
    ("target", "why"),
    [
        ("README.md", None),
        ("docs/style.md#vocabulary", None),
        ("docs/style.md#no-heading", "no such heading"),
        ("docs/nowhere.md", "no such file"),
        ("#nowhere", "no such heading"),
        ("https://example.org/page", None),
        ("https://nohost/page", "no web address"),
        ("htps://example.org", "no web address"),
    ],
)
def test_faults_of_links_are_found(target: str, why: str | None) -> None:
    assert fault(ROOT / "README.md", target) == why
