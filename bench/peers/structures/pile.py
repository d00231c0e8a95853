"""Soft cables that fall crosswise on the ground and on each other, by ancf and MuJoCo."""

from math import cos, pi, sin

import mujoco
import numpy as np

from structures import ancf_model, mujoco_model
from structures.case import Case, Program

DENSITY, YOUNG, DAMPING, RADIUS = 1140.0, 5e7, 1e-3, 0.01
ROPE = f"{{ density = {DENSITY}, young = {YOUNG}, damping = {{ strain = {DAMPING} }} }}"
AREA, INERTIA = pi * RADIUS**2, pi * RADIUS**4 / 4
CABLES, ELEMENTS = 10, 10
FRICTION = 0.3
# Contact of ancf. With 1e5 N/m^2 the cables pass through each other at 0.16 s.
CONTACT = f"stiffness = 1e6, friction = {FRICTION}, damping = 0.2, slip_speed = 0.01"
# Contact and edges of MuJoCo: time constant, s, and damping ratio; the former is at least two steps.
REFERENCE = (0.004, 1.0)
SCHEME = 0.8
STEP = 1e-3


def lines() -> list[tuple[np.ndarray, np.ndarray]]:
    """Ends of the cables."""
    rays = [np.array([0.5 * cos(2.4 * c), 0.5 * sin(2.4 * c), 0.0]) for c in range(CABLES)]
    heights = [np.array([0.0, 0.0, 0.03 + 0.03 * c]) for c in range(CABLES)]
    return [(height - ray, height + ray) for ray, height in zip(rays, heights, strict=True)]


def ancf() -> ancf_model.Structure:
    """The pile of ancf; the mean of the probes is that of all nodes."""
    made = ancf_model.Structure(ROPE, 2 * RADIUS)
    for c, (start, end) in enumerate(lines()):
        made.add("bodies", ancf_model.cable(f"c{c}", start, end, ELEMENTS))
        for k in range(ELEMENTS + 1):
            made.probe(ancf_model.place(f"c{c}", repr(k / ELEMENTS)))
    plane = '{ kind = "plane", point = [0, 0, 0], normal = [0, 0, 1] }'
    for partner in (plane, '{ kind = "bodies" }'):
        made.add("contacts", f"{{ with = {partner}, {CONTACT} }}")
    return made


def ground(spec: mujoco.MjSpec) -> None:
    """Adds the ground."""
    plane = spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[5, 5, 1])
    plane.friction[0], plane.solref = FRICTION, REFERENCE


def rods() -> mujoco.MjSpec:
    """The pile of MuJoCo's discrete elastic rods: point masses, edges of nearly constant length."""
    solref = " ".join(map(str, REFERENCE))
    texts = []
    for c, (start, end) in enumerate(lines()):
        points = np.linspace(start, end, ELEMENTS + 1).ravel()
        edges = " ".join(f"{k} {k + 1}" for k in range(ELEMENTS))
        texts.append(
            f'<flexcomp name="c{c}" dim="1" type="direct" point="{" ".join(f"{x:.12g}" for x in points)}" '
            f'element="{edges}" radius="{RADIUS}" mass="{DENSITY * AREA}">'
            f'<edge equality="true" solref="{solref}"/><elasticity young="{YOUNG}" damping="{DAMPING}"/>'
            f'<contact selfcollide="none" friction="{FRICTION}" solref="{solref}"/></flexcomp>'
        )
    spec = mujoco.MjSpec.from_string(f"<mujoco><worldbody>{''.join(texts)}</worldbody></mujoco>")
    ground(spec)
    return spec


def capsules() -> mujoco.MjSpec:
    """The pile of rigid capsules on ball joints with the bending stiffness of the cable."""
    spec = mujoco.MjSpec()
    ground(spec)
    length = 1.0 / ELEMENTS
    mass, stiffness = DENSITY * AREA * length, YOUNG * INERTIA / length
    lateral = mass * (length**2 / 12 + RADIUS**2 / 4)
    for c, (start, end) in enumerate(lines()):
        half = np.arctan2(end[1] - start[1], end[0] - start[0]) / 2
        body = spec.worldbody.add_body(pos=start, quat=[cos(half), 0, 0, sin(half)])
        body.add_freejoint()
        for k in range(ELEMENTS):
            if k:
                body = body.add_body(pos=[length, 0, 0])
                joint = body.add_joint(type=mujoco.mjtJoint.mjJNT_BALL)
                joint.stiffness[0], joint.damping[0] = stiffness, DAMPING * stiffness
            body.name = f"c{c}_{k}"
            body.mass, body.ipos, body.explicitinertial = mass, [length / 2, 0, 0], True
            body.inertia = [mass * RADIUS**2 / 2, lateral, lateral]
            geom = body.add_geom(type=mujoco.mjtGeom.mjGEOM_CAPSULE, fromto=[0, 0, 0, length, 0, 0])
            geom.size[0], geom.friction[0], geom.solref = RADIUS, FRICTION, REFERENCE
    return spec


def middle_of_vertices(data: mujoco.MjData) -> np.ndarray:
    """Mean of all vertices."""
    return data.flexvert_xpos.mean(axis=0)


def middle_of_ends(data: mujoco.MjData) -> np.ndarray:
    """Mean of all ends of capsules, each counted once."""
    starts, centers = data.xpos[1:], data.xipos[1:]
    ends = (2 * centers - starts)[ELEMENTS - 1 :: ELEMENTS]
    return np.concatenate([starts, ends]).mean(axis=0)


def programs(few: int, many: int) -> list[Program]:
    """All of ancf and both models of MuJoCo."""
    return [
        Program("ancf", ancf().solver(SCHEME), few, many),
        Program("MuJoCo rods, discrete", mujoco_model.solver(rods, "discrete", middle_of_vertices), few, many),
        Program("MuJoCo capsules, Euler", mujoco_model.solver(capsules, "Euler", middle_of_ends), few, many),
    ]


def cases() -> list[Case]:
    """Steps in contact: from 0.1 s, shortly after the first contact, to 0.4 s."""
    return [Case(f"pile, {CABLES} cables x {ELEMENTS}", STEP, programs(100, 400))]
