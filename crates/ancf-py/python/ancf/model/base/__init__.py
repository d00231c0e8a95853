"""Foundations of the model classes: parts, places on bodies, functions of time."""
