"""Cables that carry a rigid platform, and a net of crossing cables, by cable elements of 12 coordinates."""

from math import ceil, pi, sqrt

from structures import ancf_model, exudyn_model
from structures.case import Case, Program

DENSITY, YOUNG, DIAMETER = 1140.0, 2e9, 0.01
ROPE = f"{{ density = {DENSITY}, young = {YOUNG} }}"
SCHEME = 0.8
STEP = 2e-3
# Elements of a cable of the platform.
ELEMENTS = 10
# Supported cables of the net: one of as many.
SUPPORTED = 5


def stiffness() -> dict:
    """The cable of EXUDYN."""
    area, inertia = pi * DIAMETER**2 / 4, pi * DIAMETER**4 / 64
    return {
        "massPerLength": DENSITY * area,
        "bendingStiffness": YOUNG * inertia,
        "axialStiffness": YOUNG * area,
    }


def hangers(count: int) -> list[tuple[tuple[float, ...], tuple[float, ...]]]:
    """Upper and lower ends of the cables of a platform."""
    wide = ceil(sqrt(count))
    places = [(10 * (c % wide / wide - 0.5), 10 * (c // wide / wide - 0.5)) for c in range(count)]
    return [((1.3 * x, 1.3 * y, 6.0), (x, y, 0.0)) for x, y in places]


def deck(count: int) -> tuple[tuple[float, ...], float, tuple[float, ...]]:
    """Centre, mass and inertia of a platform."""
    return (0.0, 0.0, 0.0), 5.0 * count, (2.0 * count,) * 3


def ancf_platform(count: int, elements: int = ELEMENTS) -> ancf_model.Structure:
    """The platform in ancf."""
    made = ancf_model.Structure(ROPE, DIAMETER)
    made.add("bodies", ancf_model.rigid("deck", *deck(count)))
    for c, (top, eye) in enumerate(hangers(count)):
        made.add("bodies", ancf_model.cable(f"c{c}", top, eye, elements))
        ends = [ancf_model.place(f"c{c}", end) for end in ("start", "end")]
        made.add("joints", ancf_model.joint("spherical", f"top{c}", ends[0]))
        made.add("joints", ancf_model.joint("spherical", f"eye{c}", ends[1], ancf_model.place("deck", eye)))
    made.probe(ancf_model.place("deck", "center"))
    return made


def exudyn_platform(count: int, elements: int = ELEMENTS) -> tuple[exudyn_model.Structure, int]:
    """The platform in EXUDYN."""
    made = exudyn_model.Structure()
    node, body = made.rigid(*deck(count))
    for top, eye in hangers(count):
        nodes = made.cable(top, eye, elements, stiffness())
        made.ball(made.at_body(made.ground, top), made.at_node(nodes[0]))
        made.ball(made.at_body(body, eye), made.at_node(nodes[-1]))
    return made, made.probe(node)


def ancf_net(knots: int) -> ancf_model.Structure:
    """The net in ancf."""
    made = ancf_model.Structure(ROPE, DIAMETER)
    last = knots - 1

    def at(k: int) -> str:
        return "start" if k == 0 else "end" if k == last else f"{k}.0"

    for c in range(knots):
        made.add("bodies", ancf_model.cable(f"x{c}", (0, c, 0), (last, c, 0), last))
        made.add("bodies", ancf_model.cable(f"y{c}", (c, 0, 0), (c, last, 0), last))
    for i in range(knots):
        for j in range(knots):
            a, b = ancf_model.place(f"x{j}", at(i)), ancf_model.place(f"y{i}", at(j))
            made.add("joints", ancf_model.joint("spherical", f"k{i}_{j}", a, b))
    for c in range(0, knots, SUPPORTED):
        for end in ("start", "end"):
            made.add("joints", ancf_model.joint("spherical", f"{end}{c}", ancf_model.place(f"x{c}", end)))
    made.probe(ancf_model.place(f"x{knots // 2}", at(knots // 2)))
    return made


def exudyn_net(knots: int) -> tuple[exudyn_model.Structure, int]:
    """The net in EXUDYN."""
    made = exudyn_model.Structure()
    last = knots - 1
    along = [made.cable((0, c, 0), (last, c, 0), last, stiffness()) for c in range(knots)]
    across = [made.cable((c, 0, 0), (c, last, 0), last, stiffness()) for c in range(knots)]
    for i in range(knots):
        for j in range(knots):
            made.ball(made.at_node(along[j][i]), made.at_node(across[i][j]))
    for c in range(0, knots, SUPPORTED):
        for k in (0, last):
            made.ball(made.at_body(made.ground, [k, c, 0]), made.at_node(along[c][k]))
    return made, made.probe(along[knots // 2][knots // 2])


def case(name: str, ancf: ancf_model.Structure, exudyn, many: int) -> Case:
    """A structure in both programs."""

    def by_exudyn(tolerance: float):
        return exudyn_model.solver(exudyn, SCHEME, tolerance)

    programs = [
        Program("ancf", ancf.solver(SCHEME), 1, many),
        Program("ancf, 1e-5", ancf.solver(SCHEME, ancf_model.LOOSE_TOLERANCE), 1, many),
        Program("EXUDYN, 1e-5", by_exudyn(exudyn_model.TOLERANCE), 1, many),
        Program("EXUDYN, 1e-3", by_exudyn(exudyn_model.LOOSE_TOLERANCE), 1, many),
    ]
    return Case(name, STEP, programs)


def meshes() -> list[tuple[str, list[Program]]]:
    """A platform on twenty cables of several meshes, by both programs."""
    return [
        (
            f"{n} elements per cable",
            [
                Program("ancf", ancf_platform(20, n).solver(SCHEME), 0, 0),
                Program("EXUDYN", exudyn_model.solver(lambda n=n: exudyn_platform(20, n), SCHEME), 0, 0),
            ],
        )
        for n in (5, 10, 20)
    ]


def cases() -> list[Case]:
    """All sizes of both structures."""
    platforms = [
        case(f"platform, {n} cables x {ELEMENTS}", ancf_platform(n), lambda n=n: exudyn_platform(n), 50)
        for n in (20, 100, 1000)
    ]
    nets = [case(f"net, {n} x {n} knots", ancf_net(n), lambda n=n: exudyn_net(n), 50) for n in (10, 20, 40)]
    return platforms + nets
