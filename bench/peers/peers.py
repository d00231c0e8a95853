"""Compares ancf with EXUDYN and MuJoCo in one run: time at equal settings, and time at equal accuracy.

Run by `cargo xtask peers`. Prints tables in Markdown and writes `results/peers.json` and
`results/work_precision.csv` for rods, `results/structures.json` for structures of many bodies. Arguments `rods`
and `structures` select one of both.

The error of a run is the root mean square, over instants of 10 ms, of the distance of its tip from that of the
reference, divided by the root mean square of the displacement of the reference. The reference of the rods without
shear (cable elements of either program) is the mean of two fine solutions, one by each; how far they are apart is
told. Rods with shear are another continuum and have a fine solution of ancf of their own.

Times are of the processor: of EXUDYN's solver alone, in its process, without files; of whole processes of ancf,
which read a model and write a file. Each is the least of some runs.
"""

import argparse
import csv
import json
import math
from collections.abc import Callable
from pathlib import Path

import numpy as np

import ours
import theirs
from accuracy import distance, front, time_at
from problems import CANTILEVER, INTERVAL, PAPER, PENDULUM, Problem, Run
from report import conditions, number, say, short, table
from structures.table import measure as structures

RESULTS = Path(__file__).resolve().parent / "results"
ELEMENTS = (2, 4, 8, 16)
# Steps in an interval between instants, at least and at most by problem; the references have four times as many.
COARSEST = 2
FINEST = {CANTILEVER.name: 128, PENDULUM.name: 64}
# Elements of the references.
FINE = 32
REPEATS = 2
# Errors at which times are compared.
TARGETS = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4)
# Elements of the paper's table 4.
PAPER_ELEMENTS = (1, 2, 5, 10, 15, 20)

Solve = Callable[[Problem, int, float, float], Run]


def by_ours(kind: str) -> Solve:
    """Runs of ancf with elements of a kind."""
    return lambda problem, n, step, tolerance: ours.run(problem, kind, n, step, tolerance)


# What is compared: name, solver, tolerances, whether it is a rod with shear.
CODES: tuple[tuple[str, Solve, tuple[float, ...], bool], ...] = (
    ("EXUDYN cable", theirs.run, theirs.TOLERANCES, False),
    ("ancf cable", by_ours("cable"), ours.TOLERANCES, False),
    ("ancf beam, linked", by_ours("linked"), ours.TOLERANCES, True),
)


def steps(problem: Problem) -> list[float]:
    """Steps, each half of the one before."""
    doublings = range(round(math.log2(FINEST[problem.name] / COARSEST)) + 1)
    return [INTERVAL / (COARSEST * 2**k) for k in doublings]


def least(solve: Callable[[], Run]) -> Run:
    """The quickest of some equal runs."""
    return min((solve() for _ in range(REPEATS)), key=lambda run: run.seconds)


def references(problem: Problem) -> tuple[dict[bool, np.ndarray], float]:
    """The paths of rods without and with shear, and how far the two of the former are apart, relatively."""
    step = INTERVAL / (4 * FINEST[problem.name])
    # A tighter tolerance is below EXUDYN's rounding error here.
    lines = theirs.run(problem, FINE, step, 1e-6).tip, ours.run(problem, "cable", FINE, step).tip
    line = 0.5 * (lines[0] + lines[1])
    shear = ours.run(problem, "linked", FINE, step).tip
    return {False: line, True: shear}, distance(*lines) / distance(line, 0.0 * line)


def points(problem: Problem, paths: dict[bool, np.ndarray]) -> list[dict]:
    """Every code with every mesh, step and tolerance: time and error. What does not end is left out."""
    found = []
    for name, solve, tolerances, shear in CODES:
        path = paths[shear]
        for n in ELEMENTS:
            for step in steps(problem):
                for tolerance in tolerances:
                    try:
                        run = least(lambda: solve(problem, n, step, tolerance))  # noqa: B023
                    except RuntimeError as error:
                        say(f"{problem.name}, {name}, n = {n}, h = {step}: {error}")
                        continue
                    error = distance(run.tip, path) / distance(path, 0.0 * path)
                    found.append(
                        {
                            "problem": problem.name,
                            "code": name,
                            "n": n,
                            "h": step,
                            "tolerance": tolerance,
                            "seconds": run.seconds,
                            "reported": run.reported,
                            "error": error,
                        }
                    )
    return found


def at_equal_accuracy(problem: Problem) -> tuple[dict, list[dict]]:
    """Times of a problem at the target errors, and all runs behind them."""
    say(f"{problem.name}: references")
    paths, apart = references(problem)
    say(f"{problem.name}: {len(CODES) * len(ELEMENTS) * len(steps(problem))} settings")
    found = points(problem, paths)
    fronts = {name: front([p for p in found if p["code"] == name]) for name, *_ in CODES}
    times = {name: [number(time_at(target, best)) for target in TARGETS] for name, best in fronts.items()}
    return {"problem": problem.name, "references_apart": apart, "targets": TARGETS, "seconds": times}, found


def at_equal_settings() -> list[dict]:
    """The paper's cantilever, 2000 steps of 1 ms, for each of its meshes."""
    rows = []
    for n in PAPER_ELEMENTS:
        say(f"{PAPER.name}: {n} elements")
        their = least(lambda: theirs.run(PAPER, n, 1e-3))  # noqa: B023
        cable, beam = (least(lambda: ours.run(PAPER, kind, n, 1e-3)) for kind in ("cable", "beam"))  # noqa: B023
        rows.append(
            {
                "n": n,
                "EXUDYN cable": their.seconds,
                "ancf cable": cable.seconds,
                "ancf cable, reported": cable.reported,
                "ancf beam": beam.seconds,
                "ancf beam, reported": beam.reported,
            }
        )
    return rows


def accuracy_table(result: dict) -> str:
    """Times at equal errors, and how many times longer EXUDYN takes than ancf with the like elements."""
    names = [name for name, *_ in CODES]
    rows = []
    for i, target in enumerate(result["targets"]):
        times = [result["seconds"][name][i] for name in names]
        ratio = times[0] / times[1] if times[0] and times[1] else None
        rows.append([f"{target:g}", *map(short, times), short(ratio)])
    title = f"{result['problem']}, references {result['references_apart']:.1e} apart\n\n"
    return title + table(["error", *(f"{name}, s" for name in names), "EXUDYN / ancf, cables"], rows)


def settings_table(rows: list[dict]) -> str:
    """Times at equal settings."""
    names = list(rows[0])
    return table(
        [*names, "EXUDYN / ancf, cables"],
        [[*(short(row[name]) for name in names), short(row[names[1]] / row[names[2]])] for row in rows],
    )


def rods() -> str:
    """Measures the rods, writes the results and returns the tables."""
    compared = [at_equal_accuracy(problem) for problem in (CANTILEVER, PENDULUM)]
    settings = at_equal_settings()
    everything = {
        "conditions": conditions(),
        "equal_accuracy": [result for result, _ in compared],
        "equal_settings": settings,
    }
    (RESULTS / "peers.json").write_text(json.dumps(everything, indent=2) + "\n")
    found = [point for _, points in compared for point in points]
    with (RESULTS / "work_precision.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, list(found[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(found)
    return "\n".join([*(accuracy_table(result) for result, _ in compared), settings_table(settings)])


def main() -> None:
    """Measures what the arguments select, by default everything, and prints."""
    parts = {"rods": rods, "structures": lambda: structures(RESULTS / "structures.json")}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", metavar="part", help=f"one of {', '.join(parts)}")
    chosen = parser.parse_args().parts or list(parts)
    if unknown := set(chosen) - set(parts):
        parser.error(f"unknown part {min(unknown)}, expected {' or '.join(parts)}")
    RESULTS.mkdir(exist_ok=True)
    for part in chosen:
        print(parts[part](), flush=True)


if __name__ == "__main__":
    main()
