"""Flexible multibody dynamics on the absolute nodal coordinate formulation (ANCF)."""

from ancf._ancf import ModelError as ModelError
from ancf.model import *  # noqa: F403
