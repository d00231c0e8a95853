"""Definition of a study: parameters, samples, objectives, and the cases that they make."""
