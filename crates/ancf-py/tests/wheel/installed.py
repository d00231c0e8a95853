"""Use of an installed wheel in an environment without other packages: `python -I installed.py`."""

import re
import subprocess
import sys
import sysconfig
import zipfile
from importlib import metadata
from pathlib import Path

import ancf

program = Path(sysconfig.get_path("scripts")) / ("ancf.exe" if sys.platform == "win32" else "ancf")


def run(*arguments: str) -> str:
    """Run the program of the wheel and return its standard output."""
    done = subprocess.run([program, *arguments], capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, f"ancf {arguments}: {done.returncode}\n{done.stderr}"
    return done.stdout


assert Path(ancf.__file__).is_relative_to(sys.prefix), f"not the wheel: {ancf.__file__}"
tags = metadata.distribution("ancf").read_text("WHEEL") or ""
assert "Tag: cp310-abi3-" in tags, f"not for all versions of CPython from 3.10 on: {tags}"

version = run("--version").split()[-1]
assert version == metadata.version("ancf") == ancf.__version__, version

# Package and program compute the same numbers.
run("new", "model.toml", "--kind", "pendulum")
run("run", "model.toml", "-o", "run", "--quiet")
own, other = ancf.run("model.toml"), ancf.load("run")
for column in own.columns:
    own_values, other_values = own[column], other[column]
    scale = max(abs(own_values).max(), 1e-300)
    assert abs(own_values - other_values).max() <= 1e-9 * scale, column

run("fmu", "model.toml", "-o", "model.fmu", "--quiet")
with zipfile.ZipFile("model.fmu") as fmu:
    assert any(re.match(r"binaries/[^/]+/ancf\.(so|dll|dylib)$", name) for name in fmu.namelist())
print(f"ancf {version}: package, program and FMU library of the wheel work in an empty environment")
