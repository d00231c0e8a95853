"""Results as arrays: named columns, and views of them as probes, reactions, joint motions and energies."""

from ancf.record.columns import Array
from ancf.record.record import Record
from ancf.record.views import Energy, JointMotion, Probe, Reaction

__all__ = ["Array", "Energy", "JointMotion", "Probe", "Reaction", "Record"]
