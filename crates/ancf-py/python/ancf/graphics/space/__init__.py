"""Scenes in space by PyVista."""
