"""Model files of ancf."""

from collections.abc import Iterable, Sequence

import ours
from problems import GRAVITY, Run

DEFAULT_TOLERANCE, LOOSE_TOLERANCE = ours.TOLERANCES


def vector(numbers: Iterable[float]) -> str:
    """An array of numbers."""
    return "[" + ", ".join(repr(float(f"{x:.12g}")) for x in numbers) + "]"


def place(body: str, at: str | Sequence[float]) -> str:
    """A place of a body: `start`, `end`, `center`, a length along it, or a point."""
    where = vector(at) if not isinstance(at, str) else at if at[0].isdigit() else f'"{at}"'
    return f'{{ body = "{body}", at = {where} }}'


def joint(kind: str, name: str, a: str, b: str = "", axis: Sequence[float] = ()) -> str:
    """A joint of a place with another, or with the ground."""
    more = (f", b = {b}" if b else "") + (f", axis = {vector(axis)}" if axis else "")
    return f'{{ kind = "{kind}", name = "{name}", a = {a}{more} }}'


def cable(name: str, start: Sequence[float], end: Sequence[float], elements: int) -> str:
    """A cable of the section and material `rope`."""
    ends = f"from = {vector(start)}, to = {vector(end)}"
    of = f'{ends}, elements = {elements}, section = "rope", material = "rope"'
    return f'{{ kind = "cable", name = "{name}", {of} }}'


def rigid(name: str, center: Sequence[float], mass: float, inertia: Sequence[float]) -> str:
    """A rigid body."""
    of = f"center = {vector(center)}, mass = {mass}, inertia = {vector(inertia)}"
    return f'{{ kind = "rigid", name = "{name}", {of} }}'


class Structure:
    """Bodies, joints, contacts and probes of a model file, each an inline table."""

    def __init__(self, rope: str = "", diameter: float = 0.0):
        """An empty model with the table of the material of cables and their diameter."""
        self.rope, self.diameter = rope, diameter
        self.lists: dict[str, list[str]] = {name: [] for name in ("bodies", "joints", "contacts", "probes")}

    def add(self, name: str, *items: str) -> None:
        """Adds items to a list."""
        self.lists[name] += items

    def probe(self, on: str) -> None:
        """Adds a probe; its columns are those after the ones of earlier probes."""
        probes = self.lists["probes"]
        probes.append(f'{{ name = "p{len(probes)}", on = {on} }}')

    def text(self, steps: int, step: float, every: int, scheme: float, tolerance: float) -> str:
        """The model file."""
        rope = f'materials.rope = {self.rope}\nsections.rope = {{ kind = "circle", diameter = {self.diameter} }}\n'
        lists = [f"{name} = [\n" + ",\n".join(items) + "\n]\n" for name, items in self.lists.items() if items]
        stop = f'scheme = {{ spectral_radius = {scheme} }}, stop = {{ rule = "energy", tolerance = {tolerance} }}'
        span = f"duration = {steps * step!r}, step = {step!r}"
        return (
            f"gravity = [0.0, 0.0, {-GRAVITY}]\n{rope if self.rope else ''}{''.join(lists)}"
            f'analysis = {{ kind = "dynamics", {span}, {stop} }}\n'
            f"output = {{ every = {every}, states = 0, parquet = false }}\n"
        )

    def solver(self, scheme: float, tolerance: float = DEFAULT_TOLERANCE):
        """Solves steps in a process of its own."""

        def solve(steps: int, step: float, every: int) -> Run:
            return ours.solve(self.text(steps, step, every, scheme, tolerance))

        return solve
