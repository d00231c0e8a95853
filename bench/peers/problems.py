"""The problems that both programs solve: a steel rod that swings under its own weight."""

from dataclasses import dataclass
from math import pi

DIAMETER = 0.02
LENGTH = 1.0
DENSITY = 8030.0
GRAVITY = 9.81
AREA = pi * DIAMETER**2 / 4
INERTIA = pi * DIAMETER**4 / 64

# Instants at which the tips are compared, s.
INTERVAL = 0.01


@dataclass(frozen=True)
class Problem:
    """A rod along x, held at its start, that falls along -y from straight and at rest."""

    name: str
    clamped: bool
    young: float
    duration: float
    # Spectral radius of the generalized-alpha scheme, or Newmark's (beta, gamma).
    scheme: float | tuple[float, float]

    def instants(self) -> int:
        """Number of instants after the start."""
        return round(self.duration / INTERVAL)


# Small vibrations; both programs by the same second-order scheme.
CANTILEVER = Problem("cantilever", True, 193e9, 0.5, 0.9)
# Large rotations of a rod a thousand times softer, as in section 3.3 of the paper.
PENDULUM = Problem("pendulum", False, 193e6, 1.0, 0.9)
# The paper's: 2 s by Newmark's scheme with the numbers of ADAMS.
PAPER = Problem("cantilever of the paper", True, 193e9, 2.0, (0.36, 0.70))


@dataclass(frozen=True)
class Run:
    """What a run took and where the tip went."""

    # Time of the processor, s: of the solver where it can be had alone, else of the whole process.
    seconds: float
    # Time that the solver reports of itself, s, on the wall.
    reported: float
    # Displacements of the tip at all instants, shape (instants, 3).
    tip: object
