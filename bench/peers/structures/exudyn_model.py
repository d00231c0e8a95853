"""Parts of models of EXUDYN."""

from collections.abc import Callable, Sequence

import numpy as np

import theirs
from problems import GRAVITY, Run
from theirs import exu, items

_, TOLERANCE, LOOSE_TOLERANCE = theirs.TOLERANCES


class Structure:
    """A system with the ground, bodies under their weight, and joints of points."""

    def __init__(self):
        """An empty system."""
        self.container = exu.SystemContainer()
        self.system = self.container.AddSystem()
        self.ground = self.system.AddObject(items.ObjectGround())

    def weight(self, body: int) -> None:
        """Adds the weight of a body."""
        marker = self.system.AddMarker(items.MarkerBodyMass(bodyNumber=body))
        self.system.AddLoad(items.LoadMassProportional(markerNumber=marker, loadVector=[0, 0, -GRAVITY]))

    def rigid(self, center: Sequence[float], mass: float, inertia: Sequence[float]) -> tuple[int, int]:
        """Adds a rigid body with Euler parameters, the fastest of its rotations here; returns node and body."""
        node = self.system.AddNode(items.NodeRigidBodyEP(referenceCoordinates=[*center, 1, 0, 0, 0]))
        body = items.ObjectRigidBody(mass=mass, inertia=[*inertia, 0, 0, 0], nodeNumber=node)
        number = self.system.AddObject(body)
        self.weight(number)
        return node, number

    def cable(self, start: Sequence[float], end: Sequence[float], elements: int, rope: dict) -> list[int]:
        """Adds a cable; returns its nodes. `rope`: mass per length, bending and axial stiffness."""
        start, end = np.asarray(start, float), np.asarray(end, float)
        length = float(np.linalg.norm(end - start))
        slope = (end - start) / length
        places = [start + (end - start) * k / elements for k in range(elements + 1)]
        nodes = [
            self.system.AddNode(items.NodePointSlope1(referenceCoordinates=[*place, *slope])) for place in places
        ]
        for pair in zip(nodes, nodes[1:], strict=False):
            element = items.ObjectANCFCable(nodeNumbers=list(pair), length=length / elements, **rope)
            self.weight(self.system.AddObject(element))
        return nodes

    def at_node(self, node: int) -> int:
        """A marker of a node of a cable."""
        return self.system.AddMarker(items.MarkerNodePosition(nodeNumber=node))

    def at_body(self, body: int, position: Sequence[float], rotation: np.ndarray | None = None) -> int:
        """A marker of a point of a rigid body, with the rotation of its frame."""
        frame = exu.HT(rotation=np.eye(3) if rotation is None else rotation, translation=list(position))
        return self.system.AddMarker(items.MarkerBodyRigid(bodyNumber=body, localHT=frame))

    def ball(self, a: int, b: int) -> None:
        """A spherical joint of two markers."""
        self.system.AddObject(items.ObjectJointSpherical(markerNumbers=[a, b], constrainedAxes=[1, 1, 1]))

    def hinge(self, a: int, b: int) -> None:
        """A revolute joint about the third axes of two markers."""
        self.system.AddObject(items.ObjectJointRevoluteZ(markerNumbers=[a, b]))

    def probe(self, node: int) -> int:
        """Assembles with a sensor of the displacement of a node."""
        sensor = items.SensorNode(
            nodeNumber=node,
            outputVariableType=exu.OutputVariableType.Displacement,
            storeInternal=True,
            writeToFile=False,
        )
        number = self.system.AddSensor(sensor)
        self.system.Assemble()
        return number


def solver(build: Callable[[], tuple[Structure, int]], scheme: float, tolerance: float = TOLERANCE):
    """Builds anew and solves steps."""

    def solve(steps: int, step: float, every: int) -> Run:
        structure, sensor = build()
        # A run shorter than the interval records its last instant only.
        record = min(every, steps) * step
        chosen = theirs.settings(steps * step, step, scheme, tolerance, record)
        return theirs.solve(structure.system, sensor, chosen, record)

    return solve
