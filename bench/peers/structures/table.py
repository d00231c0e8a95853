"""Measures all structures and prints tables."""

import json
from pathlib import Path

import numpy as np

from accuracy import distance, front, time_at
from report import conditions, number, say, short, table
from structures import cables, chain, pile
from structures.case import Case, Program, timed

TARGETS = (1e-3, 1e-4, 1e-5, 1e-6)
# Chain of equal accuracy: rods, duration and instants of comparison, s, steps in an interval between instants.
RODS, DURATION, INTERVAL = 100, 0.5, 0.01
DIVISIONS = (1, 2, 4, 8, 16)
FINE = 64
# Steps of the pile, s; each program has its own reference.
PILE_DURATION = 0.3
PILE_STEPS = (5e-3, 2.5e-3, 1e-3, 5e-4)
PILE_FINE = 1.25e-4


def compared(case: Case) -> dict:
    """Times per step, and differences of the probes from that of the first program, relative to its motion."""
    rows = timed(case)
    base = rows[0]
    for row in rows:
        row["over_first"] = number(row["ms"] / base["ms"])
        row["difference"] = relative(row["path"], base["path"])
        row["ms"] = number(row["ms"])
    for row in rows:
        del row["path"]
    return {"case": case.name, "step": case.step, "programs": rows}


def relative(path: np.ndarray | None, base: np.ndarray | None) -> float | None:
    """Difference of two paths over their common instants, relative to the second."""
    if path is None or base is None:
        return None
    count = min(len(path), len(base))
    return number(distance(path[:count], base[:count]) / distance(base[:count], 0.0 * base[:count]))


def sweep(programs: list[Program], duration: float, interval: float, steps: list[float], references) -> list[dict]:
    """Time of the steps alone and error of each program with each step."""
    found = []
    for program in programs:
        for step in steps:
            every = max(1, round(interval / step))
            say(f"{program.name}: steps of {step} s")
            point = {"program": program.name, "step": step, "seconds": None, "error": None}
            found.append(point)
            try:
                start = program.solve(1, step, every).seconds
                run = program.solve(round(duration / step), step, every)
            except (RuntimeError, ValueError) as error:
                point["failure"] = str(error)
                continue
            point |= {"seconds": run.seconds - start, "error": relative(run.tip, references[program.name])}
            found[-1] = point
    return found


def fine(program: Program, duration: float, interval: float, step: float) -> np.ndarray:
    """Path of a run with fine steps."""
    say(f"{program.name}: reference")
    return program.solve(round(duration / step), step, round(interval / step)).tip


def chain_accuracy(hinges: bool) -> dict:
    """Times of a chain at equal errors. The reference is the fine solution of MuJoCo of fourth order."""
    programs = chain.programs(RODS, hinges)
    by_name = {program.name: program for program in programs}
    paths = [fine(by_name[name], DURATION, INTERVAL, INTERVAL / FINE) for name in ("MuJoCo RK4", "ancf")]
    steps = [INTERVAL / division for division in DIVISIONS]
    found = sweep(programs, DURATION, INTERVAL, steps, dict.fromkeys(by_name, paths[0]))
    fronts = {
        name: front([p for p in found if p["program"] == name and p["error"] is not None]) for name in by_name
    }
    return {
        "joints": "hinges" if hinges else "ball joints",
        "references_apart": relative(paths[1], paths[0]),
        "targets": TARGETS,
        "seconds": {name: [number(time_at(target, best)) for target in TARGETS] for name, best in fronts.items()},
        "runs": found,
    }


def mesh_differences() -> list[dict]:
    """Differences of the platform of both programs by mesh, with a fine step."""
    duration, interval, step = 0.1, 0.02, 5e-4
    found = []
    for name, programs in cables.meshes():
        ancf, exudyn = (fine(program, duration, interval, step) for program in programs)
        found.append({"mesh": name, "difference": relative(exudyn, ancf), "step": step})
    return found


def pile_steps() -> list[dict]:
    """Errors of the mean place of a pile by step, relative to the fine solution of the same program."""
    programs = pile.programs(1, 1)
    references = {program.name: fine(program, PILE_DURATION, INTERVAL, PILE_FINE) for program in programs}
    return sweep(programs, PILE_DURATION, INTERVAL, list(PILE_STEPS), references)


def times_table(results: list[dict]) -> str:
    """Milliseconds per step, and ratios to the first program."""
    names = list(dict.fromkeys(row["program"] for result in results for row in result["programs"]))

    def cell(result: dict, name: str) -> str:
        row = next((row for row in result["programs"] if row["program"] == name), None)
        if row is None or row["ms"] is None:
            return "-"
        return short(row["ms"]) + (f" ({short(row['over_first'])})" if name != names[0] else "")

    rows = [[result["case"], *(cell(result, name) for name in names)] for result in results]
    return table(["ms per step (ratio to ancf)", *names], rows)


def differences_table(results: list[dict]) -> str:
    """Relative differences of the motion of the probe from that of the first program."""
    names = list(dict.fromkeys(row["program"] for result in results for row in result["programs"]))[1:]
    rows = []
    for result in results:
        found = {row["program"]: row["difference"] for row in result["programs"]}
        rows.append([result["case"], *(exponent(found.get(name)) for name in names)])
    return table(["difference from ancf", *names], rows)


def exponent(x: float | None) -> str:
    """With one digit and an exponent, or a dash."""
    return "-" if x is None else f"{x:.0e}"


def accuracy_table(results: list[dict]) -> str:
    """Seconds of a chain at equal errors."""
    names = list(results[0]["seconds"])
    rows = [
        [f"{result['joints']}, {target:g}", *(short(result["seconds"][name][k]) for name in names)]
        for result in results
        for k, target in enumerate(result["targets"])
    ]
    return table([f"{RODS} rods, error", *(f"{name}, s" for name in names)], rows)


def steps_table(found: list[dict]) -> str:
    """Errors and times of the pile by step."""
    names = list(dict.fromkeys(point["program"] for point in found))
    points = {(point["program"], point["step"]): point for point in found}

    def cell(name: str, step: float) -> str:
        point = points[name, step]
        return "fails" if "failure" in point else f"{short(point['error'])} ({short(point['seconds'])} s)"

    rows = [[f"{1e3 * step:g}", *(cell(name, step) for name in names)] for step in PILE_STEPS]
    return table(["step, ms", *(f"{name}: error (time)" for name in names)], rows)


def measure(file: Path) -> str:
    """Measures, writes JSON and returns the tables."""
    groups = {
        name: [compared(case) for case in model.cases()]
        for name, model in (("chain", chain), ("cables", cables), ("pile", pile))
    }
    accuracy = [chain_accuracy(hinges) for hinges in (True, False)]
    meshes, steps = mesh_differences(), pile_steps()
    everything = {
        "conditions": conditions(),
        **groups,
        "platform_meshes": meshes,
        "chain_accuracy": accuracy,
        "pile_steps": steps,
    }
    file.write_text(json.dumps(everything, indent=2) + "\n")
    tables = [make(results) for results in groups.values() for make in (times_table, differences_table)]
    mesh_table = table(["platform", "difference"], [[row["mesh"], exponent(row["difference"])] for row in meshes])
    return "\n".join([*tables, mesh_table, accuracy_table(accuracy), steps_table(steps)])
