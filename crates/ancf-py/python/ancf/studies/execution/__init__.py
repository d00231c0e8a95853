"""Execution of the cases of a study, and the table of their results."""
