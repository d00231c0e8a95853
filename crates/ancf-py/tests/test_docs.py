"""Every code block of the documentation is run, and every notebook is kept without outputs."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from markdown_it import MarkdownIt

import ancf

ROOT = Path(__file__).parents[3]
DOCS = ROOT / "docs"
PAGES = [*sorted(ROOT.glob("*.md")), *sorted(DOCS.rglob("*.md"))]
NOTEBOOKS = sorted(DOCS.rglob("*.ipynb"))

BUILD = ["cargo", "build", "--quiet", "--workspace", "--bins", "--examples"]
"""Same packages as `cargo test --workspace`: a single package has other features of its dependencies."""

TESTED_BY = {
    "python": "run here, page by page, in one namespace a page",
    "sh": "run here by a shell, in the same folder",
    "toml": "written here to the file that its first line names, for the blocks after it; models are checked; those of "
    "docs/model-file are read by crates/ancf/tests/it/model_files/models.rs",
    "rust": "equal to a file in crates/ancf/examples, which is run here",
    "{code-cell}": "run by the build of the site, which fails if a cell does",
    "text": "not code: output, drawings, input files of other programs",
    "cpp": "code of another program, for comparison",
    "py": "code of another program, for comparison",
    "xml": "input of another program, for comparison",
    "{toctree}": "not code",
    "{eval-rst}": "not code: names for autodoc, which fails if they are not there",
}
"""Tests of the blocks of each language."""

NOT_RUN = {
    "cargo xtask": "runs this test, or takes minutes",
    "cargo run --release -- paper": "takes minutes: crates/ancf-cli/tests/it/paper.rs",
    "ancf check FILE": "a synopsis: crates/ancf-cli/tests/it/runs.rs",
    "ancf run FILE": "a synopsis: crates/ancf-cli/tests/it/runs.rs",
    "ancf scaled FILE": "a synopsis: crates/ancf-cli/tests/it/runs.rs",
    "cargo install": "installs: the program is there",
    "pip install": "installs: the package is there",
}
"""Beginnings of commands that are not run, with the reason."""


@dataclass(frozen=True)
class Block:
    """A code block of a page."""

    page: Path
    line: int
    language: str
    text: str

    def __str__(self) -> str:
        return f"{self.page.relative_to(ROOT)}:{self.line}"

    def commands(self) -> list[str]:
        """Lines of a shell that are run."""
        lines = self.text.splitlines()
        return [line for line in lines if not line.startswith(tuple(NOT_RUN))]


def blocks(page: Path) -> list[Block]:
    """All code blocks of a page."""
    fences = [
        token for token in MarkdownIt().parse(page.read_text(encoding="utf-8")) if token.type == "fence"
    ]
    return [
        Block(page, (token.map or [0])[0] + 1, (token.info.split() or [""])[0], token.content)
        for token in fences
    ]


def runnable() -> list[Path]:
    """Pages with blocks that are run here."""
    return [page for page in PAGES if {block.language for block in blocks(page)} & {"python", "sh", "toml"}]


@pytest.fixture(scope="session")
def tools(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the program `ancf`: the one that `ANCF_PROGRAM` names, else the workspace's."""
    named = os.environ.get("ANCF_PROGRAM")
    if named is None:
        subprocess.run(BUILD, cwd=ROOT, check=True)
    built = ROOT / "target" / "debug" / f"ancf{'.exe' if os.name == 'nt' else ''}"
    program = built if named is None else Path(named)
    folder = tmp_path_factory.mktemp("tools")
    shutil.copy2(program, folder / program.name)
    return folder


@pytest.fixture
def folder(tmp_path: Path, tools: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working folder with the models, and with the program on the path."""
    shutil.copytree(ROOT / "models", tmp_path / "models")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PATH", f"{tools}{os.pathsep}{os.environ['PATH']}")
    monkeypatch.setenv("MPLBACKEND", "Agg")
    monkeypatch.setenv("SLURM_ARRAY_TASK_ID", "1")
    monkeypatch.setitem(sys.modules, "dask_jobqueue", slurm())
    return tmp_path


def slurm() -> ModuleType:
    """A replacement of dask-jobqueue without SLURM: jobs are threads of this process."""
    local: Any = import_module("dask.distributed").LocalCluster

    def start(cluster: Any, **_: object) -> None:
        local.__init__(cluster, n_workers=0, threads_per_worker=2, processes=False, dashboard_address=None)

    def scale(cluster: Any, count: int = 0, jobs: int = 0) -> object:
        return local.scale(cluster, count or min(jobs, 2))

    module: Any = ModuleType("dask_jobqueue")
    module.SLURMCluster = type("SLURMCluster", (local,), {"__init__": start, "scale": scale})
    return module  # type: ignore[no-any-return]


@pytest.mark.parametrize("page", runnable(), ids=lambda page: str(page.relative_to(ROOT)))
def test_blocks_run(page: Path, folder: Path) -> None:
    space: dict[str, object] = {"__name__": "__main__"}
    for block in blocks(page):
        if block.language == "python":
            # With empty lines before the block, errors name the line of the page.
            code = "\n" * block.line + block.text
            exec(compile(code, page, "exec"), space)
        elif block.language == "sh":
            run(block)
        elif block.language == "toml" and "model-file" not in {page.stem, page.parent.name}:
            write(block, folder)


def run(block: Block) -> None:
    """Run a block of a shell."""
    script = "\n".join(block.commands()).replace("cargo run --release --", "ancf")
    done = subprocess.run(["sh", "-e", "-c", script], capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{block}: {done.stdout}{done.stderr}"


def write(block: Block, folder: Path) -> None:
    """Write a model, or a study, into the file that its first line names, and check the model."""
    first = block.text.splitlines()[0]
    assert first.startswith("# ") and first.endswith(".toml"), f"{block}: its first line names no file"
    file = folder / first.removeprefix("# ")
    file.write_text(block.text, encoding="utf-8")
    # `ancf` checks lists of analyses, in the next block.
    if "[parameters]" not in block.text and "[[analysis]]" not in block.text:
        ancf.check(file)


def test_languages_are_known() -> None:
    unknown = [str(block) for page in PAGES for block in blocks(page) if block.language not in TESTED_BY]
    assert not unknown, "no test knows their languages"


def test_excluded_commands_exist() -> None:
    lines = [
        line
        for page in PAGES
        for block in blocks(page)
        if block.language == "sh"
        for line in block.text.splitlines()
    ]
    for start in NOT_RUN:
        assert any(line.startswith(start) for line in lines), f"no page has {start!r}"


def test_cells_are_on_pages_that_the_site_runs() -> None:
    for page in PAGES:
        if any(block.language == "{code-cell}" for block in blocks(page)):
            assert page.read_text(encoding="utf-8").startswith("---\nfile_format: mystnb\n"), page


def test_rust_blocks_equal_the_examples(folder: Path) -> None:
    examples = {
        file.stem: file.read_text(encoding="utf-8")
        for file in (ROOT / "crates" / "ancf" / "examples").glob("*.rs")
    }
    found = [block for page in PAGES for block in blocks(page) if block.language == "rust"]
    for block in found:
        names = [name for name, text in examples.items() if text.endswith(block.text)]
        assert names, f"{block}: no file in crates/ancf/examples ends so"
        example(names[0], folder)


def example(name: str, folder: Path) -> None:
    """Run an example where the models are."""
    subprocess.run(BUILD, cwd=ROOT, check=True)
    subprocess.run([ROOT / "target" / "debug" / "examples" / name], cwd=folder, check=True)


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_notebooks_have_no_outputs(file: Path) -> None:
    book = json.loads(file.read_text(encoding="utf-8"))
    assert book["metadata"]["kernelspec"]["name"] == "python3"
    assert book["cells"][0]["source"][0].startswith("# ")
    for cell in book["cells"]:
        assert cell.get("outputs", []) == []
        assert cell.get("execution_count") is None


def test_index_pages_are_complete() -> None:
    for page, files in [
        ("decisions/index.md", "[0-9]*.md"),
        ("notebooks/index.md", "*.ipynb"),
        ("howto/index.md", "*.md"),
        ("coming-from/index.md", "*.md"),
    ]:
        text = (DOCS / page).read_text(encoding="utf-8")
        for file in (DOCS / page).parent.glob(files):
            assert file.name == "index.md" or f"({file.name})" in text, (
                f"docs/{page} does not name {file.name}"
            )
    sources = (ROOT / "verification/src/problems").rglob("*.rs")
    text = "".join(source.read_text(encoding="utf-8") for source in sources)
    problems = re.findall(r'Problem \{\s*name: "(\w+)"', text)
    pages = [page.read_text(encoding="utf-8") for page in (DOCS / "verification").glob("*.md")]
    named = re.findall(r"^\| \[`(\w+)`\]", "".join(pages), re.M)
    assert len(problems) >= 60
    assert sorted(named) == sorted(problems)
    assert f"verification: {len(problems)} problems" in (ROOT / "README.md").read_text(encoding="utf-8")


def test_there_are_five_notebooks() -> None:
    assert len(NOTEBOOKS) >= 5


def test_the_gallery_has_all_models() -> None:
    text = (DOCS / "gallery.md").read_text(encoding="utf-8")
    for model in (ROOT / "models").glob("*.toml"):
        assert f"(../models/{model.name})" in text, f"docs/gallery.md does not name {model.name}"


def test_the_readme_is_short_and_states_two_commands() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert len(text.splitlines()) < 150
    assert "cargo run --release -- paper" in text
    assert "cargo xtask test" in text
