"""Open chains of rigid rods with hinges in turn about y and z, or with ball joints, released from level."""

import mujoco
import numpy as np

from structures import ancf_model, exudyn_model, mujoco_model
from structures.case import Case, Program

LENGTH = 0.1
MASS = 0.1
INERTIA = (2e-5, 1e-4, 1e-4)
SCHEME = 0.8
STEP = 1e-3
# The probe is the centre of this rod. The end of the chain falls freely and shows nothing.
PROBE = 9
Y, Z = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
# Columns: x, z, -y; the third axis of the joint is y of the rod.
Z_TO_Y = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])


def ancf(n: int, hinges: bool) -> ancf_model.Structure:
    """The model of ancf."""
    made = ancf_model.Structure()
    for k in range(n):
        start = (LENGTH * k, 0.0, 0.0)
        made.add("bodies", ancf_model.rigid(f"r{k}", (LENGTH * (k + 0.5), 0.0, 0.0), MASS, INERTIA))
        before = ancf_model.place(f"r{k - 1}", start) if k else ""
        kind, axis = ("revolute", Z if k % 2 else Y) if hinges else ("spherical", ())
        made.add("joints", ancf_model.joint(kind, f"j{k}", ancf_model.place(f"r{k}", start), before, axis))
    made.probe(ancf_model.place(f"r{PROBE}", "center"))
    return made


def exudyn(n: int, hinges: bool) -> tuple[exudyn_model.Structure, int]:
    """The model of EXUDYN and its sensor."""
    made = exudyn_model.Structure()
    half = [LENGTH / 2, 0.0, 0.0]
    body, end = made.ground, [0.0, 0.0, 0.0]
    nodes = []
    for k in range(n):
        rotation = None if k % 2 or not hinges else Z_TO_Y
        before = made.at_body(body, end, rotation)
        node, body = made.rigid((LENGTH * (k + 0.5), 0.0, 0.0), MASS, INERTIA)
        after = made.at_body(body, [-half[0], 0.0, 0.0], rotation)
        (made.hinge if hinges else made.ball)(before, after)
        nodes.append(node)
        end = half
    return made, made.probe(nodes[PROBE])


def mujoco_spec(n: int, hinges: bool) -> mujoco.MjSpec:
    """The model of MuJoCo: coordinates are those of the joints."""
    spec = mujoco.MjSpec()
    body = spec.worldbody
    for k in range(n):
        body = body.add_body(name=f"r{k}", pos=[LENGTH if k else 0.0, 0.0, 0.0])
        body.mass, body.ipos, body.inertia = MASS, [LENGTH / 2, 0.0, 0.0], list(INERTIA)
        body.explicitinertial = True
        if hinges:
            body.add_joint(type=mujoco.mjtJoint.mjJNT_HINGE, axis=list(Z if k % 2 else Y))
        else:
            body.add_joint(type=mujoco.mjtJoint.mjJNT_BALL)
    return spec


def by_mujoco(n: int, hinges: bool, integrator: str):
    """Solves by MuJoCo. The first of its bodies is the world."""
    return mujoco_model.solver(lambda: mujoco_spec(n, hinges), integrator, lambda data: data.xipos[PROBE + 1])


def programs(n: int, hinges: bool, few: int = 10, many: int = 110) -> list[Program]:
    """All programs; those of MuJoCo whose steps take seconds are left out."""
    made = ancf(n, hinges)
    coordinates = n if hinges else 3 * n

    def by_exudyn(tolerance: float):
        return exudyn_model.solver(lambda: exudyn(n, hinges), SCHEME, tolerance)

    found = [
        Program("ancf", made.solver(SCHEME), few, many),
        Program("ancf, 1e-5", made.solver(SCHEME, ancf_model.LOOSE_TOLERANCE), few, many),
        Program("EXUDYN, 1e-5", by_exudyn(exudyn_model.TOLERANCE), few, many),
        Program("EXUDYN, 1e-3", by_exudyn(exudyn_model.LOOSE_TOLERANCE), few, many),
    ]
    # Largest numbers of coordinates; the time of a step grows with the cube.
    limits = {"Euler": 3000, "implicit": 300, "RK4": 1000}
    # The cost does not depend on the motion: few steps of large systems are enough.
    few, many = (few, many) if coordinates <= 300 else (few, 3 * few) if coordinates <= 1000 else (1, few)
    for name, limit in limits.items():
        if coordinates <= limit:
            found.append(Program(f"MuJoCo {name}", by_mujoco(n, hinges, name), few, many))
    return found


def cases() -> list[Case]:
    """All sizes and joints."""
    kinds = ((True, "hinges"), (False, "ball joints"))
    return [
        Case(f"{n} rods, {name}", STEP, programs(n, hinges, many=110 if n < 1000 else 60))
        for hinges, name in kinds
        for n in (100, 300, 1000)
    ]
