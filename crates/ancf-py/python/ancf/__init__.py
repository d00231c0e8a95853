"""Flexible multibody dynamics on the absolute nodal coordinate formulation (ANCF).

A model consists of typed objects (`Model`, `Beam`, ...), dictionaries, or a TOML file. `run` carries out its analysis
and returns a `Result` with NumPy arrays.
"""

from typing import TYPE_CHECKING

from ancf import _ancf, model
from ancf.analysis import (
    buckling,
    check,
    load,
    modes,
    path,
    run,
    run_sequence,
    scaled,
    schema,
    statics,
)
from ancf.errors import AnalysisError, AnalysisWarning, Fault, ModelError
from ancf.gradients import Gradients, gradients
from ancf.meshes import grid_mesh, mesh_from_meshio
from ancf.model import *  # noqa: F403
from ancf.names import unknown as _unknown
from ancf.record.instant import Instant
from ancf.result import Result
from ancf.simulation import LinearModel, Projection, Simulation, State, StepInfo
from ancf.studies import Study, sobol, study

__version__ = _ancf.VERSION

__all__ = [
    "AnalysisError",
    "AnalysisWarning",
    "Fault",
    "Gradients",
    "Instant",
    "LinearModel",
    "ModelError",
    "Projection",
    "Result",
    "Simulation",
    "State",
    "StepInfo",
    "Study",
    "__version__",
    "buckling",
    "check",
    "gradients",
    "grid_mesh",
    "load",
    "mesh_from_meshio",
    "modes",
    "path",
    "run",
    "run_sequence",
    "scaled",
    "schema",
    "sobol",
    "statics",
    "study",
    *model.__all__,
]

# A type checker must report unknown names.
if not TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        raise AttributeError(_unknown(name, __all__))
