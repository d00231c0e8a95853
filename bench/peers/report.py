"""Conditions of a measurement, tables in Markdown, progress."""

import math
import os
import platform
import sys
from datetime import date
from importlib.metadata import version
from pathlib import Path


def number(x: float) -> float | None:
    """A number that JSON has."""
    return x if math.isfinite(x) else None


def conditions() -> dict:
    """Machine and versions."""
    info = Path("/proc/cpuinfo")
    names = info.read_text().splitlines() if info.exists() else []
    name = next((line.split(": ")[1] for line in names if line.startswith("model name")), platform.processor())
    return {
        "date": date.today().isoformat(),
        "processor": name,
        "cores": os.cpu_count(),
        "load": round(os.getloadavg()[0], 1),
        "system": f"{platform.system()} {platform.machine()}",
        "python": platform.python_version(),
        **{name: version(name) for name in ("exudyn", "mujoco", "numpy")},
    }


def table(header: list[str], rows: list[list[str]]) -> str:
    """A table in Markdown."""
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def short(x: float | None) -> str:
    """With three digits, or a dash."""
    return "-" if x is None else f"{x:.3g}"


def say(text: str) -> None:
    """Tells what goes on."""
    print(text, file=sys.stderr, flush=True)
