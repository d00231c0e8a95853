"""Studies: one model, many cases, one table. Cases run on all cores or on a cluster."""

from ancf.studies.indices import sobol
from ancf.studies.report import Study
from ancf.studies.run import study

__all__ = ["Study", "sobol", "study"]
