"""Sphinx configuration. `cargo xtask docs` builds the site, runs cells and notebooks, and fails on any warning."""

import ast
import base64
import functools
import inspect
import json
import os
import re
import shutil
import zlib
from pathlib import Path
from typing import TYPE_CHECKING

import ancf

if TYPE_CHECKING:
    from sphinx.application import Sphinx

# Embed the figures of cells in the pages, independent of the environment.
os.environ["MPLBACKEND"] = "module://matplotlib_inline.backend_inline"
os.environ["MATPLOTLIBRC"] = str(Path(__file__).parent / "matplotlibrc")

project = "ancf"
release = ancf.__version__
extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
default_role = "code"
highlight_language = "text"
add_module_names = False

html_theme = "furo"
html_title = f"ancf {release}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_copyright = False

myst_heading_anchors = 4
nb_execution_mode = "force"
nb_execution_in_temp = True
nb_execution_raise_on_error = True
nb_execution_timeout = 300
nb_execution_show_tb = True
nb_merge_streams = True

autodoc_member_order = "bysource"
autodoc_type_aliases = {name: name for name in ("Array", "ModelLike")}
autodoc_typehints = "description"
autodoc_typehints_description_target = "documented"
python_maximum_signature_line_length = 80
napoleon_google_docstring = False
napoleon_use_ivar = True

DOCS = Path(__file__).parent
ROOT = DOCS.parent
ELSEWHERE = {
    "architecture": "ARCHITECTURE.md",
    "contributing": "CONTRIBUTING.md",
    "changes": "CHANGELOG.md",
    "security": "SECURITY.md",
}
"""Pages whose text is a file at the root. The page of the same name in `docs` only links to it."""


PLAYGROUND = ROOT / "target/playground"
"""Built playground, which becomes a part of the site; without it the pages have no links to it."""


def read(app: "Sphinx", name: str, source: list[str]) -> None:
    """Replace stub pages by the files at the root, and add and rewrite links."""
    page = DOCS / f"{name}.md"
    text, file = source[0], page
    if name in ELSEWHERE:
        file = ROOT / ELSEWHERE[name]
        text = file.read_text(encoding="utf-8")
        app.env.note_dependency(str(file))
    if PLAYGROUND.exists():
        text = opened(text, "../" * name.count("/") + "playground/index.html")
    source[0] = re.sub(r"\[([^][]*)\]\(([^()#\s]+)(#[^()\s]*)?\)", lambda link: led(link, file, page), text)


def opened(text: str, playground: str) -> str:
    """Add links that open models of the gallery and complete model files of the text in the playground."""

    def link(fragment: str) -> str:
        return f'<a class="playground" href="{playground}#{fragment}">open in the playground</a>'

    def with_model(block: re.Match[str]) -> str:
        model = block.group(1)
        if not re.search(r"^\[?analysis\b", model, re.MULTILINE):
            return block.group()
        deflate = zlib.compressobj(9, zlib.DEFLATED, -15)
        data = deflate.compress(model.encode()) + deflate.flush()
        return f"{block.group()}\n{link('model=' + base64.urlsafe_b64encode(data).decode().rstrip('='))}\n"

    text = re.sub(
        r"\[`(\w+)\.toml`\]\([./]*models/\w+\.toml\)",
        lambda found: (
            f"{found.group()} ({link('example=' + found.group(1))})"
            if found.group(1) in examples()
            else found.group()
        ),
        text,
    )
    return re.sub(r"^```toml\n(.*?)^```\n", with_model, text, flags=re.MULTILINE | re.DOTALL)


@functools.cache
def examples() -> set[str]:
    """Return the names of the models that the playground offers."""
    return {example["name"] for example in json.loads((PLAYGROUND / "examples.json").read_text("utf-8"))}


def publish(app: "Sphinx", exception: Exception | None) -> None:
    """Copy the playground into the finished site."""
    if exception is None and PLAYGROUND.exists():
        shutil.copytree(PLAYGROUND, Path(app.outdir) / "playground", dirs_exist_ok=True)


def led(link: re.Match[str], file: Path, page: Path) -> str:
    """Return a link rewritten for a page of the site. Links to folders without an index become plain text."""
    words, path, anchor = link.group(1), link.group(2), link.group(3) or ""
    target = (file.parent / path).resolve()
    if not target.exists():
        return link.group()
    if target.is_dir():
        target /= "index.md"
    pages = {ROOT / name: DOCS / f"{page}.md" for page, name in ELSEWHERE.items()}
    target = pages.get(target, DOCS / "index.md" if target == ROOT / "README.md" else target)
    return f"[{words}]({os.path.relpath(target, page.parent)}{anchor})" if target.exists() else words


def keys(app: "Sphinx", what: str, name: str, thing: object, options: object, lines: list[str]) -> None:
    """Escape bars, and document attributes of model classes as parameters with their source types."""
    lines[:] = [line.replace("|", r"\|") for line in lists(lines)]
    if what in {"attribute", "property"}:
        # Empty comment: otherwise napoleon takes the text before a colon as a type.
        lines[:0] = ["..", ""]
    if what == "class" and isinstance(thing, type) and "Attributes" in lines:
        types = stated(thing)
        at = lines.index("Attributes")
        lines[at:] = ["Parameters", "----------", *(types.get(line, line) for line in lines[at + 2 :])]


def lists(lines: list[str]) -> list[str]:
    """Convert tables of two columns in docstrings to lists."""
    heads = [k - 1 for k, line in enumerate(lines) if re.fullmatch(r"\|[-|]+\|", line)]
    rows = [line for k, line in enumerate(lines) if k not in heads and k - 1 not in heads]
    return [re.sub(r"^\| (.+?) \| (.+) \|$", r"* \1: \2", line) for line in rows]


def stated(part: type) -> dict[str, str]:
    """Return the attributes of a class with their types as written in the source."""
    body = ast.parse(inspect.getsource(part)).body[0].body  # type: ignore[attr-defined]
    found = {item.target.id: ast.unparse(item.annotation) for item in body if isinstance(item, ast.AnnAssign)}
    return {name: f"{name} : {text.replace(' | None', ', optional')}" for name, text in found.items()}


def setup(app: "Sphinx") -> None:
    """Register `read` and `publish` for pages, and `keys` for docstrings, before napoleon."""
    app.connect("source-read", read)
    app.connect("autodoc-process-docstring", keys, priority=400)
    app.connect("build-finished", publish)
