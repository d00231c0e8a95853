"""Columns of the table of a study."""

COLUMNS = ("case", "outcome", "message", "steps", "iterations", "seconds", "key")
"""Columns of every table. Parameters and objectives follow the first."""
