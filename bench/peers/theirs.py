"""Runs of EXUDYN, cable elements of 12 coordinates, with the fastest settings found."""

import sys
import time

# Its build without range checks.
sys.exudynFast = True

import exudyn as exu  # noqa: E402
import exudyn.itemInterface as items  # noqa: E402
import numpy as np  # noqa: E402

from problems import (  # noqa: E402
    AREA,
    DENSITY,
    GRAVITY,
    INERTIA,
    INTERVAL,
    LENGTH,
    Problem,
    Run,
)

# Standard output is that of the tables.
exu.config.printToConsole = False

# Tolerances of Newton's method, of the residual, relative and absolute. The default of the former, 1e-8, is below
# the rounding error of a rod as stiff as this one from ten elements on: it then costs many times the steps, or
# the run.
TOLERANCES = (1e-7, 1e-5, 1e-3)


def build(problem: Problem, n: int):
    """The rod of n elements, its first node held; returns container, system and the sensor of its tip."""
    container = exu.SystemContainer()
    system = container.AddSystem()
    length = LENGTH / n
    nodes = [
        system.AddNode(items.NodePointSlope1(referenceCoordinates=[k * length, 0, 0, 1, 0, 0]))
        for k in range(n + 1)
    ]
    for k in range(n):
        cable = items.ObjectANCFCable(
            nodeNumbers=[nodes[k], nodes[k + 1]],
            length=length,
            massPerLength=DENSITY * AREA,
            bendingStiffness=problem.young * INERTIA,
            axialStiffness=problem.young * AREA,
        )
        body = system.AddObject(cable)
        marker = system.AddMarker(items.MarkerBodyMass(bodyNumber=body))
        system.AddLoad(items.LoadMassProportional(markerNumber=marker, loadVector=[0, -GRAVITY, 0]))
    ground = system.AddNode(items.NodePointGround())
    fixed = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))
    for coordinate in range(6 if problem.clamped else 3):
        own = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))
        system.AddObject(items.ObjectConnectorCoordinate(markerNumbers=[fixed, own]))
    sensor = items.SensorNode(
        nodeNumber=nodes[-1],
        outputVariableType=exu.OutputVariableType.Displacement,
        storeInternal=True,
        writeToFile=False,
    )
    tip = system.AddSensor(sensor)
    system.Assemble()
    return container, system, tip


def settings(duration: float, step: float, scheme: float | tuple[float, float], tolerance: float, record: float):
    """Its settings for a run without files; sensors record at an interval."""
    chosen = exu.SimulationSettings()
    integration = chosen.timeIntegration
    integration.endTime = duration
    integration.numberOfSteps = round(duration / step)
    integration.verboseMode = 0
    # Steps that do not converge end the run; divided, they take minutes if the tolerance is below the rounding
    # error.
    integration.adaptiveStep = False
    # Its modified Newton method takes a tenth of the time of the full one here.
    integration.newton.useModifiedNewton = True
    integration.newton.relativeTolerance = tolerance
    integration.newton.absoluteTolerance = tolerance
    alpha = integration.generalizedAlpha
    if isinstance(scheme, tuple):
        alpha.useNewmark = True
        alpha.newmarkBeta, alpha.newmarkGamma = scheme
    else:
        alpha.spectralRadius = scheme
    chosen.linearSolverType = exu.LinearSolverType.EigenSparse
    chosen.solutionSettings.writeSolutionToFile = False
    chosen.solutionSettings.sensorsWritePeriod = record
    chosen.displayStatistics = False
    chosen.displayComputationTime = False
    return chosen


def solve(system, sensor: int, chosen, record: float) -> Run:
    """Time of the solver alone, in this process, without files; displacements at the multiples of an interval."""
    wall, begun = time.perf_counter(), time.process_time()
    done = system.SolveDynamic(chosen, showHints=False)
    seconds, wall = time.process_time() - begun, time.perf_counter() - wall
    integration = chosen.timeIntegration
    if not done:
        raise RuntimeError(f"EXUDYN: h = {integration.endTime / integration.numberOfSteps} did not end")
    rows = np.asarray(system.GetSensorStoredData(sensor))
    instants = np.arange(1, round(integration.endTime / record) + 1) * record
    nearest = [int(np.argmin(np.abs(rows[:, 0] - t))) for t in instants]
    if np.max(np.abs(rows[nearest, 0] - instants)) > 1e-6:
        raise RuntimeError("EXUDYN left out instants")
    return Run(seconds, wall, rows[nearest, 1:4])


def run(problem: Problem, n: int, step: float, tolerance: float = TOLERANCES[1]) -> Run:
    """A rod of n elements."""
    _container, system, tip = build(problem, n)
    return solve(system, tip, settings(problem.duration, step, problem.scheme, tolerance, INTERVAL), INTERVAL)
