"""A structure, the programs that solve it, and their times per step."""

import math
from collections.abc import Callable
from dataclasses import dataclass

from problems import Run
from report import say

# Solves a number of steps of a size, s, with the displacement of the probe after each number of steps.
Solve = Callable[[int, float, int], Run]

# Steps between recorded instants.
EVERY = 10
REPEATS = 2


@dataclass(frozen=True)
class Program:
    """A program with its settings, and the numbers of steps whose difference in time is measured."""

    name: str
    solve: Solve
    few: int
    many: int


@dataclass(frozen=True)
class Case:
    """A structure of a size, with the step of the comparison. The first program is the base of ratios."""

    name: str
    step: float
    programs: list[Program]


def timed(case: Case) -> list[dict]:
    """Time per step and path of each program: least processor times of alternating runs."""
    least: dict[str, list[float]] = {program.name: [math.inf, math.inf] for program in case.programs}
    paths, failures = {}, {}
    for _ in range(REPEATS):
        for program in case.programs:
            for k, steps in enumerate((program.few, program.many)):
                say(f"{case.name}: {program.name}, {steps} steps")
                try:
                    run = program.solve(steps, case.step, EVERY)
                except (RuntimeError, ValueError) as error:
                    failures[program.name] = str(error)
                    continue
                least[program.name][k] = min(least[program.name][k], run.seconds)
                paths[program.name] = run.tip
    return [
        {
            "program": program.name,
            "steps": program.many - program.few,
            "ms": per_step(least[program.name], program.many - program.few),
            "path": paths.get(program.name),
            "failure": failures.get(program.name),
        }
        for program in case.programs
    ]


def per_step(least: list[float], steps: int) -> float:
    """Milliseconds per step; not a number after a failure."""
    few, many = least
    return 1e3 * (many - few) / steps if math.isfinite(few + many) else math.nan
