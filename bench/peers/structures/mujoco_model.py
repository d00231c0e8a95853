"""Runs of MuJoCo."""

import time
from collections.abc import Callable

import mujoco
import numpy as np

from problems import GRAVITY, Run

INTEGRATORS = {
    "Euler": mujoco.mjtIntegrator.mjINT_EULER,
    "implicit": mujoco.mjtIntegrator.mjINT_IMPLICIT,
    "RK4": mujoco.mjtIntegrator.mjINT_RK4,
    "discrete": mujoco.mjtIntegrator.mjINT_DISCRETE,
}
# The derivatives of long chains do not fit in its default memory, bytes.
MEMORY = 2**30


def parts(steps: int, every: int) -> list[int]:
    """Numbers of steps between recorded instants; those after the last one are a part of their own."""
    rest = steps % every
    return [every] * (steps // every) + ([rest] if rest else [])


def solver(spec: Callable[[], mujoco.MjSpec], integrator: str, point: Callable[[mujoco.MjData], np.ndarray]):
    """Compiles and solves steps; the time is that of the steps. `point`: the probe."""

    def solve(steps: int, step: float, every: int) -> Run:
        made = spec()
        made.option.timestep = step
        made.option.gravity = [0, 0, -GRAVITY]
        made.option.integrator = INTEGRATORS[integrator]
        made.memory = MEMORY
        model = made.compile()
        data = mujoco.MjData(model)
        mujoco.mj_kinematics(model, data)
        mujoco.mj_flex(model, data)
        start, path, seconds, wall = point(data).copy(), [], 0.0, 0.0
        for count in parts(steps, every):
            began, begun = time.perf_counter(), time.process_time()
            mujoco.mj_step(model, data, nstep=count)
            seconds += time.process_time() - begun
            wall += time.perf_counter() - began
            # A step ends with the places of its start.
            mujoco.mj_kinematics(model, data)
            mujoco.mj_comPos(model, data)
            mujoco.mj_flex(model, data)
            path.append(point(data) - start)
        if any(warning.number for warning in data.warning):
            raise RuntimeError(f"MuJoCo: unstable at h = {step}")
        return Run(seconds, wall, np.array(path))

    return solve
