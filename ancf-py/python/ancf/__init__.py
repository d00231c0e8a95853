"""Flexible multibody dynamics on the absolute nodal coordinate formulation (ANCF)."""
