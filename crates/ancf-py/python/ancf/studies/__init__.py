"""Studies: a model in many cases, on all cores or a cluster, into a table."""

from ancf.studies.indices import sobol
from ancf.studies.report import Study
from ancf.studies.run import study

__all__ = ["Study", "sobol", "study"]
